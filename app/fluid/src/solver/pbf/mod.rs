//! Position Based Fluids (Macklin & Müller 2013): Jacobi iterations of the density constraint, then velocities.
//!
//! During the iterations a particle is a quantized position. What it moved from its predicted f32 position is added to
//! that once, at the end; iterations hold it below h, and count that.
//!
//! `quantized_positions` and `position_lambdas` are each read by one pass of an iteration and written by the other. A
//! Jacobi iteration so needs no copy, and a neighbour's position and lambda are one load of 16 bytes, or of 8 with
//! the lower precisions.

mod chebyshev;
mod constrain_density;
mod correct_positions;
mod iteration_weights;
mod update_velocity;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, PbfIteration, PbfParams, PositionLambda};

use crate::forces::Forces;
use crate::grid::NeighbourSearch;
use crate::particles::predict;
use crate::scene::Scene;
use crate::smoothing_kernel::{lattice, wendland};
use crate::step_context::{Particles, StepContext};
pub use chebyshev::{Chebyshev, Weights};
use constrain_density::constrain_density;
use correct_positions::correct_positions;
pub use iteration_weights::IterationWeights;
use update_velocity::update_velocity;

/// The solver's settings and buffers.
pub struct Pbf {
    /// Settings as the shaders see them.
    pub(crate) params: Buffer<PbfParams>,
    /// The neighbours of its substep.
    pub(crate) search: NeighbourSearch,
    pub(crate) forces: Forces,
    weights: IterationWeights,
    iterations: u32,
    s_corr: bool,
    lambdas: Lambdas,
    momentum: Option<Momentum>,
}

/// What iterations with momentum need beside the lambdas of the one before.
struct Momentum {
    /// Of each iteration.
    weights: Vec<Buffer<PbfIteration>>,
    /// Whether lambdas are held against the sum of those before.
    accumulates: bool,
    /// That sum, where the lambdas' buffer has no room for it.
    totals: Option<Buffer<f32>>,
}

/// Quantized positions with their lambdas, as they are during one iteration.
enum Lambdas {
    /// 21 bits an axis, lambdas in f32.
    Full(Buffer<PositionLambda>),
    /// Both in eight bytes.
    Packed(Buffer<[u32; 2]>),
}

/// Of two particles at one point: as much as about 4 % of compression gives, so that they part in some ten steps
/// without a leap.
const SEPARATION_LAMBDA: f64 = -0.02;

/// What the shaders are given of a scene and its weights.
pub fn params(scene: &Scene, weights: &IterationWeights) -> PbfParams {
    let solver = &scene.solver;
    // What is no constraint's lambda keeps its weight where lambdas have their own.
    let (relaxation, unconstrained) = match weights.chebyshev {
        Some(_) => (1.0, weights.relaxation),
        None => (weights.relaxation, 1.0),
    };
    PbfParams {
        relaxation: relaxation as f32,
        cfm: (solver.pbf.cfm * lattice(scene.domain.dimensions, solver.support_ratio).stiffness) as f32,
        s_corr_k: (unconstrained * solver.pbf.s_corr_k) as f32,
        s_corr_inverse_w: (1.0 / wendland(solver.pbf.s_corr_distance_ratio)) as f32,
        // Half a spacing: further, and two particles a correction drives together pass each other.
        max_correction_m: (0.5 * scene.fitted_spacing_m()) as f32,
        // Half a spacing: fluid at rest, however dense, keeps further apart.
        separation: (0.5 / solver.support_ratio) as f32,
        separation_lambda: (unconstrained * SEPARATION_LAMBDA) as f32,
        ..PbfParams::default()
    }
}

impl Pbf {
    /// Declares the buffers of the terms that `scene` has.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        let solver = &scene.solver;
        let weights = IterationWeights::of(scene);
        let momentum = weights.chebyshev.as_ref();
        Self {
            params: resources.persistent("pbf_params", 1),
            search: NeighbourSearch::declare(resources, scene, capacity),
            forces: Forces::declare(resources, scene, capacity),
            iterations: solver.pbf.iterations,
            s_corr: solver.pbf.s_corr_k > 0.0,
            lambdas: match solver.precision.packs_positions() {
                true => Lambdas::Packed(resources.buffer("position_lambdas", capacity)),
                false => Lambdas::Full(resources.buffer("position_lambdas", capacity)),
            },
            momentum: momentum.map(|weights| Momentum::declare(resources, scene, weights, capacity)),
            weights,
        }
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.params, &[params(scene, &self.weights)]);
        let buffers = self.momentum.iter_mut().flat_map(|momentum| &mut momentum.weights);
        buffers.zip(self.weights.params()).for_each(|(buffer, weights)| init.upload(buffer, &[weights]));
        self.search.record_init(init, scene);
        self.forces.record_init(init, scene);
    }

    pub(super) fn record_substep(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        predict(recording, context, particles);
        self.search.sort(recording, context, particles);
        self.search.list(recording, context);
        for iteration in 0..self.iterations {
            constrain_density(recording, self, context, iteration as usize);
            correct_positions(recording, self, context);
        }
        let updated = self.forces.input(&mut particles.velocities);
        update_velocity(recording, context, &self.search, &mut particles.positions, updated);
        self.forces.record(recording, context, &self.search, &mut particles.velocities);
    }
}

impl Momentum {
    fn declare(resources: &mut Resources, scene: &Scene, weights: &Chebyshev, capacity: u32) -> Self {
        let iterations = 0..weights.iterations.len();
        let totals = weights.accumulates() && scene.solver.precision.packs_positions();
        Self {
            weights: iterations.map(|n| resources.persistent(&format!("pbf_iteration_{n}"), 1)).collect(),
            accumulates: weights.accumulates(),
            totals: totals.then(|| resources.buffer("lambda_totals", capacity)),
        }
    }
}
