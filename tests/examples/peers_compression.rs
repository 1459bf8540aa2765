//! Compression on the workload of the peers, as a table. Arguments: the spacing in metres (0.02 is
//! 31k particles, the default), then settings of the scene as `path=value`:
//! `cargo run --release -p brooklet-tests --example peers_compression -- 0.02 solver.substeps=2`

use brooklet_reference::compression::{Compression, Summary};
use brooklet_tests::peers;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).peekable();
    let first = arguments.peek().filter(|text| !text.contains('=')).cloned();
    let spacing_m = match first.as_deref().unwrap_or("0.02").parse::<f64>() {
        Ok(spacing_m) => spacing_m,
        Err(error) => return refuse(&format!("{first:?} is neither a spacing in metres nor path=value: {error}")),
    };
    let settings: Vec<String> = arguments.skip(usize::from(first.is_some())).collect();
    let scene = match peers::scene(spacing_m, &settings) {
        Ok(scene) => scene,
        Err(error) => return refuse(&error),
    };
    let start = Instant::now();
    match peers::run(&scene) {
        Ok(snapshots) => {
            let steps = 1.0 / scene.solver.dt_s;
            println!("compression in %, mean / p99 / max; spacing {spacing_m} m {}", settings.join(" "));
            println!(
                "{:<8} {:<22} {:<22} {:<22} {:>8} {:>8}",
                "", "all", "within 2 d of a wall", "inside", "front m", "height m"
            );
            for snapshot in &snapshots {
                let place = format!("{:>8.3} {:>8.4}", snapshot.front_m, snapshot.height_m);
                println!("{:<8} {} {place}", format!("{:.1} s", snapshot.time_s), row(&snapshot.compression));
            }
            println!("{:<8} {}", "average", row(&peers::average(&snapshots)));
            println!(
                "SPlisHSPlasH's PBF at 0.02 m: all 1.3 / - / 19; {:.1} ms a step here, snapshots included",
                start.elapsed().as_secs_f64() * 1e3 / steps
            );
            ExitCode::SUCCESS
        }
        Err(error) => refuse(&error),
    }
}

fn row(compression: &Compression) -> String {
    let summary = |s: Summary| format!("{:5.2} / {:5.2} / {:6.2}", 100.0 * s.mean, 100.0 * s.p99, 100.0 * s.max);
    [compression.all, compression.wall, compression.inner].map(summary).map(|text| format!("{text:<22}")).join(" ")
}

fn refuse(reason: &str) -> ExitCode {
    eprintln!("{reason}");
    ExitCode::from(2)
}
