//! What lower precision and smaller tiers cost: every shipped scene, run in each way, against `full` on the desktop tier.
//!
//! A flow is chaotic: where particles were once moved by no more than a packed position rounds, a run of `full` ends
//! elsewhere too. So each way's difference is told beside the largest of `full` runs that were shaken so, and may be as
//! large as a few of it.

mod compare;
mod course;

pub use compare::{FULL, QUANTITIES, Quantity};

use brooklet_fluid::particles::{ParticleSet, sample_lattice};
use brooklet_fluid::scene::{SurfaceMethod, shipped_scenes};
use brooklet_fluid::{Scene, relax_particles};
use brooklet_gpu::{Tier, tier_name};

use crate::session::{Session, StudyError};
use crate::setup::rounds_a_step;
use crate::{Outcome, State, Task};
use compare::figures;
use course::{Course, Looks};

/// Part of a study.
pub const PART: &str = "precision";

/// One way to run a scene.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Its name.
    pub name: &'static str,
    tier: Tier,
    precision: &'static str,
}

/// What is held against `full`.
pub const WAYS: [Way; 3] = [
    Way { name: "mobile", tier: Tier::Mobile, precision: "relaxed" },
    Way { name: "floor", tier: Tier::Floor, precision: "relaxed" },
    Way { name: "half", tier: Tier::Desktop, precision: "half" },
];

const FULL_WAY: Way = Way { name: FULL, tier: Tier::Desktop, precision: "full" };

/// Name of what the flow itself makes of a rounding: the largest of so many runs of `full`.
pub const SHAKEN: &str = "full, shaken";
const SHAKEN_RUNS: u64 = 3;
const RUNS: u64 = 1 + SHAKEN_RUNS + WAYS.len() as u64;

/// As many particles as the phone scenes have at most.
const MOST_PARTICLES: f64 = 5000.0;
const QUICK_PARTICLES: f64 = 600.0;
/// The one scene of a quick look.
const QUICK: &str = "dam-break";
/// s; shorter where a scene is.
const END_S: f64 = 1.0;
const QUICK_END_S: f64 = 0.1;
/// Of a picture, px.
const SIZE_PX: [u32; 2] = [480, 270];
/// A position of 16 bits over 4 h rounds to half of this share of h.
const ROUNDING: f64 = 4.0 / 65_536.0;

/// Each shipped scene.
pub fn tasks(quick: bool) -> Vec<Task> {
    let wanted = |name: &str| !quick || name == QUICK;
    let (most, end_s) = if quick { (QUICK_PARTICLES, QUICK_END_S) } else { (MOST_PARTICLES, END_S) };
    shipped_scenes().filter(|(name, _)| wanted(name)).map(|(name, _)| task(name, most, end_s)).collect()
}

fn task(name: &str, most: f64, end_s: f64) -> Task {
    let mut settings = vec![
        format!("outputs.width_px={}", SIZE_PX[0]),
        format!("outputs.height_px={}", SIZE_PX[1]),
        "outputs.images=1".into(),
        "outputs.measure_every_steps=1".into(),
    ];
    // Every shipped scene loads, which a test holds.
    if let Ok(scene) = Scene::load(name, &[]) {
        settings.push(format!("outputs.seconds={}", end_s.min(scene.outputs.seconds)));
        if scene.surface.method != SurfaceMethod::Points {
            // By default the desktop tier alone has them: a choice of look, and no error.
            settings.extend(["caustics", "self_shadow"].map(|light| format!("surface.{light}=false")));
        }
        let wider = (scene.particle_count() as f64 / most).cbrt();
        if wider > 1.0 {
            settings.push(format!("spacing_m={:.4}", wider * scene.spacing_m));
        }
    }
    Task { part: PART.into(), case: name.into(), settings, tier: tier_name(Tier::Desktop).into(), repeats: 1 }
}

/// Particle iterations of a scene in all ways.
pub fn cost(task: &Task) -> Option<f64> {
    let scene = Scene::load(&task.case, &task.settings).ok()?;
    let steps = course::looks_of(&scene).steps() as f64;
    Some(RUNS as f64 * scene.particle_count() as f64 * steps * rounds_a_step(&scene))
}

