//! Position Based Fluids (Macklin & Müller 2013): Jacobi iterations of the density constraint, then velocities.
//!
//! During the iterations a particle is a quantized position. What it moved from its predicted f32 position is added to
//! that once, at the end; iterations hold it below h, and count that.
//!
//! `quantized_positions` and `position_lambdas` are each read by one pass of an iteration and written by the other. A
//! Jacobi iteration so needs no copy, and a neighbour's position and lambda are one load of 16 bytes, or of 8 with
//! the lower precisions.

mod chebyshev;
mod coarse_correction;
mod constrain_density;
mod correct_positions;
mod iteration_weights;
mod update_velocity;
mod warm_start;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buf, BufMut, Buffer, PbfIteration, PbfParams, PositionLambda, SmoothingKernelParams, WarmStart,
};

use crate::forces::Forces;
use crate::grid::NeighbourSearch;
use crate::particles::buffers::Particles;
use crate::particles::predict;
use crate::scene::{Scene, WallModel};
use crate::smoothing_kernel::{lattice, wendland};
use crate::smoothing_kernel_params::{smoothing_kernel_params, without_walls};
use crate::step_context::StepContext;
pub use chebyshev::{Chebyshev, Weights};
pub(super) use coarse_correction::{CoarseCorrection, levels as coarse_levels};
pub(crate) use coarse_correction::{MAX_CELLS, are_few_cells, finest_cells, narrow_axis};
pub use coarse_correction::{coarse_grid_params, has_coarse_correction};
use constrain_density::constrain_density;
use correct_positions::correct_positions;
pub use iteration_weights::IterationWeights;
use update_velocity::{Velocities, update_velocity};
pub use warm_start::MOST_WARM_START;
use warm_start::WarmStarts;

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
    /// The kernel of the corrections where walls count in the density and do not push.
    without_walls: Option<Buffer<SmoothingKernelParams>>,
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
    coarse: Option<CoarseCorrection>,
    warm: Option<WarmStarts>,
}

/// Quantized positions with their lambdas, as they are during one iteration.
enum Lambdas {
    /// 21 bits an axis, lambdas in f32.
    Full(Buffer<PositionLambda>),
    /// Both in eight bytes.
    Packed(Buffer<[u32; 2]>),
}

impl Lambdas {
    /// As a kernel binds them that reads them: one of the two.
    fn read(&self) -> (Option<Buf<'_, PositionLambda>>, Option<Buf<'_, [u32; 2]>>) {
        match self {
            Self::Full(lambdas) => (Some(lambdas.read()), None),
            Self::Packed(lambdas) => (None, Some(lambdas.read())),
        }
    }

    /// As one that writes them too.
    fn write(&mut self) -> (Option<BufMut<'_, PositionLambda>>, Option<BufMut<'_, [u32; 2]>>) {
        match self {
            Self::Full(lambdas) => (Some(lambdas.write()), None),
            Self::Packed(lambdas) => (None, Some(lambdas.write())),
        }
    }
}

/// Of two particles at one point: as much as about 4 % of compression gives, so that they part in some ten steps
/// without a leap.
const SEPARATION_LAMBDA: f64 = -0.02;
/// Substeps that are shorter than this share of the time in which gravity moves by a spacing, sqrt(d/g), part them in
/// as much time, not in as many substeps: the speed of parting would else grow as 1/dt.
const SEPARATION_TIME: f64 = 0.055;

/// That of a scene. Without gravity the step is what others' substeps are held against.
pub(crate) fn separation_lambda(scene: &Scene) -> f64 {
    let g_m_s2 = scene.gravity_length_m_s2();
    let fall_s = SEPARATION_TIME * (scene.fitted_spacing_m() / g_m_s2).sqrt();
    let whole_s = if g_m_s2 > 0.0 { fall_s } else { scene.solver.dt_s };
    SEPARATION_LAMBDA * (scene.substep_s() / whole_s).min(1.0)
}

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
        separation_lambda: (unconstrained * separation_lambda(scene)) as f32,
        warm_start: solver.pbf.warm_start as f32,
    }
}

