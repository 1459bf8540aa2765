//! A mesh as distances on a grid: what the shaders are given of it.
//!
//! Nodes know their exact distance, by a tree over the triangles, and their side: nodes between which no surface can be have
//! one, which is asked once by the winding number, so that pieces may overlap. Between nodes distances are interpolated, and
//! are larger than true ones by half of a cell's diagonal at most: all of it where a needle stands at its middle, .3 of a
//! cell at a right-angled edge, nothing at a flat face.

use std::sync::OnceLock;

use glam::{DVec3, IVec3};

use crate::bvh::Bvh;
use crate::grid::Grid;
use crate::mesh::Mesh;
use crate::{shares, threads};

/// Nodes that all fields of a scene may have: 32 MiB on the GPU.
pub const MOST_NODES: u64 = 4 << 20;
/// Nodes that one may have along a side.
pub const MOST_NODES_A_SIDE: u64 = 2048;

/// How a field is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldOptions {
    /// Between two nodes, m.
    pub cell_m: f64,
    /// Radius of the kernel whose share nodes know, m; none: they know no share.
    pub support_m: Option<f64>,
    /// How thick the mesh is, as a sheet, m; none: it is closed.
    pub sheet_m: Option<f64>,
}

/// Distances on a grid.
#[derive(Clone, Debug)]
pub struct Field {
    /// The lowest node, m.
    pub min_m: DVec3,
    /// Between two nodes, m.
    pub cell_m: f64,
    /// Nodes along each side.
    pub nodes: [u32; 3],
    /// Of each node, x fastest: its distance from the surface, m, negative inside.
    pub distances_m: Vec<f32>,
    support_m: Option<f64>,
    /// Takes as long as the distances, and a scene that is only counted does without.
    planes: OnceLock<Vec<f32>>,
}

impl Field {
    /// How many nodes along each side the field of what lies between two corners would have.
    pub fn nodes_of([low_m, high_m]: [DVec3; 2], options: &FieldOptions) -> [u64; 3] {
        let [low_m, high_m] = around([low_m, high_m], options);
        ((high_m - low_m) / options.cell_m).to_array().map(|cells| (cells - 1.0e-6).ceil().max(1.0) as u64 + 1)
    }

    /// Of a mesh with an inside, or of a sheet; no larger than [`MOST_NODES`].
    pub fn new(mesh: &Mesh, options: &FieldOptions) -> Self {
        let bounds_m = mesh.bounds_m();
        let nodes = Self::nodes_of(bounds_m, options).map(|side| side as u32);
        let [low_m, high_m] = around(bounds_m, options);
        let size_m = DVec3::from_array(nodes.map(|side| f64::from(side - 1))) * options.cell_m;
        let grid = Grid { min_m: 0.5 * (low_m + high_m - size_m), cell_m: options.cell_m, nodes };
        let tree = Bvh::new(mesh);
        let mut distances_m = distances(&grid, &tree);
        match options.sheet_m {
            Some(thickness_m) => distances_m.iter_mut().for_each(|away_m| *away_m -= 0.5 * thickness_m),
            None => turn_inside_out(&grid, &tree, &mut distances_m),
        }
        let distances_m = distances_m.into_iter().map(|away_m| away_m as f32).collect();
        let (support_m, planes) = (options.support_m, OnceLock::new());
        Self { min_m: grid.min_m, cell_m: grid.cell_m, nodes, distances_m, support_m, planes }
    }

    /// Of each node the distance of the plane beyond which as much of the kernel lies as in the solid, in supports; 1 of a
    /// field without a kernel. Made when first asked for.
    pub fn planes(&self) -> &[f32] {
        self.planes.get_or_init(|| match self.support_m {
            Some(support_m) => {
                let grid = Grid { min_m: self.min_m, cell_m: self.cell_m, nodes: self.nodes };
                shares::plane_distances(&grid, &self.distances_m, support_m)
            }
            None => vec![1.0; self.distances_m.len()],
        })
    }

    /// The distance of a place from the surface, as the shaders interpolate it (`boundary/solids/field.hlsli`), m.
    pub fn distance_m(&self, place_m: DVec3) -> f64 {
        let last = DVec3::from_array(self.nodes.map(|side| f64::from(side - 1)));
        let in_grid_m = place_m.clamp(self.min_m, self.min_m + last * self.cell_m);
        let at = (in_grid_m - self.min_m) / self.cell_m;
        let cell = at.floor().min(last - 1.0).max(DVec3::ZERO);
        let share = at - cell;
        let [x, y, _] = self.nodes.map(|side| side as usize);
        let first = cell.x as usize + x * (cell.y as usize + y * cell.z as usize);
        let value = |index: usize| f64::from(self.distances_m[index]);
        let along = |index: usize| value(index) + share.x * (value(index + 1) - value(index));
        let across = |index: usize| along(index) + share.y * (along(index + x) - along(index));
        let here_m = across(first) + share.z * (across(first + x * y) - across(first));
        let outside_m = place_m - in_grid_m;
        if outside_m == DVec3::ZERO { here_m } else { here_m.max(0.0).hypot(outside_m.length()) }
    }

