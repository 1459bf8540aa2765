//! The chain of one step, top to bottom: predict, sort, list, solve; and its measurement.

use brooklet_gpu::{Engine, GpuError, Recording, Resources};
use brooklet_kernels::{Buffer, Measure, Position, PrecisionKeyword, Predict, PredictVariant, Velocity};

use crate::grid::{self, Grid, Neighbours, Sorted};
use crate::measure::{Densities, Measuring};
use crate::parameters::Parameters;
use crate::particles::{ParticleSet, sample_lattice};
use crate::scene::{Precision, Scene};
use crate::smoothing_kernel;
use crate::solver::pbf::{self, Pbf, Shared};
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
    /// Their neighbours, as the last step listed them.
    pub neighbours: Neighbours,
    /// What their density ratios are computed from.
    pub densities: Densities,
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
    let grid_params = grid::params(scene, particle_count);
    let mut positions = resources.persistent("positions", particle_count);
    let mut velocities = resources.persistent("velocities", particle_count);
    let mut grid = Grid::declare(resources, scene, &grid_params);
    let mut neighbours = Neighbours::declare(resources, &grid_params);
    let mut sorted = Sorted::declare(resources, scene, particle_count);
    let mut pbf = Pbf::declare(resources, scene, particle_count);
    let mut shared = Shared {
        step: resources.persistent("step_params", 1),
        kernel: resources.persistent("smoothing_kernel_params", 1),
        walls: scene.domain.has_walls(),
        periodic: scene.domain.is_periodic(),
        precision: match scene.solver.precision {
            Precision::Full => PrecisionKeyword::Off,
            Precision::Relaxed => PrecisionKeyword::RelaxedPrecision,
            Precision::Half => PrecisionKeyword::HalfPrecision,
        },
        counters: resources.persistent("counters", 1),
    };

    let mut init = Recording::new(INIT);
    init.upload(&mut grid.params, &[grid_params]);
    init.upload(&mut shared.step, &[step_params(scene, particle_count)]);
    init.upload(&mut shared.kernel, &[smoothing_kernel::params(scene)]);
    init.upload(&mut pbf.params, &[pbf::params(scene)]);
    init.clear(&mut shared.counters);
    init.clear(&mut neighbours.heads);

    let mut step = Recording::new(STEP);
    for _ in 0..scene.solver.substeps {
        predict(&mut step, &mut shared, &mut positions, &mut velocities);
        grid.record_sort(&mut step, &positions, &velocities, &mut sorted);
        neighbours.record(&mut step, &grid, &sorted, &mut shared.counters);
        pbf.record(&mut step, &mut shared, &neighbours, &mut sorted, &mut positions, &mut velocities);
    }

    let mut recordings = vec![init, step];
    let measure = (scene.outputs.measure_every_steps > 0).then(|| {
        let mut measuring = Measuring::declare(resources, particle_count);
        let mut recording = Recording::new(MEASURE);
        measuring.record(&mut recording, &mut shared, &neighbours, &positions, &velocities);
        recordings.push(recording);
        measuring.measure
    });
    Recorded {
        particle_count,
        recordings,
        positions,
        velocities,
        neighbours,
        densities: Densities::of(&shared),
        measure,
        parameters: Parameters {
            scene: scene.clone(),
            particle_count,
            grid: grid.params.alias(),
            step: shared.step.alias(),
            kernel: shared.kernel.alias(),
            pbf: pbf.params.alias(),
        },
    }
}

/// (Shader: `particles/predict.compute`.)
fn predict(
    recording: &mut Recording,
    shared: &mut Shared,
    positions: &mut Buffer<Position>,
    velocities: &mut Buffer<Velocity>,
) {
    let count = positions.len;
    recording.dispatch(
        &Predict {
            variant: PredictVariant { walls: shared.walls, periodic: shared.periodic },
            positions: positions.write(),
            velocities: velocities.write(),
            counters: shared.counters.write(),
            step_params: shared.step.uniform(),
        },
        count,
    );
}
