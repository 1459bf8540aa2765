//! How solids stop diffuse particles. (Shader: `diffuse/collide_diffuse.compute`.)

use brooklet_kernels::{BUBBLE_ABOVE, SPRAY_BELOW};
use glam::DVec3;

use super::Particle;
use crate::boundary::solids::collide::{Moving, path_among_solids};

/// Of the distance that particles keep: less than that is no touch.
const UNTOUCHED: f64 = 1e-3;

/// `particle`, which came along its velocity in `substeps` of `substep_s`, among solids that stand.
pub fn collided(
    particle: &Particle,
    (substeps, substep_s): (u32, f64),
    solids: &[Moving],
    stop_m: f64,
    confined: impl Fn(DVec3) -> DVec3,
) -> Particle {
    let dt_s = substep_s * f64::from(substeps);
    let mut at_m = particle.position_m - particle.velocity_m_s * dt_s;
    for _ in 0..substeps {
        at_m = path_among_solids(at_m, at_m + particle.velocity_m_s * substep_s, solids, stop_m, &confined);
    }
    let pushed_m = at_m - particle.position_m;
    if pushed_m.length() <= UNTOUCHED * stop_m {
        return *particle;
    }
    let is_foam = (f64::from(SPRAY_BELOW)..=f64::from(BUBBLE_ABOVE)).contains(&particle.crowd);
    Particle {
        position_m: at_m,
        velocity_m_s: particle.velocity_m_s + pushed_m / dt_s,
        lifetime_s: (particle.lifetime_s - if is_foam { 0.0 } else { dt_s }).max(0.0),
        ..*particle
    }
}
