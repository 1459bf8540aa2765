//! The wall-weight function of Harada, Koshizuka & Kawaguchi 2007 as a table over the distances
//! to the nearest wall along each axis. (Shader: `boundary/walls.hlsl`.)
//!
//! What lies beyond walls at distances a, b, c is the union of three half-spaces. By inclusion
//! and exclusion its share of the kernel is P(a)+P(b)+P(c) − E(a,b) − E(b,c) − E(a,c) + C(a,b,c),
//! where C is the kernel's integral over the octant beyond all three, E over the quarter-space
//! beyond two, P over the half-space beyond one. The integrals stand for wall particles at rest;
//! each is scaled to what the lattice lacks half a spacing from its walls, so that fluid placed
//! there has density ratio 1 at walls, edges and corners alike.

use std::sync::OnceLock;

use crate::kernel::{for_lattice, lattice, wendland};

/// Nodes an axis of the table, from distance 0 to h.
pub const WALL_NODES: usize = brooklet_kernels::WALL_NODES as usize;

/// Quadrature steps between two nodes.
const STEPS: usize = 4;
const FINE: usize = (WALL_NODES - 1) * STEPS;
/// A quadrature step, in h.
const STEP: f64 = 1.0 / FINE as f64;

/// The table, x fastest: gradient over the three distances (1/h), then the density ratio.
pub fn wall_weights(support_ratio: f64) -> Vec<[f32; 4]> {
    // The same for every scene, and most of the work: a program that plans several does it once.
    static OCTANT: OnceLock<Octant> = OnceLock::new();
    let octant = OCTANT.get_or_init(Octant::new);
    let scale = Scale::new(octant, support_ratio);
    let mut table = Vec::with_capacity(WALL_NODES.pow(3));
    for z in 0..WALL_NODES {
        for y in 0..WALL_NODES {
            for x in 0..WALL_NODES {
                let value = scale.plane * (octant.plane(x) + octant.plane(y) + octant.plane(z))
                    - scale.edge * (octant.edge(x, y) + octant.edge(y, z) + octant.edge(x, z))
                    + scale.corner * octant.corner(x, y, z);
                let slope = |a: usize, b: usize, c: usize| {
                    scale.plane * octant.plane_slope(a)
                        - scale.edge * (octant.edge_slope(a, b) + octant.edge_slope(a, c))
                        + scale.corner * octant.corner_slope(a, b, c)
                };
                table.push([slope(x, y, z), slope(y, x, z), slope(z, x, y), value].map(|v| v as f32));
            }
        }
    }
    table
}

/// Integrals of W over the octant beyond (a, b, c), and over the quarter-plane that bounds it.
struct Octant {
    /// ∫∫∫ of W, at nodes.
    volumes: Vec<f64>,
    /// ∫∫ of W over the plane at the first index, beyond the other two, at nodes.
    areas: Vec<f64>,
}

impl Octant {
    fn new() -> Self {
        let middle = |i: usize| (i as f64 + 0.5) * STEP;
        // Volumes: the midpoint rule, summed from the far end along each axis in turn.
        let mut fine = vec![0.0; FINE.pow(3)];
        for (index, value) in fine.iter_mut().enumerate() {
            let [x, y, z] = [index % FINE, index / FINE % FINE, index / (FINE * FINE)].map(middle);
            *value = wendland((x * x + y * y + z * z).sqrt()) * STEP.powi(3);
        }
        for stride in [1, FINE, FINE * FINE] {
            sum_from_the_end(&mut fine, stride);
        }
        let mut volumes = vec![0.0; WALL_NODES.pow(3)];
        let mut areas = vec![0.0; WALL_NODES.pow(3)];
        let last = WALL_NODES - 1;
        for z in 0..last {
            for y in 0..last {
                for x in 0..last {
                    volumes[node(x, y, z)] = fine[(z * FINE + y) * STEPS * FINE + x * STEPS];
                }
            }
        }
        for plane in 0..last {
            let a = plane as f64 / last as f64;
            let mut fine = vec![0.0; FINE * FINE];
            for (index, value) in fine.iter_mut().enumerate() {
                let [y, z] = [index % FINE, index / FINE].map(middle);
                *value = wendland((a * a + y * y + z * z).sqrt()) * STEP.powi(2);
            }
            for stride in [1, FINE] {
                sum_from_the_end(&mut fine, stride);
            }
            for z in 0..last {
                for y in 0..last {
                    areas[node(plane, y, z)] = fine[z * STEPS * FINE + y * STEPS];
                }
            }
        }
        Self { volumes, areas }
    }

    // By symmetry a half-space is four octants, a quarter-space two.
    fn plane(&self, a: usize) -> f64 {
        4.0 * self.corner(a, 0, 0)
    }
    fn edge(&self, a: usize, b: usize) -> f64 {
        2.0 * self.corner(a, b, 0)
    }
    fn corner(&self, a: usize, b: usize, c: usize) -> f64 {
        self.volumes[node(a, b, c)]
    }
    // Derivatives over the first distance.
    fn plane_slope(&self, a: usize) -> f64 {
        4.0 * self.corner_slope(a, 0, 0)
    }
    fn edge_slope(&self, a: usize, b: usize) -> f64 {
        2.0 * self.corner_slope(a, b, 0)
    }
    fn corner_slope(&self, a: usize, b: usize, c: usize) -> f64 {
        -self.areas[node(a, b, c)]
    }
}

