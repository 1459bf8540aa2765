//! The command line of `brooklet bench`.

use std::path::PathBuf;

use brooklet_bench::surfaces;
use clap::{Args, Subcommand};

use crate::shared_options::{DeviceOptions, SceneOptions, seconds, steps_from};

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
    /// What solids and bodies add to a step: a pool with neither, with 100 solids, with 16 bodies, in turns
    Bodies(BodiesOptions),
    /// The rows of the source papers' tables, by every solver, each beside the paper's own figure and its card
    Papers(PapersOptions),
    /// Ways to sort the particles: the product's against others, in pairs
    Sorting(SortingOptions),
    /// The same steps in submissions of 1, 4 and 16, with and without GPU times, by the host's clock
    Submissions(SubmissionsOptions),
    /// Ways to smooth the surface in screen space and to mesh it: their errors against known bodies, and their cost
    Surfaces(SurfacesOptions),
    /// What the window's panels and its capture add to a frame, in pairs; opens no window
    #[cfg(feature = "window")]
    Window(WindowOptions),
    /// How soon and how fast scenes move in a window on this device, and what is given up for it; opens no window
    #[cfg(feature = "window")]
    Ladder(LadderOptions),
}

/// `brooklet bench bodies`.
#[derive(Clone, Debug, Args)]
pub struct BodiesOptions {
    /// About how many particles
    #[arg(long, value_name = "N", default_value_t = 125_000, value_parser = clap::value_parser!(u32).range(4096..=4_000_000))]
    pub particles: u32,
    /// Rounds; in each every scene has 4 steps
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub rounds: u32,
    /// Change a value of every scene, as solver.method=dfsph; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet bench ladder`.
#[cfg(feature = "window")]
#[derive(Clone, Debug, Args)]
pub struct LadderOptions {
    /// A shipped scene's name, or the path of a scene file; all shipped scenes, where not given
    #[arg(value_name = "SCENE")]
    pub scene: Option<String>,
    /// Change a value of the scene; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Width of the window, pixels
    #[arg(long, value_name = "PX", default_value_t = 1280, value_parser = clap::value_parser!(u32).range(320..=8192))]
    pub width: u32,
    /// Height of the window, pixels
    #[arg(long, value_name = "PX", default_value_t = 800, value_parser = clap::value_parser!(u32).range(240..=8192))]
    pub height: u32,
    /// What a frame may take, ms, as `view` takes it
    #[arg(long, value_name = "MS", value_parser = crate::shared_options::budget)]
    pub budget: Option<f64>,
    /// Stay on this rung of the quality ladder, 0 being everything, as `view` does
    #[arg(long, value_name = "N", value_parser = crate::shared_options::rung)]
    pub rung: Option<usize>,
    /// Count frames from so long after opening, s
    #[arg(long, value_name = "S", default_value_t = 5.0, value_parser = seconds)]
    pub after: f64,
    /// Count frames for so long, s
    #[arg(long, value_name = "S", default_value_t = 5.0, value_parser = seconds)]
    pub seconds: f64,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet bench window`.
#[cfg(feature = "window")]
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

/// `brooklet bench papers`.
#[derive(Clone, Debug, Args)]
pub struct PapersOptions {
    /// Change a value of the workload, as solver.neighbour_slots=40; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// The largest number of particles; rows go on to 4194304
    #[arg(long, value_name = "N", default_value_t = 4_194_304, value_parser = clap::value_parser!(u32).range(1024..))]
    pub max_particles: u32,
    /// Time for the whole table, in seconds: what would take longer is left out, and said
    #[arg(long, value_name = "S", default_value_t = 240.0, value_parser = seconds)]
    pub budget: f64,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet bench submissions`.
#[derive(Clone, Debug, Args)]
pub struct SubmissionsOptions {
    /// The scene.
    #[command(flatten)]
    pub scene: SceneOptions,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Rounds; in each every way has 32 steps
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub rounds: u32,
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
    /// Only this body, as the tables call it; may be given again
    #[arg(long = "body", value_name = "NAME", value_parser = body)]
    pub bodies: Vec<&'static str>,
    /// Only this way to smooth or to mesh, as the tables call it; may be given again
    #[arg(long = "way", value_name = "NAME", value_parser = way)]
    pub ways: Vec<&'static str>,
    /// Mesh the same particles with this program too, a splashsurf (its path, or its name where programs are looked for),
    /// in cells as large: as it is, and smoothed as its manual has it
    #[arg(long, value_name = "PROGRAM")]
    pub beside: Option<PathBuf>,
    /// Pictures and meshes that are timed of each
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub repeats: u32,
    /// Also write the tables as CSV: the pictures' to FILE, the meshes' beside it to one that ends in .meshes.csv
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Also draw both, as an SVG picture
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

fn body(name: &str) -> Result<&'static str, String> {
    one_of(name, surfaces::bodies())
}

fn way(name: &str) -> Result<&'static str, String> {
    one_of(name, surfaces::ways())
}

fn one_of(name: &str, names: Vec<&'static str>) -> Result<&'static str, String> {
    let known = names.iter().copied().find(|known| *known == name);
    known.ok_or_else(|| format!("it may be {}", names.join("; ")))
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use crate::cli::Cli;

    #[test]
    fn lengths_are_of_a_scene_and_sizes_of_the_table() {
        for arguments in [["--steps", "9"], ["--warm-up", "1"]] {
            let of_the_table = ["brooklet", "bench"].into_iter().chain(arguments);
            assert!(Cli::try_parse_from(of_the_table).is_err(), "{arguments:?} are a scene's");
            let of_a_scene = ["brooklet", "bench", "x"].into_iter().chain(arguments);
            assert!(Cli::try_parse_from(of_a_scene).is_ok());
        }
        assert!(Cli::try_parse_from(["brooklet", "bench", "x", "--max-particles", "5000"]).is_err());
    }
}
