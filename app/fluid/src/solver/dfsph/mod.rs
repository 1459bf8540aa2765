//! Divergence-free SPH (Bender & Koschier 2015, 2017): pressure that lets no particle grow denser than at rest, found by
//! iterations that end on the GPU when little is left. What compression steps leave over goes out of the positions alone
//! (implicit density projection, Kugelstadt, Longva, Thuerey & Bender 2021): the 2015 paper's density solve makes velocities of
//! it, which shook a pool at rest and took 17 iterations of it where these two take 5. Walls mirror the fluid
//! (`boundary/mirror.hlsli`). (Shaders: `solver/dfsph/`.)
//!
//! A substep moves particles first, with velocities that the last one made fit for it, and then makes the next ones: lists
//! are of the positions that a measurement sees, but for what takes out compression.

mod coarse;
mod pressure_solve;
mod weights;

pub use coarse::coarse_grid_params;
pub use pressure_solve::{Solve, params};
pub use weights::Weights;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    ApplyGravity, Buffer, FactorPressure, FactorPressureVariant, Kernel, LimitVelocity, PressureFactors,
    ShiftPositions, ShiftPositionsVariant, SolidContact, SolveState, Velocity,
};

use crate::forces::Forces;
use crate::grid::NeighbourSearch;
use crate::particles::advect;
use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::solver::pbf::CoarseCorrection;
use crate::step_context::StepContext;
use pressure_solve::PressureSolving;

/// The solver's buffers.
pub struct Dfsph {
    /// Neighbours.
    pub search: NeighbourSearch,
    forces: Forces,
    shared: Shared,
    divergence: PressureSolving,
    /// Of the divergence solve; none where the fluid is not deep.
    coarse: Option<CoarseCorrection>,
    /// None where it does no iterations.
    density: Option<PressureSolving>,
    /// What particles are moved by beside their velocities, over dt: what parts those at one point, and what the density
    /// solve finds.
    shifts: Buffer<Velocity>,
}

/// What both solves use in turn.
pub(super) struct Shared {
    factors: Buffer<PressureFactors>,
    /// What an iteration adds to pressures, or, before the first, what a solve begins with.
    changes: Buffer<f32>,
    /// What tells when to end; none where the number of iterations is fixed.
    measured: Option<Measured>,
    /// What particles know of solids, if there are any, and remember of what bodies give back.
    contacts: Option<Buffer<SolidContact>>,
}

/// What ends a solve on the GPU.
pub(super) struct Measured {
    state: Buffer<SolveState>,
    group_residuals: Buffer<f32>,
}

impl Dfsph {
    /// Declares the buffers of what `scene` has.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        let settings = &scene.solver.dfsph;
        let measured = (!settings.fixed_iterations).then(|| Measured {
            state: resources.buffer("solve_state", 1),
            group_residuals: resources
                .buffer("group_residuals", capacity.div_ceil(FactorPressure::GROUP_SIZE[0]).max(1)),
        });
        Self {
            search: NeighbourSearch::declare(resources, scene, capacity),
            forces: Forces::declare(resources, scene, capacity),
            shared: Shared {
                factors: resources.buffer("pressure_factors", capacity),
                changes: resources.buffer("pressure_changes", capacity),
                measured,
                contacts: None,
            },
            divergence: PressureSolving::declare(resources, scene, Solve::Divergence, capacity),
            coarse: CoarseCorrection::declare(resources, coarse_grid_params(scene)),
            density: (settings.max_density_iterations > 0)
                .then(|| PressureSolving::declare(resources, scene, Solve::Density, capacity)),
            shifts: resources.buffer("shifts", capacity),
        }
    }

    /// What lasts from substep to substep of both solves; nothing where they begin cold.
    pub(super) fn pressures(&self) -> Vec<Buffer<f32>> {
        [&self.divergence].into_iter().chain(&self.density).filter_map(PressureSolving::kept).collect()
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        self.search.record_init(init, scene);
        self.forces.record_init(init, scene);
        self.divergence.record_init(init, scene);
        if let Some(coarse) = &mut self.coarse {
            coarse.record_init(init);
        }
        if let Some(density) = &mut self.density {
            density.record_init(init, scene);
        }
    }

    pub(super) fn record_substep(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        let Self { search, forces, shared, divergence, coarse, density, shifts } = self;
        advect(recording, context, particles, None);
        if let Some(solids) = &mut context.solids {
            solids.record_collide(recording, &mut particles.positions, &mut particles.velocities);
        }
        search.sort(recording, context, particles);
        search.list(recording, context);
        if let Some(solids) = &mut context.solids {
            solids.record_sample(recording, &search.sorted.positions, &search.smoothing_kernel);
        }
        for solving in [&mut *divergence].into_iter().chain(density.as_mut()) {
            solving.carry(recording, context, &search.grid, &particles.positions);
        }
        let Particles { positions, velocities } = particles;
        // XSPH reads velocities where the sort left them.
        let mut sorted_velocities = search.sorted.velocities.alias();
        let input = match forces.smooth() {
            true => &mut sorted_velocities,
            false => {
                recording.copy(&search.sorted.velocities, velocities);
                &mut *velocities
            }
        };
        shared.contacts = context.solids.as_ref().map(|solids| solids.contacts().alias());
        context.slots.dispatch(
            recording,
            &FactorPressure {
                variant: FactorPressureVariant { walls: context.boundary(), precision: search.sorted.precision },
                quantized_positions: search.sorted.quantized_positions.read(),
                sorted_positions: search.sorted.positions.read(),
                neighbours: search.neighbours.deltas.read(),
                list_heads: search.neighbours.heads.read(),
                solid_contacts: context.solids.as_ref().map(|solids| solids.contacts().read()),
                positions: positions.write(),
                pressure_factors: shared.factors.write(),
                shifts: shifts.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                kernel: search.smoothing_kernel.uniform(),
            },
        );
        context.slots.dispatch(
            recording,
            &ApplyGravity {
                positions: positions.read(),
                velocities: input.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
            },
        );
        forces.record(recording, context, search, velocities);
        divergence.record(recording, context, search, shared, velocities, coarse.as_mut());
        context.slots.dispatch(
            recording,
            &LimitVelocity {
                positions: positions.read(),
                velocities: velocities.write(),
                counters: context.counters.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
            },
        );
        if let Some(density) = density {
            density.record(recording, context, search, shared, shifts, None);
        }
        if let Some(solids) = &mut context.solids {
            solids.record_gather(recording, positions);
        }
        let stopping = context.solids.as_ref();
        context.slots.dispatch(
            recording,
            &ShiftPositions {
                variant: ShiftPositionsVariant { walls: context.boundary(), periodic: context.periodic },
                positions: positions.write(),
                shifts: shifts.read(),
                counters: context.counters.write(),
                solids: stopping.map(|stopping| stopping.solids.read()),
                solid_poses: stopping.map(|stopping| stopping.poses().read()),
                solid_fields: stopping.map(|stopping| stopping.fields.read()),
                solid_blocks: stopping.map(|stopping| stopping.blocks.read()),
                solids_params: stopping.map(|stopping| stopping.params().uniform()),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
            },
        );
    }
}
