//! The acceleration of a particle. (Shader: `solver/sph/accelerate.compute`.)

use super::compute_density::{Kernels, State, Terms};
use crate::boundary::sample_boundary;
use crate::boundary::walls::DomainWalls;
use crate::params::{Smoothing, Step};
use glam::DVec3;

/// What all particles' accelerations are made of.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a> {
    /// Where they are.
    pub positions_m: &'a [DVec3],
    /// How fast.
    pub velocities_m_s: &'a [DVec3],
    /// Their pressures.
    pub states: &'a [State],
}

/// The share of the stress that is the same in all directions; Lafaurie's is 1.
const ISOTROPIC: f64 = 1.25;

/// The colour field's stress times a vector, over the tension: 1.25 |n| v - n (n·v)/|n| (Lafaurie et al. 1994: 1).
fn stress_times(normal: DVec3, v: DVec3) -> DVec3 {
    let length = normal.length();
    if length > 0.0 { ISOTROPIC * length * v - normal * (normal.dot(v) / length) } else { DVec3::ZERO }
}

/// Of particle `i`, m/s². `separation` gives the direction, of length 1, in which it parts from another at its own place.
#[expect(clippy::too_many_arguments)]
pub fn accelerate(
    i: usize,
    flow: &Flow<'_>,
    neighbours: &[usize],
    step: &Step,
    smoothing: &Smoothing,
    kernels: &Kernels,
    terms: &Terms,
    pressure_walls: Option<&DomainWalls>,
    separation: impl Fn(usize, usize) -> DVec3,
) -> DVec3 {
    let own = flow.states[i];
    let (mut push, mut shear_m_s, mut stress) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
    for &j in neighbours {
        let other = flow.states[j];
        let offset = smoothing.offset(flow.positions_m[i], flow.positions_m[j]);
        let q = offset.length();
        let gradient = kernels.push(offset);
        push += (own.pressure_m2_s2 + other.pressure_m2_s2) * gradient;
        if q > 0.0 {
            let weight = kernels.viscosity.scale * kernels.viscosity.kernel.laplacian(q);
            shear_m_s += weight * (flow.velocities_m_s[j] - flow.velocities_m_s[i]);
        }
        let draw = kernels.draw(offset);
        stress -= stress_times(own.normal, draw) + stress_times(other.normal, draw);
        if q < terms.separation {
            let direction = if q < COINCIDENT { separation(i, j) } else { offset / q };
            push += terms.separation_m2_s2 * (1.0 - q / terms.separation) * direction;
        }
    }
    let boundary = sample_boundary(flow.positions_m[i], pressure_walls);
    push = push * boundary.correction_scale - 2.0 * own.pressure_m2_s2 * boundary.gradient;
    let h_m = smoothing.support_m;
    let supported = (own.pressure_m2_s2 * terms.supported_per_m2_s2).clamp(0.0, 1.0);
    push / h_m
        + shear_m_s * (terms.viscosity_m2_s / (h_m * h_m))
        + step.gravity_m_s2 * (DVec3::ONE - supported * terms.borne_scale * boundary.borne)
        + stress * (terms.tension_m3_s2 / (h_m * h_m))
}

/// Closer than this, in h, counts as one point.
pub const COINCIDENT: f64 = 1.0e-4;
