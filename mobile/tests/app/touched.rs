//! Fingers, buttons, the back key.

use brooklet_fluid::Scene;
use brooklet_mobile::TouchPhase::{Cancel, End, Move, Start};
use brooklet_mobile::script::Hand;
use brooklet_viewer::action::Action;
use glam::DVec3;

use crate::{LONG, current, running, said};

const MIDDLE: [f32; 2] = [180.0, 320.0];

/// Where the eye is, from what it looks at.
fn eye(hand: &Hand) -> DVec3 {
    let camera = current(hand).unwrap().view().camera;
    camera.eye_m - camera.target_m
}

/// The mean of all velocities, m/s.
fn mean_m_s(hand: &mut Hand) -> DVec3 {
    let velocities = hand.app.viewer_mut().unwrap().take_state().unwrap().particles.velocities;
    let sum: DVec3 = velocities.iter().map(|velocity| DVec3::from(velocity.velocity_m_s.map(f64::from))).sum();
    sum / velocities.len() as f64
}

/// A finger that is down goes to the right from a place, while the water moves.
fn sweep(hand: &mut Hand, id: u64, [x, y]: [f32; 2]) {
    for step in 1..=4u8 {
        hand.touch(id, Move, [x + 30.0 * f32::from(step), y]);
        hand.settle();
        assert!(hand.steps(1, LONG));
    }
}

#[test]
fn one_finger_pushes_two_come_nearer_and_turn() {
    let (mut hand, _folder) = running();
    // Held: where the machine is loaded the ladder would load fewer particles under the finger.
    hand.app.viewer_mut().unwrap().handle_action(Action::Rung(12));
    hand.settle();
    assert!(hand.steps(1, LONG));
    let first = eye(&hand);
    // Only a hand moves anything sideways, out of the picture's plane.
    let fastest_x = |hand: &mut Hand| {
        let state = hand.app.viewer_mut().unwrap().take_state().unwrap();
        state.particles.velocities.iter().map(|velocity| f64::from(velocity.velocity_m_s[0].abs())).fold(0.0, f64::max)
    };
    let before = fastest_x(&mut hand);
    hand.drag(&[([140.0, 330.0], [260.0, 330.0])]);
    assert!(hand.steps(2, LONG));
    let after = fastest_x(&mut hand);
    assert!(after > before + 0.3, "{before} m/s, then {after} m/s: {:?}", said(&hand));
    assert_eq!(eye(&hand), first, "one finger leaves the camera alone");

    let [x, y] = MIDDLE;
    hand.drag(&[([x - 30.0, y], [x - 90.0, y]), ([x + 30.0, y], [x + 90.0, y])]);
    let nearer = eye(&hand);
    assert!(nearer.length() < 0.7 * first.length(), "{} m, then {} m", first.length(), nearer.length());
    hand.drag(&[([x - 60.0, y], [x, y]), ([x + 60.0, y], [x + 120.0, y])]);
    let turned = eye(&hand);
    let flat = |v: DVec3| DVec3::new(v.x, 0.0, v.z).normalize();
    assert!(flat(turned).dot(flat(nearer)) < 0.99, "it did not turn: {nearer} and {turned}");
    assert!((turned.length() / nearer.length() - 1.0).abs() < 0.05, "nor come nearer");
}

