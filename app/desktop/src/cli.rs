//! The command line.

#[cfg(not(all(
    feature = "window",
    feature = "bench",
    feature = "study",
    feature = "captures",
    feature = "report"
)))]
use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

#[cfg(feature = "bench")]
use crate::bench_options::BenchOptions;
#[cfg(feature = "captures")]
use crate::capture::CaptureCommand;
use crate::mesh_file::MeshFormat;
use crate::mesh_options::MeshOptions;
#[cfg(feature = "report")]
use crate::report_options::ReportOptions;
use crate::shared_options::{DeviceOptions, SceneOptions, TierName, seconds, steps_from};
#[cfg(feature = "study")]
use crate::study_options::{StudyOptions, TuneOptions};
#[cfg(feature = "window")]
use crate::view_options::ViewOptions;

/// Particle fluids on the GPU, with pictures and timing captures.
#[derive(Debug, Parser)]
#[command(name = "brooklet", version, arg_required_else_help = true)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Simulate a scene; write pictures, a timing capture and a summary
    Run(RunOptions),
    /// Open a window: look at a scene, change it, push it, record it
    #[cfg(feature = "window")]
    View(ViewOptions),
    /// Show what a run would do: its passes, buffers and bytes, and what is left out and why
    Plan(PlanOptions),
    /// Mesh the surface of particles from a PLY file, on the GPU
    Mesh(MeshOptions),
    /// List the shipped scenes, or print the schema of scene files
    Scenes(ScenesOptions),
    /// Time every pass: of one scene, or of the same workload at rising numbers of particles
    #[cfg(feature = "bench")]
    Bench(BenchOptions),
    /// Study error against run time, published cases, and where the solvers break; writes a report
    #[cfg(feature = "study")]
    Study(StudyOptions),
    /// Find the cheapest setting of a scene for an error, or the most exact one for a time
    #[cfg(feature = "study")]
    Tune(TuneOptions),
    /// Read captures: what they say, whether they can be believed, one against another
    #[cfg(feature = "captures")]
    #[command(subcommand)]
    Capture(CaptureCommand),
    /// Find out what a device computes and how fast, as one page to look at and send
    #[cfg(feature = "report")]
    Report(ReportOptions),
    /// List this machine's devices: their tier, what they lack, and what that costs; or check that one computes right
    Doctor(DoctorOptions),
    /// A command that this build leaves out, or none at all.
    #[cfg(not(all(
        feature = "window",
        feature = "bench",
        feature = "study",
        feature = "captures",
        feature = "report"
    )))]
    #[command(external_subcommand)]
    LeftOut(Vec<OsString>),
}

/// How much to simulate.
#[derive(Clone, Debug, Args)]
pub struct LengthOptions {
    /// Simulated time; the scene's own if not given
    #[arg(long, value_name = "S", value_parser = seconds, conflicts_with = "steps", allow_negative_numbers = true)]
    pub seconds: Option<f64>,
    /// Number of steps
    #[arg(long, value_name = "N", value_parser = steps_from(1), allow_negative_numbers = true)]
    pub steps: Option<u64>,
}

/// What to write beside the capture and the summary.
#[derive(Clone, Debug, Args)]
pub struct OutputOptions {
    /// Pictures, spread evenly over the run, the last at its end; the scene's own number if not
    /// given, 0 for none
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(..=100_000))]
    pub images: Option<u32>,
    /// Also write the particles, whenever a picture is due and at the end
    #[arg(long, value_name = "FORMAT", value_enum)]
    pub particles: Option<ParticleFormat>,
    /// Also write the fluid's surface at the end, as triangles
    #[arg(long, value_name = "FORMAT", value_enum)]
    pub mesh: Option<MeshFormat>,
    /// Write no timing capture; the summary has medians all the same
    #[arg(long)]
    pub no_capture: bool,
    /// Take no GPU times: no timestamp query is made
    #[arg(long)]
    pub no_timing: bool,
}

