//! Hands on the picture: a body is held and taken along, an emitter is placed and removed. First without a display, by the
//! events that a window hands on; then as a person does it.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use brooklet_fluid::Scene;
use brooklet_tests::gpu;
use brooklet_tests::program::Workshop;
use brooklet_viewer::action::Action;
use brooklet_viewer::{Place, Settings, Viewer};
use egui::{Event, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};
use glam::{DVec2, DVec3};

use crate::support::User;
use crate::support::screen::LEFT;

/// A block of wood on some water, and a wall in the water.
const TANK: &str = r#"
spacing_m = 0.05
[domain]
min_m = [1, 0, 0]
max_m = [2, 0.8, 0.5]
[[fluid]]
block = { min_m = [1, 0, 0], max_m = [2, 0.15, 0.5] }
[[solid]]
box = { size_m = [0.2, 0.1, 0.2] }
centre_m = [1.5, 0.22, 0.25]
density_kg_m3 = 300
[[solid]]
box = { size_m = [0.1, 0.3, 0.2] }
centre_m = [1.85, 0.15, 0.25]
[surface]
method = "points"
[camera]
eye_m = [1.5, 0.45, 2.2]
target_m = [1.5, 0.35, 0.25]
[outputs]
measure_every_steps = 1
"#;
const SIZE: egui::Vec2 = vec2(320.0, 240.0);
/// Longer than a software driver on a busy machine takes for anything here.
const LONG: Duration = Duration::from_secs(120);

struct Table {
    viewer: Viewer,
}

impl Table {
    fn open(rung: usize) -> Self {
        let scene = Scene::from_toml(TANK, "tank.toml", &[]).unwrap();
        let settings = Settings { folder: PathBuf::new(), budget_ms: Some(50.0), rung: Some(rung) };
        let size_px = [SIZE.x as u32, SIZE.y as u32];
        let mut viewer = Viewer::new(&gpu(), wgpu::TextureFormat::Rgba8Unorm, scene, settings, size_px);
        viewer.handle_action(Action::Panels);
        let mut table = Self { viewer };
        table.settle();
        table
    }

    /// Until what is wanted runs.
    fn settle(&mut self) {
        self.until("the scene", |table| table.viewer.current().is_some() && !table.viewer.is_loading());
        self.steps(2);
    }

    fn frame(&mut self, events: Vec<Event>) {
        let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, SIZE));
        self.viewer.frame(RawInput { screen_rect, events, ..RawInput::default() }, None).unwrap();
        std::thread::sleep(Duration::from_millis(1));
    }

    fn until(&mut self, what: &str, is_so: impl Fn(&mut Self) -> bool) {
        let begun = Instant::now();
        while !is_so(self) {
            let said: Vec<&str> = self.viewer.messages().collect();
            assert!(begun.elapsed() < LONG, "{what}: {said:?}");
            self.frame(Vec::new());
        }
    }

    fn done(&self) -> u64 {
        self.viewer.current().unwrap().session.steps()
    }

    fn steps(&mut self, steps: u64) {
        let before = self.done();
        self.until("steps", |table| table.done() >= before + steps);
    }

    fn button(&mut self, at: Pos2, pressed: bool) {
        let button =
            Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE };
        self.frame(vec![Event::PointerMoved(at), button]);
    }

    fn body(&mut self) -> DVec3 {
        let state = self.viewer.take_state().unwrap();
        DVec3::from(state.bodies.states[0].position_m.map(f64::from))
    }

    /// Where the body is seen, and how many points a metre is there.
    fn seen(&self, solid: usize) -> Pos2 {
        let at: DVec2 = self.viewer.current().unwrap().seen_at(solid, DVec3::ZERO).unwrap();
        pos2(at.x as f32 * SIZE.x, at.y as f32 * SIZE.y)
    }
}

#[test]
fn a_body_is_taken_along_and_let_go() {
    let mut table = Table::open(2);
    let first = table.body();
    let from = table.seen(0);
    table.button(from, true);
    let to = from + vec2(-50.0, -55.0);
    for step in 1..=5u8 {
        table.frame(vec![Event::PointerMoved(from + (to - from) * (f32::from(step) / 5.0))]);
    }
    table.steps(240);
    let held = table.body();
    // In a second of its time it is where the hand is, though nothing carries it there.
    assert!(held.x < first.x - 0.1 && held.y > first.y + 0.1, "{first}, then {held}");
    // Held by its face it hangs below the hand, by up to half its width (16 points), and sags by some millimetres.
    assert!(table.seen(0).distance(to) < 26.0, "{:?}, and the hand is at {to:?}", table.seen(0));
    table.steps(30);
    let strayed_m = table.body().distance(held);
    assert!(strayed_m < 0.05, "it stays in the hand: {strayed_m} m off");
    table.button(to, false);
    table.steps(60);
    assert!(table.body().y < held.y - 0.05, "let go it falls");

    // What stands is not held, and neither is water: that is pushed.
    let before = table.body();
    let wall = table.seen(1);
    for from in [wall, pos2(40.0, 200.0)] {
        table.button(from, true);
        table.frame(vec![Event::PointerMoved(from + vec2(0.0, -60.0))]);
        table.steps(10);
        table.button(from + vec2(0.0, -60.0), false);
    }
    assert!(table.body().y < before.y + 0.05, "nobody held it");
}

