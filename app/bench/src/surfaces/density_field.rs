//! The particles' density field, marched: slow, and what their surface could be at best.

use std::collections::HashMap;

use brooklet_fluid::{boundary::beyond_wall, smoothing_kernel};
use glam::DVec3;

use super::seen::Implicit;

/// h / spacing of the field: as far as the fluid's own kernel reaches with a wide support.
const SUPPORT_RATIO: f64 = 3.0;
/// Share of the rest density at the surface: half of the kernel then is in the fluid.
const LEVEL: f64 = 0.5;

/// Densities of particles.
pub struct DensityField {
    cells: HashMap<[i32; 3], Vec<DVec3>>,
    support_m: f64,
    spacing_m: f64,
    weight: f64,
    /// Side of the box beyond which the fluid goes on, as a wall cuts it off.
    wall_m: Option<f64>,
}

impl DensityField {
    /// Of particles on average `spacing_m` apart, in walls or in the open.
    pub fn new(particles_m: &[DVec3], spacing_m: f64, wall_m: Option<f64>) -> Self {
        let support_m = SUPPORT_RATIO * spacing_m;
        let mut cells: HashMap<[i32; 3], Vec<DVec3>> = HashMap::new();
        for &at in particles_m {
            cells.entry(cell(at, support_m)).or_default().push(at);
        }
        Self { cells, support_m, spacing_m, weight: smoothing_kernel::lattice(3, SUPPORT_RATIO).weight, wall_m }
    }

    fn density_ratio(&self, point_m: DVec3) -> f64 {
        let [x, y, z] = cell(point_m, self.support_m);
        let mut sum = 0.0;
        for dz in -1..=1 {
            for dy in -1..=1 {
                for dx in -1..=1 {
                    for at in self.cells.get(&[x + dx, y + dy, z + dz]).into_iter().flatten() {
                        sum += smoothing_kernel::wendland((point_m - *at).length() / self.support_m);
                    }
                }
            }
        }
        // What lies beyond a wall counts as more of the same.
        let inside = self.wall_m.map_or(1.0, |side_m| {
            let beyond =
                |x_m: f64| beyond_wall(3, x_m / self.support_m) + beyond_wall(3, (side_m - x_m) / self.support_m);
            point_m.to_array().into_iter().map(|x_m| 1.0 - beyond(x_m)).product()
        });
        sum * self.weight / inside
    }
}

impl Implicit for DensityField {
    fn at(&self, point_m: DVec3) -> f64 {
        LEVEL - self.density_ratio(point_m)
    }

    fn safe_step_m(&self, value: f64) -> f64 {
        // Nothing within reach: a cell's width is safe. Else steps that cannot pass a sheet.
        if value >= LEVEL { 0.5 * self.support_m } else { 0.2 * self.spacing_m }
    }

    fn normal(&self, point_m: DVec3) -> DVec3 {
        // On the wall itself the surface is the wall.
        if let Some(side_m) = self.wall_m {
            let near_m = 1e-4 * self.spacing_m;
            for axis in 0..3 {
                let mut normal = DVec3::ZERO;
                if point_m[axis] < near_m {
                    normal[axis] = -1.0;
                    return normal;
                }
                if point_m[axis] > side_m - near_m {
                    normal[axis] = 1.0;
                    return normal;
                }
            }
        }
        let step_m = 1e-3 * self.spacing_m;
        let along = |e: DVec3| self.at(point_m + step_m * e) - self.at(point_m - step_m * e);
        DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z)).normalize_or_zero()
    }
}

fn cell(point_m: DVec3, side_m: f64) -> [i32; 3] {
    (point_m / side_m).floor().to_array().map(|k| k as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surfaces::shapes::{DOMAIN_M, SPACING_M, Shape};

    #[test]
    fn the_level_is_near_the_body_s_surface() {
        for shape in [Shape::Sphere, Shape::Pool] {
            let wall_m = shape.in_walls().then_some(DOMAIN_M);
            let field = DensityField::new(&shape.particles_m(), SPACING_M, wall_m);
            assert!((field.density_ratio(shape.middle_m()) - 1.0).abs() < 0.05);
            let height_m = |inside: bool| if inside { -SPACING_M } else { SPACING_M };
            let top_m = shape.middle_m() + DVec3::Y * if shape == Shape::Pool { 0.12 } else { 0.25 };
            assert!(field.at(top_m + DVec3::Y * height_m(true)) < 0.0);
            assert!(field.at(top_m + DVec3::Y * height_m(false)) > 0.0);
        }
    }
}
