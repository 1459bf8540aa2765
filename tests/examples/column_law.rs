//! The column law measured: a column of 60 layers for 4, 8 and 16 iterations, substeps against
//! iterations at the same total, 200 layers, and what the width between the walls changes.
//! `cargo run --release -p brooklet-tests --example column_law`

use brooklet_fluid::scene::Acceleration;
use brooklet_tests::column::{Settled, Setup};

const COLUMN: Setup =
    Setup { layers: 60, width: 6, iterations: 4, substeps: 1, dt_s: 1.0 / 240.0, acceleration: Acceleration::None };

fn main() {
    println!("layers width  substeps x iterations    dt ms   law    measured  ratio  swings by");
    for compression in [0.05, 0.1, 0.15] {
        for iterations in [4, 8, 16] {
            row(&Setup { iterations, ..COLUMN }.at(compression));
        }
    }
    println!("\nsubsteps against iterations, 16 in all a step");
    let step = Setup { iterations: 16, ..COLUMN }.at(0.15);
    let settled: Vec<(u32, Settled)> =
        [1, 2, 4, 8, 16].map(|substeps| (substeps, row(&Setup { substeps, iterations: 16 / substeps, ..step }))).into();
    println!(
        "\ncompression of each layer (top first), 16 iterations in all; \
         1, 2, 4, 8, S: substeps (S: 16); a column of the plot is 0.3 %"
    );
    for layer in (0..60).rev().step_by(4) {
        let mut line = vec![b' '; 52];
        for (substeps, settled) in &settled {
            let place = (settled.layers[layer] / 0.003).round() as usize;
            line[place.min(51)] = b"1248S"[substeps.ilog2() as usize];
        }
        println!("{layer:>3} |{}", String::from_utf8_lossy(&line).trim_end());
    }
    println!("\nother heights and widths");
    for layers in [20, 200] {
        row(&Setup { layers, width: 4, ..COLUMN }.at(0.15));
    }
    for width in [4, 6, 8, 12] {
        row(&Setup { width, ..COLUMN }.at(0.1));
    }
}

fn row(setup: &Setup) -> Settled {
    let settled = setup.settle();
    println!(
        "{:>6} {:>5}  {:>8} x {:<10} {:>9.3}  {:.4}  {:.4}    {:.3}  {:.4}",
        setup.layers,
        setup.width,
        setup.substeps,
        setup.iterations,
        1e3 * setup.dt_s,
        settled.law,
        settled.bottom,
        settled.bottom / settled.law,
        settled.unrest
    );
    settled
}
