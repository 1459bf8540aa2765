//! Vorticity confinement (Fedkiw, Stam & Jensen 2001; Macklin & Muller 2013, eq. 16).

use crate::params::{Forces, Smoothing, Step};
use crate::shared::wendland;
use glam::DVec3;

/// A particle's push, and how sure its direction is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Confined {
    /// The velocity with the push.
    pub velocity_m_s: DVec3,
    /// |gradient of |omega||, without its scale: where it is near zero the direction is arbitrary.
    pub steepness_per_s: f64,
    /// Sum of the lengths of the gradient's terms: what rounding is relative to.
    pub terms_per_s: f64,
}

/// Pushes particle `i` along N x omega, where N points towards larger |omega|.
#[allow(clippy::too_many_arguments)]
pub fn confine_vorticity(
    i: usize,
    positions_m: &[DVec3],
    velocity_m_s: DVec3,
    vorticities_per_s: &[DVec3],
    neighbours: &[usize],
    step: &Step,
    smoothing: &Smoothing,
    forces: &Forces,
) -> Confined {
    let own = vorticities_per_s[i];
    let mut slope = DVec3::ZERO;
    let mut terms = 0.0;
    for &j in neighbours {
        let offset = smoothing.offset(positions_m[i], positions_m[j]);
        let rise = vorticities_per_s[j].length() - own.length();
        let term = wendland::gradient(offset) * rise;
        slope += term;
        terms += term.length();
    }
    let steepness = slope.length();
    let push_m_s2 = if steepness > FLAT * own.length() && steepness > 0.0 {
        (slope / steepness).cross(own) * forces.vorticity_m_s
    } else {
        DVec3::ZERO
    };
    Confined { velocity_m_s: velocity_m_s + push_m_s2 * step.dt_s, steepness_per_s: steepness, terms_per_s: terms }
}

/// A field whose slope over h is below this share of itself has no direction.
pub const FLAT: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;
    use glam::BVec3;

    #[test]
    fn pushes_around_the_stronger_swirl() {
        // The neighbour at +x swirls faster: N = +x, and N x z = -y.
        let points = [DVec3::ZERO, DVec3::new(0.5, 0.0, 0.0)];
        let vorticities = [DVec3::Z, DVec3::Z * 2.0];
        let step = Step {
            gravity_m_s2: DVec3::ZERO,
            dt_s: 0.1,
            domain_size_m: DVec3::ONE,
            walls: BVec3::FALSE,
            period_m: DVec3::ZERO,
            wall_offset_m: 0.0,
            max_speed_m_s: 10.0,
        };
        let smoothing = Smoothing::new(1.0, 1.0);
        let forces = Forces { vorticity_m_s: 0.3, ..Forces::default() };
        let push = confine_vorticity(0, &points, DVec3::ZERO, &vorticities, &[1], &step, &smoothing, &forces);
        assert!((push.velocity_m_s - DVec3::NEG_Y * 0.03).length() < 1e-15);
        let even = [DVec3::Z, DVec3::Z];
        let push = confine_vorticity(0, &points, DVec3::ZERO, &even, &[1], &step, &smoothing, &forces);
        assert_eq!(push.velocity_m_s, DVec3::ZERO);
    }
}
