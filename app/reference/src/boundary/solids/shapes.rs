//! The shapes of solids: distances from their surfaces, and how much of the kernel lies in them. (Shader:
//! `boundary/solids/shapes.hlsli`.)

use std::sync::Arc;

use super::field::{FIELD_STEEPNESS, Field};
use brooklet_kernels::{SHAPE_BOX, SHAPE_CAPSULE, SHAPE_FIELD, SmoothingKernelParams};
use glam::{DVec2, DVec3};

/// What a solid is, in its own frame; see `Solid` of the shaders' layout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Between two corners.
    Box,
    /// Around a line along y.
    Capsule,
    /// Around y.
    Cylinder,
}

/// A solid's shape, and what contacts with it do.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// What its numbers mean.
    pub shape: Shape,
    /// Half its sides, m; of a capsule without its ends.
    pub half_m: DVec3,
    /// Lowest and highest corner of what is hollow of it, m; beyond the shape where it is open.
    pub cavity_m: Option<[DVec3; 2]>,
    /// Half the sides of the box around it, m.
    pub extent_m: DVec3,
    /// Of a mesh, in place of shape, sizes and cavity.
    pub field: Option<Arc<Field>>,
    /// Coulomb friction.
    pub friction: f64,
    /// Of a contact.
    pub restitution: f64,
}

fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

impl Solid {
    /// What shaders are given, with the nodes of all fields.
    pub fn of(solid: &brooklet_kernels::Solid, nodes: &[[f32; 2]]) -> Self {
        Self {
            field: (solid.shape == SHAPE_FIELD).then(|| Arc::new(Field::of(solid, nodes))),
            shape: match solid.shape {
                SHAPE_BOX => Shape::Box,
                SHAPE_CAPSULE => Shape::Capsule,
                _ => Shape::Cylinder,
            },
            half_m: vector(solid.half_m),
            cavity_m: (solid.is_hollow != 0).then(|| [vector(solid.cavity_min_m), vector(solid.cavity_max_m)]),
            extent_m: vector(solid.extent_m),
            friction: solid.friction.into(),
            restitution: solid.restitution.into(),
        }
    }

    /// How far a place is from the surface, m, negative inside, and which way is out.
    pub fn surface(&self, place_m: DVec3) -> (f64, DVec3) {
        if let Some(field) = &self.field {
            return field.surface(place_m);
        }
        let outside = surface(self.shape, place_m, self.half_m);
        let Some([min_m, max_m]) = self.cavity_m else { return outside };
        let (into_m, out) = surface(self.shape, place_m - 0.5 * (min_m + max_m), 0.5 * (max_m - min_m));
        if -into_m > outside.0 { (-into_m, -out) } else { outside }
    }

    /// How fast its distance may change at most.
    pub fn steepness(&self) -> f64 {
        if self.field.is_some() { FIELD_STEEPNESS } else { 1.0 }
    }

    /// How much of the kernel around a place, in h, lies in it, and the slope of that by position, per h.
    pub fn share(&self, place: DVec3, support_m: f64, plane: &BeyondPlane) -> (f64, DVec3) {
        if let Some(field) = &self.field {
            let sample = field.sample(place * support_m);
            let (share, slope) = plane.at(sample.values[1]);
            let is_inside = sample.outside_m == DVec3::ZERO;
            return if is_inside { (share, -slope * support_m * sample.slopes[1]) } else { (0.0, DVec3::ZERO) };
        }
        let half = self.half_m / support_m;
        let whole = share(self.shape, place, -half, half, plane);
        let Some([min_m, max_m]) = self.cavity_m else { return whole };
        let [low, high] = [(min_m / support_m).max(-half), (max_m / support_m).min(half)];
        let cavity = share(self.shape, place, low, high, plane);
        ((whole.0 - cavity.0).max(0.0), whole.1 - cavity.1)
    }
}

fn or_else(direction: DVec3, otherwise: DVec3) -> DVec3 {
    direction.try_normalize().unwrap_or(otherwise)
}

