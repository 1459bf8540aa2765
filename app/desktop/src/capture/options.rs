//! `brooklet capture` on the command line.

use std::path::PathBuf;

use clap::{Args, Subcommand};

/// What to do with a capture.
#[derive(Clone, Debug, Subcommand)]
pub enum CaptureCommand {
    /// Show what a capture says: frames, passes, how far its times can be believed
    Summary(SummaryOptions),
    /// Compare B with A, pass by pass: ratios of medians with intervals
    Compare(CompareOptions),
    /// Check each message against its schema, times, damage and counts
    Check(CheckOptions),
    /// Write a capture as CSV, or as a trace that Perfetto opens
    Export(ExportOptions),
    /// Write everything whole of a damaged or cut capture to a new file
    Recover(RecoverOptions),
}

/// `brooklet capture summary`.
#[derive(Clone, Debug, Args)]
pub struct SummaryOptions {
    /// The capture
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Also draw the passes, as an SVG picture
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Print the summary as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet capture compare`.
#[derive(Clone, Debug, Args)]
pub struct CompareOptions {
    /// The capture to compare with
    #[arg(value_name = "A")]
    pub a: PathBuf,
    /// The capture that is compared
    #[arg(value_name = "B")]
    pub b: PathBuf,
    /// End with exit code 1 if the whole interval of a pass lies beyond this, as 5%
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub fail_if_slower: Option<f64>,
    /// Compare captures of different scenes all the same
    #[arg(long)]
    pub anyway: bool,
    /// Also draw the ratios and their intervals, as an SVG picture
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Print the comparison as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet capture check`.
#[derive(Clone, Debug, Args)]
pub struct CheckOptions {
    /// The capture
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Print what was found as JSON
    #[arg(long)]
    pub json: bool,
}

/// `brooklet capture export`.
#[derive(Clone, Debug, Args)]
#[command(group = clap::ArgGroup::new("format").required(true).multiple(true))]
pub struct ExportOptions {
    /// The capture
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Write a table of each topic of numbers into this folder, which is created; one that exists is kept, and a
    /// number is added
    #[arg(long, value_name = "DIR", group = "format")]
    pub csv: Option<PathBuf>,
    /// Write a Chrome trace (JSON), which ui.perfetto.dev opens; replaced if it exists
    #[arg(long, value_name = "FILE", group = "format")]
    pub chrome_trace: Option<PathBuf>,
}

/// `brooklet capture recover`.
#[derive(Clone, Debug, Args)]
pub struct RecoverOptions {
    /// The capture, which stays as it is
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The new file, FILE with -recovered in its name if not given. One that exists is kept, and an error
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// `5%`, or `0.05`.
pub fn share(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.strip_suffix('%') {
        Some(percent) => (percent.trim(), 0.01),
        None => (text, 1.0),
    };
    let share = number.parse::<f64>().ok().map(|number| number * unit);
    share.filter(|share| (0.0..=10.0).contains(share)).ok_or("must be a share from 0 to 10, as 5% or 0.05".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_percent_or_plain() {
        assert_eq!((share("5%"), share("0.05"), share("0"), share("50 %")), (Ok(0.05), Ok(0.05), Ok(0.0), Ok(0.5)));
        assert!(["", "%", "-1%", "nan", "inf", "1001%", "five"].iter().all(|text| share(text).is_err()));
    }
}