impl Pbf {
    /// Declares the buffers of the terms that `scene` has.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        let solver = &scene.solver;
        let weights = IterationWeights::of(scene);
        let momentum = Momentum::declare(resources, scene, &weights, capacity);
        Self {
            params: resources.persistent("pbf_params", 1),
            search: NeighbourSearch::declare(resources, scene, capacity),
            forces: Forces::declare(resources, scene, capacity),
            iterations: solver.pbf.iterations,
            s_corr: solver.pbf.s_corr_k > 0.0,
            without_walls: (scene.domain.wall.model == WallModel::Distance)
                .then(|| resources.persistent("smoothing_kernel_without_walls", 1)),
            lambdas: match solver.precision.packs_positions() {
                true => Lambdas::Packed(resources.buffer("position_lambdas", capacity)),
                false => Lambdas::Full(resources.buffer("position_lambdas", capacity)),
            },
            momentum,
            weights,
        }
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.params, &[params(scene, &self.weights)]);
        if let Some(momentum) = &mut self.momentum {
            let buffers = momentum.weights.iter_mut();
            let params = self.weights.params(momentum.warm.is_some());
            buffers.zip(params).for_each(|(buffer, weights)| init.upload(buffer, &[weights]));
            if let Some(warm) = &mut momentum.warm {
                warm.record_init(init);
            }
            if let Some(coarse) = &mut momentum.coarse {
                coarse.record_init(init);
            }
        }
        if let Some(kernel) = &mut self.without_walls {
            init.upload(kernel, &[without_walls(smoothing_kernel_params(scene))]);
        }
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
        if let Some(solids) = &mut context.solids {
            solids.record_collide(recording, &mut particles.positions, &mut particles.velocities);
        }
        self.search.sort_forgetting(recording, context, particles);
        self.search.list(recording, context);
        self.meet_solids(recording, context);
        self.start_warm(recording, context, particles);
        particles.forget_until_moved(recording, &context.slots);
        self.iterate(recording, context, self.s_corr);
        self.confine(recording, context, true);
        if let Some(solids) = &mut context.solids {
            solids.record_gather(recording, &self.search.sorted.positions);
        }
        self.keep_pressure(recording, context);
        let what = if self.forces.smooth() { Velocities::TakeInPlace } else { Velocities::TakeCorrections };
        update_velocity(recording, context, &mut self.search, particles, what);
        self.forces.record(recording, context, &self.search, &mut particles.velocities);
    }

    /// Sorts and lists the particles where they are, and leaves them there.
    pub(super) fn record_list(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        self.search.sort_forgetting(recording, context, particles);
        self.search.list(recording, context);
        self.begin_cold(recording);
        particles.forget_until_moved(recording, &context.slots);
        self.move_particles(recording, context, particles);
    }

    /// A substep's iterations while time stands: they move particles, and change no velocity. Artificial pressure is
    /// left out, which would push on for ever.
    pub(super) fn record_relaxation(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        self.search.sort_forgetting(recording, context, particles);
        self.search.list(recording, context);
        if let Some(solids) = &mut context.solids {
            solids.record_move(recording);
        }
        self.meet_solids(recording, context);
        self.begin_cold(recording);
        particles.forget_until_moved(recording, &context.slots);
        self.iterate(recording, context, false);
        self.confine(recording, context, false);
        self.move_particles(recording, context, particles);
    }

    fn iterate(&mut self, recording: &mut Recording, context: &mut StepContext, s_corr: bool) {
        if let Some(Momentum { coarse: Some(coarse), .. }) = &mut self.momentum {
            coarse.clear(recording);
        }
        for iteration in 0..self.iterations {
            constrain_density(recording, self, context, iteration as usize);
            if let (0, Some(Momentum { coarse: Some(coarse), totals, .. })) = (iteration, &mut self.momentum) {
                coarse.record(recording, context, &self.search.sorted, &mut self.lambdas, totals.as_mut());
            }
            correct_positions(recording, self, context, s_corr);
        }
    }

    /// Tells particles of the solids near them.
    fn meet_solids(&mut self, recording: &mut Recording, context: &mut StepContext) {
        if let Some(solids) = &mut context.solids {
            solids.record_sample(recording, &self.search.sorted.positions, &self.search.smoothing_kernel);
        }
    }

    /// Holds what the iterations moved to what solids let through; bodies feel it if time passes.
    fn confine(&mut self, recording: &mut Recording, context: &mut StepContext, time_passes: bool) {
        if let Some(solids) = &mut context.solids {
            let sorted = &mut self.search.sorted;
            let (positions, quantized_positions) = (&sorted.positions, &mut sorted.quantized_positions);
            let kernel = &self.search.smoothing_kernel;
            solids.record_confine(recording, sorted.precision, positions, quantized_positions, kernel, time_passes);
        }
    }

    fn start_warm(&mut self, recording: &mut Recording, context: &StepContext, particles: &Particles) {
        if let Some(Momentum { warm: Some(warm), totals, .. }) = &mut self.momentum {
            let lambdas = (&mut self.lambdas, totals.as_mut());
            warm.start(recording, context, &mut self.search, particles, lambdas, &self.params);
        }
    }

    /// Nothing stands before the first iteration, nor before the next substep's: what was kept belongs to the slots that
    /// particles were in.
    fn begin_cold(&mut self, recording: &mut Recording) {
        let Some(Momentum { warm: Some(warm), totals, .. }) = &mut self.momentum else { return };
        recording.clear(&mut warm.starts);
        match &mut self.lambdas {
            Lambdas::Full(lambdas) => recording.clear(lambdas),
            Lambdas::Packed(lambdas) => recording.clear(lambdas),
        }
        if let Some(totals) = totals {
            recording.clear(totals);
        }
    }

    fn keep_pressure(&mut self, recording: &mut Recording, context: &StepContext) {
        if let Some(Momentum { warm: Some(warm), totals, .. }) = &mut self.momentum {
            warm.keep(recording, context, &self.search, (&self.lambdas, totals.as_ref()));
        }
    }

    /// What its shaders are told.
    pub(crate) fn params(&self) -> &Buffer<PbfParams> {
        &self.params
    }

    /// What the next substep begins with of the last one's pressure, by slot; none of scenes that begin cold.
    pub(crate) fn warm_starts(&self) -> Option<&Buffer<WarmStart>> {
        Some(&self.momentum.as_ref()?.warm.as_ref()?.starts)
    }

    fn move_particles(&mut self, recording: &mut Recording, context: &mut StepContext, particles: &mut Particles) {
        update_velocity(recording, context, &mut self.search, particles, Velocities::Keep);
    }
}

