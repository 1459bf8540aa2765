//! Spray, foam and bubbles.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::Scene;

/// Diffuse particles: spray, foam and bubbles, which the fluid spawns where it traps air and where waves break (Ihmsen, Akinci,
/// Akinci & Teschner 2012). They are drawn with the fluid and do nothing to it. Only of solvers whose particles interact.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct DiffuseSettings {
    /// Room for so many; of more, the oldest are overwritten. 0 leaves all of it out.
    pub max_particles: u32,
    /// How many a fluid particle spawns at most where it traps air, 1/s (the paper's k_ta).
    pub trapped_air_per_s: f64,
    /// How many at most at a wave's crest, 1/s (k_wc).
    pub wave_crest_per_s: f64,
    /// How long foam lives, s: each from half of it to half as much again.
    pub lifetime_s: f64,
    /// How strongly bubbles rise, over gravity (k_b).
    pub buoyancy: f64,
    /// Share of the fluid's velocity that a bubble takes on in a step (k_d).
    pub drag: f64,
    /// How fast neighbours run into each other for air to be trapped, m/s, and from how fast on as much as may be. Default: 0.06
    /// and 0.4 of the speed √(g H), with which a wave runs in fluid as deep as the domain is high.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trapped_air_min_m_s: Option<f64>,
    /// The upper end of it, m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trapped_air_max_m_s: Option<f64>,
    /// How curved a crest is that breaks: the mean of 1 - cos of the angles to the normals around.
    pub wave_crest_min: f64,
    /// How curved one is that breaks as much as may be.
    pub wave_crest_max: f64,
    /// Kinetic energy below which nothing is spawned, J/kg. Default: that of 0.2 √(g H).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_min_j_kg: Option<f64>,
    /// Kinetic energy from which on as much is spawned as may be, J/kg. Default: that of 0.8 √(g H).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_max_j_kg: Option<f64>,
}

impl Default for DiffuseSettings {
    fn default() -> Self {
        Self {
            max_particles: 200_000,
            trapped_air_per_s: 300.0,
            wave_crest_per_s: 300.0,
            lifetime_s: 2.0,
            buoyancy: 2.0,
            drag: 0.8,
            trapped_air_min_m_s: None,
            trapped_air_max_m_s: None,
            wave_crest_min: 0.04,
            wave_crest_max: 0.25,
            energy_min_j_kg: None,
            energy_max_j_kg: None,
        }
    }
}

/// Below the first nothing is spawned, above the second no more.
pub type Limits = [f64; 2];

impl Scene {
    /// What it says of diffuse particles, if it has any.
    pub fn diffuse_particles(&self) -> Option<&DiffuseSettings> {
        self.diffuse.as_ref().filter(|diffuse| diffuse.max_particles > 0 && self.solver.method.interacts())
    }

    /// Speed of a long wave in fluid as deep as the domain is high, m/s: what speeds of the scene's events scale with. Without
    /// gravity that of the earth's.
    fn wave_speed_m_s(&self) -> f64 {
        let (gravity, size_m) = (self.gravity_m_s2, self.domain.size_m());
        let g = self.gravity_length_m_s2();
        let depth_m = match g > 0.0 {
            true => (0..3).map(|axis| gravity[axis].abs() / g * size_m[axis]).sum::<f64>(),
            false => size_m[1],
        };
        (if g > 0.0 { g } else { 9.81 } * depth_m).sqrt()
    }

    /// Between which speeds of neighbours into each other air is trapped, m/s.
    pub fn trapped_air_limits_m_s(&self, diffuse: &DiffuseSettings) -> Limits {
        let wave_m_s = self.wave_speed_m_s();
        [diffuse.trapped_air_min_m_s.unwrap_or(0.06 * wave_m_s), diffuse.trapped_air_max_m_s.unwrap_or(0.4 * wave_m_s)]
    }

    /// Between which kinetic energies particles are spawned, J/kg.
    pub fn energy_limits_j_kg(&self, diffuse: &DiffuseSettings) -> Limits {
        let of = |share: f64| 0.5 * (share * self.wave_speed_m_s()).powi(2);
        [diffuse.energy_min_j_kg.unwrap_or(of(0.2)), diffuse.energy_max_j_kg.unwrap_or(of(0.8))]
    }

    /// Neighbours of a particle with fluid all around, and the sum of their weights 1 - r/h.
    pub fn neighbours_all_around(&self) -> [f64; 2] {
        let ratio = self.solver.support_ratio;
        let [all, weight] = match self.domain.is_flat() {
            true => [PI * ratio.powi(2), PI / 3.0 * ratio.powi(2)],
            false => [4.0 / 3.0 * PI * ratio.powi(3), PI / 3.0 * ratio.powi(3)],
        };
        // But itself.
        [all - 1.0, weight - 1.0]
    }

    /// The sum over neighbours of (x_i - x_j)/r (1 - r/h) for a particle on a plane above which is nothing: its length.
    pub fn flat_normal(&self) -> f64 {
        let ratio = self.solver.support_ratio;
        match self.domain.is_flat() {
            true => ratio.powi(2) / 3.0,
            false => PI / 12.0 * ratio.powi(3),
        }
    }
}
