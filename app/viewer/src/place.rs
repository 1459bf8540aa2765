//! Placing an emitter where a hand points.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::EmitterSettings;
use brooklet_render::View;
use glam::{DVec2, DVec3};

use crate::orbit::{Ray, ray};
use crate::viewer_scene::ViewerScene;

/// Where an emitter is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// On the wall or the solid under the pointer: a hose, which flows away from it.
    Wall,
    /// In the air, in the middle of the domain's depth: a faucet, which flows down.
    Air,
}

/// Radius of a nozzle, in diagonals of the domain: at least one spacing.
const RADIUS_RATIO: f64 = 0.02;
/// What flows has fallen so far, in heights of the domain.
const FALL_RATIO: f64 = 0.1;
/// Room for what it emits in so long, s.
const ROOM_S: f64 = 20.0;
/// And no more than so many particles at once: what has no slot is counted as lost.
const MOST_ROOM: f64 = 200_000.0;

/// The scene with an emitter more, at a place of the picture, from now on; it has `particles` now, if that was measured.
///
/// # Errors
/// Says why there can be none.
pub fn placed(current: &ViewerScene, place: Place, at: DVec2, particles: Option<u32>) -> Result<Scene, String> {
    let view = current.view();
    let ray = ray(view, at);
    let origin_m = ray.origin_m - view.domain_min_m;
    let solid = match place {
        Place::Wall => current.pick(at).filter(|hit| hit.body.is_none()).map(|hit| (hit.at_m, hit.normal)),
        Place::Air => None,
    };
    let simulated = current.session.scene();
    let spacing_m = simulated.fitted_spacing_m();
    let radius_m = (RADIUS_RATIO * view.diagonal_m()).max(spacing_m);
    let (at_m, direction) = match (place, solid) {
        (Place::Air, _) => (in_the_air_m(view, &ray), -up(simulated)),
        (Place::Wall, Some(on_solid)) => on_solid,
        (Place::Wall, None) => {
            let size_m = view.domain_max_m - view.domain_min_m;
            wall(origin_m, ray.direction, size_m).ok_or("there is no wall: point at the water's box")?
        }
    };
    let emitter = nozzle(simulated, view, at_m + view.domain_min_m, direction, radius_m);
    let emitter = EmitterSettings { start_s: current.session.simulated_s(), ..emitter };
    let now = particles.map_or(simulated.particle_count() as f64, f64::from);
    let emitters: Vec<EmitterSettings> = current.scene.emitters.iter().cloned().chain([emitter]).collect();
    with_room(current, emitters, now)
}

/// The scene with these emitters and room for what they emit. The slots that there are stay.
///
/// # Errors
/// If one of the emitters is not allowed.
fn with_room(current: &ViewerScene, emitters: Vec<EmitterSettings>, now: f64) -> Result<Scene, String> {
    let (scene, simulated) = (&current.scene, current.session.scene());
    let now_s = current.session.simulated_s();
    let emitted = |emitter: &EmitterSettings| {
        emitter.most_particles(simulated, now_s + ROOM_S) - emitter.most_particles(simulated, now_s)
    };
    let coming: f64 = emitters.iter().map(emitted).sum::<f64>().min(MOST_ROOM);
    // Of what is simulated; the scene's own may be finer.
    let finer = scene.particle_count() as f64 / (simulated.particle_count() as f64).max(1.0);
    let has = scene.slot_capacity().map_or(scene.particle_count() as f64, f64::from);
    let room = ((now + coming) * finer).max(has).min(f64::from(u32::MAX)).ceil() as u32;
    scene.with_emitters(emitters, Some(room)).map_err(|error| error.to_string())
}

fn nozzle(scene: &Scene, view: &View, at_m: DVec3, direction: DVec3, radius_m: f64) -> EmitterSettings {
    let g_m_s2 = scene.gravity_length_m_s2();
    let height_m = (view.domain_max_m - view.domain_min_m).y;
    let fallen_m_s = (2.0 * g_m_s2.max(1.0) * FALL_RATIO * height_m).sqrt();
    let mut direction = direction;
    if scene.domain.is_flat() {
        direction.z = 0.0;
    }
    // Its disc lies across its direction, a spacing from what it is on.
    let towards = direction.normalize_or(-up(scene));
    let across = (DVec3::ONE - towards * towards).max(DVec3::ZERO).map(f64::sqrt);
    let margin_m = radius_m * across + scene.fitted_spacing_m();
    let (low_m, high_m) = (view.domain_min_m + margin_m, view.domain_max_m - margin_m);
    let centre_m = (at_m + scene.fitted_spacing_m() * towards).max(low_m).min(high_m.max(low_m));
    EmitterSettings {
        radius_m: Some(radius_m),
        centre_m: centre_m.to_array(),
        direction: towards.to_array().map(tidied),
        speed_m_s: fallen_m_s.min(0.4 * scene.max_speed_m_s()),
        ..EmitterSettings::default()
    }
}

