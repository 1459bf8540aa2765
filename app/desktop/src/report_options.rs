//! The command line of `brooklet report`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use crate::{capture::share, shared_options::DeviceOptions};

/// `brooklet report`.
#[derive(Clone, Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct ReportOptions {
    /// What else can be done with reports.
    #[command(subcommand)]
    pub compare: Option<ReportCommand>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Time for all of it; every part has its share, and is cut off behind it
    #[arg(long, value_name = "MIN", default_value_t = 6.0, value_parser = minutes)]
    pub minutes: f64,
    /// Folder to write to, out/report if not given. One that exists is kept, and a number is added
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Leave parts out, as sorting,extremes
    #[arg(long, value_name = "PARTS", value_enum, value_delimiter = ',')]
    pub skip: Vec<PartName>,
}

/// What else can be done with reports.
#[derive(Clone, Debug, Subcommand)]
pub enum ReportCommand {
    /// Compare two reports: two devices, or two versions on one
    Compare(CompareOptions),
}

/// `brooklet report compare`.
#[derive(Clone, Debug, Args)]
pub struct CompareOptions {
    /// A report's folder
    #[arg(value_name = "A")]
    pub a: PathBuf,
    /// The folder of the one that is held against it
    #[arg(value_name = "B")]
    pub b: PathBuf,
    /// End with exit code 1 if the whole interval of a pass lies beyond this, as 5%
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub fail_if_slower: Option<f64>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// A part of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PartName {
    /// The device, its driver and limits
    Device,
    /// Every kernel on known inputs, held against f64
    Check,
    /// A capture, and two deterministic runs that have to end alike
    Runs,
    /// Time of every pass at rising numbers of particles, beside what bounds it
    Scaling,
    /// Pictures of 1920 x 1080 by every surface, pass by pass
    Pictures,
    /// Ways to sort
    Sorting,
    /// Steps in one submission, and what timestamps cost
    Submissions,
    /// Error against time
    Errors,
    /// Extreme cases
    Extremes,
}

impl PartName {
    /// As it is written on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Device => "device",
            Self::Check => "check",
            Self::Runs => "runs",
            Self::Scaling => "scaling",
            Self::Pictures => "pictures",
            Self::Sorting => "sorting",
            Self::Submissions => "submissions",
            Self::Errors => "errors",
            Self::Extremes => "extremes",
        }
    }
}

/// A positive number of minutes, at most a day.
fn minutes(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(minutes) if (0.5..=1440.0).contains(&minutes) => Ok(minutes),
        _ => Err("must be a number of minutes from 0.5 to 1440".into()),
    }
}