/// Of 1 and -1, that with the sign of `x`; 1 of 0.
fn side(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

fn surface(shape: Shape, place_m: DVec3, half_m: DVec3) -> (f64, DVec3) {
    match shape {
        Shape::Box => {
            let beyond_m = place_m.abs() - half_m;
            let outside_m = beyond_m.max(DVec3::ZERO);
            let furthest_m = beyond_m.max_element();
            let face = (0..3).find(|&axis| beyond_m[axis] >= furthest_m).unwrap_or_default();
            let signs = DVec3::new(side(place_m.x), side(place_m.y), side(place_m.z));
            (outside_m.length() + furthest_m.min(0.0), signs * or_else(outside_m, DVec3::AXES[face]))
        }
        Shape::Capsule => {
            let from_axis_m = place_m - DVec3::Y * place_m.y.clamp(-half_m.y, half_m.y);
            (from_axis_m.length() - half_m.x, or_else(from_axis_m, DVec3::X))
        }
        Shape::Cylinder => {
            let from_axis_m = DVec3::new(place_m.x, 0.0, place_m.z);
            let beyond_m = DVec2::new(from_axis_m.length() - half_m.x, place_m.y.abs() - half_m.y);
            let outside_m = beyond_m.max(DVec2::ZERO);
            let face = if beyond_m.x >= beyond_m.y { DVec2::X } else { DVec2::Y };
            let out = outside_m.try_normalize().unwrap_or(face);
            let radial = or_else(from_axis_m, DVec3::X);
            (
                outside_m.length() + beyond_m.max_element().min(0.0),
                radial * out.x + DVec3::Y * (side(place_m.y) * out.y),
            )
        }
    }
}

/// The share of the kernel beyond a plane: a polynomial of how far the kernel reaches into it, times its fifth power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeyondPlane {
    fraction: [f64; 4],
}

impl BeyondPlane {
    /// That which shaders are given.
    pub fn of(kernel: &SmoothingKernelParams) -> Self {
        Self { fraction: kernel.wall_kernel_fraction.map(f64::from) }
    }

    /// At a signed distance in h: the share, and how much it shrinks with the distance, per h.
    pub fn at(&self, distance: f64) -> (f64, f64) {
        let t = (1.0 - distance.abs()).clamp(0.0, 1.0);
        let powers = (5..).map(|n| (n, t.powi(n), f64::from(n) * t.powi(n - 1)));
        let (share, slope) = self
            .fraction
            .iter()
            .zip(powers)
            .fold((0.0, 0.0), |sum, (c, (_, power, derivative))| (sum.0 + c * power, sum.1 + c * derivative));
        (if distance < 0.0 { 1.0 - share } else { share }, slope)
    }

    /// The distance at which a share lies beyond the plane, by as many bisections as the shader makes.
    pub fn distance_of(&self, share: f64) -> f64 {
        let (low, high) = (0..18).fold((-1.0, 1.0), |(low, high), _| {
            let middle = 0.5 * (low + high);
            if self.at(middle).0 > share { (middle, high) } else { (low, middle) }
        });
        0.5 * (low + high)
    }
}

/// Between two planes along an axis: the share, and its slope by position.
fn between(low: f64, high: f64, plane: &BeyondPlane) -> (f64, f64) {
    let [below, above] = [plane.at(low), plane.at(high)];
    ((1.0 - below.0 - above.0).max(0.0), below.1 - above.1)
}

