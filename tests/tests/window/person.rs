//! The window as a person uses it: real input events on a display of the test's own.
//!
//! Pictures of the screen are kept in `target/window-test`, to be looked at.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use crate::support::User;
use crate::support::dropping::drop_file;
use crate::support::screen::{F1, LEFT, RIGHT, SPACE, WHEEL_UP};
use brooklet_capture::Capture;
use brooklet_fluid::{Scene, particles::sample_lattice};
use brooklet_tests::program::Workshop;
use brooklet_tests::states::{OLD_SCENE, state_of, version_1};

/// A pool of some 100 particles: a software driver draws some frames of it a second.
const POOL: &[&str] =
    &["calm-pool", "--set", "spacing_m=0.05", "--set", "outputs.measure_every_steps=1", "--rung", "6"];

fn view(shop: &Workshop, scene: &[&str]) -> Command {
    let mut command = shop.command(["view"]);
    command.args(scene).args(["--budget", "200", "--out", "shots"]);
    command
}

/// Where pictures of the screen are kept.
pub fn gallery() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("../window-test");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn number(user: &User, fact: &str) -> f64 {
    user.fact(fact).as_f64().unwrap_or(f64::NAN)
}

#[test]
fn a_person_uses_the_window() {
    let shop = Workshop::new();
    let mut user = User::open(&mut view(&shop, POOL), shop.path("").as_path());
    user.wait("the simulation", |user| (number(user, "steps") > 4.0).then_some(()));
    user.wait("a measurement", |user| (number(user, "kinetic_j") >= 0.0).then_some(()));
    let (width, height, rgba) = user.look(&gallery().join("1-open.png"));
    let colors: std::collections::BTreeSet<&[u8]> = rgba.chunks_exact(4).collect();
    assert_eq!((width, height), (1100, 720));
    assert!(colors.len() > 2000, "{} colours: nothing is drawn", colors.len());

    // Turning, and coming nearer.
    let eye = user.fact("eye_m");
    let [left, top, right, bottom] = user.rect("picture");
    let middle = [(left + right) / 2, (top + bottom) / 2];
    user.drag(RIGHT, middle, [middle[0] + 120, middle[1] - 20], 4);
    user.wait("the camera to turn", |user| (user.fact("eye_m") != eye).then_some(()));
    let distance = |user: &User| number(user, "distance_m");
    let before = distance(&user);
    user.screen.point(middle);
    for _ in 0..4 {
        user.screen.button(WHEEL_UP, true);
        user.screen.button(WHEEL_UP, false);
    }
    user.wait("the camera to come nearer", |user| (distance(user) < 0.9 * before).then_some(()));

    // Pushing the water, as fast as a hand does: from frame to frame where there are many, between two where there
    // are few. Where a frame holds many steps, most of what was pushed has come to rest by the next measurement: so
    // it may take some, held against the calmest moment since the water has settled on the lattice.
    user.wait("a second of the simulation", |user| (number(user, "steps") > 240.0).then_some(()));
    let ends = [[middle[0] - 150, middle[1] + 60], [middle[0] + 150, middle[1] + 60]];
    let mut calm_j = f64::INFINITY;
    let moved = (0..30).any(|drag| {
        calm_j = calm_j.min(number(&user, "kinetic_j"));
        let since = user.lines();
        user.flick(LEFT, ends[drag % 2], ends[1 - drag % 2]);
        user.most("kinetic_j", since) > 3.0 * calm_j
    });
    assert!(moved, "the water does not move: {} J, {calm_j} J at its calmest", number(&user, "kinetic_j"));
    user.look(&gallery().join("2-pushed.png"));

    // Pause, one step, and on.
    user.screen.key(SPACE, false);
    user.wait("the pause", |user| (user.fact("paused") == true).then_some(()));
    std::thread::sleep(Duration::from_millis(500));
    let steps = number(&user, "steps");
    user.click("step");
    user.wait("a step", |user| (number(user, "steps") == steps + 1.0).then_some(()));
    user.click("pause");
    user.wait("it to go on", |user| (number(user, "steps") > steps + 2.0).then_some(()));

    // A capture around all that follows.
    user.click("capture");
    let capture = user.wait("the capture", |user| user.fact("capture").as_str().map(PathBuf::from));

    // Five settings: two that are numbers of the plan, two that change the plan, one that waits for a reset.
    let setting = |user: &User, path: &str| {
        let text = user.fact("toml").as_str().unwrap_or_default().to_owned();
        let mut value: toml::Value = toml::from_str(&text).unwrap();
        for key in path.split('.') {
            value = value.get(key).cloned().unwrap_or(toml::Value::Boolean(false));
        }
        value
    };
    let spot = |user: &mut User, name: &str, share: f64| {
        let [left, top, right, bottom] = user.rect(name);
        let at = [left + ((right - left) as f64 * share) as i16, (top + bottom) / 2];
        // A slider follows a button that is down in some frame.
        user.drag(LEFT, at, at, 1);
    };
    for (path, share) in [("solver.pbf.relaxation", 0.2), ("forces.xsph", 0.25), ("solver.pbf.iterations", 0.1)] {
        let before = setting(&user, path);
        spot(&mut user, path, share);
        user.wait(path, |user| (setting(user, path) != before).then_some(()));
    }
    user.click("section solver");
    user.click("section surface");
    user.click("surface.method");
    user.click("surface.method points");
    user.wait("points", |user| (setting(user, "surface.method").as_str() == Some("points")).then_some(()));
    user.look(&gallery().join("3-settings.png"));
    user.click("surface.method");
    user.click("surface.method screen-space");
    user.click("section surface");
    user.click("section scene");
    let particles = number(&user, "particles");
    spot(&mut user, "spacing_m", 0.22);
    user.click("reset now");
    user.wait("another spacing", |user| (number(user, "particles") != particles).then_some(()));

    // Another size.
    let picture = user.fact("picture_px");
    user.screen.resize(user.window, 980, 640);
    user.wait("a picture of another size", |user| (user.fact("picture_px") != picture).then_some(()));

    // A bad file, and a good one.
    let scene = user.fact("scene");
    std::fs::write(shop.path("bad.toml"), "spacing_m = \"wide\"\n").unwrap();
    drop_file(&user.screen, user.window, &shop.path("bad.toml"));
    user.control("error");
    let said = user.wait("what is wrong", |user| user.fact("messages").as_array()?.last()?.as_str().map(str::to_owned));
    assert!(said.contains("bad.toml") && said.contains("spacing_m") && said.contains("wide"), "{said}");
    assert_eq!(user.fact("scene"), scene, "the scene before it goes on");
    user.look(&gallery().join("4-bad-file.png"));
    drop_file(&user.screen, user.window, &shop.path("scene.toml"));
    user.wait("the dropped scene", |user| (user.fact("scene") == "scene").then_some(()));

    // The list of scenes, a screenshot, the help.
    user.click("scenes");
    user.click("scene falling-ball");
    user.wait("falling-ball", |user| (user.fact("scene") == "falling-ball").then_some(()));
    user.click("screenshot");
    let shot = user.wait("the screenshot", |user| {
        let _ = user;
        std::fs::read_dir(shop.path("shots"))
            .ok()?
            .flatten()
            .map(|entry| entry.path())
            .find(|path| path.extension().is_some_and(|ending| ending == "png"))
    });
    assert!(std::fs::read(&shot).unwrap().starts_with(b"\x89PNG"));
    user.screen.key(F1, false);
    user.control("help window");
    user.look(&gallery().join("5-help.png"));
    user.screen.key(F1, false);

    user.click("capture");
    user.wait("the capture's end", |user| user.fact("capture").is_null().then_some(()));
    user.screen.key(u32::from(b'q'), true);
    let status = user.ended();
    assert!(status.success(), "{status}: {}", user.words());

    let capture = Capture::open(&shop.path("").join(capture)).unwrap();
    assert!(capture.frames.len() > 10, "{} frames", capture.frames.len());
    assert!(capture.stats.len() > 2, "{} measurements", capture.stats.len());
}

