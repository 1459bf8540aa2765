//! What a scene's values may be.

use std::fmt::Debug;

use super::{Fluid, Scene, SceneError};
use crate::particles::MAX_PARTICLES;

/// Cells a grid may have: their counts and starts stay inside one 128 MiB binding.
pub(crate) const MAX_CELLS: f64 = (1 << 25) as f64;

struct Checker<'a> {
    source_name: &'a str,
}

impl Checker<'_> {
    fn require(&self, ok: bool, field: &str, value: impl Debug, allowed: &str) -> Result<(), SceneError> {
        if ok {
            return Ok(());
        }
        Err(SceneError::NotAllowed {
            source_name: self.source_name.into(),
            field: field.into(),
            value: format!("{value:?}"),
            allowed: allowed.into(),
        })
    }

    fn range(&self, field: &str, value: f64, low: f64, high: f64) -> Result<(), SceneError> {
        self.require((low..=high).contains(&value), field, value, &format!("must be {low} to {high}"))
    }

    fn positive(&self, field: &str, value: f64) -> Result<(), SceneError> {
        self.require(value > 0.0 && value.is_finite(), field, value, "must be a positive number")
    }

    fn finite(&self, field: &str, value: [f64; 3]) -> Result<(), SceneError> {
        self.require(value.iter().all(|x| x.is_finite()), field, value, "must be three finite numbers")
    }

    fn ordered(&self, field: &str, min: [f64; 3], max: [f64; 3]) -> Result<(), SceneError> {
        self.finite(&format!("{field}.min_m"), min)?;
        self.finite(&format!("{field}.max_m"), max)?;
        let ok = (0..3).all(|axis| max[axis] > min[axis]);
        self.require(ok, &format!("{field}.max_m"), max, &format!("must be above min_m = {min:?} along each axis"))
    }
}

impl Scene {
    pub(super) fn check(&self, source_name: &str) -> Result<(), SceneError> {
        let check = Checker { source_name };
        check.positive("spacing_m", self.spacing_m)?;
        check.finite("gravity_m_s2", self.gravity_m_s2)?;
        check.ordered("domain", self.domain.min_m, self.domain.max_m)?;
        let size_m = self.domain.size_m();
        check.require(
            size_m.iter().all(|&s| s >= self.spacing_m),
            "domain",
            size_m,
            &format!("each side must be at least spacing_m = {}", self.spacing_m),
        )?;
        self.check_solver(&check)?;
        let cells: f64 = crate::grid::cells(self).iter().map(|&n| n as f64).product();
        check.require(
            cells <= MAX_CELLS,
            "domain",
            size_m,
            &format!(
                "needs {cells:.3e} grid cells of h/2; at most {MAX_CELLS:.3e}: make it smaller or spacing_m larger"
            ),
        )?;
        let mut particles = 0.0;
        for (index, fluid) in self.fluids.iter().enumerate() {
            self.check_fluid(&check, &format!("fluid.{index}"), fluid)?;
            particles += fluid.volume_m3() / self.spacing_m.powi(3);
        }
        check.require(
            particles <= f64::from(MAX_PARTICLES),
            "spacing_m",
            self.spacing_m,
            &format!("makes about {particles:.3e} particles; at most {MAX_PARTICLES}"),
        )?;
        if let Some(camera) = &self.camera {
            check.finite("camera.eye_m", camera.eye_m)?;
            check.finite("camera.target_m", camera.target_m)?;
            check.require(
                camera.eye_m != camera.target_m,
                "camera.eye_m",
                camera.eye_m,
                "must differ from target_m",
            )?;
            check.range("camera.fov_deg", camera.fov_deg, 1.0, 150.0)?;
        }
        check.range("outputs.seconds", self.outputs.seconds, 0.0, 1.0e6)?;
        check.range("outputs.width_px", f64::from(self.outputs.width_px), 1.0, 8192.0)?;
        check.range("outputs.height_px", f64::from(self.outputs.height_px), 1.0, 8192.0)?;
        check.range("outputs.images", f64::from(self.outputs.images), 0.0, 100_000.0)
    }

