//! What the shaders are told of solids, and how far from one a place is before anything moves.

use std::sync::Arc;

use brooklet_kernels::{Keyframe, MAX_SOLIDS, SHAPE_BOX, SHAPE_CAPSULE, SHAPE_CYLINDER, SHAPE_FIELD, Solid};
use brooklet_shapes::Field;
use glam::{DQuat, DVec2, DVec3};

use super::forms::fields;
use super::reactions::reaction_places;
use super::{Scene, Shape, SolidSettings};

/// Solids that a scene may have.
pub(super) const MOST_SOLIDS: usize = MAX_SOLIDS as usize;
/// Until when a steady motion is told, s: in f32 the way at any earlier time is then as exact as the time is.
const WITHOUT_END_S: f64 = 1.0e6;
/// Parts of a whole turn, each less than half of one, which a quaternion cannot tell from the shorter way round.
const PARTS_OF_A_TURN: u32 = 8;
/// What the shaders turn a solid by between two keyframes, at most.
const MOST_TURN_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// A solid at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    pub time_s: f64,
    /// In the scene's coordinates, m.
    pub centre_m: DVec3,
    pub rotation: DQuat,
}

impl Pose {
    /// Where nothing was moved.
    pub(super) fn standing() -> Self {
        Self { time_s: 0.0, centre_m: DVec3::ZERO, rotation: DQuat::IDENTITY }
    }
}

fn turned(turned_deg: [f64; 3]) -> DQuat {
    DQuat::from_scaled_axis(DVec3::from_array(turned_deg.map(f64::to_radians)))
}

/// Where a solid is at times, and after which time that begins again, s; 0: never.
pub(super) fn motion(solid: &SolidSettings) -> (Vec<Pose>, f64) {
    let keyframes: Vec<Pose> = solid
        .keyframes
        .iter()
        .map(|keyframe| Pose {
            time_s: keyframe.time_s,
            centre_m: keyframe.centre_m.into(),
            rotation: turned(keyframe.turned_deg),
        })
        .collect();
    if let Some(last) = keyframes.last() {
        let period_s = if solid.repeat { last.time_s } else { 0.0 };
        return (in_small_turns(&keyframes), period_s);
    }
    let start = Pose { time_s: 0.0, centre_m: solid.centre_m.into(), rotation: turned(solid.turned_deg) };
    let spin = DVec3::from_array(solid.spin_deg_s.map(f64::to_radians));
    if solid.density_kg_m3.is_some() {
        return (vec![start], 0.0);
    }
    let velocity_m_s = DVec3::from_array(solid.velocity_m_s);
    if spin != DVec3::ZERO {
        let period_s = std::f64::consts::TAU / spin.length();
        let part = |k: u32| {
            let time_s = period_s * f64::from(k) / f64::from(PARTS_OF_A_TURN);
            Pose { time_s, rotation: DQuat::from_scaled_axis(spin * time_s) * start.rotation, ..start }
        };
        return ((0..=PARTS_OF_A_TURN).map(part).collect(), period_s);
    }
    let end = Pose { time_s: WITHOUT_END_S, centre_m: start.centre_m + velocity_m_s * WITHOUT_END_S, ..start };
    (if velocity_m_s == DVec3::ZERO { vec![start] } else { vec![start, end] }, 0.0)
}

/// The same motion with more keyframes, where two are further turned than the shaders go between two; each after the first
/// with the sign that is nearer to the one before.
fn in_small_turns(keyframes: &[Pose]) -> Vec<Pose> {
    let mut turns: Vec<Pose> = keyframes.first().copied().into_iter().collect();
    for pair in keyframes.windows(2) {
        let parts = (pair[0].rotation.angle_between(pair[1].rotation) / MOST_TURN_RAD).ceil().max(1.0) as u32;
        for part in 1..=parts {
            let share = f64::from(part) / f64::from(parts);
            let rotation = pair[0].rotation.slerp(pair[1].rotation, share).normalize();
            let before = turns.last().map_or(rotation, |before| before.rotation);
            turns.push(Pose {
                time_s: pair[0].time_s + share * (pair[1].time_s - pair[0].time_s),
                centre_m: pair[0].centre_m.lerp(pair[1].centre_m, share),
                rotation: if before.dot(rotation) < 0.0 { -rotation } else { rotation },
            });
        }
    }
    turns
}