/// What turns an integral over h³ into a density ratio.
struct Scale {
    plane: f64,
    edge: f64,
    corner: f64,
}

impl Scale {
    fn new(octant: &Octant, support_ratio: f64) -> Self {
        let (mut plane, mut edge, mut corner) = (0.0, 0.0, 0.0);
        for_lattice(support_ratio, |[x, y, z], q| {
            let w = wendland(q);
            plane += if x > 0 { w } else { 0.0 };
            edge += if x > 0 && y > 0 { w } else { 0.0 };
            corner += if x > 0 && y > 0 && z > 0 { w } else { 0.0 };
        });
        let weight = lattice(support_ratio).weight;
        let half = 0.5 / support_ratio;
        // Where the lattice has no point beyond an edge or corner, the continuum stands in.
        let continuum = weight * support_ratio.powi(3);
        let scale = |sum: f64, integral: f64| if sum > 0.0 { weight * sum / integral } else { continuum };
        Self {
            plane: scale(plane, 4.0 * octant.at([half, 0.0, 0.0])),
            edge: scale(edge, 2.0 * octant.at([half, half, 0.0])),
            corner: scale(corner, octant.at([half, half, half])),
        }
    }
}

impl Octant {
    /// The octant's integral between nodes, as the shader interpolates it.
    fn at(&self, distances: [f64; 3]) -> f64 {
        let place = distances.map(|d| d.clamp(0.0, 1.0) * (WALL_NODES - 1) as f64);
        let low = place.map(|p| (p as usize).min(WALL_NODES - 2));
        let part: [f64; 3] = std::array::from_fn(|axis| place[axis] - low[axis] as f64);
        (0..8)
            .map(|corner| {
                let up = [corner & 1, corner >> 1 & 1, corner >> 2];
                let share: f64 = (0..3).map(|axis| if up[axis] == 1 { part[axis] } else { 1.0 - part[axis] }).product();
                share * self.corner(low[0] + up[0], low[1] + up[1], low[2] + up[2])
            })
            .sum()
    }
}

fn node(x: usize, y: usize, z: usize) -> usize {
    (z * WALL_NODES + y) * WALL_NODES + x
}

/// Along the axis of `stride`, replaces each value by the sum of it and all behind it.
fn sum_from_the_end(values: &mut [f64], stride: usize) {
    for index in (0..values.len()).rev() {
        if index / stride % FINE + 1 < FINE {
            values[index] += values[index + stride];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lattice_against_walls_has_density_ratio_one() {
        for support_ratio in [2.0, 2.5, 3.0] {
            let table = wall_weights(support_ratio);
            let weight = lattice(support_ratio).weight;
            for walls in 0..8_usize {
                let bit = |axis: usize| walls >> axis & 1 == 1;
                let mut fluid = 0.0;
                for_lattice(support_ratio, |step, q| {
                    if (0..3).all(|axis| !bit(axis) || step[axis] >= 0) {
                        fluid += wendland(q) * weight;
                    }
                });
                let distances = std::array::from_fn(|axis| if bit(axis) { 0.5 / support_ratio } else { 1.0 });
                let ratio = fluid + f64::from(interpolated(&table, distances)[3]);
                // Table in f32 and its scale taken at the interpolated value: only rounding is left.
                assert!((ratio - 1.0).abs() < 1.0e-6, "h = {support_ratio} d, walls {walls:03b}: {ratio}");
            }
        }
    }

    #[test]
    fn slope_is_that_of_the_value() {
        let table = wall_weights(2.0);
        let step = 1.0 / (WALL_NODES - 1) as f64;
        for start in [[0.2, 0.9, 0.6], [0.05, 0.1, 0.4]] {
            // At nodes: between them value and slope are interpolated apart.
            let at = start.map(|s: f64| (s / step).round() * step);
            for axis in 0..3 {
                let [mut low, mut high] = [at; 2];
                low[axis] -= step;
                high[axis] += step;
                let difference = f64::from(interpolated(&table, high)[3] - interpolated(&table, low)[3]) / (2.0 * step);
                let slope = f64::from(interpolated(&table, at)[axis]);
                // Central differences over 2/31 h: their own error is of the order of step².
                assert!(
                    (slope - difference).abs() < 0.02 + 0.02 * slope.abs(),
                    "{at:?} axis {axis}: {slope} {difference}"
                );
            }
        }
    }

    fn interpolated(table: &[[f32; 4]], distances: [f64; 3]) -> [f32; 4] {
        let place = distances.map(|d: f64| d.clamp(0.0, 1.0) * (WALL_NODES - 1) as f64);
        let low = place.map(|p| (p as usize).min(WALL_NODES - 2));
        let mut sum = [0.0_f64; 4];
        for corner in 0..8 {
            let up = [corner & 1, corner >> 1 & 1, corner >> 2];
            let share: f64 = (0..3)
                .map(|axis| {
                    let part = place[axis] - low[axis] as f64;
                    if up[axis] == 1 { part } else { 1.0 - part }
                })
                .product();
            let entry = table[node(low[0] + up[0], low[1] + up[1], low[2] + up[2])];
            (0..4).for_each(|i| sum[i] += share * f64::from(entry[i]));
        }
        sum.map(|v| v as f32)
    }
}
