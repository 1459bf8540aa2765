//! `brooklet-compiler build | check | lint`: see the library.

use std::path::PathBuf;
use std::process::ExitCode;

use brooklet_compiler::{Places, problem::Problems};
use clap::{Args, Parser, Subcommand};

/// Compiles HLSL kernels to SPIR-V and to typed Rust bindings.
#[derive(Parser)]
#[command(name = "brooklet-compiler", version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Compile every kernel and variant, and write what changed.
    Build(PlaceArguments),
    /// Compile everything anew with the pinned DXC and compare bytes; exit 1 if anything is stale.
    Check(PlaceArguments),
    /// Compile and hold every module against the device tiers; write nothing; exit 1 if one is refused.
    Lint(PlaceArguments),
}

#[derive(Args)]
struct PlaceArguments {
    /// Folder of shaders [default: shaders/hlsl of this repository].
    #[arg(long)]
    shaders: Option<PathBuf>,
    /// Folder that gets src/generated, spirv and manifest.json [default: app/kernels, and app/bench for what only
    /// benchmarks run].
    #[arg(long)]
    out: Option<PathBuf>,
}

impl PlaceArguments {
    fn places(self) -> Result<Places, Problems> {
        Ok(match (self.shaders, self.out) {
            (Some(shaders), Some(out)) => Places {
                shaders,
                out,
                parts: Vec::new(),
                // A folder of any project: its own repository's target, or the folder's own.
                target: Places::of_repository().map_or_else(|_| PathBuf::from("target"), |places| places.target),
            },
            (shaders, out) => {
                let own = Places::of_repository()?;
                // What is written elsewhere is all written there.
                let parts = if out.is_some() { Vec::new() } else { own.parts };
                let shaders = shaders.unwrap_or(own.shaders);
                Places { shaders, out: out.unwrap_or(own.out), parts, target: own.target }
            }
        })
    }
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Build(places) => places.places().and_then(build),
        Command::Check(places) => places.places().and_then(check),
        Command::Lint(places) => places.places().and_then(lint),
    };
    result.unwrap_or_else(|problems| {
        eprintln!("{problems}");
        ExitCode::from(2)
    })
}

fn build(places: Places) -> Result<ExitCode, Problems> {
    let report = brooklet_compiler::build(&places)?;
    for path in &report.changed {
        println!("  {path}");
    }
    println!(
        "{} modules of {} variants, {} KiB; {} files changed",
        report.modules,
        report.variants,
        report.bytes / 1024,
        report.changed.len()
    );
    Ok(ExitCode::SUCCESS)
}

fn check(places: Places) -> Result<ExitCode, Problems> {
    let differences = brooklet_compiler::check(&places)?;
    if differences.is_empty() {
        println!("every generated file is fresh");
        return Ok(ExitCode::SUCCESS);
    }
    for difference in &differences {
        println!("{difference}");
    }
    println!("run `cargo run -p brooklet-compiler -- build` and commit what it writes");
    Ok(ExitCode::from(1))
}

fn lint(places: Places) -> Result<ExitCode, Problems> {
    let manifests = match brooklet_compiler::lint(&places) {
        Ok(manifests) => manifests,
        Err(problems) => {
            eprintln!("{problems}");
            return Ok(ExitCode::from(1));
        }
    };
    let modules = || manifests.iter().flat_map(|manifest| &manifest.modules);
    for module in modules() {
        let [x, y, z] = module.group_size;
        println!(
            "{:<8} {:<44} {:>4} threads {:>6} B shared {:>2} bindings {:>7} B",
            module.tier,
            module.name,
            x * y * z,
            module.shared_bytes,
            module.bindings.len(),
            module.bytes
        );
    }
    println!("{} modules, all within their tiers", modules().count());
    Ok(ExitCode::SUCCESS)
}