#[test]
fn a_finger_is_of_what_it_came_down_on_until_it_is_lifted() {
    let (mut hand, _folder) = running();
    // Drops in free space: only a hand changes their momentum. The rung is held: nothing is loaded while fingers are down.
    let viewer = hand.app.viewer_mut().unwrap();
    viewer.handle_action(Action::Rung(12));
    viewer.open("colliding-drops");
    let begins = |hand: &mut Hand| current(hand).is_some_and(|run| run.scene.name == "colliding-drops");
    assert!(hand.until(LONG, begins) && hand.steps(2, LONG), "{:?}", said(&hand));
    let (first, before) = (eye(&hand), mean_m_s(&mut hand));
    let pushed = |hand: &mut Hand| (mean_m_s(hand) - before).length();
    let is_left = |hand: &mut Hand, what: &str| {
        let by = pushed(hand);
        assert!(by < 0.005, "{what}: pushed by {by} m/s");
    };
    // One that began at the foot's bar.
    let on_bar: [f32; 2] = hand.marks["level"].center().into();
    hand.touch(1, Start, on_bar);
    sweep(&mut hand, 1, MIDDLE);
    is_left(&mut hand, "a finger of the bar's");
    // Beside one on the picture: they are no two that turn.
    hand.touch(2, Start, MIDDLE);
    sweep(&mut hand, 2, MIDDLE);
    sweep(&mut hand, 1, [MIDDLE[0], 500.0]);
    assert_eq!(eye(&hand), first, "one of the bar's and one of the picture's");
    is_left(&mut hand, "a second finger");
    hand.touch(1, End, MIDDLE);
    sweep(&mut hand, 2, MIDDLE);
    is_left(&mut hand, "one that the bar's left over");
    // With another on the picture they do.
    hand.touch(3, Start, [MIDDLE[0], 200.0]);
    hand.settle();
    sweep(&mut hand, 3, [MIDDLE[0], 200.0]);
    let nearer = eye(&hand);
    assert!((nearer - first).length() > 0.02 * first.length(), "two on the picture: {first}, then {nearer}");
    // What is left over pushes nothing.
    hand.touch(3, End, [MIDDLE[0], 200.0]);
    hand.settle();
    let turned = eye(&hand);
    sweep(&mut hand, 2, MIDDLE);
    assert_eq!(eye(&hand), turned);
    is_left(&mut hand, "one that a pinch left over");
    hand.touch(2, End, MIDDLE);
    // The drops are where they were.
    hand.tap("reset").unwrap();
    assert!(hand.until(LONG, |hand| !hand.app.viewer().unwrap().is_loading()) && hand.steps(1, LONG));
    is_left(&mut hand, "begun again");
    let [x, y] = [MIDDLE[0] - 60.0, MIDDLE[1]];
    hand.touch(2, Start, [x, y]);
    sweep(&mut hand, 2, [x, y]);
    let by = pushed(&mut hand);
    assert!(by > 0.02, "lifted and put down again: pushed by {by} m/s");
    hand.touch(2, End, MIDDLE);

    // What the system takes away clicks nothing, and neither does the next one in its place.
    let pause: [f32; 2] = hand.marks["pause"].center().into();
    hand.touch(1, Start, pause);
    hand.settle();
    hand.touch(1, Cancel, pause);
    hand.tap("menu").unwrap();
    assert!(hand.marks.contains_key("plainer") && !hand.app.viewer().unwrap().is_paused());
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
    let begins = |hand: &mut Hand| current(hand).is_some_and(|run| run.scene.name == "phone-5k");
    assert!(hand.until(LONG, begins), "{:?}", said(&hand));
    assert!(!hand.marks.contains_key("scene phone-5k"), "the sheet is closed");
    assert!(folder.path().join("files").is_dir());
}

#[test]
fn short_of_memory_it_gives_up_particles_and_says_so() {
    let (mut hand, _folder) = running();
    let count = |hand: &Hand| current(hand).unwrap().session.slot_count();
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

#[test]
fn a_scene_that_has_no_room_begins_with_fewer_particles_and_says_so() {
    let (mut hand, folder) = running();
    // Lists so wide that those of all particles are beyond what a binding has on this tier (128 MiB), those of half are not.
    let settings = ["spacing_m=0.0145", "solver.neighbour_slots=1024", "surface.method=\"points\""];
    let scene = Scene::load("dam-break", &settings.map(Into::into)).unwrap();
    // A place takes two bytes.
    let lists = |particles: u64| 2 * 1024 * particles;
    let (all, most) = (scene.particle_count(), 128 << 20);
    assert!(lists(all) > most && lists(all) < 2 * most, "{all} particles");
    let path = folder.path().join("wide.toml");
    std::fs::write(&path, scene.to_toml()).unwrap();
    let viewer = hand.app.viewer_mut().unwrap();
    // A budget and a pace that everything is within: what is given up is for want of room alone.
    viewer.handle_action(Action::Auto(true));
    viewer.handle_action(Action::Speed(1e-4));
    viewer.handle_action(Action::Budget(1e5));
    viewer.open(path.to_str().unwrap());
    let mut heard = Vec::new();
    let begins = |hand: &mut Hand| {
        heard.extend(said(hand));
        current(hand).is_some_and(|run| run.scene.name == "wide")
    };
    assert!(hand.until(LONG, begins), "{heard:?}");
    let count = u64::from(current(&hand).unwrap().session.slot_count());
    assert!(count < all && 3 * count > all && lists(count) <= most, "{count} of {all}: {heard:?}");
    assert!(heard.iter().any(|text| text.contains("there is no room: 1/2 of the particles")), "{heard:?}");
    assert!(heard.iter().any(|text| text.contains("the device allows")), "why: {heard:?}");
    assert!(hand.steps(1, LONG) && hand.app.failure().is_none() && hand.app.viewer().unwrap().is_auto());
    // Another scene is not told apart: there is room for it.
    hand.app.viewer_mut().unwrap().open("phone-1k");
    let is_whole = |hand: &mut Hand| current(hand).is_some_and(|run| run.session.slot_count() == 1000);
    assert!(hand.until(LONG, is_whole), "{:?}", said(&hand));
}