/// `brooklet run`.
#[derive(Clone, Debug, Args)]
pub struct RunOptions {
    /// The scene.
    #[command(flatten)]
    pub scene: SceneOptions,
    /// The length.
    #[command(flatten)]
    pub length: LengthOptions,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// The outputs.
    #[command(flatten)]
    pub outputs: OutputOptions,
    /// Folder to write to, out/SCENE if not given. One that exists is kept, and a number is added
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// The timing capture's file, if not DIR/capture.mcap; replaced if it exists
    #[arg(long, value_name = "FILE", conflicts_with = "no_capture")]
    pub capture: Option<PathBuf>,
    /// Also write the pictures as one animated WebP, DIR/clip.webp, at the pace of the scene's time
    #[cfg(feature = "clip")]
    #[arg(long)]
    pub clip: bool,
    /// Print the summary as JSON, and nothing else, on standard output
    #[arg(long)]
    pub json: bool,
}

/// `brooklet plan`.
#[derive(Clone, Debug, Args)]
pub struct PlanOptions {
    /// The scene.
    #[command(flatten)]
    pub scene: SceneOptions,
    /// Plan for a device of this tier; desktop if not given
    #[arg(long, value_enum, env = "BROOKLET_TIER")]
    pub tier: Option<TierName>,
    /// The outputs.
    #[command(flatten)]
    pub outputs: OutputOptions,
    /// Print the plan as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet scenes`.
#[derive(Clone, Debug, Args)]
pub struct ScenesOptions {
    /// Print the list as JSON
    #[arg(long)]
    pub json: bool,
    /// Print the JSON Schema of scene files instead: with it an editor completes and checks them
    #[arg(long, conflicts_with = "json")]
    pub schema: bool,
}

/// `brooklet doctor`.
#[derive(Clone, Debug, Args)]
pub struct DoctorOptions {
    /// Run small inputs with known answers on the device, for every kernel and variant that SCENE's plan has (dam-break
    /// if not given); exit code 1 if anything is wrong
    #[arg(long, value_name = "SCENE", num_args = 0..=1, default_missing_value = "dam-break")]
    pub check: Option<String>,
    /// Check everything that the device's tier can run, on large inputs too
    #[arg(long, requires = "check")]
    pub all: bool,
    /// Change a value of the scene that is checked, as solver.precision=relaxed; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE", requires = "check", conflicts_with = "all")]
    pub settings: Vec<String>,
    /// Only cases of this room of known answers, as grid; may be given again
    #[arg(long, value_name = "ROOM", requires = "check")]
    pub room: Vec<String>,
    /// Write every verdict to this MCAP file as it is known
    #[arg(long, value_name = "FILE", requires = "check")]
    pub capture: Option<PathBuf>,
    /// Put a SPIR-V file in place of a kernel's variant, as Xsph=broken.spv: to see that what it breaks is found
    #[arg(long, value_name = "VARIANT=FILE", requires = "check", hide = true)]
    pub replace: Vec<String>,
    /// The device that is checked.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Print as JSON, and nothing else, on standard output
    #[arg(long)]
    pub json: bool,
}

/// File format of particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ParticleFormat {
    /// Binary little-endian PLY: x y z, vx vy vz, id, fluid
    Ply,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn lengths_are_positive() {
        for (text, fits) in [("2.5", true), ("0", false), ("-1", false), ("inf", false), ("a", false)] {
            let parsed = Cli::try_parse_from(["brooklet", "run", "dam-break", "--seconds", text]);
            assert_eq!(parsed.is_ok(), fits, "{text}");
        }
        for arguments in [["--steps", "0"], ["--steps", "-1"]] {
            let all = ["brooklet", "run", "dam-break"].into_iter().chain(arguments);
            assert!(Cli::try_parse_from(all).is_err());
        }
        let both = ["brooklet", "run", "x", "--steps", "1", "--seconds", "1"];
        assert!(Cli::try_parse_from(both).is_err());
    }
}
