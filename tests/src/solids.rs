//! Scenes with solids that no particle may pass, and how one that did is told.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::solids;
use brooklet_reference::boundary::solids::motion::pose_at;
use glam::DVec3;

/// A scene, and whether a particle is where it cannot be.
pub struct Leak {
    /// Its name.
    pub name: &'static str,
    /// TOML.
    pub scene: &'static str,
    /// Whether a particle at a time (s) and a position relative to the domain's lowest corner has passed a solid.
    pub is_through: fn(&Scene, f64, [f32; 3]) -> bool,
}

/// The position in the frame of the scene's first solid.
fn in_frame_m(scene: &Scene, time_s: f64, position_m: [f32; 3]) -> DVec3 {
    let (solids, keyframes) = solids(scene);
    let own = &keyframes[..solids[0].keyframe_count as usize];
    pose_at(own, solids[0].period_s.into(), time_s).in_frame(DVec3::from_array(position_m.map(f64::from)))
}

/// A cup that is carried, tilted by 30 degrees in all directions, and set down. Its wall is a spacing thick.
pub const CUP: Leak = Leak {
    name: "cup",
    scene: include_str!("solids/cup.toml"),
    is_through: |scene, time_s, position_m| {
        let place_m = in_frame_m(scene, time_s, position_m);
        place_m.y < 0.2 && (place_m.x.hypot(place_m.z) > 0.19 || place_m.y < -0.19)
    },
};

/// A closed box that turns around a skew axis.
pub const BOX: Leak = Leak {
    name: "box",
    scene: include_str!("solids/box.toml"),
    is_through: |scene, time_s, position_m| in_frame_m(scene, time_s, position_m).abs().max_element() > 0.24,
};

/// A jet at 100 m/s, 21 spacings a step, against a wall of one spacing.
pub const JET: Leak =
    Leak { name: "jet", scene: include_str!("solids/jet.toml"), is_through: |_, _, position_m| position_m[0] > 1.61 };

/// All of them.
pub const LEAKS: &[Leak] = &[CUP, BOX, JET];
