//! Which solid is under the pointer: a ray of view against the solids as they were last seen.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::{SolidLook, SolidSurface, body_count, solids};
use brooklet_kernels::SolidPose;
use glam::{DQuat, DVec3};

/// What can be under the pointer.
pub struct PickSolid {
    surface: SolidSurface,
    /// Which body it is, if the fluid moves it.
    pub body: Option<u32>,
    is_glass: bool,
}

/// What is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The solid's number.
    pub solid: usize,
    /// Which body it is, if the fluid moves it.
    pub body: Option<u32>,
    /// Where, relative to the domain's lowest corner, m.
    pub at_m: DVec3,
    /// The same in the solid's frame.
    pub in_frame_m: DVec3,
    /// Out of the solid, of length 1.
    pub normal: DVec3,
    /// From where the ray begins, m.
    pub distance_m: f64,
}

/// A place this near to a surface, over the solid's own extent, is on it.
const NEAR_RATIO: f64 = 1e-4;
/// Steps of a ray: one that only grazes a solid takes many, and is then past it.
const MOST_STEPS: u32 = 200;

impl PickSolid {
    /// All solids of a scene.
    pub fn all(scene: &Scene) -> Vec<Self> {
        let (told, _) = solids(scene);
        let bodies = body_count(scene);
        let each = scene.solids.iter().zip(&told);
        each.map(|(settings, told)| Self {
            surface: SolidSurface::of(settings, scene),
            body: (told.body < bodies).then_some(told.body),
            is_glass: settings.look == SolidLook::Glass,
        })
        .collect()
    }

    /// Where a ray of its frame meets it first: how far along.
    fn meet_m(&self, origin_m: DVec3, direction: DVec3) -> Option<f64> {
        let extent_m = self.surface.extent_m();
        let near_m = NEAR_RATIO * extent_m.length();
        // Of the box around it, a little larger.
        let reach_m = extent_m + near_m;
        let (to_low, to_high) = ((-reach_m - origin_m) / direction, (reach_m - origin_m) / direction);
        let (mut at_m, end_m) = (to_low.min(to_high).max_element().max(0.0), to_low.max(to_high).min_element());
        for _ in 0..MOST_STEPS {
            if at_m > end_m {
                return None;
            }
            let distance_m = self.surface.distance_m(origin_m + at_m * direction);
            if distance_m < near_m {
                return Some(at_m);
            }
            at_m += distance_m;
        }
        None
    }

    fn normal(&self, in_frame_m: DVec3) -> DVec3 {
        let step_m = 10.0 * NEAR_RATIO * self.surface.extent_m().length();
        let slope = |axis: DVec3| {
            let [after_m, before_m] =
                [1.0, -1.0].map(|side| self.surface.distance_m(in_frame_m + side * step_m * axis));
            (after_m - before_m) * axis
        };
        DVec3::AXES.into_iter().map(slope).sum::<DVec3>().normalize_or(DVec3::Y)
    }
}

/// The first solid that a ray of the domain meets: `direction` of length 1. What is of glass is looked through, but for a body.
pub fn pick(solids: &[PickSolid], poses: &[SolidPose], origin_m: DVec3, direction: DVec3) -> Option<Hit> {
    let mut first: Option<Hit> = None;
    for (number, (solid, pose)) in solids.iter().zip(poses).enumerate() {
        if solid.is_glass && solid.body.is_none() {
            continue;
        }
        let middle_m = DVec3::from_array(pose.position_m.map(f64::from));
        let rotation = DQuat::from_array(pose.rotation.map(f64::from)).normalize();
        let [from_m, along] = [origin_m - middle_m, direction].map(|v| rotation.inverse() * v);
        let Some(distance_m) = solid.meet_m(from_m, along) else { continue };
        if first.is_none_or(|first| distance_m < first.distance_m) {
            let in_frame_m = from_m + distance_m * along;
            first = Some(Hit {
                solid: number,
                body: solid.body,
                at_m: origin_m + distance_m * direction,
                in_frame_m,
                normal: rotation * solid.normal(in_frame_m),
                distance_m,
            });
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_fluid::BodyMotion;
    use brooklet_fluid::scene::poses_before;

    const SCENE: &str = r#"
spacing_m = 0.02
[domain]
min_m = [1, 0, 0]
max_m = [2, 1, 1]
[[solid]]
box = { size_m = [0.2, 0.2, 0.2] }
turned_deg = [0, 45, 0]
centre_m = [1.3, 0.5, 0.5]
density_kg_m3 = 500
[[solid]]
box = { size_m = [0.02, 0.8, 0.8] }
centre_m = [1.1, 0.5, 0.5]
look = "glass"
[[solid]]
sphere = { radius_m = 0.1 }
centre_m = [1.7, 0.5, 0.5]
[[solid]]
box = { size_m = [0.2, 0.2, 0.2] }
thickness_m = 0.04
open = "y_max"
centre_m = [1.5, 0.2, 0.5]
density_kg_m3 = 700
"#;

    fn scene() -> (Vec<PickSolid>, Vec<SolidPose>) {
        let scene = Scene::from_toml(SCENE, "pick", &[]).unwrap();
        (PickSolid::all(&scene), poses_before(&scene, &BodyMotion::first(&scene).states))
    }

    #[test]
    fn the_nearest_is_hit_where_it_is_and_glass_is_looked_through() {
        let (solids, poses) = scene();
        let from = |at: [f64; 3], direction: DVec3| pick(&solids, &poses, DVec3::from_array(at), direction);
        let hit = from([-1.0, 0.5, 0.5], DVec3::X).unwrap();
        // An edge of the turned box, half its diagonal before its middle.
        assert_eq!((hit.solid, hit.body), (0, Some(0)));
        assert!((hit.at_m.x - (0.3 - 0.02f64.sqrt())).abs() < 1e-3 && (hit.distance_m - 1.0 - hit.at_m.x).abs() < 1e-9);
        let other_side = from([2.0, 0.5, 0.5], DVec3::NEG_X).unwrap();
        assert_eq!((other_side.solid, other_side.body), (2, None), "a ball before the box");
        assert!(other_side.normal.abs_diff_eq(DVec3::X, 1e-3) && (other_side.at_m.x - 0.8).abs() < 1e-3);
        assert_eq!(from([-1.0, 0.95, 0.5], DVec3::X), None);
        assert_eq!(from([-1.0, 0.5, 0.5], DVec3::NEG_X), None, "nothing is behind the eye");
    }

    #[test]
    fn the_bottom_of_a_hollow_one_is_hit_through_its_opening() {
        let (solids, poses) = scene();
        let hit = pick(&solids, &poses, DVec3::new(0.5, 1.0, 0.5), DVec3::NEG_Y).unwrap();
        assert_eq!((hit.solid, hit.body), (3, Some(1)));
        assert!((hit.at_m.y - 0.14).abs() < 1e-3 && hit.normal.abs_diff_eq(DVec3::Y, 1e-3), "{hit:?}");
        assert!(hit.in_frame_m.abs_diff_eq(DVec3::new(0.0, -0.06, 0.0), 1e-3));
    }
}
