//! Spray, foam and bubbles (Ihmsen, Akinci, Akinci & Teschner 2012).

pub mod advect_diffuse;
pub mod collide_diffuse;
pub mod count_spawned;
pub mod crest_normals;
pub mod draw_diffuse;
pub mod spawn_diffuse;
pub mod walls_near;

use brooklet_kernels::DiffuseParams;
use glam::DVec3;

/// What makes and moves them; see `DiffuseParams`.
#[derive(Clone, Copy, Debug)]
pub struct Diffuse {
    /// Slots.
    pub capacity: u32,
    /// k_ta, 1/s.
    pub trapped_air_per_s: f64,
    /// k_wc, 1/s.
    pub wave_crest_per_s: f64,
    /// Lifetime of foam, s.
    pub lifetime_s: f64,
    /// Speed into neighbours, m/s.
    pub trapped_air: Ramp,
    /// Curvature.
    pub wave_crest: Ramp,
    /// Kinetic energy, J/kg.
    pub energy: Ramp,
    /// k_b.
    pub buoyancy: f64,
    /// k_d.
    pub drag: f64,
    /// Neighbours of one with fluid all around.
    pub neighbours: f64,
    /// Sum of their weights.
    pub weight: f64,
    /// Length of a flat surface's normal.
    pub normal: f64,
    /// Radius of the cylinder in which they are spawned, m.
    pub spread_m: f64,
    /// Substeps of the step.
    pub substeps: u32,
    /// 1; 0 in two dimensions.
    pub along_z: f64,
}

/// Phi(I, tau_min, tau_max), eq. (1).
#[derive(Clone, Copy, Debug)]
pub struct Ramp {
    /// tau_min.
    pub least: f64,
    /// 1 / (tau_max - tau_min).
    pub inverse_range: f64,
}

impl Ramp {
    /// Its value, 0 to 1.
    pub fn at(&self, value: f64) -> f64 {
        ((value - self.least) * self.inverse_range).clamp(0.0, 1.0)
    }
}

impl Diffuse {
    /// As the shaders are told.
    pub fn of(params: &DiffuseParams) -> Self {
        let ramp = |least: f32, inverse_range: f32| Ramp { least: least.into(), inverse_range: inverse_range.into() };
        Self {
            capacity: params.capacity,
            trapped_air_per_s: params.trapped_air_per_s.into(),
            wave_crest_per_s: params.wave_crest_per_s.into(),
            lifetime_s: params.lifetime_s.into(),
            trapped_air: ramp(params.trapped_air_least_m_s, params.trapped_air_inverse_range_s_m),
            wave_crest: ramp(params.wave_crest_least, params.wave_crest_inverse_range),
            energy: ramp(params.energy_least_j_kg, params.energy_inverse_range_kg_j),
            buoyancy: params.buoyancy.into(),
            drag: params.drag.into(),
            neighbours: 1.0 / f64::from(params.inverse_neighbours),
            weight: 1.0 / f64::from(params.inverse_weight),
            normal: 1.0 / f64::from(params.inverse_normal),
            spread_m: params.spread_m.into(),
            substeps: params.substeps,
            along_z: params.along_z.into(),
        }
    }
}

/// Where the fluid is: walls too far away to matter along axes that have none.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    /// The walls' lowest corner, m.
    pub wall_min_m: DVec3,
    /// Their highest, m.
    pub wall_max_m: DVec3,
    /// The domain's side along periodic axes, 0 along others, m.
    pub period_m: DVec3,
    /// h, m.
    pub support_m: f64,
}

/// A diffuse particle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Particle {
    /// Where it is, m.
    pub position_m: DVec3,
    /// How fast, m/s.
    pub velocity_m_s: DVec3,
    /// What is left of its lifetime, s.
    pub lifetime_s: f64,
    /// Share of the fluid particles that are near one with fluid all around.
    pub crowd: f64,
}
