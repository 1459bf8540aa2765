//! By what the walls of the domain keep the fluid.

use serde::{Deserialize, Serialize};

use super::{Method, Scene};

/// Root of the largest k_s dt² that a scene gets by itself. With 1 a pool of PBF at 1/240 s boiled: its iterations press particles
/// into springs that then throw them out.
const PENALTY_STEP: f64 = 0.3;

/// By what walls keep the fluid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum WallModel {
    /// They count in the density, as the wall-weight function of Harada, Koshizuka & Kawaguchi 2007 or as mirrors, and answer to
    /// pressure by the slope of what they count.
    #[default]
    Pressure,
    /// They count in the density by that function, and bring whoever would come nearer than half a spacing back to that (Harada,
    /// Koshizuka & Kawaguchi 2007, eq. 11), which walls of the first model do, too.
    Distance,
    /// A spring and a damper on whoever is nearer than half a spacing (Tang, Wu & Zhou, eq. 9; Moore & Wilhelms 1988).
    Penalty,
    /// The velocity across the wall of whoever is about to come nearer than half a spacing is turned round (Müller, Charypar &
    /// Gross 2003).
    Deflection,
}

impl WallModel {
    /// Every model by its name.
    pub const NAMES: &[&str] = &["pressure", "distance", "penalty", "deflection"];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// Whether walls are part of the density.
    pub fn counts_in_density(self) -> bool {
        matches!(self, Self::Pressure | Self::Distance)
    }

    /// Whether pressure pushes away from walls.
    pub fn answers_pressure(self) -> bool {
        self == Self::Pressure
    }
}

/// By what walls keep the fluid, and how hard.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Wall {
    /// By what walls keep the fluid.
    pub model: WallModel,
    /// Stiffness k_s of the penalty over a particle's mass, 1/s². Default: that with which the fastest fall of the fluid ends
    /// within a quarter of a spacing, but no more than .09 / dt² of a substep dt.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_per_s2: Option<f64>,
    /// Damping k_d of the penalty over a particle's mass, 1/s. Default: 2 √k_s, with which nothing swings.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub damping_per_s: Option<f64>,
    /// Share of its velocity across the wall that a deflected particle keeps.
    pub restitution: f64,
}

impl Wall {
    /// Whether all of it is as if it were left out.
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

impl Scene {
    /// Stiffness of the walls' penalty over a particle's mass, 1/s².
    pub fn wall_stiffness_per_s2(&self) -> f64 {
        let stops_per_s = self.expected_speed_m_s() / (0.25 * self.fitted_spacing_m());
        let substep_s = match self.solver.method {
            Method::Sph => self.sound_limit_s().min(self.steady_limit_s()),
            Method::Pbf | Method::Dfsph | Method::None => self.substep_s(),
        };
        self.domain.wall.stiffness_per_s2.unwrap_or_else(|| stops_per_s.min(PENALTY_STEP / substep_s).powi(2))
    }

    /// Its damping, 1/s.
    pub fn wall_damping_per_s(&self) -> f64 {
        self.domain.wall.damping_per_s.unwrap_or_else(|| 2.0 * self.wall_stiffness_per_s2().sqrt())
    }

    /// Whether walls keep the fluid by a stage of their own: by neither its pressure nor their stop.
    pub fn repels_at_walls(&self) -> bool {
        self.domain.has_walls() && !self.domain.wall.model.counts_in_density()
    }
}
