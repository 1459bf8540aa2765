//! Scenes with bodies, and with emitters: chosen by touch, run as phones run them.

use brooklet_mobile::TouchPhase::{End, Move, Start};
use brooklet_mobile::script::Hand;
use brooklet_viewer::action::Action;
use glam::DVec3;

use crate::{LONG, SIZE_PX, current, running, said};

/// Chooses a scene by its button, on a rung that a software driver holds.
fn choose(hand: &mut Hand, name: &str) {
    hand.app.viewer_mut().unwrap().handle_action(Action::Rung(12));
    hand.tap("scenes").unwrap();
    // The list scrolls: the button may lie below what is seen of it.
    let key = format!("scene {name}");
    for _ in 0..20 {
        let rect = hand.marks.get(&key).copied();
        if rect.is_some_and(|rect| rect.center().y < SIZE_PX[1] as f32 - 30.0) {
            break;
        }
        hand.drag(&[([180.0, 560.0], [180.0, 440.0])]);
    }
    hand.tap(&key).unwrap();
    let begins = |hand: &mut Hand| current(hand).is_some_and(|run| run.scene.name == name);
    assert!(hand.until(LONG, begins), "{name}: {:?}", said(hand));
    assert!(
        hand.until(LONG, |hand| !hand.app.viewer().unwrap().is_loading()) && hand.steps(2, LONG),
        "{:?}",
        said(hand)
    );
}

#[test]
fn a_finger_holds_a_boat() {
    let (mut hand, _folder) = running();
    choose(&mut hand, "boats");
    let boat = |hand: &mut Hand| {
        let state = hand.app.viewer_mut().unwrap().take_state().unwrap();
        assert_eq!(state.bodies.states.len(), 6);
        DVec3::from(state.bodies.states[1].position_m.map(f64::from))
    };
    let before = boat(&mut hand);
    // The block of its list that nothing stands before.
    let at = current(&hand).unwrap().seen_at(1, DVec3::ZERO).unwrap();
    let from = [at.x as f32 * SIZE_PX[0] as f32, at.y as f32 * SIZE_PX[1] as f32];
    let to = [from[0], from[1] - 60.0];
    hand.touch(1, Start, from);
    hand.settle();
    hand.touch(1, Move, to);
    hand.settle();
    assert!(hand.steps(100, LONG));
    let held = boat(&mut hand);
    assert!(held.y > before.y + 0.05, "{before}, then {held} in the hand: {:?}", said(&hand));
    hand.touch(1, End, to);
    hand.settle();
    assert!(hand.steps(60, LONG));
    let after = boat(&mut hand);
    assert!(after.y < held.y - 0.03, "let go it falls: {held}, then {after}");
}

#[test]
fn a_faucet_runs() {
    let (mut hand, _folder) = running();
    choose(&mut hand, "faucet");
    let emits = |hand: &mut Hand| hand.app.viewer().is_some_and(|viewer| viewer.flow().emitted > 20);
    assert!(hand.until(LONG, emits), "{:?}", said(&hand));
    let viewer = hand.app.viewer().unwrap();
    let (flow, slots) = (viewer.flow(), current(&hand).unwrap().session.slot_count());
    let particles = viewer.stats().unwrap().particles;
    assert!(flow.lost == 0 && particles <= slots, "{flow:?}, {particles} in {slots}");
}
