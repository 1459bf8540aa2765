//! The steps that the source papers timed, at their numbers of particles, by every solver: beside each the paper's own
//! figure and its card.

use std::time::Instant;

use brooklet_fluid::scene::{Method, Scene};
use brooklet_gpu::{Gpu, Quantiles, tier_name};
use serde::Serialize;

use crate::{
    BenchError, Observer,
    figures::LeftOut,
    stepping::{LEAST_STEPS, pace},
    workload,
};

/// A figure of a paper's.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Published {
    /// Who.
    pub paper: &'static str,
    /// With what.
    pub card: &'static str,
    /// By which solver.
    pub method: &'static str,
    /// Number of particles.
    pub particles: u32,
    /// Of a step or a frame, ms; none where it was shown and not timed.
    pub step_ms: Option<f64>,
    /// What is in it.
    pub what: &'static str,
}

const MULLER: &str = "Müller, Charypar & Gross 2003";
const HARADA: &str = "Harada, Koshizuka & Kawaguchi 2007";
const TANG: &str = "Tang, Wu & Zhou";
const DECK: &str = "the mobile deck";

const fn muller(frames_per_s: f64, what: &'static str) -> Published {
    let (card, step_ms) = ("Pentium 4 at 1.8 GHz, GeForce 4", Some(1e3 / frames_per_s));
    Published { paper: MULLER, card, method: "sph", particles: 2200, step_ms, what }
}

const fn harada(particles: u32, step_ms: f64) -> Published {
    let card = "GeForce 8800 GTX";
    Published { paper: HARADA, card, method: "sph", particles, step_ms: Some(step_ms), what: "a step, drawn" }
}

const fn tang(particles: u32, frames_per_s: f64) -> Published {
    let step_ms = Some(1e3 / frames_per_s);
    Published { paper: TANG, card: "GeForce GTX 570", method: "sph", particles, step_ms, what: "a frame, no surface" }
}

const fn deck(particles: u32, frames_per_s: f64) -> Published {
    let step_ms = Some(1e3 / frames_per_s);
    let what = "a frame, 6 iterations, not drawn";
    Published { paper: DECK, card: "GeForce GTX 750 Ti", method: "pbf", particles, step_ms, what }
}

/// All rows of the papers' tables. Harada's second reads 16,386, which no texture is: its neighbours are powers of 4.
pub const PUBLISHED: &[Published] = &[
    harada(1024, 3.9),
    muller(20.0, "a frame, points or splats"),
    muller(5.0, "a frame, marching cubes"),
    harada(4096, 5.45),
    harada(16_384, 14.8),
    deck(27_000, 75.0),
    deck(64_000, 45.0),
    harada(65_536, 58.6),
    tang(65_536, 98.1),
    deck(125_000, 25.0),
    Published {
        paper: DECK,
        card: "GeForce GTX 750 Ti",
        method: "sph",
        particles: 125_000,
        step_ms: None,
        what: "a film beside PBF's",
    },
    tang(131_072, 42.2),
    deck(216_000, 15.0),
    harada(262_144, 235.9),
    tang(262_144, 18.8),
    harada(1_048_576, 1096.8),
    harada(4_194_304, 3783.6),
];

/// What is timed.
#[derive(Clone, Debug)]
pub struct Options {
    /// What is changed of the workload.
    pub settings: Vec<String>,
    /// The largest number of particles.
    pub max_particles: u32,
    /// Time for the whole table, s: what would take longer is left out.
    pub budget_s: f64,
}

/// A number of particles with a solver.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Number of particles.
    pub particles: u32,
    /// The solver.
    pub method: &'static str,
    /// Iterations of a step, of solvers that iterate.
    pub iterations: Option<u32>,
    /// Steps that were timed.
    pub steps: u64,
    /// Of one, ms.
    pub step_ms: Quantiles,
    /// What a step advances, s.
    pub dt_s: f64,
    /// GPU time of a simulated second, s.
    pub s_per_s: f64,
    /// Of GPU memory, over the particles.
    pub bytes_per_particle: f64,
    /// What papers have of the same number by the same solver.
    pub published: Vec<Published>,
}

