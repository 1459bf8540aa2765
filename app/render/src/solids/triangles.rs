//! Triangles of solids' shapes, each in its solid's own frame: counter-clockwise as seen from where their normals point to.
//!
//! Round sides have the normals of what they stand for and meet at rims with a hard edge, as a box's faces do. A hollow solid
//! has its outside, its inside and, where it is open, the rim between both.

use brooklet_fluid::scene::SolidSettings;
use brooklet_kernels::{SHAPE_BOX, SHAPE_CAPSULE, SHAPE_FIELD, Solid, SolidVertex};
use glam::DVec3;

/// Triangles of some of a scene's solids.
#[derive(Clone, Debug, Default)]
pub struct SolidTriangles {
    /// Their corners.
    pub vertices: Vec<SolidVertex>,
    /// Three a triangle.
    pub indices: Vec<u32>,
}

/// A point of a profile that is turned around y: its radius and height, m, and the normal's.
type ProfilePoint = [f64; 4];

impl SolidTriangles {
    /// Adds solid `number` of the scene, which has these `settings`, with so many `segments` around whatever is round.
    pub fn add(&mut self, number: u32, solid: &Solid, segments: u32, settings: &SolidSettings) {
        let before = self.vertices.len();
        match solid.shape {
            SHAPE_FIELD => settings.triangles().into_iter().for_each(|own| self.add_triangles(settings, own)),
            SHAPE_BOX => self.add_box(solid),
            SHAPE_CAPSULE => self.add_capsule(solid, segments),
            _ => self.add_cylinder(solid, segments),
        }
        self.vertices[before..].iter_mut().for_each(|vertex| vertex.solid = number);
    }

    fn add_box(&mut self, solid: &Solid) {
        let half_m = vector(solid.half_m);
        let (cavity, is_hollow) = (cavity_m(solid), solid.is_hollow != 0);
        let [low_m, high_m] = cavity.map(|end_m| end_m.clamp(-half_m, half_m));
        for (axis, highest) in (0..3).flat_map(|axis| [(axis, false), (axis, true)]) {
            let (a, b, side) = ((axis + 1) % 3, (axis + 2) % 3, if highest { 1.0 } else { -1.0 });
            let along = |axis: usize| DVec3::AXES[axis];
            let normal = side * along(axis);
            // Around the face, from the lowest corner.
            let around = |at_m: f64, low_m: DVec3, high_m: DVec3| {
                let [(a0, a1), (b0, b1)] = [a, b].map(|axis| (low_m[axis], high_m[axis]));
                [(a0, b0), (a1, b0), (a1, b1), (a0, b1)]
                    .map(|(at_a, at_b)| at_m * along(axis) + at_a * along(a) + at_b * along(b))
            };
            let outside = around(side * half_m[axis], -half_m, half_m);
            if is_hollow && is_open(solid, axis, highest) {
                let hole = around(side * half_m[axis], low_m, high_m);
                for corner in 0..4 {
                    let next = (corner + 1) % 4;
                    self.quad([outside[corner], outside[next], hole[next], hole[corner]], normal, 1.0);
                }
            } else {
                self.quad(outside, normal, 0.0);
                if is_hollow {
                    let end_m = if highest { high_m } else { low_m };
                    self.quad(around(end_m[axis], low_m, high_m), -normal, 0.0);
                }
            }
        }
    }

    fn add_capsule(&mut self, solid: &Solid, segments: u32) {
        let half_m = vector(solid.half_m);
        self.lathe(&capsule_profile(half_m.x, half_m.y, 1.0, segments), segments, 0.0);
        if solid.is_hollow != 0 {
            self.lathe(&capsule_profile(f64::from(solid.cavity_max_m[0]), half_m.y, -1.0, segments), segments, 0.0);
        }
    }

    fn add_cylinder(&mut self, solid: &Solid, segments: u32) {
        let half_m = vector(solid.half_m);
        let radius_m = half_m.x;
        self.lathe(&[[radius_m, -half_m.y, 1.0, 0.0], [radius_m, half_m.y, 1.0, 0.0]], segments, 0.0);
        let is_hollow = solid.is_hollow != 0;
        let [low_m, high_m] = cavity_m(solid).map(|end_m| end_m.y.clamp(-half_m.y, half_m.y));
        let inner_m = f64::from(solid.cavity_max_m[0]);
        for (highest, side, end_m) in [(false, -1.0, low_m), (true, 1.0, high_m)] {
            let at_m = side * half_m.y;
            let is_open = is_hollow && is_open(solid, 1, highest);
            let from_m = if is_open { inner_m } else { 0.0 };
            let rim = f32::from(u8::from(is_open));
            self.lathe(&[[from_m, at_m, 0.0, side], [radius_m, at_m, 0.0, side]], segments, rim);
            if is_hollow && !is_open {
                self.lathe(&[[0.0, end_m, 0.0, -side], [inner_m, end_m, 0.0, -side]], segments, 0.0);
            }
        }
        if is_hollow {
            self.lathe(&[[inner_m, low_m, -1.0, 0.0], [inner_m, high_m, -1.0, 0.0]], segments, 0.0);
        }
    }