impl Momentum {
    /// None if the iterations are plain.
    fn declare(resources: &mut Resources, scene: &Scene, weights: &IterationWeights, capacity: u32) -> Option<Self> {
        let chebyshev = weights.chebyshev.as_ref()?;
        let iterations = 0..chebyshev.iterations.len();
        let coarse = CoarseCorrection::declare(resources, coarse_grid_params(scene, weights));
        // A coarse multiplier is more than the first iteration asks for: the next ones give back what is too much.
        let warm = WarmStarts::declare(resources, scene, capacity);
        let accumulates = chebyshev.accumulates() || coarse.is_some() || warm.is_some();
        let totals = accumulates && scene.solver.precision.packs_positions();
        Some(Self {
            weights: iterations.map(|n| resources.persistent(&format!("pbf_iteration_{n}"), 1)).collect(),
            accumulates,
            totals: totals.then(|| resources.buffer("lambda_totals", capacity)),
            coarse,
            warm,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_part_at_a_speed_that_short_substeps_do_not_raise() {
        let scene = |settings: &[&str]| {
            let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
            Scene::load("dam-break", &settings).unwrap()
        };
        // As much as an iteration moves over the time that it takes: a speed, but for h.
        let speed = |settings: &[&str]| -separation_lambda(&scene(settings)) / scene(settings).substep_s();
        assert_eq!(separation_lambda(&scene(&[])), SEPARATION_LAMBDA, "the step's own");
        let most = 1.7 * speed(&[]);
        for settings in [["solver.substeps=8"], ["solver.substeps=64"], ["solver.dt_s=0.00001"]] {
            assert!(speed(&settings) < most, "{settings:?}: {}", speed(&settings));
        }
        let weightless = "gravity_m_s2=[0, 0, 0]";
        let [one, eight] = [1, 8].map(|n| speed(&[weightless, &format!("solver.substeps={n}")]));
        assert!((one / eight - 1.0).abs() < 1e-9);
    }
}
