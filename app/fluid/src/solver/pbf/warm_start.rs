//! A substep that begins with a share of the last one's pressure. (Shaders: `solver/pbf/{start_warm, keep_pressure}
//! .compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, KeepPressure, KeepPressureVariant, PbfParams, StartWarm, StartWarmVariant, WarmStart};

use super::Lambdas;
use crate::grid::NeighbourSearch;
use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::step_context::StepContext;

/// The largest share of it: in f64 energy rose at .4, and from .5 on slow modes grew whatever the number of iterations
/// (`app/study/FINDINGS.md`).
pub const MOST_WARM_START: f64 = 0.3;

/// What the last substep's corrections came to, by slot. Zeros begin cold.
pub(super) struct WarmStarts {
    pub(super) starts: Buffer<WarmStart>,
}

impl WarmStarts {
    /// None if `scene` begins its substeps cold.
    pub(super) fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Option<Self> {
        let is_wanted = scene.solver.pbf.warm_start > 0.0;
        is_wanted.then(|| Self { starts: resources.persistent("warm_starts", capacity) })
    }

    pub(super) fn record_init(&mut self, init: &mut Recording) {
        init.clear(&mut self.starts);
    }

    /// Moves the listed particles, and writes what stands before their first iteration.
    pub(super) fn start(
        &self,
        recording: &mut Recording,
        context: &StepContext,
        search: &mut NeighbourSearch,
        particles: &Particles,
        (lambdas, totals): (&mut Lambdas, Option<&mut Buffer<f32>>),
        params: &Buffer<PbfParams>,
    ) {
        let (position_lambdas, packed_position_lambdas) = lambdas.write();
        context.slots.dispatch(
            recording,
            &StartWarm {
                variant: StartWarmVariant { walls: context.walls, precision: search.sorted.precision },
                positions: particles.positions.read(),
                warm_starts: self.starts.read(),
                cell_slots: search.grid.cell_slots.read(),
                cell_starts: search.grid.cell_starts.read(),
                quantized_positions: search.sorted.quantized_positions.write(),
                position_lambdas,
                packed_position_lambdas,
                lambda_totals: totals.map(|totals| totals.write()),
                step_state: context.slots.state.uniform(),
                step_params: context.walls.then(|| context.step.uniform()),
                kernel: search.smoothing_kernel.uniform(),
                pbf: params.uniform(),
            },
        );
    }

    /// Keeps what the substep's corrections came to.
    pub(super) fn keep(
        &mut self,
        recording: &mut Recording,
        context: &StepContext,
        search: &NeighbourSearch,
        (lambdas, totals): (&Lambdas, Option<&Buffer<f32>>),
    ) {
        let (position_lambdas, packed_position_lambdas) = lambdas.read();
        context.slots.dispatch(
            recording,
            &KeepPressure {
                variant: KeepPressureVariant { precision: search.sorted.precision },
                quantized_positions: search.sorted.quantized_positions.read(),
                sorted_positions: search.sorted.positions.read(),
                position_lambdas,
                packed_position_lambdas,
                lambda_totals: totals.map(|totals| totals.read()),
                warm_starts: self.starts.write(),
                step_state: context.slots.state.uniform(),
                kernel: search.smoothing_kernel.uniform(),
            },
        );
    }
}