/// The last frames of a capture that the window had open when something happened to it.
fn recorded(path: &Path) -> usize {
    Capture::open(path).unwrap_or_else(|error| panic!("{error}")).frames.len()
}

#[test]
fn a_lost_device_and_a_lost_surface_cost_the_state_alone() {
    let shop = Workshop::new();
    let mut command = view(&shop, POOL);
    // Far enough for a capture before it; the surface goes first.
    command.args(["--lose-surface", "30", "--lose-device", "60"]);
    let mut user = User::open(&mut command, shop.path("").as_path());
    user.wait("the simulation", |user| (number(user, "steps") > 0.0).then_some(()));
    user.screen.key(u32::from(b'c'), false);
    let capture = user.wait("the capture", |user| user.fact("capture").as_str().map(PathBuf::from));
    user.wait("a new device", |user| {
        let words = user.fact("messages");
        words
            .as_array()?
            .iter()
            .any(|text| text.as_str().is_some_and(|text| text.contains("device was lost")))
            .then_some(())
    });
    user.wait("the scene to begin again", |user| (number(user, "steps") > 0.0).then_some(()));
    user.look(&gallery().join("6-device-lost.png"));
    assert!(recorded(&shop.path("").join(capture)) > 0);
    user.screen.key(u32::from(b'q'), true);
    assert!(user.ended().success(), "{}", user.words());
}

