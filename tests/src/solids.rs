//! Scenes with solids that no particle may pass, and how one that did is told.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::solids;
use brooklet_reference::boundary::solids::motion::pose_at;
use brooklet_shapes::Mesh;
use glam::DVec3;

/// A scene, and whether a particle is where it cannot be.
pub struct Leak {
    /// Its name.
    pub name: &'static str,
    /// Its file's path, which those of meshes are beside.
    pub source: &'static str,
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
    source: "cup",
    scene: include_str!("solids/cup.toml"),
    is_through: |scene, time_s, position_m| {
        let place_m = in_frame_m(scene, time_s, position_m);
        place_m.y < 0.2 && (place_m.x.hypot(place_m.z) > 0.19 || place_m.y < -0.19)
    },
};

/// A closed box that turns around a skew axis.
pub const BOX: Leak = Leak {
    name: "box",
    source: "box",
    scene: include_str!("solids/box.toml"),
    is_through: |scene, time_s, position_m| in_frame_m(scene, time_s, position_m).abs().max_element() > 0.24,
};

/// A jet at 100 m/s, 21 spacings a step, against a wall of one spacing.
pub const JET: Leak = Leak {
    name: "jet",
    source: "jet",
    scene: include_str!("solids/jet.toml"),
    is_through: |_, _, position_m| position_m[0] > 1.61,
};

/// A bowl of triangles, .02 m thick, that is rocked while a rod stirs what is in it.
pub const BOWL: Leak = Leak {
    name: "bowl",
    source: concat!(env!("CARGO_MANIFEST_DIR"), "/src/solids/bowl.toml"),
    scene: include_str!("solids/bowl.toml"),
    is_through: |scene, time_s, position_m| {
        let place_m = in_frame_m(scene, time_s, position_m);
        // The middle of its wall; nobody flies over its rim.
        let from_m = if place_m.y < 0.0 { place_m.length() } else { place_m.x.hypot(place_m.z) };
        from_m > 0.23
    },
};

/// A pool over hills.
pub const HILLS: Leak = Leak {
    name: "hills",
    source: "hills",
    scene: include_str!("solids/hills.toml"),
    is_through: |scene, time_s, position_m| {
        let ground = scene.solids[0].triangles().expect("ground");
        // Below the surface, by the ray that goes up.
        let place_m = in_frame_m(scene, time_s, position_m);
        is_below(&ground.solid, place_m)
    },
};

/// Whether one of a mesh's triangles is above a place.
fn is_below(mesh: &Mesh, place_m: DVec3) -> bool {
    (0..mesh.triangles.len()).map(|triangle| mesh.corners_m(triangle)).any(|corners_m| {
        let [a, b, c] = corners_m.map(|corner_m| corner_m - place_m);
        let side = |p: DVec3, q: DVec3| p.x * q.z - p.z * q.x;
        let sides = [side(a, b), side(b, c), side(c, a)];
        let is_over = sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0);
        let area: f64 = sides.iter().sum();
        is_over && area != 0.0 && (a.y * sides[1] + b.y * sides[2] + c.y * sides[0]) / area > 0.0
    })
}

/// All of them.
pub const LEAKS: &[Leak] = &[CUP, BOX, JET, BOWL, HILLS];
