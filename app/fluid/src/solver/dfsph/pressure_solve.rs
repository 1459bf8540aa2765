//! One of the two solves: its pressures, and what its iterations are told. (Shaders: `solver/dfsph/{carry_pressure,
//! correct_pressure, apply_pressure, solve_state, coarse_pressure}.compute`.)

use std::mem::offset_of;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    ApplyPressure, ApplyPressureVariant, BeginSolve, Buffer, CarryPressure, CorrectPressure, CorrectPressureVariant,
    EndIteration, Kernel, Position, PressureSolve, ProlongPressure, RestrictPressure, SolveState, Velocity,
    WallsKeyword,
};

use super::{Measured, Shared, Weights, coarse_grid_params};
use crate::grid::{Grid, NeighbourSearch};
use crate::scene::Scene;
use crate::solver::pbf::CoarseCorrection;
use crate::step_context::StepContext;

/// Of the compression that a density solve finds it takes out so much. All of it, and what a solve left over one way the next
/// one pushes back: 2.6 times the iterations in a pool at rest (`SHARE` 1: 5.4 + 7.8, a half: 1.7 + 3.4).
const SHARE: f32 = 0.5;
/// Of the last substep's pressures with which it begins, for flow compresses alike from substep to substep; where it ends by
/// its residual, and where one iteration has to do. Of more of them, a pool at rest that no iteration looks at would breathe.
const WARM_SHARES: [f32; 2] = [0.7, 0.9];

/// Least iterations of a solve that a coarse grid corrects.
const CORRECTED_ITERATIONS: u32 = 3;
/// Of the tolerance, for the same solve. A column of 200 layers is calm with a tenth or less, and bursts with all of it.
const CORRECTED_TOLERANCE: f64 = 1.0 / 30.0;

/// Which of the two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solve {
    /// Of velocities: particles may grow as dense as at rest in the substep, no denser.
    Divergence,
    /// Of positions: what is denser than at rest is to move apart.
    Density,
}

/// What the iterations are told: the first one, and the others.
pub fn params(scene: &Scene, solve: Solve) -> [PressureSolve; 2] {
    let settings = &scene.solver.dfsph;
    let weights = Weights::new(scene.domain.dimensions, scene.solver.support_ratio, settings.momentum);
    let (tolerance, most_iterations, room_share, excess_share, warm_share) = match solve {
        Solve::Divergence => (settings.divergence_tolerance, settings.max_divergence_iterations, 1.0, 0.0, 1.0),
        Solve::Density => (
            settings.density_tolerance,
            settings.max_density_iterations,
            0.0,
            SHARE,
            WARM_SHARES[usize::from(settings.fixed_iterations)],
        ),
    };
    // What the grid adds is rough where it is interpolated, however small the mean residual: a few iterations smooth it.
    let is_corrected = solve == Solve::Divergence && !coarse_grid_params(scene).is_empty();
    // What every layer may sink by in a substep adds up over the depth.
    let share = if is_corrected { CORRECTED_TOLERANCE } else { 1.0 };
    let others = PressureSolve {
        tolerance: (share * tolerance) as f32,
        step: weights.step as f32,
        momentum: weights.momentum as f32,
        guarded_step: weights.plain as f32,
        room_share,
        solids_move: if matches!(solve, Solve::Divergence) { 1.0 } else { 0.0 },
        excess_share,
        warm_share,
        most_iterations,
        least_iterations: if is_corrected { CORRECTED_ITERATIONS.min(most_iterations) } else { 0 },
        ..PressureSolve::default()
    };
    [PressureSolve { step: weights.first_step as f32, momentum: 0.0, ..others }, others]
}

/// One solve's buffers.
pub(super) struct PressureSolving {
    solve: Solve,
    iterations: u32,
    params: [Buffer<PressureSolve>; 2],
    /// The multipliers, which last from substep to substep, in the last sort's order.
    pressures: Buffer<f32>,
    /// The last substep's in this one's order; none where solves begin cold.
    carried: Option<Buffer<f32>>,
}

impl PressureSolving {
    pub(super) fn declare(resources: &mut Resources, scene: &Scene, solve: Solve, capacity: u32) -> Self {
        let settings = &scene.solver.dfsph;
        let (name, iterations) = match solve {
            Solve::Divergence => ("divergence", settings.max_divergence_iterations),
            Solve::Density => ("density", settings.max_density_iterations),
        };
        let pressures = format!("{name}_pressures");
        Self {
            solve,
            iterations,
            params: ["first", "next"].map(|which| resources.persistent(&format!("{name}_solve_{which}"), 1)),
            pressures: match settings.warm_start {
                true => resources.persistent(&pressures, capacity),
                false => resources.buffer(&pressures, capacity),
            },
            carried: settings.warm_start.then(|| resources.buffer(&format!("carried_{pressures}"), capacity)),
        }
    }

    /// The pressures that the next substep begins with, if it does.
    pub(super) fn kept(&self) -> Option<Buffer<f32>> {
        self.carried.is_some().then(|| self.pressures.alias())
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        let params = params(scene, self.solve);
        self.params.iter_mut().zip(params).for_each(|(buffer, params)| init.upload(buffer, &[params]));
        if self.carried.is_some() {
            init.clear(&mut self.pressures);
        }
    }

    /// Brings the last substep's pressures into this one's order; before the particles are where the sort put them.
    pub(super) fn carry(
        &mut self,
        recording: &mut Recording,
        context: &StepContext,
        grid: &Grid,
        positions: &Buffer<Position>,
    ) {
        let Some(carried) = &mut self.carried else { return };
        context.slots.dispatch(
            recording,
            &CarryPressure {
                positions: positions.read(),
                cell_slots: grid.cell_slots.read(),
                cell_starts: grid.cell_starts.read(),
                pressures: self.pressures.read(),
                carried_pressures: carried.write(),
                step_state: context.slots.state.uniform(),
                solve: self.params[0].uniform(),
            },
        );
    }