#[test]
fn a_saved_state_of_the_version_before_goes_on_from_its_step() {
    let shop = Workshop::new();
    let scene = Scene::load("dam-break", &["spacing_m=0.08".into()]).unwrap();
    let particles = sample_lattice(&scene);
    let state = state_of(scene, particles, 30_000, 125.0);
    std::fs::write(shop.path("pool.brooklet"), version_1(&state, OLD_SCENE)).unwrap();
    let mut user = User::open(&mut view(&shop, &["pool.brooklet"]), shop.path("").as_path());
    user.wait("the state", |user| (number(user, "steps") > 30_000.0).then_some(()));
    let toml = user.fact("toml").as_str().unwrap_or_default().to_owned();
    assert!(toml.contains("[solver.pbf]\niterations = 7\n"), "{toml}");
    user.screen.key(u32::from(b'q'), true);
    assert!(user.ended().success(), "{}", user.words());
}

#[test]
fn a_window_system_that_ends_leaves_the_capture_readable() {
    let shop = Workshop::new();
    let mut user = User::open(&mut view(&shop, POOL), shop.path("").as_path());
    user.wait("the simulation", |user| (number(user, "steps") > 0.0).then_some(()));
    user.screen.key(u32::from(b'c'), false);
    let capture = user.wait("the capture", |user| user.fact("capture").as_str().map(PathBuf::from));
    let capture = shop.path("").join(capture);
    user.wait("a chunk of it", |_| (recorded(&capture) > 2).then_some(()));
    user.screen.end();
    let status = user.ended();
    assert!(status.code().is_some_and(|code| code != 0 && code != 101), "{status}: {}", user.words());
    assert!(recorded(&capture) > 2);
}

#[test]
fn without_a_display_it_says_what_works_without_one() {
    let shop = Workshop::new();
    let mut command = shop.command(["view", "calm-pool"]);
    let output =
        command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET").output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("brooklet run") && said.contains("DISPLAY") && !said.contains("panicked"), "{said}");
    // A display that is not there, and a bad scene, which is said before a window is tried.
    let output =
        shop.command(["view", "calm-pool"]).env("DISPLAY", ":4711").env_remove("WAYLAND_DISPLAY").output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
    let output = shop.command(["view", "no-such-scene"]).env_remove("DISPLAY").output().unwrap();
    assert!(output.status.code() == Some(2) && String::from_utf8_lossy(&output.stderr).contains("no-such-scene"));
}

#[test]
fn without_its_libraries_it_says_so() {
    let screen = crate::support::screen::Screen::start(640, 480);
    for library in ["libXcursor.so.1", "libXi.so.6", "libxkbcommon-x11.so.0"] {
        // An empty file of its name before the real one: the loader stops there.
        let shop = Workshop::new();
        std::fs::write(shop.path(library), []).unwrap();
        let mut command = shop.command(["view", "calm-pool"]);
        command.env("DISPLAY", &screen.display).env_remove("WAYLAND_DISPLAY").env("LD_LIBRARY_PATH", shop.path(""));
        let output = command.output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{library}: {said}");
        assert!(said.contains("brooklet run") && !said.contains("panicked"), "{library}: {said}");
        assert!(said.contains("librar") || said.contains("Librar"), "{library}: {said}");
        assert!(!said.contains(".rs:"), "{library}: {said}");
    }
}
