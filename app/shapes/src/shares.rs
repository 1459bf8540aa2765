//! How much of the smoothing kernel around a node lies in a solid, told as a distance: that of a plane beyond which as much
//! lies (volume maps, Bender et al. 2019). Beside a flat face it is the face's own distance, which linear interpolation keeps
//! exactly; a share itself curves so much over a cell that interpolation would be off by a fortieth.
//!
//! The share is the sum over a lattice in the kernel's ball. What such a sum is off by for a plane at the node's own distance,
//! whose share is known, is taken off.

use glam::{DVec3, IVec3};

use crate::grid::Grid;
use crate::threads;

/// Of a kernel's radius, between two points of the lattice at most.
const POINTS_A_RADIUS: f64 = 4.0;

/// Wendland's C2 kernel beyond a plane at a signed distance, in supports.
pub fn plane_share(distance: f64) -> f64 {
    let t = (1.0 - distance.abs()).clamp(0.0, 1.0);
    let share = t.powi(6) * (3.5 + t * (-4.5 + 1.5 * t));
    if distance < 0.0 { 1.0 - share } else { share }
}

/// The distance of the plane beyond which a share lies, in supports, from -1 to 1.
pub fn plane_distance(share: f64) -> f64 {
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if plane_share(middle) > share { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

fn kernel(q: f64) -> f64 {
    let t = (1.0 - q).max(0.0);
    t.powi(4) * (1.0 + 4.0 * q)
}

/// Of a cell of a side around a point at a distance from the surface, what lies in the solid.
fn inside(distance_m: f64, side_m: f64) -> f64 {
    (0.5 - distance_m / side_m).clamp(0.0, 1.0)
}

struct Lattice {
    /// Offsets, in parts of a cell, and weights that add up to 1.
    points: Vec<(IVec3, f64)>,
    /// Parts of a cell.
    parts: i32,
    side_m: f64,
}

impl Lattice {
    fn new(cell_m: f64, support_m: f64) -> Self {
        let parts = (POINTS_A_RADIUS * cell_m / support_m - 1.0e-9).ceil().max(1.0) as i32;
        let side_m = cell_m / f64::from(parts);
        let reach = (support_m / side_m).floor() as i32;
        let along = || -reach..=reach;
        let mut points = Vec::new();
        for z in along() {
            for y in along() {
                for x in along() {
                    let at = IVec3::new(x, y, z);
                    let weight = kernel(at.as_dvec3().length() * side_m / support_m);
                    if weight > 0.0 {
                        points.push((at, weight));
                    }
                }
            }
        }
        let all: f64 = points.iter().map(|point| point.1).sum();
        points.iter_mut().for_each(|point| point.1 /= all);
        Self { points, parts, side_m }
    }
}

/// For each node of `distances_m` that distance, in supports. Where the kernel does not reach the surface it is the node's
/// own.
pub(crate) fn plane_distances(grid: &Grid, distances_m: &[f32], support_m: f64) -> Vec<f32> {
    let lattice = Lattice::new(grid.cell_m, support_m);
    let mut planes = vec![0.0_f32; distances_m.len()];
    let slab = (grid.nodes[0] * grid.nodes[1]) as usize;
    let slabs: Vec<(usize, &mut [f32])> = planes.chunks_mut(slab).enumerate().collect();
    threads::for_each(slabs, |(z, slab)| {
        for (index, plane) in slab.iter_mut().enumerate() {
            let node = z * (grid.nodes[0] * grid.nodes[1]) as usize + index;
            let own_m = f64::from(distances_m[node]);
            let far = own_m / support_m;
            if far.abs() >= 1.0 {
                *plane = far as f32;
                continue;
            }
            let share = share(grid, distances_m, node, &lattice, support_m);
            *plane = match share {
                share if share <= 1.0e-9 => 1.0,
                share if share >= 1.0 - 1.0e-9 => -1.0,
                share => plane_distance(share) as f32,
            };
        }
    });
    planes
}

fn share(grid: &Grid, distances_m: &[f32], node: usize, lattice: &Lattice, support_m: f64) -> f64 {
    let at = grid.place(node);
    let own_m = f64::from(distances_m[node]);
    let known = |at: IVec3| grid.index(at).map(|index| f64::from(distances_m[index]));
    let value = |at: IVec3| known(at).unwrap_or(f64::INFINITY);
    let slope = DVec3::from_array([IVec3::X, IVec3::Y, IVec3::Z].map(|axis| {
        let [below, above] = [at - axis, at + axis].map(|at| known(at).unwrap_or(own_m));
        above - below
    }));
    let normal = slope.normalize_or_zero();
    let mut off = 0.0;
    for &(offset, weight) in &lattice.points {
        let there_m = match lattice.parts {
            1 => value(at + offset),
            parts => between(&value, at * parts + offset, parts),
        };
        let plane_m = own_m + normal.dot(offset.as_dvec3()) * lattice.side_m;
        off += weight * (inside(there_m, lattice.side_m) - inside(plane_m, lattice.side_m));
    }
    plane_share(own_m / support_m) + off
}

/// Trilinear, at a place in parts of a cell; what is outside of the grid is outside of the solid.
fn between(value: &impl Fn(IVec3) -> f64, at: IVec3, parts: i32) -> f64 {
    let cell = IVec3::new(at.x.div_euclid(parts), at.y.div_euclid(parts), at.z.div_euclid(parts));
    let share = (at - cell * parts).as_dvec3() / f64::from(parts);
    let mut sum = 0.0;
    for corner in 0..8 {
        let step = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
        let weights = DVec3::select(step.cmpeq(IVec3::ONE), share, 1.0 - share);
        let weight = weights.element_product();
        if weight > 0.0 {
            sum += weight * value(cell + step);
        }
    }
    sum
}
