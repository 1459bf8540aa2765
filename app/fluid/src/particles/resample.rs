//! The same fluid with particles of another spacing, without a new start: for a quality ladder that goes
//! up or down a rung while the fluid moves.
//!
//! The density of the old particles is splatted onto the new spacing's lattice, and as many of its points
//! as make the old volume get a particle, densest first: about those where the density is above half of
//! that at rest, which is where a flat surface lies. So the volume is kept even where a sheet or a drop is
//! thinner than the new spacing, and no threshold is right. Velocities are interpolated with the same
//! kernel (Shepard 1968), the fluid's number is the nearest particle's.

use std::collections::HashMap;

use brooklet_kernels::{FLUID_SHIFT, Position, Velocity};

use super::{ParticleSet, fluid_of, is_simulated};
use crate::scene::{MAX_PARTICLES, Scene, WHOLE, steps_m};
use crate::smoothing_kernel::{lattice, wendland};

/// The support radius of the splatting kernel, in spacings of whichever lattice is coarser.
const SUPPORT_RATIO: f64 = 2.0;
/// No particle is put where the density ratio is below this: nothing of the fluid is there.
const LEAST_RATIO: f32 = 0.02;
/// Density ratios that differ by less are the same, as those over a flat surface are but for rounding.
const RATIO_STEP: f32 = 1.0 / 64.0;

/// `particles` of scene `from` as particles of scene `to`, which has another spacing, and the same domain
/// and dimensions. What is quarantined is left out. The particle count is the old one times the ratio of
/// the particles' volumes, to within half a particle; at most [`MAX_PARTICLES`], and fewer where spray is
/// finer than the new lattice. Fluid that reaches from wall to wall gets a lattice that does, too
/// (`scene/lattice.rs`); elsewhere it lies as [`super::sample_lattice`] puts a block at the domain's corner.
///
/// What it costs a fluid at rest or in smooth motion (`tests/tests/fluid/resample.rs`, 0.7 to 1.6 times the spacing): no
/// volume, up to 3.3 % of the momentum, and less than 0.3 spacings of its position where it is two layers thin.
pub fn resample(from: &Scene, particles: &ParticleSet, to: &Scene) -> ParticleSet {
    let [from_m, to_m] = [from, to].map(Scene::fitted_spacing_m);
    let support_m = SUPPORT_RATIO * from_m.max(to_m);
    let dimensions = to.domain.dimensions;
    let cell_ratio = (from_m / to_m).powi(dimensions as i32);
    // Each particle's share of a density ratio: the kernel's sum over a lattice of `from`.
    let scale = (lattice(dimensions, support_m / from_m).weight) as f32;
    let moved_m: [f64; 3] = std::array::from_fn(|axis| from.domain.min_m[axis] - to.domain.min_m[axis]);
    let placed_m = |position: &Position| -> [f64; 3] {
        std::array::from_fn(|axis| f64::from(position.position_m[axis]) + moved_m[axis])
    };
    let is_kept = |(position, velocity): &(&Position, &Velocity)| {
        let numbers = position.position_m.iter().chain(&velocity.velocity_m_s);
        is_simulated(position.tag) && numbers.copied().all(f32::is_finite)
    };
    let kept = || particles.positions.iter().zip(&particles.velocities).filter(is_kept);
    let mut extent_m = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for (position, _) in kept() {
        for (axis, x_m) in placed_m(position).into_iter().enumerate() {
            extent_m[0][axis] = extent_m[0][axis].min(x_m);
            extent_m[1][axis] = extent_m[1][axis].max(x_m);
        }
    }
    let points = Points::of(to, extent_m);
    let mut field = Field::default();
    let mut count = 0u64;
    for (position, velocity) in kept() {
        count += 1;
        let fluid = fluid_of(position.tag);
        for_each_image(to, placed_m(position), support_m, |image_m, mirrored| {
            let velocity_m_s = std::array::from_fn(|axis| match mirrored[axis] {
                true => -velocity.velocity_m_s[axis],
                false => velocity.velocity_m_s[axis],
            });
            field.splat(&points, image_m, support_m, velocity_m_s, fluid);
        });
    }
    let wanted = (count as f64 * cell_ratio).round().min(f64::from(MAX_PARTICLES)) as usize;
    particle_set(&points, field.densest(scale, wanted), to)
}

