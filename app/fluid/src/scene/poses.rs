//! Where solids are before a step moves them.

use brooklet_kernels::{BodyState, Solid, SolidPose};
use glam::{Quat, Vec3};

use super::Scene;
use super::bodies::bodies;
use super::solid_shapes::solids;

/// Where the solids of a scene are before a step moves them: bodies as `states` has them, others as they begin.
pub fn poses_before(scene: &Scene, states: &[BodyState]) -> Vec<SolidPose> {
    let (solids, keyframes) = solids(scene);
    let bodies = bodies(scene);
    let pose = |solid: &Solid| {
        let mut first = keyframes.get(solid.first_keyframe as usize).copied().unwrap_or_default();
        let body = solid.body as usize;
        if let (Some(body), Some(state)) = (bodies.get(body), states.get(body)) {
            let rotation = Quat::from_array(state.rotation);
            let to_middle_m = rotation * Vec3::from_array(body.centre_of_mass_m);
            first.position_m = (Vec3::from_array(state.position_m) - to_middle_m).to_array();
            first.rotation = state.rotation;
        }
        SolidPose {
            position_m: first.position_m,
            rotation: first.rotation,
            before_m: first.position_m,
            rotation_before: first.rotation,
            // Near everybody, until a step or a round of relaxation tells the box around it.
            min_m: [-1.0e30; 3],
            max_m: [1.0e30; 3],
            ..SolidPose::default()
        }
    };
    solids.iter().map(pose).collect()
}
