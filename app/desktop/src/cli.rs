//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::capture::CaptureCommand;
use crate::view_options::ViewOptions;

pub use crate::shared_options::{DeviceOptions, SceneOptions, TierName};

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
    View(ViewOptions),
    /// Show what a run would do: its passes, buffers and bytes, and what is left out and why
    Plan(PlanOptions),
    /// List the shipped scenes, or print the schema of scene files
    Scenes(ScenesOptions),
    /// Time every pass: of one scene, or of the same workload at rising numbers of particles
    Bench(BenchOptions),
    /// Study error against run time, published cases, and where the solvers break; writes a report
    Study(StudyOptions),
    /// Find the cheapest setting of a scene for an error, or the most exact one for a time
    Tune(TuneOptions),
    /// Read captures: what they say, whether they can be believed, one against another
    #[command(subcommand)]
    Capture(CaptureCommand),
    /// List this machine's devices: their tier, what they lack, and what that costs
    Doctor(ListOptions),
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

/// `brooklet bench`.
#[derive(Clone, Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct BenchOptions {
    /// What else can be timed.
    #[command(subcommand)]
    pub study: Option<BenchStudy>,
    /// Time this scene alone: a shipped scene's name, or the path of a scene file
    #[arg(value_name = "SCENE")]
    pub scene: Option<String>,
    /// Change a value of the scene or of the table's workload, as solver.neighbour_slots=40; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Steps of SCENE that are timed
    #[arg(long, value_name = "N", default_value_t = 100, requires = "scene", value_parser = steps_from(1))]
    pub steps: u64,
    /// Steps of SCENE before them that are not
    #[arg(long, value_name = "N", default_value_t = 20, requires = "scene", value_parser = steps_from(0))]
    pub warm_up: u64,
    /// Then also time so many pictures of SCENE, pass by pass
    #[arg(long, value_name = "N", default_value_t = 0, requires = "scene", value_parser = clap::value_parser!(u32).range(0..=10_000))]
    pub pictures: u32,
    /// The table's largest size; sizes go on to 16777216
    #[arg(long, value_name = "N", default_value_t = 1_000_000, conflicts_with = "scene", value_parser = clap::value_parser!(u32).range(4096..))]
    pub max_particles: u32,
    /// Time for the whole table, in seconds: what would take longer is left out, and said
    #[arg(long, value_name = "S", default_value_t = 240.0, conflicts_with = "scene", value_parser = seconds)]
    pub budget: f64,
    /// Also draw the table, as an SVG picture
    #[arg(long, value_name = "FILE", conflicts_with = "scene")]
    pub plot: Option<PathBuf>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// What else `brooklet bench` times.
#[derive(Clone, Debug, Subcommand)]
pub enum BenchStudy {
    /// Ways to sort the particles: the product's against others, in pairs
    Sorting(SortingOptions),
    /// Ways to smooth the surface in screen space: their errors against known bodies, and their cost
    Surfaces(SurfacesOptions),
    /// What the window's panels and its capture add to a frame, in pairs; opens no window
    Window(WindowOptions),
}

