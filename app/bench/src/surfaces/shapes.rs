//! Bodies of fluid whose surfaces are known.

use glam::DVec3;

use super::seen::Implicit;

/// Particle spacing of every body, m.
pub const SPACING_M: f64 = 0.02;
/// How far particles are off their lattice along each axis, in spacings: fluid is never a lattice.
const JITTER: f64 = 0.1;
/// Side of the domain, m; its lowest corner is the origin.
pub const DOMAIN_M: f64 = 1.0;

/// A body of fluid in a domain of 1 m.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Of radius 0.25 m.
    Sphere,
    /// Of side 0.4 m, turned so that no face is of the lattice.
    Box,
    /// Of radii 0.26 and 0.11 m, tilted.
    Torus,
    /// 0.24 m deep, from wall to wall.
    Pool,
    /// Two of radius 0.15 m, three spacings apart.
    Spheres,
    /// One layer of particles, 0.4 m wide.
    Sheet,
}

impl Shape {
    /// What is drawn.
    pub const ALL: [Self; 4] = [Self::Sphere, Self::Box, Self::Torus, Self::Pool];
    /// What is meshed.
    pub const MESHED: [Self; 6] = [Self::Sphere, Self::Box, Self::Torus, Self::Pool, Self::Spheres, Self::Sheet];

    /// As figures and files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Box => "box",
            Self::Torus => "torus",
            Self::Pool => "calm pool",
            Self::Spheres => "two spheres",
            Self::Sheet => "sheet",
        }
    }

    /// What the camera looks at.
    pub fn middle_m(self) -> DVec3 {
        match self {
            Self::Pool => DVec3::new(0.5, 0.12, 0.5),
            Self::Sheet => DVec3::new(0.5, 0.51, 0.5),
            _ => DVec3::splat(0.5),
        }
    }

    /// Whether the domain's walls cut the fluid off.
    pub fn in_walls(self) -> bool {
        self == Self::Pool
    }

    /// Volume inside, m^3.
    pub fn volume_m3(self) -> f64 {
        let ball = |radius_m: f64| 4.0 / 3.0 * std::f64::consts::PI * radius_m.powi(3);
        match self {
            Self::Sphere => ball(0.25),
            Self::Box => 0.4_f64.powi(3),
            Self::Torus => 2.0 * std::f64::consts::PI.powi(2) * 0.26 * 0.11 * 0.11,
            Self::Pool => 0.24,
            Self::Spheres => 2.0 * ball(0.15),
            Self::Sheet => 0.16 * SPACING_M,
        }
    }

    /// Middles of particles inside: the points of a jittered lattice that are.
    pub fn particles_m(self) -> Vec<DVec3> {
        let mut random = fastrand::Rng::with_seed(41);
        let side = (DOMAIN_M / SPACING_M).round() as usize;
        (0..side.pow(3))
            .filter_map(|i| {
                let point = DVec3::new((i % side) as f64, (i / side % side) as f64, (i / side / side) as f64) + 0.5;
                let mut offset = || JITTER * (2.0 * random.f64() - 1.0);
                let jittered = point + DVec3::new(offset(), offset(), offset());
                // The lattice point decides, so that layers along a surface are whole.
                (self.at(point * SPACING_M) < 0.0).then_some(jittered * SPACING_M)
            })
            .collect()
    }
}

/// Turns a world direction into the axes of the bodies that are turned: about y, then about x.
fn turned(v: DVec3) -> DVec3 {
    let (sin, cos) = (-0.2_f64).sin_cos();
    let v = DVec3::new(cos * v.x - sin * v.z, v.y, sin * v.x + cos * v.z);
    let (sin, cos) = (-0.15_f64).sin_cos();
    DVec3::new(v.x, cos * v.y - sin * v.z, sin * v.y + cos * v.z)
}

fn box_distance(offset: DVec3, half: DVec3) -> f64 {
    let beyond = offset.abs() - half;
    beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
}

impl Implicit for Shape {
    /// Signed distance to the surface, m, negative inside.
    fn at(&self, point_m: DVec3) -> f64 {
        let offset = point_m - self.middle_m();
        match self {
            Self::Sphere => offset.length() - 0.25,
            Self::Box => box_distance(turned(offset), DVec3::splat(0.2)),
            Self::Torus => {
                let v = turned(offset);
                (v.x.hypot(v.z) - 0.26).hypot(v.y) - 0.11
            }
            Self::Pool => box_distance(offset, DVec3::new(0.5, 0.12, 0.5)),
            Self::Spheres => {
                let apart = DVec3::X * (0.15 + 1.5 * SPACING_M);
                (offset - apart).length().min((offset + apart).length()) - 0.15
            }
            Self::Sheet => box_distance(offset, DVec3::new(0.2, 0.5 * SPACING_M, 0.2)),
        }
    }

    fn safe_step_m(&self, value: f64) -> f64 {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn particles_fill_their_bodies() {
        for shape in Shape::MESHED {
            let particles = shape.particles_m();
            let filled = particles.len() as f64 * SPACING_M.powi(3) / shape.volume_m3();
            assert!((filled - 1.0).abs() < 0.02, "{}: {filled}", shape.name());
            assert!(particles.iter().all(|&p| shape.at(p) < 0.2 * SPACING_M && p.min_element() > 0.0));
        }
    }

    #[test]
    fn distances_are_distances() {
        for (shape, point, distance) in [
            (Shape::Sphere, DVec3::new(0.5, 0.5, 1.0), 0.25),
            (Shape::Pool, DVec3::new(0.5, 0.34, 0.5), 0.1),
            (Shape::Pool, DVec3::new(0.5, 0.12, 0.5), -0.12),
            (Shape::Box, DVec3::splat(0.5), -0.2),
        ] {
            assert!((shape.at(point) - distance).abs() < 1e-12, "{}", shape.name());
        }
        let far = DVec3::new(0.1, 0.9, 0.3);
        for shape in Shape::ALL {
            let slope = DVec3::from_array(
                [DVec3::X, DVec3::Y, DVec3::Z].map(|e| (shape.at(far + 1e-6 * e) - shape.at(far - 1e-6 * e)) / 2e-6),
            );
            assert!((slope.length() - 1.0).abs() < 1e-6, "{}: {slope}", shape.name());
        }
    }
}
