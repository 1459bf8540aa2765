//! What diffuse particles may be told together.

use super::Checker;
use crate::scene::field::Short;
use crate::scene::{Scene, SceneError};

impl Scene {
    /// Limits in order.
    pub(super) fn check_diffuse(&self, check: &Checker) -> Result<(), SceneError> {
        let Some(diffuse) = &self.diffuse else { return Ok(()) };
        let air = self.trapped_air_limits_m_s(diffuse);
        let energy = self.energy_limits_j_kg(diffuse);
        for (field, least, [min, max], unit) in [
            ("trapped_air_max_m_s", "trapped_air_min_m_s", air, " m/s"),
            ("wave_crest_max", "wave_crest_min", [diffuse.wave_crest_min, diffuse.wave_crest_max], ""),
            ("energy_max_j_kg", "energy_min_j_kg", energy, " J/kg"),
        ] {
            check.require(
                max > min,
                &format!("diffuse.{field}"),
                Short(max),
                format_args!("must be above {least} = {}{unit}", Short(min)),
            )?;
        }
        Ok(())
    }
}