/// The table.
#[derive(Clone, Debug, Serialize)]
pub struct Papers {
    /// What it ran on.
    pub device: String,
    /// `cpu` of a driver that runs on the processor.
    pub device_type: String,
    /// The driver and its version.
    pub driver: String,
    /// What the device was used as.
    pub tier: &'static str,
    /// By number of particles, then by solver.
    pub rows: Vec<Row>,
    /// What has no row, and why.
    pub left_out: Vec<LeftOut>,
}

/// Times every solver at every number of particles that fits the budget, smallest first.
///
/// # Errors
/// Every [`BenchError`].
pub fn run(gpu: &Gpu, options: &Options, observer: &dyn Observer) -> Result<Papers, BenchError> {
    let methods: Vec<&'static str> = solvers();
    let mut sizes: Vec<u32> = PUBLISHED.iter().map(|row| row.particles).collect();
    sizes.dedup();
    sizes.retain(|&particles| particles <= options.max_particles);
    // A setting that no scene takes is told before anything runs.
    for method in &methods {
        scene(PUBLISHED[0].particles, method, &options.settings)?;
    }
    observer.begin((sizes.len() * methods.len()) as u64);
    let begun = Instant::now();
    let (mut rows, mut left_out) = (Vec::new(), Vec::new());
    let mut step_s_per_particle = vec![0.0_f64; methods.len()];
    for (nth, &particles) in sizes.iter().enumerate() {
        for (method, slowest) in methods.iter().zip(&mut step_s_per_particle) {
            observer.message(format!("{particles} particles, {method}"));
            let remaining_s = options.budget_s - begun.elapsed().as_secs_f64();
            let least_s = *slowest * f64::from(particles) * LEAST_STEPS as f64;
            let left = |reason: String| LeftOut { particles, reason: format!("{method}: {reason}") };
            if least_s > remaining_s {
                left_out.push(left(format!("--budget {} leaves no time for it", options.budget_s)));
            } else {
                let share_s = remaining_s / ((sizes.len() - nth) * methods.len()) as f64;
                match row(gpu, particles, method, options, share_s, observer) {
                    Ok((row, step_s)) => {
                        *slowest = slowest.max(step_s / f64::from(particles));
                        rows.push(row);
                    }
                    // The device says which buffer is too large for it, or for its memory.
                    Err(BenchError::Input(reason)) => left_out.push(left(reason)),
                    Err(error) => return Err(error),
                }
                // A smaller one's memory would only lie in the way.
                gpu.trim();
            }
            observer.advance();
        }
    }
    let info = gpu.info();
    Ok(Papers {
        device: info.name.clone(),
        device_type: info.device_type.clone(),
        driver: format!("{} {}", info.driver, info.driver_info),
        tier: tier_name(gpu.tier()),
        rows,
        left_out,
    })
}

/// Every solver whose particles interact.
fn solvers() -> Vec<&'static str> {
    let interacts = |name: &&&str| {
        let scene = workload::block(BOX_OF_8, workload::SPACING_M, 1.0 / 240.0, &[format!("solver.method={name}")]);
        scene.is_ok_and(|scene| scene.solver.method.interacts())
    };
    Method::NAMES.iter().filter(interacts).copied().collect()
}

const BOX_OF_8: [u32; 3] = [2, 2, 2];