/// The particle, and its images beyond walls and periodic faces that are near enough to be met. A wall
/// mirrors, so that density and velocity along it go on behind it.
fn for_each_image(scene: &Scene, position_m: [f64; 3], reach_m: f64, mut visit: impl FnMut([f64; 3], [bool; 3])) {
    let (size_m, period_m) = (scene.domain.size_m(), scene.period_m());
    let along = |axis: usize| {
        let x = position_m[axis];
        let mut images = vec![(x, false)];
        if scene.domain.has_walls_along(axis) {
            images.extend((x < reach_m).then_some((-x, true)));
            images.extend((x > size_m[axis] - reach_m).then_some((2.0 * size_m[axis] - x, true)));
        } else if period_m[axis] > 0.0 {
            images.extend((x < reach_m).then_some((x + period_m[axis], false)));
            images.extend((x > period_m[axis] - reach_m).then_some((x - period_m[axis], false)));
        }
        images
    };
    let [xs, ys, zs] =
        [along(0), along(1), if scene.domain.is_flat() { vec![(position_m[2], false)] } else { along(2) }];
    for &(z, mirrored_z) in &zs {
        for &(y, mirrored_y) in &ys {
            for &(x, mirrored_x) in &xs {
                visit([x, y, z], [mirrored_x, mirrored_y, mirrored_z]);
            }
        }
    }
}

/// The lattice of a scene: the middles of cells of its spacing, from the domain's lowest corner on.
struct Points {
    first_m: [f64; 3],
    steps_m: [f64; 3],
    /// Lowest and one past the highest number along each axis; a lattice without an end is cut where
    /// numbers would no longer be exact.
    bounds: [[i32; 2]; 3],
}

impl Points {
    /// For fluid whose particles lie within `extent_m`, lowest and highest along each axis: where it reaches
    /// from wall to wall, so does the lattice; where it stands against one wall, the lattice begins there.
    fn of(scene: &Scene, extent_m: [[f64; 3]; 2]) -> Self {
        const FAR: i32 = 1 << 24;
        let (domain, spacing_m, size_m) = (&scene.domain, scene.fitted_spacing_m(), scene.domain.size_m());
        let low = |axis: usize| extent_m[0][axis] < spacing_m;
        let high = |axis: usize| extent_m[1][axis] > size_m[axis] - spacing_m;
        let filled_m = std::array::from_fn(|axis| {
            let is_filled = domain.periodic[axis] || domain.has_walls_along(axis) && low(axis) && high(axis);
            is_filled.then(|| size_m[axis])
        });
        let steps_m = steps_m(spacing_m, domain.dimensions, filled_m);
        let mut points = Self { first_m: steps_m.map(|step_m| 0.5 * step_m), steps_m, bounds: [[-FAR, FAR]; 3] };
        for (axis, size_m) in size_m.into_iter().enumerate() {
            if axis == 2 && domain.is_flat() {
                points.first_m[axis] = domain.plane_z_m() - domain.min_m[axis];
                points.bounds[axis] = [0, 1];
            } else if domain.periodic[axis] || domain.has_walls_along(axis) {
                let count = (size_m / steps_m[axis] + WHOLE).floor();
                points.bounds[axis] = [0, count as i32];
                if high(axis) && !low(axis) {
                    points.first_m[axis] += size_m - count * steps_m[axis];
                }
            }
        }
        points
    }

    fn place_m(&self, point: [i32; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| self.first_m[axis] + f64::from(point[axis]) * self.steps_m[axis])
    }

    /// Numbers along an axis of the points within `reach_m` of `x`.
    fn near(&self, axis: usize, x: f64, reach_m: f64) -> std::ops::Range<i32> {
        let [first, end] = self.bounds[axis];
        let low = ((x - reach_m - self.first_m[axis]) / self.steps_m[axis]).ceil() as i32;
        let high = ((x + reach_m - self.first_m[axis]) / self.steps_m[axis]).floor() as i32;
        low.max(first)..high.saturating_add(1).min(end)
    }
}

/// Points of a block's side.
const SIDE: i32 = 8;

/// What the old particles say of a lattice point.
#[derive(Clone, Copy, Default)]
struct Sum {
    /// Of the kernel.
    weight: f32,
    /// The nearest particle's fluid, and the kernel's value at it.
    fluid: u32,
    nearest: f32,
    velocity_m_s: [f32; 3],
}

/// Sums over the lattice, where there is fluid: in blocks, since a splash may be anywhere.
#[derive(Default)]
struct Field {
    blocks: HashMap<[i32; 3], Vec<Sum>>,
}

