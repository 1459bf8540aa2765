//! What a picture of the fluid may be told together.

use super::{Checker, numbers};
use crate::scene::{Scene, SceneError};

impl Scene {
    /// No light in a metal.
    pub(super) fn check_surface(&self, check: &Checker) -> Result<(), SceneError> {
        let surface = &self.surface;
        if surface.metal_reflectance.is_none() {
            return Ok(());
        }
        for (is_on, field) in [
            (surface.caustics == Some(true), "surface.caustics"),
            (surface.self_shadow == Some(true), "surface.self_shadow"),
        ] {
            let allowed = "must be false or left out with surface.metal_reflectance: no light passes a metal";
            check.require(!is_on, field, true, allowed)?;
        }
        check.require(
            surface.absorption_per_m.is_none(),
            "surface.absorption_per_m",
            numbers(surface.absorption_per_m.unwrap_or_default()),
            "must be left out with surface.metal_reflectance: no light passes a metal",
        )
    }
}
