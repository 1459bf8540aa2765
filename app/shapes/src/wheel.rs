//! A wheel with paddles.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::mesh::Mesh;

/// Parts of the hub's arc between two paddles.
const ARC_PARTS: u32 = 4;

/// A wheel with paddles around z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// To the paddles' ends, m.
    pub radius_m: f64,
    /// Along z, m.
    pub width_m: f64,
    /// How many paddles, at least 2.
    pub paddles: u32,
    /// Of the hub, m.
    pub hub_radius_m: f64,
    /// How thick a paddle is, m.
    pub paddle_m: f64,
}

impl Wheel {
    /// Its triangles.
    ///
    /// # Errors
    /// In words: paddles that meet beyond the hub, or end in it.
    pub fn mesh(&self) -> Result<Mesh, String> {
        let half_m = 0.5 * self.paddle_m;
        let between_m = self.hub_radius_m * (0.5 * TAU / f64::from(self.paddles)).sin();
        if half_m >= between_m {
            return Err(format!(
                "has {} paddles of {} m, which meet beyond its hub: a thickness below {} m",
                self.paddles,
                self.paddle_m,
                2.0 * between_m
            ));
        }
        if self.radius_m * self.radius_m - half_m * half_m <= self.hub_radius_m * self.hub_radius_m {
            return Err(format!("has paddles of {} m that end in a hub of {} m", self.radius_m, self.hub_radius_m));
        }
        Ok(self.extruded(&self.outline_m()))
    }

    /// Its border around z, counter-clockwise: every point of it is seen from the middle.
    fn outline_m(&self) -> Vec<[f64; 2]> {
        let half_m = 0.5 * self.paddle_m;
        let at_hub = (half_m / self.hub_radius_m).asin();
        let end_m = (self.radius_m * self.radius_m - half_m * half_m).sqrt();
        let pitch = TAU / f64::from(self.paddles);
        let on_hub = |angle: f64| [self.hub_radius_m * angle.cos(), self.hub_radius_m * angle.sin()];
        let mut outline_m = Vec::new();
        for k in 0..self.paddles {
            let angle = pitch * f64::from(k);
            let (sin, cos) = angle.sin_cos();
            let of_paddle = |along_m: f64, aside_m: f64| [cos * along_m - sin * aside_m, sin * along_m + cos * aside_m];
            outline_m.push(on_hub(angle - at_hub));
            outline_m.extend([of_paddle(end_m, -half_m), of_paddle(end_m, half_m)]);
            let arc = pitch - 2.0 * at_hub;
            let part = |part: u32| on_hub(angle + at_hub + arc * f64::from(part) / f64::from(ARC_PARTS));
            outline_m.extend((0..ARC_PARTS).map(part));
        }
        outline_m
    }

    fn extruded(&self, outline_m: &[[f64; 2]]) -> Mesh {
        let count = outline_m.len() as u32;
        let side = |z_m: f64| outline_m.iter().map(move |&[x_m, y_m]| DVec3::new(x_m, y_m, z_m));
        let half_m = 0.5 * self.width_m;
        let mut positions_m: Vec<DVec3> = side(-half_m).chain(side(half_m)).collect();
        positions_m.extend([DVec3::new(0.0, 0.0, -half_m), DVec3::new(0.0, 0.0, half_m)]);
        let (back, front) = (2 * count, 2 * count + 1);
        let of = |a: u32| {
            let b = (a + 1) % count;
            let (c, d) = (a + count, b + count);
            [[a, b, c], [b, d, c], [back, b, a], [front, c, d]]
        };
        Mesh { positions_m, triangles: (0..count).flat_map(of).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Repairs, checked};

    fn wheel() -> Wheel {
        Wheel { radius_m: 0.3, width_m: 0.2, paddles: 8, hub_radius_m: 0.1, paddle_m: 0.03 }
    }

    /// A closed one, as large as its parts: hub, and paddles less what of them is in it.
    #[test]
    fn a_wheel_is_closed_and_as_large_as_its_parts() {
        let wheel = wheel();
        let (mesh, repairs) = checked(wheel.mesh().unwrap(), false).unwrap();
        assert_eq!(repairs, Repairs::default());
        let arc = TAU / 8.0 - 2.0 * (0.15_f64).asin();
        // Triangles between the middle and its border: of arcs, of paddles' sides and of their ends.
        let arcs_m2 = 8.0 * 0.5 * 0.01 * f64::from(ARC_PARTS) * (arc / f64::from(ARC_PARTS)).sin();
        let end_m = (0.09_f64 - 0.015 * 0.015).sqrt();
        let paddles_m2 = 8.0 * (0.03 * end_m - 0.5 * 0.03 * (0.01_f64 - 0.015 * 0.015).sqrt());
        let expected_m3 = 0.2 * (arcs_m2 + paddles_m2);
        let volume_m3 = mesh.volume_m3();
        assert!((volume_m3 / expected_m3 - 1.0).abs() < 1e-9, "{volume_m3}, not {expected_m3}");
    }

    #[test]
    fn paddles_neither_meet_nor_end_in_the_hub() {
        let thick = Wheel { paddle_m: 0.08, ..wheel() }.mesh().unwrap_err();
        assert!(thick.contains("8 paddles of 0.08 m, which meet"), "{thick}");
        let short = Wheel { radius_m: 0.1, ..wheel() }.mesh().unwrap_err();
        assert!(short.contains("end in a hub of 0.1 m"), "{short}");
    }
}
