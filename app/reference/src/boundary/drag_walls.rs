//! Walls that drag the fluid along them at a substep's end. (Shader: `boundary/drag_walls.compute`.)

use super::walls::DomainWalls;
use glam::DVec3;

/// How one wall drags; see `WallFace` of the shaders' layout.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WallFace {
    /// Its own velocity, along it.
    pub velocity_m_s: DVec3,
    /// Twice the kinematic viscosity, scaled; 0 where the fluid may slip.
    pub shear_m2_s: f64,
    /// c_f of a shear stress of c_f/2 ρ v², scaled.
    pub friction: f64,
}

impl WallFace {
    /// What shaders are given.
    pub fn of(face: &brooklet_kernels::WallFace) -> Self {
        Self {
            velocity_m_s: DVec3::from_array(face.velocity_m_s.map(f64::from)),
            shear_m2_s: face.shear_m2_s.into(),
            friction: face.friction.into(),
        }
    }
}

/// The six walls, lowest end of each axis first.
pub type WallFaces = [WallFace; 6];

/// The velocity after a substep of `dt_s`: for each wall in turn the solution of dv/dt = k (v_wall - v) along it, with
/// k = 2ν L(s)/s or c_f L(s) |v - v_wall| and L the slope of the kernel's share beyond the wall per metre. Nearer than
/// `least_m`, which walls keep particles away, is as near as that.
pub fn drag_walls(
    position_m: DVec3,
    mut velocity_m_s: DVec3,
    dt_s: f64,
    least_m: f64,
    walls: &DomainWalls,
    faces: &WallFaces,
) -> DVec3 {
    for (index, face) in faces.iter().enumerate() {
        let axis = index / 2;
        if !walls.axes.test(axis) {
            continue;
        }
        let from_low_m = position_m[axis];
        let distance_m = if index % 2 == 0 { from_low_m } else { walls.domain_size_m[axis] - from_low_m }.max(least_m);
        let mut relative_m_s = velocity_m_s - face.velocity_m_s;
        relative_m_s[axis] = 0.0;
        let slope_per_m = walls.share_slope(distance_m / walls.support_m) / walls.support_m;
        let sheared = (-slope_per_m * face.shear_m2_s / distance_m * dt_s).exp();
        let rubbed = 1.0 + slope_per_m * face.friction * relative_m_s.length() * dt_s;
        velocity_m_s += relative_m_s * (sheared / rubbed - 1.0);
    }
    velocity_m_s
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::walls::WallScales;
    use glam::BVec3;

    fn walls() -> DomainWalls {
        DomainWalls {
            dimensions: 3,
            axes: BVec3::TRUE,
            scales: WallScales::new(3, 2.0),
            domain_size_m: DVec3::splat(2.0),
            support_m: 0.5,
        }
    }

    #[test]
    fn a_wall_takes_its_friction_of_the_fluid_over_it() {
        // Of a column at v the momentum that a short time takes is c_f/2 v², whatever h.
        let (friction, v, dt_s) = (0.02, 3.0, 1e-6);
        let mut faces = WallFaces::default();
        faces[2].friction = friction;
        let n = 20_000;
        let lost: f64 = (0..n)
            .map(|i| {
                let y = 0.5 * (f64::from(i) + 0.5) / f64::from(n);
                let at = DVec3::new(1.0, y, 1.0);
                (v - drag_walls(at, DVec3::X * v, dt_s, 0.0, &walls(), &faces).x) * 0.5 / f64::from(n)
            })
            .sum();
        let expected = 0.5 * friction * v * v * dt_s;
        assert!((lost / expected - 1.0).abs() < 1e-4, "{lost} and {expected}");
    }

    #[test]
    fn friction_decays_as_its_closed_form_at_any_step() {
        let mut faces = WallFaces::default();
        faces[2].friction = 0.5;
        let at = DVec3::new(1.0, 0.1, 1.0);
        let run = |steps: u32| {
            let dt_s = 4.0 / f64::from(steps);
            (0..steps).fold(DVec3::X * 3.0, |v, _| drag_walls(at, v, dt_s, 0.0, &walls(), &faces))
        };
        assert!((run(1).x - run(1000).x).abs() < 1e-12, "{} and {}", run(1).x, run(1000).x);
        assert!(run(1).x < 1.5);
    }

    #[test]
    fn a_wall_leaves_what_is_across_it_and_far_from_it_alone_and_takes_along_what_is_near() {
        let mut faces = WallFaces::default();
        faces[1] = WallFace { velocity_m_s: DVec3::new(0.0, 2.0, -1.0), shear_m2_s: 1.0, friction: 0.0 };
        let v = DVec3::new(5.0, 1.0, 1.0);
        let drag = |x: f64, dt_s: f64| drag_walls(DVec3::new(x, 1.0, 1.0), v, dt_s, 0.01, &walls(), &faces);
        assert_eq!(drag(1.49, 1.0), v);
        let near = drag(1.99, 1e9);
        assert!((near - DVec3::new(5.0, 2.0, -1.0)).length() < 1e-6, "{near}");
    }
}
