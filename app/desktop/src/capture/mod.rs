//! `brooklet capture`: what captures say, whether they can be believed, and against each other.

mod check;
mod compare;
mod export;
mod options;
mod plot;
mod recover;
mod summary;

use crate::failure::Failure;

pub use compare::{compare as compare_captures, judge};
pub use options::{CaptureCommand, CompareOptions as CaptureCompare, share};

/// Does it.
pub fn capture(command: &CaptureCommand) -> Result<(), Failure> {
    match command {
        CaptureCommand::Summary(options) => summary::summary(options),
        CaptureCommand::Compare(options) => compare::compare(options),
        CaptureCommand::Check(options) => check::check(options),
        CaptureCommand::Export(options) => export::export(options),
        CaptureCommand::Recover(options) => recover::recover(options),
    }
}
