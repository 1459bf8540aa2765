//! The command lines of `brooklet study` and `brooklet tune`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use crate::shared_options::{DeviceOptions, seconds};

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
    /// Lower precision and smaller tiers
    Precision,
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
    /// Search these solvers alone, whatever is known of them, as sph,pbf; all that may move the scene, if not given
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub methods: Vec<String>,
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

/// Part I of N, from 1.
fn shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/').and_then(|(index, of)| Some((index.parse().ok()?, of.parse().ok()?)));
    parts.filter(|&(index, of)| 1 <= index && index <= of).ok_or("must be I/N with I from 1 to N, as 2/5".into())
}

/// A positive, finite number.
fn positive(text: &str) -> Result<f64, String> {
    seconds(text).map_err(|_| "must be a positive number".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_are_counted_from_one() {
        assert_eq!(shard("2/5"), Ok((2, 5)));
        assert!(["0/5", "6/5", "2", "a/b", "1/0", "-1/2"].iter().all(|text| shard(text).is_err()));
    }
}