    /// Makes `velocities`, or displacements over dt, what the solve asks for.
    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        search: &NeighbourSearch,
        shared: &mut Shared,
        velocities: &mut Buffer<Velocity>,
        mut coarse: Option<&mut CoarseCorrection>,
    ) {
        recording.clear(&mut self.pressures);
        if let Some(carried) = &self.carried {
            recording.copy(carried, &mut shared.changes);
            let apply = self.apply(context, search, shared, velocities);
            context.slots.dispatch(recording, &apply);
        }
        if let Some(Measured { state, .. }) = &mut shared.measured {
            let begin = BeginSolve { solve_state: state.write(), step_state: context.slots.state.uniform() };
            recording.dispatch_groups(&begin, [1; 3]);
        }
        for iteration in 0..self.iterations {
            self.correct(recording, context, search, shared, velocities, iteration);
            if let (0, Some(coarse)) = (iteration, &mut coarse) {
                self.correct_slow_modes(recording, context, search, shared, coarse);
            }
            let state = shared.measured.as_ref().map(|measured| measured.state.alias());
            let apply = self.apply(context, search, shared, velocities);
            match state {
                Some(state) => record_if_unsolved(recording, context, &state, &apply),
                None => context.slots.dispatch(recording, &apply),
            }
        }
        // What the last iteration left over.
        if shared.measured.is_some() {
            self.correct(recording, context, search, shared, velocities, self.iterations);
        }
    }

    /// Adds to the first iteration's changes what a coarse grid makes of what they leave over.
    fn correct_slow_modes(
        &self,
        recording: &mut Recording,
        context: &StepContext,
        search: &NeighbourSearch,
        shared: &mut Shared,
        coarse: &mut CoarseCorrection,
    ) {
        coarse.clear(recording);
        let (cells, grid) = coarse.finest();
        context.slots.dispatch(
            recording,
            &RestrictPressure {
                positions: search.sorted.positions.read(),
                pressure_factors: shared.factors.read(),
                pressure_changes: shared.changes.write(),
                coarse_cells: cells.write(),
                step_state: context.slots.state.uniform(),
                solve: self.params[0].uniform(),
                coarse: grid.uniform(),
            },
        );
        let (multipliers, grid) = coarse.solve(recording);
        context.slots.dispatch(
            recording,
            &ProlongPressure {
                positions: search.sorted.positions.read(),
                pressures: self.pressures.read(),
                multipliers: multipliers.read(),
                pressure_changes: shared.changes.write(),
                step_state: context.slots.state.uniform(),
                coarse: grid.uniform(),
            },
        );
    }

    fn correct(
        &self,
        recording: &mut Recording,
        context: &mut StepContext,
        search: &NeighbourSearch,
        shared: &mut Shared,
        velocities: &Buffer<Velocity>,
        iteration: u32,
    ) {
        let Shared { factors, changes, measured, .. } = shared;
        let params = &self.params[usize::from(iteration > 0)];
        let state = measured.as_ref().map(|measured| measured.state.alias());
        let correct = CorrectPressure {
            variant: CorrectPressureVariant {
                walls: context.boundary(),
                measured: state.is_some(),
                precision: search.sorted.precision,
            },
            quantized_positions: search.sorted.quantized_positions.read(),
            velocities: velocities.read(),
            neighbours: search.neighbours.deltas.read(),
            list_heads: search.neighbours.heads.read(),
            pressure_factors: factors.read(),
            pressures: self.pressures.read(),
            pressure_changes: changes.write(),
            group_residuals: measured.as_mut().map(|measured| measured.group_residuals.write()),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: search.smoothing_kernel.uniform(),
            solve: params.uniform(),
        };
        match &state {
            Some(state) => record_if_unsolved(recording, context, state, &correct),
            None => context.slots.dispatch(recording, &correct),
        }
        let Some(Measured { state, group_residuals }) = measured else { return };
        let end = EndIteration {
            group_residuals: group_residuals.read(),
            solve_state: state.write(),
            counters: context.counters.write(),
            step_state: context.slots.state.uniform(),
            solve: params.uniform(),
        };
        recording.dispatch_groups(&end, [1; 3]);
    }

    fn apply<'a>(
        &'a mut self,
        context: &'a StepContext,
        search: &'a NeighbourSearch,
        shared: &'a mut Shared,
        velocities: &'a mut Buffer<Velocity>,
    ) -> ApplyPressure<'a> {
        let Shared { factors, changes, contacts, .. } = shared;
        ApplyPressure {
            variant: ApplyPressureVariant { walls: context.boundary(), precision: search.sorted.precision },
            quantized_positions: search.sorted.quantized_positions.read(),
            neighbours: search.neighbours.deltas.read(),
            list_heads: search.neighbours.heads.read(),
            pressure_factors: (context.boundary() != WallsKeyword::Off).then(|| factors.read()),
            pressure_changes: changes.read(),
            pressures: self.pressures.write(),
            velocities: velocities.write(),
            solve: contacts.as_ref().map(|_| self.params[0].uniform()),
            solid_contacts: contacts.as_mut().map(Buffer::write),
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            kernel: search.smoothing_kernel.uniform(),
        }
    }
}

/// Runs `kernel` with a thread for each slot, or not at all where the solve has ended.
fn record_if_unsolved<K: Kernel>(
    recording: &mut Recording,
    context: &StepContext,
    state: &Buffer<SolveState>,
    kernel: &K,
) {
    recording.dispatch_indirect(kernel, state, offset_of!(SolveState, groups) as u32, context.slots.capacity);
}
