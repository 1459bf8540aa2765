//! What divergence-free SPH takes.

use serde::{Deserialize, Serialize};

use super::{Fluid, Scene};

/// Largest pressure p dt² / (ρ0 h²) of fluid at rest with which a substep is stable. Pressure is added at once, and from some
/// size on it pushes pairs past each other: in f64 trials a column stands with .077 and bursts with .15, however exactly it is
/// solved for.
const MOST_PRESSURE: f64 = 0.06;

impl Scene {
    /// How deep the fluid begins, m: along gravity, between the ends of all bodies, and no deeper than all of them on each other.
    pub(crate) fn depth_m(&self) -> f64 {
        let size = self.gravity_length_m_s2();
        if size <= 0.0 {
            return 0.0;
        }
        let bounds: Vec<([f64; 3], [f64; 3])> = self.fluids.iter().map(Fluid::bounds_m).collect();
        let along = |axis: usize| {
            let low_m = bounds.iter().map(|(min_m, _)| min_m[axis]).fold(f64::INFINITY, f64::min);
            let high_m = bounds.iter().map(|(_, max_m)| max_m[axis]).fold(f64::NEG_INFINITY, f64::max);
            let stacked_m: f64 = bounds.iter().map(|(min_m, max_m)| max_m[axis] - min_m[axis]).sum();
            (high_m - low_m).min(stacked_m).max(0.0)
        };
        (0..3).map(|axis| (self.gravity_m_s2[axis] / size).abs() * along(axis)).sum()
    }

    /// Substeps of a step that DFSPH takes: as many as the scene says, and as its depth needs at the start.
    pub(super) fn dfsph_substeps(&self) -> u32 {
        let g_depth_m2_s2 = self.gravity_length_m_s2() * self.depth_m();
        let needed = self.solver.dt_s * (g_depth_m2_s2 / MOST_PRESSURE).sqrt() / self.support_m();
        // A hair less: rounding makes no substep more.
        (needed - 1e-6).ceil().max(f64::from(self.solver.substeps)) as u32
    }
}

/// Settings of `method = "dfsph"`. A solve without iterations leaves no pass of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct DfsphSettings {
    /// Mean residual at which a substep's divergence solve ends: of the density ratio, by what velocities would make particles
    /// too dense in the substep, or pressure keeps them too thin.
    pub divergence_tolerance: f64,
    /// The same of the density solve: of what is left of the compression that it takes out.
    pub density_tolerance: f64,
    /// Most iterations of a substep's divergence solve, which is the fluid's pressure. Solves that end here above their
    /// tolerance are counted.
    pub max_divergence_iterations: u32,
    /// Most iterations of its density solve, which takes half of what compression there is out of the positions and leaves
    /// the velocities; 0 leaves it out.
    pub max_density_iterations: u32,
    /// Whether the solves begin with the pressures that the last substep's ended with.
    pub warm_start: bool,
    /// Whether both solves do as many iterations as they may, whatever is left: nothing is measured for them and nothing is
    /// dispatched indirectly, as slow devices like it. Tolerances then mean nothing.
    pub fixed_iterations: bool,
    /// Share of what an iteration added to pressures that the next one adds again, as Chebyshev's semi-iteration does in the
    /// limit: 0 is plain Jacobi.
    pub momentum: f64,
    /// Whether a coarse grid corrects a divergence solve's first iteration; three iterations at least, and a thirtieth of the
    /// tolerance, follow. Default: where the fluid begins deeper than 64 layers.
    pub coarse_correction: Option<bool>,
}

impl Default for DfsphSettings {
    fn default() -> Self {
        Self {
            divergence_tolerance: 3.0e-4,
            density_tolerance: 1.0e-3,
            max_divergence_iterations: 30,
            max_density_iterations: 20,
            warm_start: true,
            fixed_iterations: false,
            momentum: 0.4,
            coarse_correction: None,
        }
    }
}
