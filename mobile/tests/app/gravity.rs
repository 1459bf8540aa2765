//! Water that goes where the phone is tilted.

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_mobile::Acceleration;
use brooklet_mobile::script::{Hand, Readings};

use crate::{LONG, running, said};

/// Where the water's middle is along x, m, after so many steps of a sensor that is upright first, then as a file says.
fn middle_x_m(text: &str) -> f64 {
    let (mut hand, folder) = running();
    let path = folder.path().join("sensor.csv");
    std::fs::write(&path, text).unwrap();
    let readings = Readings::load(&path).unwrap();
    let dt_s = Scene::load("phone-1k", &[]).unwrap().solver.dt_s;
    let steps = |hand: &Hand| crate::current(hand).map_or(0, |run| run.session.steps());
    while steps(&hand) < 80 {
        if let Some(reading) = readings.at(steps(&hand) as f64 * dt_s, 0) {
            hand.app.acceleration(reading);
        }
        assert!(hand.steps(1, LONG), "{:?}", said(&hand));
    }
    let state = hand.app.viewer_mut().unwrap().take_state().unwrap();
    let positions = state.particles.positions;
    positions.iter().map(|position| f64::from(position.position_m[0])).sum::<f64>() / positions.len() as f64
}

#[test]
fn a_tilt_from_a_file_turns_the_water() {
    let right = middle_x_m("0,0,9.81,0\n0.1,-9.81,1,0\n");
    let left = middle_x_m("0,0,9.81,0\n0.1,9.81,1,0\n");
    // Half of a tank of 0.8 m is filled: at its right end the middle is near 0.6 m, at its left end near 0.2 m.
    assert!(right > 0.5 && left < 0.3, "{right} m and {left} m");
}

#[test]
fn what_is_in_free_space_falls_nowhere_and_has_no_level() {
    let (mut hand, folder) = running();
    let down = Acceleration { m_s2: [0.0, 9.81, 0.0], rotation_degrees: 0 };
    // The mean velocity, m/s, after so many steps of a scene.
    let mut fall = |name: &str| {
        hand.app.viewer_mut().unwrap().open(name);
        let begins = |hand: &mut Hand| crate::current(hand).is_some_and(|run| name.contains(&run.scene.name));
        assert!(hand.until(LONG, begins), "{:?}", said(&hand));
        hand.app.acceleration(down);
        assert!(hand.steps(20, LONG));
        hand.tap("level").unwrap();
        let is_level = said(&hand).iter().any(|text| text.contains("is level now"));
        let velocities = hand.app.viewer_mut().unwrap().take_state().unwrap().particles.velocities;
        let sum: f64 = velocities.iter().map(|velocity| f64::from(velocity.velocity_m_s[1])).sum();
        (sum / velocities.len() as f64, is_level)
    };
    let (drops, drops_level) = fall("colliding-drops");
    assert!(drops.abs() < 1e-3 && !drops_level, "{drops} m/s, level: {drops_level}");
    // The same drops in a scene that has gravity fall, and their button is there.
    let scene = Scene::load("colliding-drops", &["gravity_m_s2=[0.0, -1.0, 0.0]".into()]).unwrap();
    let path = folder.path().join("falling.toml");
    std::fs::write(&path, scene.to_toml()).unwrap();
    let (falling, falling_level) = fall(path.to_str().unwrap());
    assert!(falling < -0.1 && falling_level, "{falling} m/s, level: {falling_level}");
}

/// Particles after some steps, with gravity set as `how` does.
fn particles(gpu: &brooklet_gpu::Gpu, scene: &Scene, set_m_s2: Option<[f64; 3]>) -> Vec<[f32; 3]> {
    let mut session = Session::new(gpu, scene).unwrap();
    if let Some(gravity_m_s2) = set_m_s2 {
        session.set_gravity(gravity_m_s2);
    }
    session.submit(&FrameRequest { steps: 20, ..FrameRequest::default() }).unwrap();
    let particles = session.read_particles().unwrap();
    particles.positions.iter().map(|position| position.position_m).collect()
}

#[test]
fn gravity_that_is_set_is_gravity_that_was_planned() {
    let gpu = brooklet_gpu::Gpu::open(&crate::options()).unwrap();
    // So short a step that the parameter of the constraint depends on gravity as well; particles in the order of their ids.
    let settings = ["solver.dt_s=0.0005", "solver.deterministic=true", "spacing_m=0.08", "surface.method=none"];
    let mut scene = Scene::load("phone-1k", &settings.map(Into::into)).unwrap();
    // As much compression is taken out of the start in both.
    scene.gravity_m_s2 = [0.0, -2.0, 0.0];
    let wanted = [3.0, -5.0, 1.0];
    let mut planned = scene.clone();
    planned.gravity_m_s2 = wanted;
    let start = particles(&gpu, &scene, None);
    let set = particles(&gpu, &scene, Some(wanted));
    let of_plan = particles(&gpu, &planned, None);
    let furthest = |a: &[[f32; 3]], b: &[[f32; 3]]| {
        let parts = a.iter().flatten().zip(b.iter().flatten());
        parts.map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max)
    };
    assert_eq!(set.len(), of_plan.len());
    let (same, other) = (furthest(&set, &of_plan), furthest(&set, &start));
    assert!(same < 1e-5 && other > 1e-4, "{same} m from the planned one, {other} m from the one before");
    // Nonsense changes nothing.
    assert!(furthest(&particles(&gpu, &scene, Some([f64::NAN, 0.0, 0.0])), &start) < 1e-5);
}
