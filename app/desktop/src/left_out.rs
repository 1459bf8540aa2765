//! Commands that this build leaves out.

use std::ffi::OsString;

use clap::{CommandFactory, error::ErrorKind};

use crate::{cli::Cli, failure::Failure};

/// Each command that a feature brings, and whether this build has it.
const COMMANDS: [(&str, bool); 6] = [
    ("view", cfg!(feature = "window")),
    ("bench", cfg!(feature = "bench")),
    ("study", cfg!(feature = "study")),
    ("tune", cfg!(feature = "study")),
    ("capture", cfg!(feature = "captures")),
    ("report", cfg!(feature = "report")),
];

/// Says how to get the command; any other word is a mistake, told as clap tells it.
pub fn left_out(words: &[OsString]) -> Result<(), Failure> {
    let name = words.first().map(|word| word.to_string_lossy()).unwrap_or_default();
    if COMMANDS.iter().any(|(command, here)| *command == name && !here) {
        return Err(Failure::Input(format!(
            "this build leaves `brooklet {name}` out; `cargo run --release -- {name}` builds and runs the whole program"
        )));
    }
    Cli::command().error(ErrorKind::InvalidSubcommand, format!("unrecognized subcommand '{name}'")).exit()
}
