//! Fingers, buttons, the back key.

use brooklet_viewer::action::Action;
use glam::DVec3;

use crate::{LONG, current, running, said};

const MIDDLE: [f32; 2] = [180.0, 320.0];

#[test]
fn one_finger_pushes_two_come_nearer_and_turn() {
    let (mut hand, _folder) = running();
    assert!(hand.steps(1, LONG));
    let eye = |hand: &brooklet_mobile::script::Hand| {
        let camera = current(hand).unwrap().view().camera;
        (camera.eye_m - camera.target_m, camera)
    };
    // Only a hand moves anything sideways, out of the picture's plane.
    let fastest_z = |hand: &mut brooklet_mobile::script::Hand| {
        let state = hand.app.viewer_mut().unwrap().take_state().unwrap();
        state.particles.velocities.iter().map(|velocity| f64::from(velocity.velocity_m_s[0].abs())).fold(0.0, f64::max)
    };
    let (first, _) = eye(&hand);
    let before = fastest_z(&mut hand);
    hand.drag(&[([140.0, 330.0], [260.0, 330.0])]);
    assert!(hand.steps(2, LONG));
    let after = fastest_z(&mut hand);
    assert!(after > before + 0.3, "{before} m/s, then {after} m/s: {:?}", said(&hand));
    assert_eq!(eye(&hand).0, first, "one finger leaves the camera alone");

    let [x, y] = MIDDLE;
    hand.drag(&[([x - 30.0, y], [x - 90.0, y]), ([x + 30.0, y], [x + 90.0, y])]);
    let (nearer, _) = eye(&hand);
    assert!(nearer.length() < 0.7 * first.length(), "{} m, then {} m", first.length(), nearer.length());
    hand.drag(&[([x - 60.0, y], [x, y]), ([x + 60.0, y], [x + 120.0, y])]);
    let (turned, _) = eye(&hand);
    let flat = |v: DVec3| DVec3::new(v.x, 0.0, v.z).normalize();
    assert!(flat(turned).dot(flat(nearer)) < 0.99, "it did not turn: {nearer} and {turned}");
    assert!((turned.length() / nearer.length() - 1.0).abs() < 0.05, "nor come nearer");
}

#[test]
fn buttons_do_what_they_say_and_the_back_key_closes_what_is_open() {
    let (mut hand, folder) = running();
    assert!(!hand.app.back(), "nothing is open: to the background");
    assert!(hand.tap("no such button").is_err());
    for name in ["scenes", "pause", "reset", "level", "capture", "menu", "times"] {
        let rect = hand.marks[name];
        assert!(rect.width() >= 48.0 && rect.height() >= 48.0, "{name} is {} points", rect.size());
        assert!(rect.min.x >= 0.0 && rect.max.x <= 360.0 && rect.max.y <= 640.0, "{name} is off the screen: {rect}");
    }
    hand.tap("pause").unwrap();
    assert!(hand.app.viewer().unwrap().is_paused());
    hand.tap("pause").unwrap();
    assert!(!hand.app.viewer().unwrap().is_paused());

    hand.tap("times").unwrap();
    assert!(hand.marks.contains_key("overlay"));
    hand.tap("times").unwrap();
    assert!(!hand.marks.contains_key("overlay"));

    // Without a sensor nothing can be level.
    hand.tap("level").unwrap();
    assert!(!said(&hand).iter().any(|text| text.contains("level")), "{:?}", said(&hand));

    hand.tap("menu").unwrap();
    assert!(hand.marks.contains_key("plainer"));
    assert!(hand.app.back(), "the menu was open");
    hand.settle();
    assert!(!hand.marks.contains_key("plainer") && !hand.app.back());
    // Beside the sheet is a way out, too.
    hand.tap("menu").unwrap();
    hand.drag(&[([180.0, 40.0], [180.0, 40.0])]);
    assert!(!hand.marks.contains_key("plainer"));

    hand.tap("scenes").unwrap();
    hand.tap("scene phone-5k").unwrap();
    let begins =
        |hand: &mut brooklet_mobile::script::Hand| current(hand).is_some_and(|run| run.scene.name == "phone-5k");
    assert!(hand.until(LONG, begins), "{:?}", said(&hand));
    assert!(!hand.marks.contains_key("scene phone-5k"), "the sheet is closed");
    assert!(folder.path().join("files").is_dir());
}

#[test]
fn short_of_memory_it_gives_up_particles_and_says_so() {
    let (mut hand, _folder) = running();
    let count = |hand: &brooklet_mobile::script::Hand| current(hand).unwrap().session.slot_count();
    // From all of them: a software driver may have given up what can be before.
    hand.app.viewer_mut().unwrap().handle_action(Action::Rung(0));
    assert!(hand.until(LONG, |hand| count(hand) == 1000), "{} particles", count(&hand));
    hand.app.viewer_mut().unwrap().handle_action(Action::Auto(true));
    let before = count(&hand);
    hand.app.low_memory();
    assert!(hand.until(LONG, |hand| count(hand) < before), "{before} particles stay: {:?}", said(&hand));
    assert!(said(&hand).iter().any(|text| text.contains("short of memory")), "{:?}", said(&hand));
    assert!(hand.app.viewer().unwrap().is_auto(), "the ladder goes on, below that");
    for _ in 0..8 {
        hand.app.low_memory();
    }
    assert!(said(&hand).iter().any(|text| text.contains("nothing left")), "{:?}", said(&hand));
}