    fn check_solver(&self, check: &Checker) -> Result<(), SceneError> {
        let solver = &self.solver;
        check.positive("solver.dt_s", solver.dt_s)?;
        check.range("solver.substeps", f64::from(solver.substeps), 1.0, 1000.0)?;
        check.range("solver.iterations", f64::from(solver.iterations), 0.0, 1000.0)?;
        check.range("solver.support_ratio", solver.support_ratio, 1.2, 4.0)?;
        check.require(
            solver.relaxation > 0.0 && solver.relaxation <= 1.0,
            "solver.relaxation",
            solver.relaxation,
            "must be above 0 and at most 1",
        )?;
        check.range("solver.cfm", solver.cfm, 1.0e-6, 1.0e3)?;
        check.range("solver.s_corr_k", solver.s_corr_k, 0.0, 10.0)?;
        check.range("solver.s_corr_distance_ratio", solver.s_corr_distance_ratio, 0.0, 0.9)?;
        check.range("solver.xsph", solver.xsph, 0.0, 1.0)?;
        check.range("solver.vorticity_m_s", solver.vorticity_m_s, 0.0, 1.0e3)?;
        if let Some(max_speed_m_s) = solver.max_speed_m_s {
            check.positive("solver.max_speed_m_s", max_speed_m_s)?;
        }
        check.range("solver.neighbour_slots", f64::from(solver.neighbour_slots), 1.0, 1024.0)
    }

    fn check_fluid(&self, check: &Checker, field: &str, fluid: &Fluid) -> Result<(), SceneError> {
        check.finite(&format!("{field}.velocity_m_s"), fluid.velocity_m_s)?;
        check.positive(&format!("{field}.rest_density_kg_m3"), fluid.rest_density_kg_m3)?;
        check.require(
            fluid.rest_density_kg_m3 == self.rest_density_kg_m3(),
            &format!("{field}.rest_density_kg_m3"),
            fluid.rest_density_kg_m3,
            &format!(
                "must be that of fluid.0, {}: fluids of different densities are not there yet",
                self.rest_density_kg_m3()
            ),
        )?;
        let (min, max) = match (&fluid.block, &fluid.sphere) {
            (Some(block), None) => {
                check.ordered(&format!("{field}.block"), block.min_m, block.max_m)?;
                (block.min_m, block.max_m)
            }
            (None, Some(sphere)) => {
                check.finite(&format!("{field}.sphere.centre_m"), sphere.centre_m)?;
                check.positive(&format!("{field}.sphere.radius_m"), sphere.radius_m)?;
                (sphere.centre_m.map(|x| x - sphere.radius_m), sphere.centre_m.map(|x| x + sphere.radius_m))
            }
            (None, None) => {
                return check.require(false, field, "nothing", "give it a `block` or a `sphere`");
            }
            (Some(_), Some(_)) => {
                return check.require(false, field, "block and sphere", "give it one of the two");
            }
        };
        // A hair of tolerance: 0.1 + 0.2 is above 0.3.
        let slack_m = 1.0e-6 * self.spacing_m;
        let inside = (0..3).all(|axis| {
            min[axis] >= self.domain.min_m[axis] - slack_m && max[axis] <= self.domain.max_m[axis] + slack_m
        });
        check.require(
            inside,
            field,
            format_args!("{min:?} to {max:?}"),
            &format!("must lie inside the domain, {:?} to {:?}", self.domain.min_m, self.domain.max_m),
        )
    }
}

impl Fluid {
    fn volume_m3(&self) -> f64 {
        let block = self.block.as_ref().map(|b| (0..3).map(|axis| b.max_m[axis] - b.min_m[axis]).product());
        let sphere = self.sphere.as_ref().map(|s| 4.0 / 3.0 * std::f64::consts::PI * s.radius_m.powi(3));
        block.or(sphere).unwrap_or(0.0)
    }
}
