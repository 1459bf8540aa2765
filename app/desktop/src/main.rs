//! The `brooklet` program.
//!
//! Exit codes: 0; 1 the job could not be done to its end; 2 bad input, or no device for it;
//! 130 Ctrl-C.

#[macro_use]
mod stdout;

mod bench;
mod capture;
mod cli;
mod commit;
mod doctor;
mod failure;
mod fit;
mod interrupt;
mod job;
mod measured;
mod out_dir;
mod pictures;
mod plan;
mod ply;
mod progress;
mod recorder;
mod run;
mod running;
mod scenes;
mod shared_options;
mod study;
mod summary;
mod table;
mod timings;
mod tune;
mod view;
mod view_options;

use std::{io::Write, process::ExitCode};

use clap::Parser;

use cli::{Cli, Command};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let result = match &cli.command {
        Command::Run(options) => run::run(options),
        Command::View(options) => view::view(options),
        Command::Plan(options) => plan::plan(options),
        Command::Scenes(options) => scenes::scenes(options),
        Command::Bench(options) => bench::bench(options),
        Command::Study(options) => study::study(options),
        Command::Tune(options) => tune::tune(options),
        Command::Capture(command) => capture::capture(command),
        Command::Doctor(options) => doctor::doctor(options),
    };
    // The job's own failure says more than that of its table.
    match result.and(stdout::finish()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // Where even this cannot be written, the exit code still tells.
            let _ = writeln!(std::io::stderr(), "{failure}");
            failure.exit_code()
        }
    }
}