#[test]
fn an_emitter_is_placed_where_a_hand_points_and_removed() {
    let mut table = Table::open(2);
    let particles = |table: &mut Table| {
        table.until("a measurement", |table| table.viewer.stats().is_some());
        table.viewer.stats().unwrap().particles
    };
    let (before, steps) = (particles(&mut table), table.done());
    let emitters = |table: &Table| table.viewer.current().unwrap().scene.emitters.clone();
    // On the wall that stands in the water, from the left; then in the air.
    for (place, at) in [(Place::Wall, table.seen(1)), (Place::Air, pos2(100.0, 60.0))] {
        let had = emitters(&table).len();
        table.viewer.handle_action(Action::Place(Some(place)));
        table.button(at, true);
        table.button(at, false);
        table.until("the emitter", |table| emitters(table).len() == had + 1 && !table.viewer.is_loading());
        assert!(table.done() >= steps, "the scene goes on");
    }
    let placed = emitters(&table);
    assert!(placed[0].direction[1].abs() < 0.5 && placed[0].centre_m[0] > 1.7, "out of the wall's side: {placed:?}");
    assert_eq!(placed[1].direction, [0.0, -1.0, 0.0]);
    table.until("water", |table| table.viewer.stats().is_some_and(|stats| stats.particles > before + 50));
    let flow = table.viewer.flow();
    assert!(flow.emitted > 50 && flow.drained == 0 && flow.lost == 0, "{flow:?}");
    let count = table.viewer.stats().unwrap().particles;
    assert!(u64::from(count) <= u64::from(before) + flow.emitted + 50, "{count} particles, {flow:?}");

    let scene = table.viewer.current().unwrap().scene.clone();
    let without = scene.with_emitters(Vec::new(), scene.slot_capacity()).unwrap();
    table.viewer.apply(without);
    table.until("no emitter", |table| emitters(table).is_empty() && !table.viewer.is_loading());
    table.steps(4);
    let left = particles(&mut table);
    assert!(left >= count, "what it emitted stays: {count}, then {left}");
    table.steps(20);
    assert_eq!(particles(&mut table), left, "and no more comes");

    // A place where nothing can be is said, and changes nothing.
    table.viewer.handle_action(Action::Place(Some(Place::Wall)));
    table.viewer.handle_action(Action::ResetCamera);
    table.button(pos2(1.0, 1.0), true);
    table.button(pos2(1.0, 1.0), false);
    table.steps(4);
    assert!(emitters(&table).is_empty());
    let said: Vec<String> = table.viewer.messages().map(str::to_owned).collect();
    assert!(said.iter().any(|text| text.contains("there is no wall")), "{said:?}");
}

#[test]
fn a_person_holds_a_body_and_places_a_hose() {
    let shop = Workshop::new();
    std::fs::write(shop.path("tank.toml"), TANK).unwrap();
    let mut command = shop.command(["view", "tank.toml", "--rung", "3", "--budget", "200", "--out", "shots"]);
    let mut user = User::open(&mut command, shop.path("").as_path());
    let number = |user: &User, fact: &str| user.fact(fact).as_f64().unwrap_or(f64::NAN);
    // By then the body floats: while it still falls into the water it is no longer where it was told to be.
    user.wait("the simulation", |user| (number(user, "steps") > 480.0).then_some(()));
    let seen = |user: &User| {
        let at = user.fact("bodies_seen")[0].clone();
        [at[0].as_f64().unwrap_or(f64::NAN), at[1].as_f64().unwrap_or(f64::NAN)]
    };
    let [left, top, right, bottom] = user.rect("picture");
    let on_screen =
        |[x, y]: [f64; 2]| [left + (x * f64::from(right - left)) as i16, top + (y * f64::from(bottom - top)) as i16];
    let from = seen(&user);
    user.screen.point(on_screen(from));
    user.screen.button(LEFT, true);
    for step in 1..=4 {
        user.screen.point(on_screen([from[0] - 0.04 * f64::from(step), from[1] - 0.06 * f64::from(step)]));
        std::thread::sleep(Duration::from_millis(100));
    }
    user.wait("the body in the hand", |user| {
        let at = seen(user);
        // It hangs below the hand by up to half its width, a quarter of the way.
        (at[0] < from[0] - 0.08 && at[1] < from[1] - 0.1).then_some(())
    });
    user.look(&crate::person::gallery().join("7-held.png"));
    user.screen.button(LEFT, false);
    user.wait("it to fall", |user| (seen(user)[1] > from[1] - 0.06).then_some(()));

    user.click("section sources");
    user.click("place hose");
    user.screen.point(on_screen([0.3, 0.3]));
    user.screen.button(LEFT, true);
    user.screen.button(LEFT, false);
    user.wait("water of the hose", |user| (number(user, "emitted") > 30.0).then_some(()));
    user.look(&crate::person::gallery().join("8-hose.png"));
    user.click("emitter 0 remove");
    user.wait("no emitter", |user| {
        let toml = user.fact("toml").as_str().unwrap_or_default().to_owned();
        (!toml.contains("[[emitter]]")).then_some(())
    });
    user.screen.key(u32::from(b'q'), true);
    assert!(user.ended().success(), "{}", user.words());
}