/// Runs a scene in every way.
///
/// # Errors
/// If there is no such scene, or no such device.
pub fn run(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let scene = match Scene::load(&task.case, &task.settings) {
        Ok(scene) => scene,
        Err(error) => return Ok(Some(Outcome::empty(State::Refused, error.to_string()))),
    };
    let looks = course::looks_of(&scene);
    let gpu = session.gpu(&task.tier)?;
    let mut particles = sample_lattice(&scene);
    // Once, and the same for all.
    if let Err(error) = relax_particles(&gpu, &scene, &mut particles) {
        return Ok(Some(Outcome::empty(State::Refused, error.to_string())));
    }
    let (mut courses, mut not_run) = (Vec::new(), Vec::new());
    let shaken = (1..=SHAKEN_RUNS).map(|seed| (FULL_WAY, Some(seed)));
    let runs = std::iter::once((FULL_WAY, None)).chain(shaken).chain(WAYS.map(|way| (way, None)));
    for (index, (way, seed)) in runs.enumerate() {
        let progress = |share: f64| session.progress((index as f64 + share) / RUNS as f64);
        let mut start = particles.clone();
        if let Some(seed) = seed {
            shake(&mut start, &scene, seed);
        }
        match run_way(session, task, &way, (&looks, start), &progress)? {
            Ok(Some(course)) if course.moments.iter().any(|stats| stats.quarantined > 0) => {
                let reason = format!("{}: particles are not finite, and quarantined", way.name);
                return Ok(Some(Outcome::empty(State::Unstable, reason)));
            }
            Ok(Some(course)) => courses.push(Some(course)),
            Ok(None) => return Ok(None),
            Err(reason) if way.name == FULL => return Ok(Some(Outcome::empty(State::NotRun, reason))),
            // As a device without f16 has no half: the others are compared.
            Err(reason) => {
                not_run.push(format!("{}: {reason}", way.name));
                courses.push(None);
            }
        }
    }
    let others = courses.split_off(1 + SHAKEN_RUNS as usize);
    let full_runs: Vec<Course> = courses.into_iter().flatten().collect();
    let Some((full, shaken)) = full_runs.split_first() else { return Ok(None) };
    let mut outcome = Outcome::empty(State::Stable, not_run.join("; "));
    outcome.figures = figures(&scene, full, shaken, &WAYS.map(|way| way.name), &others);
    outcome.particles = particles.positions.len() as u64;
    outcome.device = gpu.info().name.clone();
    Ok(Some(outcome))
}

/// One way: its course, none if it was stopped, or why it cannot be run here.
fn run_way(
    session: &Session<'_>,
    task: &Task,
    way: &Way,
    (looks, start): (&Looks, ParticleSet),
    progress: &dyn Fn(f64),
) -> Result<Result<Option<Course>, String>, StudyError> {
    let loaded = |settings: &[String]| Scene::load(&task.case, settings).map_err(|error| error.to_string());
    // Particles that do not interact have no precision to choose: of theirs the tiers alone are compared.
    let precision = match loaded(&task.settings) {
        Ok(scene) if !scene.solver.method.interacts() => None,
        _ => Some(format!("solver.precision={}", way.precision)),
    };
    let settings: Vec<String> = task.settings.iter().cloned().chain(precision).collect();
    let scene = match loaded(&settings) {
        Ok(scene) => scene,
        Err(reason) => return Ok(Err(reason)),
    };
    let gpu = session.gpu(tier_name(way.tier))?;
    if gpu.tier() != way.tier {
        return Ok(Err(format!("{} is of tier {}", gpu.info().name, tier_name(gpu.tier()))));
    }
    Ok(course::run(&gpu, &scene, start, looks, &|| session.stops(), progress))
}

/// Moves every particle by what a packed position may round.
fn shake(particles: &mut ParticleSet, scene: &Scene, seed: u64) {
    let most_m = 0.5 * ROUNDING * scene.support_m();
    let mut random = fastrand::Rng::with_seed(seed);
    for position in &mut particles.positions {
        for axis in &mut position.position_m {
            *axis = (f64::from(*axis) + most_m * (2.0 * random.f64() - 1.0)) as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_scene_is_run_small_and_in_its_own_time() {
        let all = tasks(false);
        assert_eq!(all.len(), shipped_scenes().count());
        for task in &all {
            let scene = Scene::load(&task.case, &task.settings).unwrap_or_else(|error| panic!("{error}"));
            let count = scene.particle_count();
            assert!((1000..=7000).contains(&count), "{}: {count}", task.case);
            assert!(scene.outputs.seconds <= END_S && cost(task).unwrap() > 0.0);
        }
        assert_eq!(tasks(true).len(), 1);
    }

    #[test]
    fn a_shaken_start_is_off_by_a_rounding_and_no_more() {
        let scene = Scene::load("calm-pool", &[]).unwrap();
        let start = sample_lattice(&scene);
        let mut shaken = start.clone();
        shake(&mut shaken, &scene, 1);
        let off = |axis: usize| {
            let pairs = start.positions.iter().zip(&shaken.positions);
            pairs.map(|(a, b)| f64::from((a.position_m[axis] - b.position_m[axis]).abs())).fold(0.0, f64::max)
        };
        let most_m = 0.5 * ROUNDING * scene.support_m();
        assert!((0..3).all(|axis| off(axis) > 0.9 * most_m && off(axis) < 1.1 * most_m));
    }
}
