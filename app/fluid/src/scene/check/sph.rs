//! What the settings of SPH may be.

use super::{Checker, LEAST_TENSION_RATIO, MAX_SUBSTEPS};
use crate::scene::field::Short;
use crate::scene::{Scene, SceneError, SmoothingKernel};

impl Scene {
    /// Kernels with an end where they meet their own particle, and no more substeps than a recording holds.
    pub(super) fn check_sph(&self, check: &Checker) -> Result<(), SceneError> {
        let sph = &self.solver.sph;
        for (field, kernel) in
            [("solver.sph.density_kernel", sph.density_kernel), ("solver.sph.pressure_kernel", sph.pressure_kernel)]
        {
            check.require(
                kernel != SmoothingKernel::Viscosity,
                field,
                "\"viscosity\"",
                format_args!(
                    "must be \"{}\": that kernel has no end where particles meet",
                    SmoothingKernel::FINITE_NAMES.join("\" or \"")
                ),
            )?;
        }
        check.require(
            sph.surface_tension_n_m == 0.0 || self.solver.support_ratio >= LEAST_TENSION_RATIO,
            "solver.sph.surface_tension_n_m",
            Short(sph.surface_tension_n_m),
            format_args!(
                "needs a solver.support_ratio of {LEAST_TENSION_RATIO} or more: with less a surface has \
                 one layer that knows its normal, and a drop was measured to lose particles"
            ),
        )?;
        if !sph.adaptive_substeps {
            return Ok(());
        }
        let (most, limit_s) = (self.most_substeps(), self.sound_limit_s().min(self.steady_limit_s()));
        check.require(
            most <= MAX_SUBSTEPS,
            "solver.dt_s",
            Short(self.solver.dt_s),
            format_args!(
                "takes up to {most} substeps, whose limit is {:.3e} s by the speed of sound and viscosity; at most \
                 {MAX_SUBSTEPS}: a shorter solver.dt_s, or less of solver.sph.stiffness_m2_s2 or of the viscosities",
                limit_s
            ),
        )
    }
}
