//! How many diffuse particles a fluid particle spawns. (Shader: `diffuse/count_spawned.compute`.)

use glam::DVec3;

use super::{Diffuse, Domain};
use crate::params::nearest_image;
use crate::shared::hash::{hash, share};

/// How near a rounding may put what decides to either side.
const DOUBT: f64 = 1e-5;
/// Cosine between velocity and normal from which on a crest runs forward.
const FORWARD: f64 = 0.6;

/// The fluid as it is told: a normal's length is 1, or 0 where there is none; with it how much of a surface there is.
#[derive(Clone, Copy, Debug)]
pub struct Fluid<'a> {
    /// Places, m.
    pub positions_m: &'a [DVec3],
    /// Velocities, m/s.
    pub velocities_m_s: &'a [DVec3],
    /// Normals.
    pub normals: &'a [(DVec3, f64)],
}

/// How many are due of particle `i` in `dt_s`, at least and at most: what decides between all and nothing of a term may be
/// rounded to either side.
pub fn due(
    i: usize,
    fluid: &Fluid<'_>,
    neighbours: &[usize],
    dt_s: f64,
    domain: &Domain,
    diffuse: &Diffuse,
) -> [f64; 2] {
    let (velocity_m_s, (normal, surface)) = (fluid.velocities_m_s[i], fluid.normals[i]);
    let mut meeting_m_s = 0.0;
    let mut curvature = [0.0; 2];
    for &j in neighbours {
        let offset_m = nearest_image(fluid.positions_m[i] - fluid.positions_m[j], domain.period_m);
        let weight = (1.0 - offset_m.length() / domain.support_m).max(0.0);
        let away = offset_m.normalize_or_zero();
        let difference_m_s = velocity_m_s - fluid.velocities_m_s[j];
        // |v| (1 - v̂ x̂), eq. (2).
        meeting_m_s += (difference_m_s.length() - difference_m_s.dot(away)) * weight;
        let (other, of_surface) = fluid.normals[j];
        let term = (1.0 - normal.dot(other)) * weight * of_surface;
        curvature[0] += if away.dot(normal) > DOUBT { term } else { 0.0 };
        curvature[1] += if away.dot(normal) > -DOUBT { term } else { 0.0 };
    }
    let forward = velocity_m_s.normalize_or_zero().dot(normal);
    let shares = [FORWARD + DOUBT, FORWARD - DOUBT].map(|least| if forward >= least { surface } else { 0.0 });
    let energy = diffuse.energy.at(0.5 * velocity_m_s.length_squared());
    let air = diffuse.trapped_air.at(meeting_m_s / diffuse.weight);
    std::array::from_fn(|k| {
        let crest = diffuse.wave_crest.at(curvature[k] * shares[k] / diffuse.weight);
        energy * (diffuse.trapped_air_per_s * air + diffuse.wave_crest_per_s * crest) * dt_s
    })
}

/// The chance that what is left of a whole number becomes one: `due` and this, rounded down.
pub fn chance(id: u32, time_s: f32) -> f64 {
    share(id.wrapping_add(hash(time_s.to_bits())))
}