/// A block at rest of so many particles, solved so. Iterations are the deck's 6; an explicit solver steps as far as its
/// sound allows, once a step, as the papers' do.
fn scene(particles: u32, method: &str, settings: &[String]) -> Result<Scene, BenchError> {
    let edges = edges(particles);
    let own: &[&str] = match method {
        "pbf" => &["solver.pbf.iterations=6", "solver.pbf.relaxation=0.5"],
        "sph" => &["solver.sph.adaptive_substeps=false"],
        // As a phone runs it: as many iterations a step at any size.
        "dfsph" => &[
            "solver.dfsph.fixed_iterations=true",
            "solver.dfsph.max_divergence_iterations=2",
            "solver.dfsph.max_density_iterations=1",
        ],
        _ => &[],
    };
    let all: Vec<String> = std::iter::once(format!("solver.method={method}"))
        .chain(own.iter().map(|&setting| setting.into()))
        .chain(settings.iter().cloned())
        .collect();
    let dt_s = workload::calm_dt_s(edges[1]);
    let scene = workload::block(edges, workload::SPACING_M, dt_s, &all)?;
    match method {
        "sph" => {
            let limit_s = OF_THE_LIMIT * scene.sound_limit_s().min(scene.steady_limit_s());
            workload::block(edges, workload::SPACING_M, limit_s, &all)
        }
        _ => Ok(scene),
    }
}

/// Of the longest substep: room for the first hits of a jittered lattice.
const OF_THE_LIMIT: f64 = 0.8;

/// Whole edges of a block of so many particles: as near a cube as its divisors allow, the least upwards.
fn edges(particles: u32) -> [u32; 3] {
    let largest = |of: u32, root: f64| {
        let from = (f64::from(of).powf(root) + 1e-9) as u32;
        (1..=from.max(1)).rev().find(|edge| of.is_multiple_of(*edge)).unwrap_or(1)
    };
    let first = largest(particles, 1.0 / 3.0);
    let second = largest(particles / first, 0.5);
    let mut edges = [first, second, particles / first / second];
    edges.sort_unstable();
    let [up, across, along] = edges;
    [along, up, across]
}

fn row(
    gpu: &Gpu,
    particles: u32,
    method: &'static str,
    options: &Options,
    share_s: f64,
    observer: &dyn Observer,
) -> Result<(Row, f64), BenchError> {
    let scene = scene(particles, method, &options.settings)?;
    let paced = pace(gpu, &scene, false, share_s, observer)?;
    let step_ms = paced.timings.step_ms();
    let step_ms = step_ms.ok_or_else(|| {
        BenchError::Stopped(format!("no usable times: {} flagged spans", paced.timings.flagged_spans()))
    })?;
    let session = &paced.session;
    let dt_s = scene.solver.dt_s;
    let same = |row: &&Published| row.particles == particles && row.method == method;
    let row = Row {
        particles,
        method,
        iterations: scene.solver.iterations(),
        steps: paced.steps,
        step_ms,
        dt_s,
        s_per_s: step_ms.median * 1e-3 / dt_s,
        bytes_per_particle: session.recorded().bytes_per_particle(session.engine().plan()).unwrap_or_default(),
        published: PUBLISHED.iter().filter(same).copied().collect(),
    };
    Ok((row, paced.step_s))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_of_the_papers_is_a_block_that_every_solver_steps() {
        let methods = solvers();
        assert!(methods.contains(&"pbf") && methods.contains(&"sph") && !methods.contains(&"none"), "{methods:?}");
        for published in PUBLISHED {
            assert!(methods.contains(&published.method), "{published:?}");
            let [x, y, z] = edges(published.particles);
            assert_eq!(x * y * z, published.particles);
            assert!(y <= z && z <= x && x <= 4 * y, "{}: {:?}", published.particles, [x, y, z]);
        }
        for method in methods {
            let scene = scene(1024, method, &[]).unwrap();
            assert_eq!((scene.particle_count(), scene.substeps()), (1024, 1), "{method}");
        }
        assert!(PUBLISHED.is_sorted_by_key(|row| row.particles));
        assert!(scene(1024, "pbf", &["forces.xsph=2".into()]).is_err());
    }

    #[test]
    fn frame_rates_become_times() {
        let of = |paper, particles| {
            PUBLISHED.iter().find(|row| row.paper == paper && row.particles == particles).unwrap().step_ms.unwrap()
        };
        assert!((of(TANG, 131_072) - 23.70).abs() < 0.01 && (of(DECK, 125_000) - 40.0).abs() < 1e-9);
        assert_eq!((of(HARADA, 4_194_304), of(MULLER, 2200)), (3783.6, 50.0));
    }
}
