//! `brooklet capture check`.

use super::options::CheckOptions;
use crate::failure::Failure;

/// Prints whether a capture keeps what its format promises.
pub fn check(options: &CheckOptions) -> Result<(), Failure> {
    let report = brooklet_capture::check(&options.file).map_err(Failure::input)?;
    if options.json {
        say!("{}", serde_json::to_string_pretty(&report).map_err(Failure::stopped)?);
    } else {
        let messages: u64 = report.topics.values().sum();
        say!("{messages} messages on {} topics in {} chunks", report.topics.len(), report.ending.chunks);
        for (topic, count) in &report.topics {
            say!("  {topic} {count}");
        }
        for note in &report.notes {
            say!("note: {note}");
        }
        for problem in &report.problems {
            say!("wrong: {problem}");
        }
        let untold = report.problem_count - report.problems.len() as u64;
        if untold > 0 {
            say!("and {untold} more");
        }
        if report.is_good() {
            say!("each message fits its schema, and log_time never goes back");
        }
    }
    if report.is_good() {
        return Ok(());
    }
    Err(Failure::Stopped(format!("{}: {} things are wrong", options.file.display(), report.problem_count)))
}
