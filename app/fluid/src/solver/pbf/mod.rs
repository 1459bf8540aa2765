//! Position Based Fluids (Macklin & Müller 2013): Jacobi iterations of the density constraint,
//! then velocities, vorticity confinement and XSPH viscosity. Each optional term is a variant or
//! a pass of its own, chosen here once.

mod constraint;
mod velocity;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, Counters, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepParams,
    Velocity,
};

use crate::grid::{Neighbours, Sorted};
use crate::scene::Scene;
use crate::smoothing_kernel::{lattice, wendland};
use velocity::Vortices;

/// What every stage of a substep shares.
pub struct Shared {
    /// Time, gravity, domain.
    pub step: Buffer<StepParams>,
    /// The smoothing kernel.
    pub kernel: Buffer<SmoothingKernelParams>,
    /// Whether the domain has walls.
    pub walls: bool,
    /// Whether it has periodic axes.
    pub periodic: bool,
    /// How what is computed for pairs of particles is rounded.
    pub precision: PrecisionKeyword,
    /// Events that are counted.
    pub counters: Buffer<Counters>,
}

/// The solver's settings and buffers.
pub struct Pbf {
    /// Settings as the shaders see them.
    pub params: Buffer<PbfParams>,
    iterations: u32,
    s_corr: bool,
    position_lambdas: Lambdas,
    vortices: Option<Vortices>,
    /// Velocities before viscosity; without it they are the result.
    unsmoothed: Option<Buffer<Velocity>>,
}

/// Places with their multipliers, as they are during one iteration.
pub(crate) enum Lambdas {
    /// Places of 21 bits an axis, multipliers in f32.
    Full(Buffer<PositionLambda>),
    /// Both in eight bytes.
    Packed(Buffer<[u32; 2]>),
}

/// What the shaders are given.
pub fn params(scene: &Scene) -> PbfParams {
    let (solver, forces) = (&scene.solver, &scene.forces);
    PbfParams {
        relaxation: solver.pbf.relaxation as f32,
        cfm: (solver.pbf.cfm * lattice(scene.domain.dimensions, solver.support_ratio).stiffness) as f32,
        s_corr_k: solver.pbf.s_corr_k as f32,
        s_corr_inverse_w: (1.0 / wendland(solver.pbf.s_corr_distance_ratio)) as f32,
        xsph: forces.xsph as f32,
        vorticity: forces.vorticity_m_s as f32,
        // Half a spacing: further, and two particles a correction drives together pass each other.
        max_correction_m: (0.5 * scene.fitted_spacing_m()) as f32,
        // Half a spacing: fluid at rest, however dense, keeps further apart.
        separation: (0.5 / solver.support_ratio) as f32,
    }
}

impl Pbf {
    /// Declares the buffers of the terms that `scene` has.
    pub fn declare(resources: &mut Resources, scene: &Scene, particle_count: u32) -> Self {
        let (solver, forces) = (&scene.solver, &scene.forces);
        Self {
            params: resources.persistent("pbf_params", 1),
            iterations: solver.pbf.iterations,
            s_corr: solver.pbf.s_corr_k > 0.0,
            position_lambdas: if solver.packed_positions {
                Lambdas::Packed(resources.buffer("position_lambdas", particle_count))
            } else {
                Lambdas::Full(resources.buffer("position_lambdas", particle_count))
            },
            vortices: (forces.vorticity_m_s > 0.0).then(|| Vortices::declare(resources, particle_count)),
            unsmoothed: (forces.xsph > 0.0).then(|| resources.buffer("unsmoothed_velocities", particle_count)),
        }
    }

    /// From predicted, sorted particles to their positions and velocities after the substep.
    pub fn record(
        &mut self,
        recording: &mut Recording,
        shared: &mut Shared,
        neighbours: &Neighbours,
        sorted: &mut Sorted,
        positions: &mut Buffer<Position>,
        velocities: &mut Buffer<Velocity>,
    ) {
        for _ in 0..self.iterations {
            constraint::constrain_density(recording, self, shared, neighbours, sorted);
            constraint::correct_positions(recording, self, shared, neighbours, sorted);
        }
        let updated = self.unsmoothed.as_mut().unwrap_or(&mut *velocities);
        velocity::update_velocity(recording, shared, sorted, positions, updated);
        if let Some(vortices) = &mut self.vortices {
            vortices.record(recording, &self.params, shared, neighbours, sorted, updated);
        }
        if let Some(unsmoothed) = &self.unsmoothed {
            velocity::viscosity(recording, &self.params, shared, neighbours, sorted, unsmoothed, velocities);
        }
    }
}
