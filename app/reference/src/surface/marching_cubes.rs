//! A field's zero as an indexed mesh with shared vertices, from a dense grid of its values.
//!
//! A vertex stands where the field, linear along an edge of the grid, is 0. An edge is cut in one point from all of its
//! cells, so the mesh has no seams; with the table's two rules it is closed and has two triangles at each edge, wherever
//! the grid's outermost values are outside.

use std::collections::HashMap;

use super::marching_cubes_table::{EDGES, triangles};
use glam::DVec3;

/// Values at the points of a grid, x fastest; above 0 is inside.
#[derive(Clone, Copy, Debug)]
pub struct FieldGrid<'a> {
    /// Points along each axis.
    pub points: [usize; 3],
    /// Its lowest corner.
    pub min_m: DVec3,
    /// From point to point along each axis.
    pub cell_m: DVec3,
    /// As many as there are points.
    pub values: &'a [f64],
}

/// A mesh.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Where its vertices are.
    pub vertices_m: Vec<DVec3>,
    /// Vertices of each triangle, counter-clockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl FieldGrid<'_> {
    fn index(&self, at: [usize; 3]) -> usize {
        (at[2] * self.points[1] + at[1]) * self.points[0] + at[0]
    }

    fn place_m(&self, at: [usize; 3]) -> DVec3 {
        self.min_m + self.cell_m * DVec3::from_array(at.map(|i| i as f64))
    }
}

/// Which corners of the cell with this lowest point are inside, a bit each.
pub fn corners_inside(grid: &FieldGrid<'_>, at: [usize; 3]) -> u8 {
    (0..8).filter(|&corner| grid.values[grid.index(corner_of(at, corner))] > 0.0).map(|corner| 1 << corner).sum()
}

fn corner_of(at: [usize; 3], corner: u8) -> [usize; 3] {
    std::array::from_fn(|axis| at[axis] + (corner >> axis & 1) as usize)
}

/// Where the field is 0 between a value above 0 and one that is not, as a share of the way from `from` to `to`.
pub fn crossing(from: f64, to: f64) -> f64 {
    (from / (from - to)).clamp(0.0, 1.0)
}

/// The mesh of a field.
pub fn marching_cubes(grid: &FieldGrid<'_>) -> Mesh {
    let mut mesh = Mesh::default();
    let mut vertex_of: HashMap<[usize; 2], u32> = HashMap::new();
    let cells = grid.points.map(|points| points.saturating_sub(1));
    for z in 0..cells[2] {
        for y in 0..cells[1] {
            for x in 0..cells[0] {
                let at = [x, y, z];
                for triangle in triangles(corners_inside(grid, at)) {
                    let corners = triangle.map(|edge| {
                        let [low, high] = EDGES[edge as usize].map(|corner| corner_of(at, corner));
                        let [from, to] = [low, high].map(|point| grid.index(point));
                        *vertex_of.entry([from, to]).or_insert_with(|| {
                            let share = crossing(grid.values[from], grid.values[to]);
                            mesh.vertices_m.push(grid.place_m(low).lerp(grid.place_m(high), share));
                            mesh.vertices_m.len() as u32 - 1
                        })
                    });
                    mesh.triangles.push(corners);
                }
            }
        }
    }
    mesh
}

/// Whether a mesh is closed, has two triangles at each edge and is oriented alike throughout.
///
/// # Errors
/// Says how many edges are open, and how many have more than two triangles or two in one direction.
pub fn check_closed(triangles: &[[u32; 3]]) -> Result<(), String> {
    let mut sides: HashMap<[u32; 2], u32> = HashMap::new();
    for &[a, b, c] in triangles {
        for side in [[a, b], [b, c], [c, a]] {
            *sides.entry(side).or_default() += 1;
        }
    }
    let twice = sides.values().filter(|&&count| count > 1).count();
    let open = sides.keys().filter(|[a, b]| !sides.contains_key(&[*b, *a])).count();
    match (open, twice) {
        (0, 0) => Ok(()),
        _ => Err(format!("{open} open edges, {twice} with two triangles in one direction")),
    }
}

/// Volume that a closed mesh holds, m³: negative if it is turned inside out.
pub fn volume_m3(mesh: &Mesh) -> f64 {
    let of = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|vertex| mesh.vertices_m[vertex as usize]);
        a.dot(b.cross(c)) / 6.0
    };
    mesh.triangles.iter().map(of).sum()
}

