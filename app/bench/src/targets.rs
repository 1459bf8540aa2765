//! What the table is held against: set for two CPU cores, where a real GPU meets the rates easily.

use super::{
    figures::{Row, Verdict},
    workload::LOADS,
};

/// Particle iterations a second with the default terms.
pub const DEFAULT_RATE: f64 = 4.5e6;
/// The same with every term, and measuring.
pub const EVERY_TERM_RATE: f64 = 3.5e6;
const FLATNESS: f64 = 1.5;
const GRID_SHARE: f64 = 0.10;
const BYTES_PER_PARTICLE: f64 = 320.0;
/// Below so many particles a step is over before a device is busy.
const SMALLEST: u32 = 27_000;
const RATE_SIZES: [u32; 2] = [27_000, 125_000];

/// Each target for which the table has figures.
pub fn verdicts(rows: &[Row]) -> Vec<Verdict> {
    let mut all = Vec::new();
    let mut hold = |name: String, measured: Option<f64>, target: f64, at_least: bool| {
        if let Some(measured) = measured {
            let met = if at_least { measured >= target } else { measured <= target };
            all.push(Verdict { name, target, measured, met, at_least });
        }
    };
    for (load, target) in [(LOADS[0], DEFAULT_RATE), (LOADS[2], EVERY_TERM_RATE)] {
        for size in RATE_SIZES {
            let found = rows.iter().find(|row| row.particles == size && row.is_of(load));
            let rate = found.map(|row| row.particle_iterations_per_s);
            hold(format!("particle iterations a second, {}, {size}", load.terms()), rate, target, true);
        }
    }
    let large = || rows.iter().filter(|row| row.particles >= SMALLEST);
    let costs: Vec<f64> = large().filter(|row| row.is_of(LOADS[0])).map(|row| row.ns_per_particle_iteration).collect();
    if let (Some(most), Some(least), Some(last)) = (largest(&costs), smallest(&costs), large().next_back())
        && costs.len() > 1
    {
        let name = format!("cost of a particle, largest over smallest, {SMALLEST} to {}", last.particles);
        hold(name, Some(most / least), FLATNESS, false);
    }
    let shares: Vec<f64> = large().map(|row| row.grid_share).collect();
    hold(format!("share of the grid in a step, from {SMALLEST}"), largest(&shares), GRID_SHARE, false);
    let bytes: Vec<f64> = large().map(|row| row.bytes_per_particle).collect();
    hold(format!("bytes a particle, from {SMALLEST}"), largest(&bytes), BYTES_PER_PARTICLE, false);
    all
}

fn largest(values: &[f64]) -> Option<f64> {
    values.iter().copied().max_by(f64::total_cmp)
}

fn smallest(values: &[f64]) -> Option<f64> {
    values.iter().copied().min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_gpu::{Passes, Quantiles};

    fn row(particles: u32, every_term: bool, rate: f64) -> Row {
        Row {
            particles,
            load: if every_term { LOADS[2] } else { LOADS[0] },
            terms: "",
            iterations: 4,
            steps: 5,
            step_ms: Quantiles { median: 1.0, p95: 1.0 },
            measure_ms: 0.0,
            particle_iterations_per_s: rate,
            ns_per_particle_iteration: 1e9 / rate,
            bytes: 0,
            bytes_per_particle: 320.0,
            neighbours_mean: 27.0,
            grid_share: 0.05,
            furthest_from_bound: None,
            passes: Passes(Vec::new()),
            flagged_spans: 0,
        }
    }

    #[test]
    fn each_target_can_be_met_and_missed() {
        let good = [row(4096, false, 1e6), row(27_000, false, 6e6), row(27_000, true, 4e6), row(125_000, false, 5e6)];
        let verdicts_of = verdicts(&good);
        assert_eq!(verdicts_of.len(), 6);
        assert!(verdicts_of.iter().all(|verdict| verdict.met), "{verdicts_of:?}");
        let mut bad = good.to_vec();
        for row in &mut bad {
            row.particle_iterations_per_s = 1e6;
            row.grid_share = 0.11;
            row.bytes_per_particle = 321.0;
        }
        bad[3].ns_per_particle_iteration *= 2.0;
        assert!(verdicts(&bad).iter().all(|verdict| !verdict.met));
        assert!(verdicts(&[]).is_empty());
    }
}