impl Field {
    fn splat(&mut self, points: &Points, at_m: [f64; 3], support_m: f64, velocity_m_s: [f32; 3], fluid: u32) {
        let near: [_; 3] = std::array::from_fn(|axis| points.near(axis, at_m[axis], support_m));
        if near.iter().any(std::ops::Range::is_empty) {
            return;
        }
        let blocks: [_; 3] =
            std::array::from_fn(|axis| near[axis].start.div_euclid(SIDE)..=(near[axis].end - 1).div_euclid(SIDE));
        for bz in blocks[2].clone() {
            for by in blocks[1].clone() {
                for bx in blocks[0].clone() {
                    let block = [bx, by, bz];
                    let within: [_; 3] = std::array::from_fn(|axis| {
                        let first = block[axis] * SIDE;
                        near[axis].start.max(first)..near[axis].end.min(first + SIDE)
                    });
                    let sums = self.blocks.entry(block).or_insert_with(|| vec![Sum::default(); SIDE.pow(3) as usize]);
                    for_each(within, |point| {
                        let place_m = points.place_m(point);
                        let squared_m2: f64 = (0..3).map(|axis| (place_m[axis] - at_m[axis]).powi(2)).sum();
                        let weight = wendland(squared_m2.sqrt() / support_m) as f32;
                        if weight > 0.0 {
                            sums[index(point)].add(weight, velocity_m_s, fluid);
                        }
                    });
                }
            }
        }
    }

    /// The `wanted` points with the highest density ratios, in the lattice's order.
    fn densest(self, scale: f32, wanted: usize) -> Vec<([i32; 3], Sum)> {
        let mut found: Vec<([i32; 3], Sum)> = Vec::new();
        for (block, sums) in self.blocks {
            let first = block.map(|number| number * SIDE);
            let points = std::array::from_fn(|axis| first[axis]..first[axis] + SIDE);
            for_each(points, |point| {
                let sum = sums[index(point)];
                if scale * sum.weight >= LEAST_RATIO {
                    found.push((point, sum));
                }
            });
        }
        let level = |sum: &Sum| (scale * sum.weight / RATIO_STEP) as u32;
        if found.len() > wanted {
            let (_, (_, last), _) = found.select_nth_unstable_by_key(wanted, |(_, sum)| u32::MAX - level(sum));
            let cut = level(last);
            let mut equal: Vec<([i32; 3], Sum)> = found.iter().filter(|(_, sum)| level(sum) == cut).copied().collect();
            found.retain(|(_, sum)| level(sum) > cut);
            // The last particles are spread evenly over the points that have equal claims to them.
            equal.sort_by_cached_key(|(point, _)| interleaved(*point));
            let missing = wanted - found.len();
            found.extend((0..missing).map(|number| equal[(2 * number + 1) * equal.len() / (2 * missing)]));
        }
        // A map has no order of its own.
        found.sort_unstable_by_key(|([x, y, z], _)| [*z, *y, *x]);
        found
    }
}

impl Sum {
    fn add(&mut self, weight: f32, velocity_m_s: [f32; 3], fluid: u32) {
        self.weight += weight;
        for (sum, v) in self.velocity_m_s.iter_mut().zip(velocity_m_s) {
            *sum += weight * v;
        }
        if weight > self.nearest {
            (self.nearest, self.fluid) = (weight, fluid);
        }
    }
}

fn for_each(ranges: [std::ops::Range<i32>; 3], mut visit: impl FnMut([i32; 3])) {
    for z in ranges[2].clone() {
        for y in ranges[1].clone() {
            for x in ranges[0].clone() {
                visit([x, y, z]);
            }
        }
    }
}

/// A point's index in its block.
fn index(point: [i32; 3]) -> usize {
    let [x, y, z] = point.map(|number| number.rem_euclid(SIDE));
    ((z * SIDE + y) * SIDE + x) as usize
}

/// The bits of a point's numbers by turns: points that follow each other lie near each other.
fn interleaved(point: [i32; 3]) -> u128 {
    let mut code = 0;
    for bit in (0..32).rev() {
        for number in point {
            code = code << 1 | u128::from((number as u32 ^ 1 << 31) >> bit & 1);
        }
    }
    code
}

fn particle_set(points: &Points, found: Vec<([i32; 3], Sum)>, to: &Scene) -> ParticleSet {
    let mut particles = ParticleSet::default();
    for (id, (point, sum)) in found.into_iter().enumerate() {
        let mut velocity_m_s = sum.velocity_m_s.map(|v| v / sum.weight);
        if to.domain.is_flat() {
            velocity_m_s[2] = 0.0;
        }
        particles.positions.push(Position {
            position_m: points.place_m(point).map(|x| x as f32),
            tag: id as u32 | sum.fluid << FLUID_SHIFT,
        });
        particles.velocities.push(Velocity { velocity_m_s, age_s: 0.0 });
    }
    particles
}
