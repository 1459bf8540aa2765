//! How diffuse particles move over a step. (Shader: `diffuse/advect_diffuse.compute`.)

use brooklet_kernels::{BUBBLE_ABOVE, SPRAY_BELOW};
use glam::DVec3;

use super::walls_near::share_inside;
use super::{Diffuse, Domain, Particle};
use crate::params::{Step, nearest_image};

/// How near a rounding may put what decides to either side.
const DOUBT: f64 = 1e-5;

/// A particle a step on.
#[derive(Clone, Copy, Debug)]
pub struct Advected {
    /// As it then is; a lifetime of 0: it is gone.
    pub particle: Particle,
    /// Whether a rounding decides what becomes of it.
    pub is_fickle: bool,
}

/// `particle` a step of `step.dt_s` on, among fluid particles at `fluid` (places and velocities), of which those within h
/// are looked for one by one.
pub fn advected(
    particle: &Particle,
    fluid: &[(DVec3, DVec3)],
    step: &Step,
    domain: &Domain,
    diffuse: &Diffuse,
) -> Advected {
    let (mut count, mut weight, mut carried_m_s, mut is_fickle) = (0, 0.0, DVec3::ZERO, false);
    for (position_m, velocity_m_s) in fluid {
        let q = nearest_image(particle.position_m - *position_m, domain.period_m).length() / domain.support_m;
        is_fickle |= (q - 1.0).abs() < DOUBT;
        if q < 1.0 {
            count += 1;
            weight += 1.0 - q * q;
            carried_m_s += (1.0 - q * q) * *velocity_m_s;
        }
    }
    let fluid_m_s = if weight > 0.0 { carried_m_s / weight } else { DVec3::ZERO };
    let inside = share_inside(particle.position_m, domain).max(0.125);
    let crowd = f64::from(count) / diffuse.neighbours / inside;
    let [spray, bubble] = [SPRAY_BELOW, BUBBLE_ABOVE].map(f64::from);
    is_fickle |= [spray, bubble].into_iter().any(|bound| (crowd - bound).abs() < DOUBT);

    let mut ages = false;
    let velocity_m_s = if crowd < spray {
        particle.velocity_m_s + step.gravity_m_s2 * step.dt_s
    } else if crowd <= bubble {
        ages = true;
        fluid_m_s
    } else {
        particle.velocity_m_s + diffuse.drag * (fluid_m_s - particle.velocity_m_s)
            - diffuse.buoyancy * step.gravity_m_s2 * step.dt_s
    };
    let velocity_m_s = velocity_m_s.clamp_length_max(step.max_speed_m_s);
    let end_m = particle.position_m + velocity_m_s * step.dt_s;
    let offset_m = DVec3::splat(step.wall_offset_m);
    let inside_m = match step.walls.any() {
        true => end_m.clamp(domain.wall_min_m + offset_m, domain.wall_max_m - offset_m),
        false => end_m,
    };
    let touches_m = (inside_m - end_m).length();
    is_fickle |= touches_m > 0.0 && touches_m < 1e-7;
    ages |= touches_m > 0.0;
    let lifetime_s = (particle.lifetime_s - if ages { step.dt_s } else { 0.0 }).max(0.0);
    is_fickle |= ages && (particle.lifetime_s - step.dt_s).abs() < 1e-6;

    let open = (domain.wall_max_m - domain.wall_min_m).cmpgt(2.0 * step.domain_size_m);
    let away = inside_m.cmplt(-step.domain_size_m) | inside_m.cmpgt(2.0 * step.domain_size_m);
    let particle = match (open & away).any() {
        true => Particle::default(),
        false => Particle {
            position_m: step.wrapped(inside_m),
            velocity_m_s: velocity_m_s + (inside_m - end_m) / step.dt_s,
            lifetime_s,
            crowd,
        },
    };
    Advected { particle, is_fickle }
}
