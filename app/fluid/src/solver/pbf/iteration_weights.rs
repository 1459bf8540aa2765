//! How the iterations of a substep are weighted: those of Jacobi all alike, or by an acceleration.

use brooklet_kernels::PbfIteration;

use super::chebyshev::{Chebyshev, Weights};
use crate::scene::{Acceleration, Scene};
use crate::spectrum::lambda_max;

/// The weights of a scene of PBF. They take a search over the kernel's spectrum (0.7 ms at h = 2 d on a slow core), so a plan
/// asks for them once.
#[derive(Clone, Debug, PartialEq)]
pub struct IterationWeights {
    /// ω of plain iterations, and of what an acceleration leaves plain.
    pub relaxation: f64,
    /// What accelerates them. None if the scene wants nothing, or what answers slow modes less than as many Jacobi
    /// iterations do: that of a single iteration, and in two dimensions that of two.
    pub chebyshev: Option<Chebyshev>,
    /// What a substep does to a constraint that varies slowly, over one iteration of weight 1: n ω, or the acceleration's.
    /// The column law's compression is inverse to it.
    pub response: f64,
}

impl IterationWeights {
    /// Those of `scene`.
    pub fn of(scene: &Scene) -> Self {
        let (solver, pbf) = (&scene.solver, &scene.solver.pbf);
        let lambda_max = lambda_max(scene.domain.dimensions, solver.support_ratio, pbf.cfm);
        let relaxation = scene.relaxation_at(lambda_max);
        let plain = f64::from(pbf.iterations) * relaxation;
        let is_wanted = pbf.acceleration == Acceleration::Chebyshev && pbf.iterations >= 2;
        let chebyshev = is_wanted
            .then(|| Chebyshev::new(pbf.iterations, lambda_max))
            .filter(|chebyshev| chebyshev.response > plain);
        let response = chebyshev.as_ref().map_or(plain, |chebyshev| chebyshev.response);
        Self { relaxation, chebyshev, response }
    }

    /// What it comes to, whatever the scene asks for.
    pub fn acceleration(&self) -> Acceleration {
        if self.chebyshev.is_some() { Acceleration::Chebyshev } else { Acceleration::None }
    }

    /// Of the constraint in an accelerated iteration, where the fluid is very compressed.
    pub fn guarded_step(&self, weights: &Weights) -> f64 {
        weights.step.min(self.relaxation)
    }

    /// What the shaders are given of the accelerated iterations, in order; `is_warm` if something stands before the first.
    pub(super) fn params(&self, is_warm: bool) -> impl Iterator<Item = PbfIteration> {
        let all = self.chebyshev.iter().flat_map(|chebyshev| &chebyshev.iterations).enumerate();
        all.map(move |(n, weights)| PbfIteration {
            step: weights.step as f32,
            momentum: weights.momentum as f32,
            guarded_step: self.guarded_step(weights) as f32,
            begins_cold: u32::from(n == 0 && !is_warm),
        })
    }
}
