//! The `brooklet` program.
//!
//! Exit codes: 0; 1 the job could not be done to its end; 2 bad input, or no device for it;
//! 130 Ctrl-C.

#[macro_use]
mod stdout;

#[cfg(feature = "bench")]
mod bench;
#[cfg(feature = "bench")]
mod bench_options;
#[cfg(feature = "captures")]
mod capture;
#[cfg(feature = "check")]
mod check;
#[cfg(feature = "check")]
mod check_capture;
#[cfg(feature = "check")]
mod check_words;
mod cli;
#[cfg(feature = "clip")]
mod clip;
mod commit;
mod doctor;
mod drawn_meshes;
mod estimate_spacing;
mod failure;
mod interrupt;
mod job;
#[cfg(not(all(feature = "window", feature = "bench", feature = "study", feature = "captures", feature = "report")))]
mod left_out;
mod measured;
mod mesh;
mod mesh_file;
mod mesh_options;
mod out_dir;
mod pictures;
mod plan;
mod ply;
mod point_cloud;
mod progress;
mod recorder;
#[cfg(feature = "report")]
mod report;
#[cfg(feature = "report")]
mod report_options;
mod run;
mod run_mesh;
mod running;
mod scenes;
mod shared_options;
mod spacing;
mod start_run;
#[cfg(feature = "study")]
mod study;
#[cfg(feature = "study")]
mod study_options;
mod summary;
mod table;
#[cfg(feature = "study")]
mod tune;
#[cfg(feature = "window")]
mod view;
#[cfg(feature = "window")]
mod view_options;

use std::{io::Write, process::ExitCode};

use clap::Parser;

use cli::{Cli, Command};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let result = match &cli.command {
        Command::Run(options) => run::run(options),
        #[cfg(feature = "window")]
        Command::View(options) => view::view(options),
        Command::Plan(options) => plan::plan(options),
        Command::Mesh(options) => mesh::mesh(options),
        Command::Scenes(options) => scenes::scenes(options),
        #[cfg(feature = "bench")]
        Command::Bench(options) => bench::bench(options),
        #[cfg(feature = "study")]
        Command::Study(options) => study::study(options),
        #[cfg(feature = "study")]
        Command::Tune(options) => tune::tune(options),
        #[cfg(feature = "captures")]
        Command::Capture(command) => capture::capture(command),
        #[cfg(feature = "report")]
        Command::Report(options) => report::report(options),
        Command::Doctor(options) => doctor::doctor(options),
        #[cfg(not(all(
            feature = "window",
            feature = "bench",
            feature = "study",
            feature = "captures",
            feature = "report"
        )))]
        Command::LeftOut(words) => left_out::left_out(words),
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
