//! Where solids are, the boxes around them, and the blocks of the domain that those touch. (Shaders:
//! `boundary/solids/move_solids.compute`, `mark_solids.compute`.)

use super::shapes::Solid;
use brooklet_kernels::Keyframe;
use glam::{DMat3, DQuat, DVec3, UVec3};

/// Where a solid's frame is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Its origin, m.
    pub position_m: DVec3,
    /// Its axes.
    pub rotation: DQuat,
}

impl Pose {
    /// A place in the frame, of one in the domain's.
    pub fn in_frame(&self, position_m: DVec3) -> DVec3 {
        self.rotation.conjugate() * (position_m - self.position_m)
    }

    /// The other way.
    pub fn from_frame(&self, place_m: DVec3) -> DVec3 {
        self.position_m + self.rotation * place_m
    }

    /// Of a keyframe.
    pub fn of(keyframe: &Keyframe) -> Self {
        Self {
            position_m: DVec3::from_array(keyframe.position_m.map(f64::from)),
            rotation: DQuat::from_array(keyframe.rotation.map(f64::from)).normalize(),
        }
    }
}

/// Where a solid of these keyframes is at a time, begun anew after each `period_s` if that is more than 0.
pub fn pose_at(keyframes: &[Keyframe], period_s: f64, time_s: f64) -> Pose {
    let time_s = if period_s > 0.0 { time_s.rem_euclid(period_s) } else { time_s };
    let behind = keyframes.partition_point(|keyframe| f64::from(keyframe.time_s) <= time_s);
    let [from, to] = match behind {
        0 => [&keyframes[0]; 2],
        n if n == keyframes.len() => [&keyframes[n - 1]; 2],
        n => [&keyframes[n - 1], &keyframes[n]],
    };
    let length_s = f64::from(to.time_s) - f64::from(from.time_s);
    let share = if length_s > 0.0 { (time_s - f64::from(from.time_s)) / length_s } else { 0.0 };
    let [from, to] = [from, to].map(Pose::of);
    Pose {
        position_m: from.position_m.lerp(to.position_m, share),
        rotation: from.rotation.slerp(to.rotation, share).normalize(),
    }
}

/// The box around a solid at two poses, with a margin: its lowest and highest corner, m.
pub fn box_around(solid: &Solid, poses: [Pose; 2], reach_m: f64) -> [DVec3; 2] {
    let corners = poses.map(|pose| {
        let turned = DMat3::from_quat(pose.rotation);
        let axes = [turned.x_axis, turned.y_axis, turned.z_axis].map(DVec3::abs);
        let extent_m = axes[0] * solid.extent_m.x + axes[1] * solid.extent_m.y + axes[2] * solid.extent_m.z;
        [pose.position_m - extent_m, pose.position_m + extent_m]
    });
    [corners[0][0].min(corners[1][0]) - reach_m, corners[0][1].max(corners[1][1]) + reach_m]
}

/// Whether a block of the domain, cut into `blocks` of `block_m`, touches a box. Blocks at the domain's faces go on without
/// end; a block is a thousandth larger than it is.
pub fn block_touches(block: UVec3, blocks: UVec3, block_m: DVec3, [min_m, max_m]: [DVec3; 2]) -> bool {
    (0..3).all(|axis| {
        let from_m = (f64::from(block[axis]) - 1e-3) * block_m[axis];
        let to_m = (f64::from(block[axis]) + 1.001) * block_m[axis];
        let is_first = block[axis] == 0;
        let is_last = block[axis] + 1 == blocks[axis];
        (is_last || min_m[axis] <= to_m) && (is_first || max_m[axis] >= from_m)
    })
}