/// What is against gravity; up where there is none.
fn up(scene: &Scene) -> DVec3 {
    (-DVec3::from_array(scene.gravity_m_s2)).normalize_or(DVec3::Y)
}

/// What a number says in a field.
fn tidied(x: f64) -> f64 {
    (x * 1000.0).round() / 1000.0
}

/// Where a ray is in the plane through the middle of the domain that faces the camera, relative to the domain's lowest corner.
fn in_the_air_m(view: &View, ray: &Ray) -> DVec3 {
    let forward = -view.camera.axes().z_axis;
    let middle_m = 0.5 * (view.domain_min_m + view.domain_max_m);
    let along_m = (middle_m - ray.origin_m).dot(forward) / ray.direction.dot(forward);
    ray.origin_m + along_m * ray.direction - view.domain_min_m
}

/// Where a ray leaves a box from 0 to `size_m`, and out of which wall: its direction into the box. None if it passes it by.
fn wall(origin_m: DVec3, direction: DVec3, size_m: DVec3) -> Option<(DVec3, DVec3)> {
    let (to_low, to_high) = (-origin_m / direction, (size_m - origin_m) / direction);
    let (enter, leave) = (to_low.min(to_high), to_low.max(to_high));
    let leaves_m = leave.min_element();
    if enter.max_element() > leaves_m || leaves_m < 0.0 {
        return None;
    }
    let axis = (0..3).find(|&axis| leave[axis] == leaves_m)?;
    let into = -direction[axis].signum() * DVec3::AXES[axis];
    Some((origin_m + leaves_m * direction, into))
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_render::Camera;

    fn scene() -> (Scene, View) {
        let scene = Scene::load("dam-break", &["spacing_m=0.05".into()]).unwrap();
        let view = View {
            camera: Camera { eye_m: DVec3::new(1.0, 0.5, 6.0), target_m: DVec3::new(1.0, 0.5, 0.5), fov_deg: 40.0 },
            domain_min_m: DVec3::from_array(scene.domain.min_m),
            domain_max_m: DVec3::from_array(scene.domain.max_m),
            size_px: [640, 360],
        };
        (scene, view)
    }

    #[test]
    fn a_ray_leaves_through_the_wall_behind() {
        let size_m = DVec3::new(2.0, 1.0, 1.0);
        let (at_m, into) = wall(DVec3::new(1.0, 0.5, 5.0), DVec3::NEG_Z, size_m).unwrap();
        assert_eq!((at_m, into), (DVec3::new(1.0, 0.5, 0.0), DVec3::Z));
        let down = DVec3::new(0.0, -1.0, -0.1).normalize();
        let (at_m, into) = wall(DVec3::new(1.0, 3.0, 0.8), down, size_m).unwrap();
        assert!(at_m.y.abs() < 1e-12 && into == DVec3::Y, "the floor: {at_m}");
        assert_eq!(wall(DVec3::new(1.0, 5.0, 5.0), DVec3::NEG_Z, size_m), None);
        assert_eq!(wall(DVec3::new(1.0, 0.5, 5.0), DVec3::Z, size_m), None, "behind the eye");
    }

    #[test]
    fn whatever_is_pointed_at_the_emitter_is_allowed() {
        let (scene, view) = scene();
        let size_m = view.domain_max_m - view.domain_min_m;
        for at in [[0.5, 0.5], [0.2, 0.3], [0.5, 0.02], [0.99, 0.97], [0.0, 1.0]] {
            let ray = ray(&view, DVec2::from_array(at));
            let in_air = (in_the_air_m(&view, &ray), DVec3::NEG_Y);
            let on_wall = wall(ray.origin_m - view.domain_min_m, ray.direction, size_m);
            for (at_m, direction) in [Some(in_air), on_wall].into_iter().flatten() {
                for dimensions in [2, 3] {
                    let scene = scene.with_setting(&format!("domain.dimensions={dimensions}")).unwrap();
                    let emitter = nozzle(&scene, &view, at_m + view.domain_min_m, direction, 0.08);
                    let with = scene.with_emitters(vec![emitter.clone()], Some(50_000));
                    assert!(with.is_ok(), "{at:?}: {emitter:?}: {}", with.err().unwrap());
                }
            }
        }
        let aside = EmitterSettings { centre_m: [9.0; 3], radius_m: Some(0.1), speed_m_s: 1.0, ..Default::default() };
        assert!(scene.with_emitters(vec![aside], None).unwrap_err().to_string().contains("emitter.0"));
    }
}