    /// A profile turned around y.
    fn lathe(&mut self, profile: &[ProfilePoint], segments: u32, rim: f32) {
        let first = self.vertices.len() as u32;
        for &[radius_m, height_m, aside, upward] in profile {
            for segment in 0..segments {
                let (sine, cosine) = (std::f64::consts::TAU * f64::from(segment) / f64::from(segments)).sin_cos();
                let normal = DVec3::new(aside * cosine, upward, aside * sine);
                self.vertex(DVec3::new(radius_m * cosine, height_m, radius_m * sine), normal, rim);
            }
        }
        for (ring, segment) in (1..profile.len() as u32).flat_map(|ring| (0..segments).map(move |s| (ring, s))) {
            let next = (segment + 1) % segments;
            let [below, above] = [ring - 1, ring].map(|ring| first + ring * segments);
            self.triangle([below + segment, below + next, above + next]);
            self.triangle([below + segment, above + next, above + segment]);
        }
    }

    pub(super) fn quad(&mut self, corners_m: [DVec3; 4], normal: DVec3, rim: f32) {
        let first = self.vertices.len() as u32;
        corners_m.into_iter().for_each(|corner_m| self.vertex(corner_m, normal, rim));
        self.triangle([first, first + 1, first + 2]);
        self.triangle([first, first + 2, first + 3]);
    }

    pub(super) fn vertex(&mut self, position_m: DVec3, normal: DVec3, rim: f32) {
        self.vertices.push(SolidVertex {
            position_m: position_m.as_vec3().into(),
            solid: 0,
            normal: normal.as_vec3().into(),
            rim,
        });
    }

    /// Adds a triangle the way round that its normals say; none where two corners are one point, as at a pole.
    fn triangle(&mut self, [a, b, c]: [u32; 3]) {
        let at = |index: u32| &self.vertices[index as usize];
        let [from_m, to_b_m, to_c_m] = [a, b, c].map(|index| vector(at(index).position_m));
        let (along_b_m, along_c_m) = (to_b_m - from_m, to_c_m - from_m);
        let (across_m2, outward) =
            (along_b_m.cross(along_c_m), [a, b, c].map(|index| vector(at(index).normal)).into_iter().sum());
        if across_m2.length() <= 1e-7 * along_b_m.length().max(along_c_m.length()).powi(2) {
            return;
        }
        self.indices.extend(if across_m2.dot(outward) > 0.0 { [a, b, c] } else { [a, c, b] });
    }
}

/// Half a capsule's outline, from its lowest point: of what is solid, or with -1 of what is hollow of it.
fn capsule_profile(radius_m: f64, half_m: f64, outward: f64, segments: u32) -> Vec<ProfilePoint> {
    let quarter = segments.div_ceil(4);
    let arc = |from: f64, middle_m: f64| {
        (0..=quarter).map(move |step| {
            let (sine, cosine) = (from + 0.5 * std::f64::consts::PI * f64::from(step) / f64::from(quarter)).sin_cos();
            [radius_m * cosine.max(0.0), middle_m + radius_m * sine, outward * cosine, outward * sine]
        })
    };
    let mut profile: Vec<ProfilePoint> = arc(-0.5 * std::f64::consts::PI, -half_m).collect();
    profile.extend(arc(0.0, half_m).skip(usize::from(half_m == 0.0)));
    profile
}

/// Whether a hollow solid's face at an end of an axis is missing: its cavity reaches beyond it.
fn is_open(solid: &Solid, axis: usize, highest: bool) -> bool {
    match highest {
        true => solid.cavity_max_m[axis] > solid.half_m[axis],
        false => solid.cavity_min_m[axis] < -solid.half_m[axis],
    }
}

fn cavity_m(solid: &Solid) -> [DVec3; 2] {
    [vector(solid.cavity_min_m), vector(solid.cavity_max_m)]
}

fn vector(of: [f32; 3]) -> DVec3 {
    DVec3::from_array(of.map(f64::from))
}
