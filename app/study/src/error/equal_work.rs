//! Iterations against substeps at equal work: the same number of iterations a step, spent in one substep
//! or in many.

use brooklet_fluid::Scene;
use brooklet_fluid::particles::{ParticleSet, sample_lattice};

use super::{EQUAL_WORK_PART, common};
use crate::backend::GpuRun;
use crate::energy;
use crate::session::{Session, StudyError, state_of};
use crate::{Figure, Outcome, Setup, SetupResult, State, Task};

/// Iterations a step of every run.
const ITERATIONS: u32 = 8;
/// Spacings of the shipped dam break that give about 27 and 125 thousand particles.
const SPACINGS_M: [f64; 2] = [0.0208, 0.0125];
const END_S: f64 = 0.25;

/// Each size with each way to spend the iterations.
pub fn equal_work_tasks() -> Vec<Task> {
    let one = |spacing_m: f64, substeps: u32| Task {
        part: EQUAL_WORK_PART.into(),
        case: "dam-break".into(),
        settings: vec![
            format!("spacing_m={spacing_m}"),
            format!("solver.substeps={substeps}"),
            format!("solver.pbf.iterations={}", ITERATIONS / substeps),
        ],
        tier: "desktop".into(),
        repeats: 1,
    };
    SPACINGS_M.iter().flat_map(|&spacing_m| [1, 2, 4, 8].map(|substeps| one(spacing_m, substeps))).collect()
}

fn setup(task: &Task) -> SetupResult {
    let scene = Scene::load(&task.case, &task.settings).map_err(Box::new)?;
    let particles = sample_lattice(&scene);
    Ok(Setup {
        scene,
        particles,
        sample_times_s: (1..=5).map(|k| END_S * f64::from(k) / 5.0).collect(),
        relaxes: true,
        squeezed: false,
    })
}

/// Particle iterations, without making the particles.
pub fn equal_work_cost(task: &Task) -> Option<f64> {
    let scene = Scene::load(&task.case, &task.settings).ok()?;
    let count = scene.particle_count();
    let empty =
        Setup { scene, particles: ParticleSet::default(), sample_times_s: vec![END_S], relaxes: true, squeezed: false };
    Some(empty.particle_iterations_of(count))
}

/// Runs one.
///
/// # Errors
/// If the device is not there.
pub fn run_equal_work(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let setup = match setup(task) {
        Ok(setup) => setup,
        Err(error) => return Ok(Some(Outcome::empty(State::Refused, error.to_string()))),
    };
    let gpu = session.gpu(&task.tier)?;
    let run = match session.run_setup(&gpu, &setup) {
        Ok(run) if run.stopped => return Ok(None),
        Ok(run) => run,
        Err(reason) => return Ok(Some(Outcome::empty(State::Refused, reason))),
    };
    let (state, reason) = state_of(&run);
    let mut outcome = Outcome::empty(state, reason);
    let samples = run.measured.len().max(1) as f64;
    let mean = |of: fn(&brooklet_fluid::Stats) -> f64| run.measured.iter().map(|m| of(&m.stats)).sum::<f64>() / samples;
    outcome.figures = vec![
        Figure::told("mean compression", mean(|s| s.compression.mean), "", "mean of five moments"),
        Figure::told("mean p99", mean(|s| s.compression.p99), "", "of 99 of 100 particles, mean of five moments"),
    ];
    outcome.figures.extend(common(&setup, &run, energy::RISE));
    outcome.particles = setup.count() as u64;
    outcome.device = gpu.info().name.clone();
    outcome.cost = GpuRun::cost(&[run], 10, setup.scene.solver.dt_s);
    Ok(Some(outcome))
}