#[cfg(test)]
mod tests {
    use super::super::surface_field::surface_field;
    use super::*;
    use crate::shared::lattice;

    fn grid_of(points: [usize; 3], cell_m: f64, min_m: DVec3, field: impl Fn(DVec3) -> f64) -> Vec<f64> {
        let mut values = Vec::new();
        for z in 0..points[2] {
            for y in 0..points[1] {
                for x in 0..points[0] {
                    values.push(field(min_m + cell_m * DVec3::new(x as f64, y as f64, z as f64)));
                }
            }
        }
        values
    }

    #[test]
    fn a_ball_is_closed_and_has_its_volume() {
        let (points, cell_m, min_m) = ([24; 3], 0.1, DVec3::splat(-1.15));
        let values = grid_of(points, cell_m, min_m, |at_m| 1.0 - at_m.length());
        let mesh = marching_cubes(&FieldGrid { points, min_m, cell_m: DVec3::splat(cell_m), values: &values });
        check_closed(&mesh.triangles).unwrap();
        let exact_m3 = 4.0 / 3.0 * std::f64::consts::PI;
        assert!((volume_m3(&mesh) / exact_m3 - 1.0).abs() < 0.01, "{}", volume_m3(&mesh));
        let off = |at_m: &DVec3| (at_m.length() - 1.0).abs();
        // A chord of a cell's diagonal is off by an eighth of its square.
        assert!(mesh.vertices_m.iter().map(off).fold(0.0, f64::max) < 0.01);
        assert!(check_closed(&mesh.triangles[1..]).is_err(), "a missing triangle is seen");
        let mut turned = mesh.triangles.clone();
        turned[0].swap(0, 1);
        assert!(check_closed(&turned).is_err(), "and one that is turned over");
    }

    #[test]
    fn noise_is_closed_in_every_case() {
        // Numerical Recipes' 64-bit congruential generator, its upper bits.
        let mut state = 9_u64;
        let mut noise = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / f64::from(1 << 24)
        };
        let points = [20, 17, 13];
        let mut cases = [false; 256];
        for inside in [0.2, 0.5, 0.8] {
            let mut values = vec![0.0; points.iter().product()];
            for (i, value) in values.iter_mut().enumerate() {
                let at = [i % points[0], i / points[0] % points[1], i / points[0] / points[1]];
                let outermost = (0..3).any(|axis| at[axis] == 0 || at[axis] == points[axis] - 1);
                *value = if outermost { -1.0 } else { inside - noise() };
            }
            let grid = FieldGrid { points, min_m: DVec3::ZERO, cell_m: DVec3::ONE, values: &values };
            for z in 0..points[2] - 1 {
                for y in 0..points[1] - 1 {
                    (0..points[0] - 1).for_each(|x| cases[corners_inside(&grid, [x, y, z]) as usize] = true);
                }
            }
            let mesh = marching_cubes(&grid);
            check_closed(&mesh.triangles).unwrap();
            assert!(volume_m3(&mesh) > 0.0);
        }
        assert!(cases.iter().all(|&seen| seen), "every case was met");
    }

    #[test]
    fn a_block_of_particles_is_a_closed_block() {
        const SPACING_M: f64 = 0.02;
        let particles_m = lattice::points([6, 4, 5], SPACING_M);
        let min_m = DVec3::splat(-2.0 * SPACING_M);
        let (points, cell_m) = ([24, 20, 22], 0.5 * SPACING_M);
        let values =
            grid_of(points, cell_m, min_m, |at_m| surface_field(at_m, particles_m.iter().copied(), SPACING_M).0);
        let mesh = marching_cubes(&FieldGrid { points, min_m, cell_m: DVec3::splat(cell_m), values: &values });
        check_closed(&mesh.triangles).unwrap();
        let particles_m3 = particles_m.len() as f64 * SPACING_M.powi(3);
        // Its edges are rounded: 60 spacings of them lose a fifth of a spacing squared each, a tenth of so small a block.
        let kept = volume_m3(&mesh) / particles_m3;
        assert!((0.88..1.0).contains(&kept), "{kept}");
    }
}