/// In a ball of a radius, at a signed distance from its surface, all in h: as [`BeyondPlane::at`].
fn ball(distance: f64, radius: f64, plane: &BeyondPlane) -> (f64, f64) {
    let t = (1.0 - distance.abs()).clamp(0.0, 1.0);
    let curved = t.powi(7) / 2.0 - 9.0 / 16.0 * t.powi(8) + t.powi(9) / 6.0;
    let curved_slope = 3.5 * t.powi(6) - 4.5 * t.powi(7) + 1.5 * t.powi(8);
    let (flat, flat_slope) = plane.at(distance.abs());
    let to_middle = (radius + distance).max(0.5 * radius);
    match distance < 0.0 {
        false => {
            let share = (radius * flat - curved) / to_middle;
            (share, (radius * flat_slope - curved_slope + share) / to_middle)
        }
        true => {
            let beyond = (radius * flat + curved) / to_middle;
            (1.0 - beyond, (radius * flat_slope + curved_slope - beyond) / to_middle)
        }
    }
}

fn share(shape: Shape, place: DVec3, low: DVec3, high: DVec3, plane: &BeyondPlane) -> (f64, DVec3) {
    match shape {
        Shape::Box => {
            let each: [(f64, f64); 3] =
                std::array::from_fn(|axis| between(place[axis] - low[axis], high[axis] - place[axis], plane));
            let others = |axis: usize| each[(axis + 1) % 3].0 * each[(axis + 2) % 3].0;
            (each[0].0 * others(0), DVec3::from_array(std::array::from_fn(|axis| each[axis].1 * others(axis))))
        }
        Shape::Capsule => {
            let (from_middle, half) = (place - 0.5 * (low + high), 0.5 * (high - low));
            let from_axis = from_middle - DVec3::Y * from_middle.y.clamp(-half.y, half.y);
            let ends = plane.at(half.y - from_middle.y).0 + plane.at(half.y + from_middle.y).0;
            let radius = half.x / (0.5 + 0.5 * ends);
            let (share, slope) = ball(from_axis.length() - half.x, radius, plane);
            (share, -slope * or_else(from_axis, DVec3::ZERO))
        }
        Shape::Cylinder => {
            let radius = 0.5 * (high.x - low.x);
            let from_axis = DVec3::new(place.x, 0.0, place.z);
            let (side, side_slope) = ball(from_axis.length() - radius, 2.0 * radius, plane);
            let (along, along_slope) = between(place.y - low.y, high.y - place.y, plane);
            (side * along, -side_slope * along * or_else(from_axis, DVec3::ZERO) + DVec3::Y * (side * along_slope))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::wendland::kernel;

    /// Points along each axis of a grid over the kernel's ball: of a plane's share it is off by .0005.
    const POINTS: i32 = 64;

    /// How much of the kernel around a place lies inside a solid, by a sum over a grid.
    fn integral(solid: &Solid, place: DVec3) -> f64 {
        let (mut inside, mut all) = (0.0, 0.0);
        let at = |k: i32| (f64::from(k) + 0.5) / f64::from(POINTS) * 2.0 - 1.0;
        for x in 0..POINTS {
            for y in 0..POINTS {
                for z in 0..POINTS {
                    let q = DVec3::new(at(x), at(y), at(z));
                    let weight = kernel(q.length().min(1.0));
                    all += weight;
                    inside += if solid.surface(place + q).0 < 0.0 { weight } else { 0.0 };
                }
            }
        }
        inside / all
    }

    fn plane() -> BeyondPlane {
        BeyondPlane { fraction: [0.0, 3.5, -4.5, 1.5] }
    }

    fn solid(shape: Shape, half_m: DVec3, cavity_m: Option<[DVec3; 2]>) -> Solid {
        let extent_m = if shape == Shape::Capsule { half_m + DVec3::Y * half_m.x } else { half_m };
        Solid { shape, half_m, cavity_m, extent_m, field: None, friction: 0.0, restitution: 0.0 }
    }

    /// Places on which particles stand: at several distances outside, in all directions.
    fn places(solid: &Solid) -> impl Iterator<Item = DVec3> {
        let directions = (0..26).map(|k| {
            let k = f64::from(k);
            DVec3::new((2.4 * k).cos(), (k - 12.5) / 13.0, (2.4 * k).sin()).normalize()
        });
        let places = directions.flat_map(|direction| [0.25, 0.5, 0.75].map(|distance| (direction, distance)));
        places.map(|(direction, distance)| {
            let mut place = direction * (solid.extent_m + 1.0);
            for _ in 0..40 {
                let (away, out) = solid.surface(place);
                place += out * (distance - away);
            }
            place
        })
    }

    /// Lengths are in h. Shares are at most .5, .19 at half a spacing of h/2.
    #[test]
    fn shares_of_shapes_are_close_to_their_integrals() {
        let cases = [
            ("box", solid(Shape::Box, DVec3::new(1.0, 0.5, 2.0), None), 0.01),
            ("a thin box", solid(Shape::Box, DVec3::new(0.25, 1.0, 1.0), None), 0.009),
            ("ball of h", solid(Shape::Capsule, DVec3::new(1.0, 0.0, 1.0), None), 0.001),
            ("ball of h/2", solid(Shape::Capsule, DVec3::new(0.5, 0.0, 0.5), None), 0.002),
            ("capsule", solid(Shape::Capsule, DVec3::new(1.0, 1.0, 1.0), None), 0.005),
            ("cylinder", solid(Shape::Cylinder, DVec3::new(1.5, 1.0, 1.5), None), 0.006),
        ];
        for (name, solid, tolerance) in cases {
            let off = |place: DVec3| (solid.share(place, 1.0, &plane()).0 - integral(&solid, place)).abs();
            let worst = places(&solid).map(off).fold(0.0, f64::max);
            println!("{name}: {worst:.5}");
            assert!(worst < tolerance, "{name}: off by {worst}");
        }
    }

    #[test]
    fn what_a_hollow_solid_holds_is_outside_of_it() {
        let inner = DVec3::splat(1.5);
        let hollow = solid(Shape::Box, DVec3::splat(2.0), Some([-inner, DVec3::new(1.5, 20.0, 1.5)]));
        assert!((hollow.surface(DVec3::ZERO).0 - 1.5).abs() < 1e-12);
        assert!(hollow.surface(DVec3::new(1.75, 0.0, 0.0)).0 < 0.0);
        // Through the open lid the sky is free.
        assert!(hollow.surface(DVec3::new(0.0, 1.9, 0.0)).0 > 1.0);
        for at in [DVec3::new(1.25, 0.0, 0.0), DVec3::new(1.25, -1.25, 0.3), DVec3::new(1.2, 1.8, 0.1)] {
            let (share, expected) = (hollow.share(at, 1.0, &plane()).0, integral(&hollow, at));
            assert!((share - expected).abs() < 0.01, "at {at}: {share} and {expected}");
        }
    }

    /// Directions in which a share grows are its differences.
    #[test]
    fn slopes_are_those_of_shares() {
        let hollow = Some([DVec3::new(-1.2, -0.7, -1.2), DVec3::new(1.2, 10.0, 1.2)]);
        for solid in [
            solid(Shape::Box, DVec3::new(1.0, 0.5, 2.0), None),
            solid(Shape::Capsule, DVec3::new(1.0, 0.0, 1.0), None),
            solid(Shape::Cylinder, DVec3::new(1.5, 1.0, 1.5), hollow),
        ] {
            for place in places(&solid) {
                let (_, slope) = solid.share(place, 1.0, &plane());
                let differences = DVec3::AXES.map(|axis| {
                    let at = |step: f64| solid.share(place + axis * step, 1.0, &plane()).0;
                    (at(1e-5) - at(-1e-5)) / 2e-5
                });
                let off = (slope - DVec3::from_array(differences)).length();
                assert!(off < 1e-5, "{:?} at {place}: {slope} and {differences:?}", solid.shape);
            }
        }
    }

    #[test]
    fn a_plane_is_found_by_its_share() {
        for share in [0.01, 0.19, 0.5, 0.8] {
            let found = plane().at(plane().distance_of(share)).0;
            assert!((found - share).abs() < 2e-5, "{share}: {found}");
        }
    }
}
