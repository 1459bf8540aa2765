//! The particles' density field, marched: slow, and what their surface could be at best.

use brooklet_fluid::{boundary::beyond_wall, smoothing_kernel};
use glam::{DVec3, IVec3};

use super::seen::Implicit;

/// h / spacing of the field: as far as the fluid's own kernel reaches with a wide support.
const SUPPORT_RATIO: f64 = 3.0;
/// Share of the rest density at the surface: half of the kernel then is in the fluid.
const LEVEL: f64 = 0.5;

/// Densities of particles.
pub struct DensityField {
    /// By cell, x first.
    particles_m: Vec<DVec3>,
    /// Where each cell's particles begin, and where the last one's end.
    starts: Vec<usize>,
    lowest: IVec3,
    cells: IVec3,
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
        let cell = |at_m: DVec3| (at_m / support_m).floor().as_ivec3();
        let lowest = particles_m.iter().copied().map(cell).reduce(IVec3::min).unwrap_or_default();
        let highest = particles_m.iter().copied().map(cell).reduce(IVec3::max).unwrap_or_default();
        let cells = highest - lowest + 1;
        let index = |at_m: DVec3| {
            let cell = cell(at_m) - lowest;
            ((cell.z * cells.y + cell.y) * cells.x + cell.x) as usize
        };
        let mut sorted = particles_m.to_vec();
        sorted.sort_by_key(|&at_m| index(at_m));
        let starts =
            (0..=cells.element_product() as usize).map(|cell| sorted.partition_point(|&at_m| index(at_m) < cell));
        Self {
            starts: starts.collect(),
            particles_m: sorted,
            lowest,
            cells,
            support_m,
            spacing_m,
            weight: smoothing_kernel::lattice(3, SUPPORT_RATIO).weight,
            wall_m,
        }
    }

    fn density_ratio(&self, point_m: DVec3) -> f64 {
        let middle = (point_m / self.support_m).floor().as_ivec3() - self.lowest;
        let low = (middle - 1).max(IVec3::ZERO);
        let high = (middle + 1).min(self.cells - 1);
        let mut sum = 0.0;
        // Cells of a row follow each other.
        if low.x <= high.x {
            for z in low.z..=high.z {
                for y in low.y..=high.y {
                    let row = (z * self.cells.y + y) * self.cells.x;
                    let [begin, end] = [row + low.x, row + high.x + 1].map(|cell| self.starts[cell as usize]);
                    for at_m in &self.particles_m[begin..end] {
                        let squared_m2 = point_m.distance_squared(*at_m);
                        // Most of them are too far, which takes no root to know.
                        if squared_m2 < self.support_m * self.support_m {
                            sum += smoothing_kernel::wendland(squared_m2.sqrt() / self.support_m);
                        }
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
