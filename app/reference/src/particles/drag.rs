//! Particles near a ray are drawn toward a velocity. (Shader: `particles/drag.compute`.)

use glam::DVec3;

/// What is dragged, and where; see `DragParams` of the shaders' layout.
#[derive(Clone, Copy, Debug)]
pub struct Drag {
    /// Where the ray begins.
    pub origin_m: DVec3,
    /// Where it goes, of length 1.
    pub direction: DVec3,
    /// Nothing farther from it is touched.
    pub radius_m: f64,
    /// Nothing before this distance along it is touched.
    pub near_m: f64,
    /// Nor behind this one.
    pub far_m: f64,
    /// What velocities are drawn toward.
    pub velocity_m_s: DVec3,
    /// Share of the way there that is made up on the ray itself.
    pub share: f64,
    /// Whether nothing moves along z.
    pub flat: bool,
}

impl Drag {
    /// Weight at a position: 1 on the ray, 0 where it does not reach.
    pub fn weight(&self, position_m: DVec3) -> f64 {
        let from_origin_m = position_m - self.origin_m;
        let depth_m = from_origin_m.dot(self.direction);
        let q = (from_origin_m - depth_m * self.direction).length() / self.radius_m;
        if q < 1.0 && (self.near_m..=self.far_m).contains(&depth_m) { (1.0 - q * q).powi(2) } else { 0.0 }
    }
}

/// The velocity of a particle after the drag.
pub fn drag(position_m: DVec3, velocity_m_s: DVec3, drag: &Drag) -> DVec3 {
    let mut change_m_s = drag.weight(position_m) * drag.share * (drag.velocity_m_s - velocity_m_s);
    if drag.flat {
        change_m_s.z = 0.0;
    }
    velocity_m_s + change_m_s
}

#[cfg(test)]
mod tests {
    use super::*;

    const DRAG: Drag = Drag {
        origin_m: DVec3::new(1.0, 2.0, 10.0),
        direction: DVec3::NEG_Z,
        radius_m: 0.5,
        near_m: 4.0,
        far_m: 12.0,
        velocity_m_s: DVec3::new(3.0, 0.0, -1.0),
        share: 1.0,
        flat: false,
    };

    #[test]
    fn on_the_ray_the_velocity_is_the_drags() {
        let before = DVec3::new(-1.0, 2.0, 0.5);
        assert_eq!(drag(DVec3::new(1.0, 2.0, 0.0), before, &DRAG), DRAG.velocity_m_s);
        let half = Drag { share: 0.5, flat: true, ..DRAG };
        assert_eq!(drag(DVec3::new(1.0, 2.0, 0.0), before, &half), DVec3::new(1.0, 1.0, 0.5));
        // Before it begins, behind its end, beside it.
        for outside in [DVec3::new(1.0, 2.0, 7.0), DVec3::new(1.0, 2.0, -2.5), DVec3::new(1.51, 2.0, 0.0)] {
            assert_eq!(drag(outside, before, &DRAG), before);
        }
    }

    #[test]
    fn the_weight_falls_to_zero_with_slope_zero_at_the_radius() {
        let at = |q: f64| DRAG.weight(DVec3::new(1.0, 2.0 + q * DRAG.radius_m, 0.0));
        assert_eq!((at(0.0), at(1.0)), (1.0, 0.0));
        assert!((at(0.5) - 0.5625).abs() < 1e-12);
        let weights: Vec<f64> = (0..=1000).map(|i| at(f64::from(i) / 1000.0)).collect();
        assert!(weights.is_sorted_by(|a, b| a > b));
        // C1: differences shrink to nothing at both ends.
        assert!(weights[0] - weights[1] < 1e-5 && weights[999] - weights[1000] < 1e-5);
    }
}