/// Half the sides of what holds a shape, in the form of the shaders' `Solid::half_m`, and of the box around it.
pub(super) fn halves(solid: &SolidSettings) -> (u32, DVec3, DVec3) {
    match solid.shape() {
        Shape::Box(half_m) => (SHAPE_BOX, half_m.into(), half_m.into()),
        Shape::Capsule(radius_m, half_m) => {
            (SHAPE_CAPSULE, DVec3::new(radius_m, half_m, radius_m), DVec3::new(radius_m, half_m + radius_m, radius_m))
        }
        Shape::Cylinder(radius_m, half_m) => {
            let half_m = DVec3::new(radius_m, half_m, radius_m);
            (SHAPE_CYLINDER, half_m, half_m)
        }
        Shape::Triangles => {
            let thickness_m = solid.thickness_m.unwrap_or_default();
            let extent_m = solid.triangles().map_or(DVec3::ZERO, |triangles| triangles.extent_m(thickness_m));
            (SHAPE_FIELD, DVec3::ZERO, extent_m)
        }
    }
}

/// The cavity of a hollow solid: its lowest and highest corner, beyond the shape where it is open.
pub(super) fn cavity_m(solid: &SolidSettings) -> Option<[DVec3; 2]> {
    let thickness_m = solid.thickness_m?;
    let (shape, half_m, extent_m) = halves(solid);
    if shape == SHAPE_FIELD {
        return None;
    }
    let mut inner_m = half_m - thickness_m;
    if shape == SHAPE_CAPSULE {
        inner_m.y = half_m.y;
    }
    let mut ends_m = [-inner_m, inner_m];
    for (highest, end_m) in [false, true].into_iter().zip(&mut ends_m) {
        for axis in 0..3 {
            if solid.open.is_some_and(|open| open.has(axis, highest)) {
                // So far that no place near the solid is nearer to the lid that is not there than to its walls.
                end_m[axis] = (half_m[axis] + 4.0 * extent_m.max_element()) * if highest { 1.0 } else { -1.0 };
            }
        }
    }
    Some(ends_m)
}

/// What the shaders are told of a scene's solids, and their keyframes: relative to the domain's lowest corner.
pub fn solids(scene: &Scene) -> (Vec<Solid>, Vec<Keyframe>) {
    let origin_m = DVec3::from_array(scene.domain.min_m);
    let mut keyframes = Vec::new();
    let fields = fields(scene);
    let of = |(solid, body): (&SolidSettings, u32)| {
        let (shape, half_m, extent_m) = halves(solid);
        let cavity_m = cavity_m(solid);
        let [cavity_min_m, cavity_max_m] = cavity_m.unwrap_or_default().map(|end_m| end_m.as_vec3().to_array());
        let (poses, period_s) = motion(solid);
        let first_keyframe = keyframes.len() as u32;
        keyframes.extend(poses.iter().map(|pose| Keyframe {
            position_m: (pose.centre_m - origin_m).as_vec3().to_array(),
            time_s: pose.time_s as f32,
            rotation: pose.rotation.as_quat().to_array(),
        }));
        Solid {
            half_m: half_m.as_vec3().to_array(),
            shape,
            cavity_min_m,
            is_hollow: cavity_m.is_some().into(),
            cavity_max_m,
            friction: solid.friction as f32,
            extent_m: extent_m.as_vec3().to_array(),
            restitution: solid.restitution as f32,
            first_keyframe,
            keyframe_count: poses.len() as u32,
            period_s: period_s as f32,
            body,
            ..field_of(solid.field(scene), &fields)
        }
    };
    let solids = scene.solids.iter().zip(reaction_places(scene)).map(of).collect();
    (solids, keyframes)
}

/// What the shaders are told of a solid's field, which is one of these; nothing of a solid that has none.
fn field_of(field: Option<Arc<Field>>, fields: &[(Arc<Field>, u32)]) -> Solid {
    let found = field.and_then(|field| fields.iter().find(|(other, _)| Arc::ptr_eq(other, &field)));
    found.map_or_else(Solid::default, |(field, first)| Solid {
        field_min_m: field.min_m.as_vec3().to_array(),
        field_cell_m: field.cell_m as f32,
        field_nodes: field.nodes,
        first_field_node: *first,
        ..Solid::default()
    })
}

