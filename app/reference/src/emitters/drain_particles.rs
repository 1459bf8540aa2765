//! Which particles drains take, and whose lifetime is over. (Shader: `emitters/drain_particles.compute`.)

use glam::DVec3;

/// A region that takes what enters.
#[derive(Clone, Copy, Debug)]
pub enum Region {
    /// From its lowest to its highest corner, faces too, m.
    Box(DVec3, DVec3),
    /// Around its middle, by a radius, m.
    Sphere(DVec3, f64),
    /// All but a box.
    Outside(DVec3, DVec3),
}

/// Whether a particle is in the region.
pub fn drains(region: &Region, position_m: DVec3) -> bool {
    let in_box = |min_m: DVec3, max_m: DVec3| position_m.clamp(min_m, max_m) == position_m;
    match *region {
        Region::Box(min_m, max_m) => in_box(min_m, max_m),
        Region::Sphere(centre_m, radius_m) => position_m.distance(centre_m) <= radius_m,
        Region::Outside(min_m, max_m) => !in_box(min_m, max_m),
    }
}

/// Whether a lifetime ends in a substep of `dt_s`: an age below 0 is what is left of it.
pub fn is_over(age_s: f64, dt_s: f64) -> bool {
    age_s < 0.0 && age_s + dt_s >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_have_their_faces() {
        let (min_m, max_m) = (DVec3::ZERO, DVec3::ONE);
        let boxed = Region::Box(min_m, max_m);
        assert!(drains(&boxed, min_m) && drains(&boxed, max_m) && !drains(&boxed, 1.001 * max_m));
        let outside = Region::Outside(min_m, max_m);
        assert!(!drains(&outside, max_m) && drains(&outside, 1.001 * max_m));
        let ball = Region::Sphere(DVec3::ONE, 0.5);
        assert!(drains(&ball, DVec3::new(1.0, 1.5, 1.0)) && !drains(&ball, DVec3::new(1.3, 1.4, 1.1)));
    }

    #[test]
    fn a_lifetime_ends_once_and_no_other_age_does() {
        let mut age_s = -0.35;
        let mut substeps = 0;
        while !is_over(age_s, 0.1) {
            age_s += 0.1;
            substeps += 1;
        }
        assert_eq!(substeps, 3);
        assert!(!is_over(0.0, 0.1) && !is_over(5.0, 0.1));
    }
}
