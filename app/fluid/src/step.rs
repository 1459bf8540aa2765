//! A scene as recordings: its start, one step of its solver's substeps, and its measurement.

use brooklet_gpu::{Engine, GpuError, Recording, Resources};
use brooklet_kernels::{Buffer, Measure, Position, Velocity};

use crate::grid::Neighbours;
use crate::measure::{Densities, Measuring};
use crate::parameters::Parameters;
use crate::particles::{ParticleSet, sample_lattice};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::step_context::{Particles, StepContext};
use crate::step_params::step_params;

/// Name of the recording that uploads the scene; run it once, first.
pub const INIT: &str = "init";
/// Name of the recording of one step.
pub const STEP: &str = "step";
/// Name of the recording of one measurement.
pub const MEASURE: &str = "measure";

/// A scene as recordings, and the buffers others read.
pub struct Recorded {
    /// Number of particles.
    pub particle_count: u32,
    /// `init`, `step` and, if the scene measures, `measure`.
    pub recordings: Vec<Recording>,
    /// Where the particles are after a step, relative to the domain's lowest corner; in cell
    /// order, named by the ids in their tags.
    pub positions: Buffer<Position>,
    /// Their velocities, in the same order.
    pub velocities: Buffer<Velocity>,
    /// Their neighbours, as the last step listed them; `None` of particles that do not interact.
    pub neighbours: Option<Neighbours>,
    /// What their density ratios are computed from, if they have neighbours.
    pub densities: Option<Densities>,
    /// The last measurement, if the scene measures.
    pub measure: Option<Buffer<Measure>>,
    /// The settings that a run takes as it goes.
    pub parameters: Parameters,
}

impl Recorded {
    /// Waits, and copies the particles to the host, in cell order: to save them, or to carry them over
    /// to another plan with [`record_particles`].
    ///
    /// # Errors
    /// If the device is lost.
    pub fn particles(&self, engine: &mut Engine) -> Result<ParticleSet, GpuError> {
        Ok(ParticleSet { positions: engine.read(&self.positions)?, velocities: engine.read(&self.velocities)? })
    }
}

/// Declares the scene's buffers in `resources` and records its chain.
pub fn record(resources: &mut Resources, scene: &Scene) -> Recorded {
    record_particles(resources, scene, sample_lattice(scene))
}

/// As [`record`], with particles of the caller's instead of the scene's fluids.
pub fn record_particles(resources: &mut Resources, scene: &Scene, emitted: ParticleSet) -> Recorded {
    let mut recorded = record_count(resources, scene, emitted.positions.len() as u32);
    let init = &mut recorded.recordings[0];
    init.upload(&mut recorded.positions, &emitted.positions);
    init.upload(&mut recorded.velocities, &emitted.velocities);
    recorded
}

/// As [`record`], for so many particles that nobody uploads: what a plan is like, at a cost that
/// does not grow with them. They are at rest at the domain's lowest corner until
/// `Engine::write` puts them elsewhere.
pub fn record_count(resources: &mut Resources, scene: &Scene, particle_count: u32) -> Recorded {
    let mut context = StepContext::declare(resources, scene);
    let mut particles = Particles::declare(resources, particle_count);
    let mut solver = Solver::declare(resources, scene, particle_count);

    let mut init = Recording::new(INIT);
    init.upload(&mut context.step, &[step_params(scene, particle_count)]);
    init.clear(&mut context.counters);
    solver.record_init(&mut init, scene);

    let mut step = Recording::new(STEP);
    for _ in 0..scene.solver.substeps {
        solver.record_substep(&mut step, &mut context, &mut particles);
    }

    let mut recordings = vec![init, step];
    let measure = (scene.outputs.measure_every_steps > 0).then(|| {
        let mut measuring = Measuring::declare(resources, particle_count);
        let mut recording = Recording::new(MEASURE);
        measuring.record(&mut recording, &mut context, solver.search(), &particles);
        recordings.push(recording);
        measuring.measure
    });
    Recorded {
        particle_count,
        recordings,
        neighbours: solver.search().map(|search| search.neighbours.alias()),
        densities: solver.search().map(|search| Densities::of(&context, search)),
        measure,
        parameters: Parameters::of(scene, particle_count, &context, &solver),
        positions: particles.positions,
        velocities: particles.velocities,
    }
}