/// `brooklet bench window`.
#[derive(Clone, Debug, Args)]
pub struct WindowOptions {
    /// A shipped scene's name, or the path of a scene file
    #[arg(value_name = "SCENE", default_value = "calm-pool")]
    pub scene: String,
    /// Change a value of the scene; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Width of the window with its panels, pixels
    #[arg(long, value_name = "PX", default_value_t = 1280, value_parser = clap::value_parser!(u32).range(700..=8192))]
    pub width: u32,
    /// Height of the window, pixels
    #[arg(long, value_name = "PX", default_value_t = 800, value_parser = clap::value_parser!(u32).range(240..=8192))]
    pub height: u32,
    /// Pairs of turns that are timed
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub pairs: u32,
    /// Frames of a turn
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    pub frames: u64,
    /// Keep the capture that was timed, with its cost in it
    #[arg(long, value_name = "FILE")]
    pub capture: Option<PathBuf>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet bench surfaces`.
#[derive(Clone, Debug, Args)]
pub struct SurfacesOptions {
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Width of the pictures, pixels
    #[arg(long, value_name = "PX", default_value_t = 640, value_parser = clap::value_parser!(u32).range(64..=4096))]
    pub width: u32,
    /// Height of the pictures, pixels
    #[arg(long, value_name = "PX", default_value_t = 360, value_parser = clap::value_parser!(u32).range(64..=4096))]
    pub height: u32,
    /// Pictures that are timed of each
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub repeats: u32,
    /// Also write the table as CSV
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Also draw it, as an SVG picture
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Also write what was seen as a PNG: normals as colours, a row for each body, a column for each
    /// filter, then the marched density field and the known surface
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet bench sorting`.
#[derive(Clone, Debug, Args)]
pub struct SortingOptions {
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Particles, rounded down to a size of the table
    #[arg(long, value_name = "N", default_value_t = 125_000, value_parser = clap::value_parser!(u32).range(4096..))]
    pub particles: u32,
    /// Pairs of runs of each comparison
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub pairs: u32,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet study`.
#[derive(Clone, Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct StudyOptions {
    /// Join parts.
    #[command(subcommand)]
    pub merge: Option<StudyMerge>,
    /// Which part
    #[arg(value_enum, value_name = "PART", default_value_t = StudyPart::All)]
    pub part: StudyPart,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// The curves.
    #[command(flatten)]
    pub curves: CurveOptions,
    /// Run this part of all runs, as 2/5, and write no report: `study merge` does, of all parts
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub shard: Option<(usize, usize)>,
    /// Folder to write to, out/study if not given. An unfinished study in it goes on; a finished one is kept, and
    /// a number is added
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// What else `brooklet study` does.
#[derive(Clone, Debug, Subcommand)]
pub enum StudyMerge {
    /// Join the parts that shards wrote, and write their report
    Merge(MergeOptions),
}

/// `brooklet study merge`.
#[derive(Clone, Debug, Args)]
pub struct MergeOptions {
    /// Folders that shards wrote
    #[arg(value_name = "DIR", required = true)]
    pub parts: Vec<PathBuf>,
    /// Which part of a study they are parts of
    #[arg(long, value_enum, value_name = "PART", default_value_t = StudyPart::All)]
    pub part: StudyPart,
    /// The curves.
    #[command(flatten)]
    pub curves: CurveOptions,
    /// Folder for the report, out/study if not given; as for `study`
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Which curves of error against run time, and how much of everything.
#[derive(Clone, Debug, Args)]
pub struct CurveOptions {
    /// Draw error against time of these cases alone, as elliptical-drop,martin-moyce
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub scenes: Vec<String>,
    /// Of these solvers alone
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub methods: Vec<String>,
    /// Of these knobs alone, as iterations,substeps
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub knobs: Vec<String>,
    /// Few of everything: within three minutes on two cores
    #[arg(long)]
    pub quick: bool,
}

/// A part of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StudyPart {
    /// Everything
    All,
    /// Error against run time
    Error,
    /// Published cases
    Validation,
    /// Extreme cases and maps
    Stability,
}

/// `brooklet tune`.
#[derive(Clone, Debug, Args)]
#[command(group = clap::ArgGroup::new("goal").required(true))]
pub struct TuneOptions {
    /// A shipped scene's name, or the path of a scene file
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Change a value of the scene first; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
    /// GPU time that a step may take, ms: the smallest error within it is searched
    #[arg(long, value_name = "MS", group = "goal", value_parser = positive, allow_negative_numbers = true)]
    pub budget_ms: Option<f64>,
    /// Error that a step may leave (compression that 99 of 100 particles do not exceed, .02 for 2 %): the
    /// shortest step within it is searched
    #[arg(long, value_name = "E", group = "goal", value_parser = positive, allow_negative_numbers = true)]
    pub max_error: Option<f64>,
    /// Simulated time of each run
    #[arg(long, value_name = "S", default_value_t = 0.5, value_parser = seconds)]
    pub seconds: f64,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Write the scene with the chosen settings to this file, SCENE-tuned.toml if not given
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Print the result as JSON
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
pub struct ListOptions {
    /// Print the list as JSON
    #[arg(long)]
    pub json: bool,
}

/// File format of particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ParticleFormat {
    /// Binary little-endian PLY: x y z, vx vy vz, id, fluid
    Ply,
}

/// The most steps of a run: what a step's number in the capture and a picture's in its name hold.
pub const MOST_STEPS: u64 = 1_000_000_000;

fn steps_from(least: u64) -> clap::builder::RangedU64ValueParser {
    clap::value_parser!(u64).range(least..=MOST_STEPS)
}

/// Part I of N, from 1.
fn shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/').and_then(|(index, of)| Some((index.parse().ok()?, of.parse().ok()?)));
    parts.filter(|&(index, of)| 1 <= index && index <= of).ok_or("must be I/N with I from 1 to N, as 2/5".into())
}

/// A positive, finite number.
fn positive(text: &str) -> Result<f64, String> {
    seconds(text).map_err(|_| "must be a positive number".into())
}

/// A positive, finite time.
fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds.is_finite() => Ok(seconds),
        _ => Err("must be a positive number of seconds".into()),
    }
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
        for arguments in [["--steps", "9"], ["--warm-up", "1"]] {
            let of_the_table = ["brooklet", "bench"].into_iter().chain(arguments);
            assert!(Cli::try_parse_from(of_the_table).is_err(), "{arguments:?} are a scene's");
            let of_a_scene = ["brooklet", "bench", "x"].into_iter().chain(arguments);
            assert!(Cli::try_parse_from(of_a_scene).is_ok());
        }
        assert!(Cli::try_parse_from(["brooklet", "bench", "x", "--max-particles", "5000"]).is_err());
        let both = ["brooklet", "run", "x", "--steps", "1", "--seconds", "1"];
        assert!(Cli::try_parse_from(both).is_err());
    }

    #[test]
    fn shards_are_counted_from_one() {
        assert_eq!(shard("2/5"), Ok((2, 5)));
        assert!(["0/5", "6/5", "2", "a/b", "1/0", "-1/2"].iter().all(|text| shard(text).is_err()));
    }
}