/// How far a place of a shape's frame is from its surface, m; negative inside.
pub(super) fn from_shape_m(shape: u32, place_m: DVec3, half_m: DVec3) -> f64 {
    match shape {
        SHAPE_BOX => {
            let beyond_m = place_m.abs() - half_m;
            beyond_m.max(DVec3::ZERO).length() + beyond_m.max_element().min(0.0)
        }
        SHAPE_CAPSULE => {
            let on_axis_m = DVec3::Y * place_m.y.clamp(-half_m.y, half_m.y);
            (place_m - on_axis_m).length() - half_m.x
        }
        _ => {
            let beyond_m = DVec2::new(place_m.x.hypot(place_m.z) - half_m.x, place_m.y.abs() - half_m.y);
            beyond_m.max(DVec2::ZERO).length() + beyond_m.max_element().min(0.0)
        }
    }
}

/// A solid's surface, in its own frame.
pub struct SolidSurface {
    shape: u32,
    half_m: DVec3,
    extent_m: DVec3,
    cavity_m: Option<[DVec3; 2]>,
    field: Option<Arc<Field>>,
}

impl SolidSurface {
    /// That of one of a scene's solids.
    pub fn of(solid: &SolidSettings, scene: &Scene) -> Self {
        let (shape, half_m, extent_m) = halves(solid);
        Self { shape, half_m, extent_m, cavity_m: cavity_m(solid), field: solid.field(scene) }
    }

    /// How far a place of its frame is from it, m; negative inside the solid. What a hollow one holds is outside.
    pub fn distance_m(&self, in_frame_m: DVec3) -> f64 {
        if let Some(field) = &self.field {
            return field.distance_m(in_frame_m);
        }
        let outside_m = from_shape_m(self.shape, in_frame_m, self.half_m);
        self.cavity_m.map_or(outside_m, |[min_m, max_m]| {
            let in_cavity_m = in_frame_m - 0.5 * (min_m + max_m);
            outside_m.max(-from_shape_m(self.shape, in_cavity_m, 0.5 * (max_m - min_m)))
        })
    }

    /// Half the sides of a box around the frame's origin that holds it, m.
    pub fn extent_m(&self) -> DVec3 {
        self.extent_m
    }
}

/// A solid where it begins.
pub(super) struct StandingSolid {
    pose: Pose,
    surface: SolidSurface,
}

impl StandingSolid {
    /// The solid before anything moves.
    pub(super) fn of(solid: &SolidSettings, scene: &Scene) -> Self {
        let pose = motion(solid).0.first().copied().unwrap_or_else(Pose::standing);
        Self { pose, surface: SolidSurface::of(solid, scene) }
    }

    /// How far a place is from its surface, m; negative inside it. What a hollow one holds is outside.
    pub(super) fn distance_m(&self, place_m: [f64; 3]) -> f64 {
        let from_middle_m = DVec3::from_array(place_m) - self.pose.centre_m;
        self.surface.distance_m(self.pose.rotation.inverse() * from_middle_m)
    }

    /// Where a place of its frame is, m.
    pub(super) fn placed_m(&self, place_m: DVec3) -> DVec3 {
        self.pose.centre_m + self.pose.rotation * place_m
    }

    /// The box around it: its lowest and highest corner, m.
    pub(super) fn bounds_m(&self) -> [DVec3; 2] {
        let along = |axis: DVec3| (self.pose.rotation * (axis * self.surface.extent_m)).abs();
        let around_m = along(DVec3::X) + along(DVec3::Y) + along(DVec3::Z);
        [self.pose.centre_m - around_m, self.pose.centre_m + around_m]
    }
}

/// The fastest that a point of the solid moves between two of its keyframes, m/s, and the number of the second.
pub(super) fn fastest_m_s(solid: &SolidSettings) -> (f64, usize) {
    let reach_m = halves(solid).2.length();
    let (poses, _) = motion(solid);
    let number =
        |pose: &Pose| solid.keyframes.iter().position(|keyframe| keyframe.time_s >= pose.time_s).unwrap_or_default();
    let speed_m_s = |pair: &[Pose]| {
        let turned = pair[0].rotation.angle_between(pair[1].rotation);
        (pair[0].centre_m.distance(pair[1].centre_m) + turned * reach_m) / (pair[1].time_s - pair[0].time_s)
    };
    let speeds = poses.windows(2).map(|pair| (speed_m_s(pair), number(&pair[1])));
    speeds.fold((0.0, 0), |most, speed| if speed.0 > most.0 { speed } else { most })
}