    /// The share of a mesh's surface behind which the field stays a distance or more outside, to a cell's depth: what is too
    /// thin for its cells, so that a path through it meets nothing.
    pub fn lost(&self, mesh: &Mesh, away_m: f64) -> f64 {
        let is_lost = |at_m: DVec3, step_m: DVec3| {
            (0..=4).all(|steps| self.distance_m(at_m + f64::from(steps) * step_m) > away_m)
        };
        let (mut lost_m2, mut all_m2) = (0.0, 0.0);
        for triangle in 0..mesh.triangles.len() {
            let normal_m2 = mesh.area_normal_m2(triangle);
            let area_m2 = normal_m2.length();
            let step_m = -0.25 * self.cell_m * normal_m2.normalize_or_zero();
            let [a, b, c] = mesh.corners_m(triangle);
            let middle_m = (a + b + c) / 3.0;
            let within = [middle_m, 0.5 * (middle_m + a), 0.5 * (middle_m + b), 0.5 * (middle_m + c)];
            let lost = within.into_iter().filter(|&at_m| is_lost(at_m, step_m)).count();
            lost_m2 += area_m2 * lost as f64 / 4.0;
            all_m2 += area_m2;
        }
        lost_m2 / all_m2
    }
}

/// The box around what lies between two corners and what the kernel sees of it.
fn around([low_m, high_m]: [DVec3; 2], options: &FieldOptions) -> [DVec3; 2] {
    let margin_m = options.support_m.unwrap_or(options.cell_m).max(options.cell_m)
        + options.cell_m
        + 0.5 * options.sheet_m.unwrap_or(0.0);
    [low_m - margin_m, high_m + margin_m]
}

/// How far each node is from the nearest triangle.
fn distances(grid: &Grid, tree: &Bvh) -> Vec<f64> {
    let [x, y, z] = grid.nodes.map(|side| side as usize);
    let mut distances_m = vec![0.0; x * y * z];
    let rows: Vec<(usize, &mut [f64])> = distances_m.chunks_mut(x * y).enumerate().collect();
    threads::for_each(rows, |(z, slab)| {
        for (y, row) in slab.chunks_mut(x).enumerate() {
            let mut within_m = f64::INFINITY;
            for (x, away_m) in row.iter_mut().enumerate() {
                let place_m = grid.position_m(IVec3::new(x as i32, y as i32, z as i32));
                let nearest_m = tree.nearest_m(place_m, within_m).or_else(|| tree.nearest_m(place_m, f64::INFINITY));
                *away_m = nearest_m.map_or(f64::INFINITY, |on_m| on_m.distance(place_m));
                // The next is a cell away.
                within_m = (*away_m + grid.cell_m) * (1.0 + 1.0e-9);
            }
        }
    });
    distances_m
}

/// Makes distances of nodes inside negative.
fn turn_inside_out(grid: &Grid, tree: &Bvh, distances_m: &mut [f64]) {
    const NONE: u32 = u32::MAX;
    let mut pieces = vec![NONE; distances_m.len()];
    let mut firsts = Vec::new();
    let mut waiting = Vec::new();
    for first in 0..pieces.len() {
        if pieces[first] != NONE {
            continue;
        }
        let piece = firsts.len() as u32;
        firsts.push(first);
        pieces[first] = piece;
        waiting.push(first);
        while let Some(node) = waiting.pop() {
            let at = grid.place(node);
            for step in [IVec3::X, IVec3::Y, IVec3::Z, IVec3::NEG_X, IVec3::NEG_Y, IVec3::NEG_Z] {
                let Some(other) = grid.index(at + step) else { continue };
                // A surface between them would be nearer to one.
                if pieces[other] == NONE && distances_m[node] + distances_m[other] > grid.cell_m * (1.0 + 1.0e-9) {
                    pieces[other] = piece;
                    waiting.push(other);
                }
            }
        }
    }
    let mut is_inside = vec![false; firsts.len()];
    let parts: Vec<(&[usize], &mut [bool])> = firsts.chunks(512).zip(is_inside.chunks_mut(512)).collect();
    threads::for_each(parts, |(firsts, is_inside)| {
        for (&first, is_inside) in firsts.iter().zip(is_inside) {
            *is_inside = tree.winding(grid.position_m(grid.place(first))) > 0.5;
        }
    });
    for (away_m, piece) in distances_m.iter_mut().zip(&pieces) {
        if is_inside[*piece as usize] {
            *away_m = -*away_m;
        }
    }
}
