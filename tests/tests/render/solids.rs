//! Pictures of solids among the fluid: what hides what, what moves, and what of it is in no other scene's plan.

use crate::support::Picture;
use brooklet_fluid::{Scene, Session};
use brooklet_gpu::Tier;
use brooklet_render::{ScenePlan, View};
use brooklet_tests::gpu;
use glam::DVec3;

const METHODS: [&str; 5] = ["none", "points", "screen-space", "marching-cubes", "auto"];
const SIZE_PX: [u32; 2] = [160, 120];

/// A block of water in the middle of a domain of 1 m, with these solids, in free fall so short that it stays.
fn scene(solids: &str, method: &str) -> Scene {
    let [width, height] = SIZE_PX;
    let text = format!(
        "spacing_m = 0.04\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [3, -2, 1]\nmax_m = [4, -1, 2]\n[[fluid]]\n\
         block = {{ min_m = [3.3, -1.7, 1.3], max_m = [3.7, -1.3, 1.7] }}\n{solids}[solver]\nmethod = \"none\"\n\
         dt_s = 0.001\n[surface]\nmethod = \"{method}\"\n[outputs]\nimages = 1\nwidth_px = {width}\nheight_px = {height}\n"
    );
    Scene::from_toml(&text, "solids", &[]).expect("a scene")
}

/// The picture after so many steps.
fn picture(scene: &Scene, steps: u32) -> Picture {
    let mut planned = ScenePlan::new(scene, gpu().tier()).expect("a plan");
    let mut passes = planned.passes.take().expect("a picture");
    let count = planned.session.slot_count();
    let mut session = Session::start(&gpu(), planned.session).expect("a session");
    for _ in 0..steps {
        session.step().expect("a step");
    }
    let draw = passes.next(session.engine_mut(), count, false);
    session.engine_mut().run(&[draw], &[]).expect("it draws");
    let rgba = session.engine_mut().read_texture(&passes.color).expect("a picture");
    Picture { size_px: SIZE_PX, rgba, depth: Vec::new() }
}

/// What is seen of a place.
fn seen(picture: &Picture, scene: &Scene, at_m: DVec3) -> [i32; 3] {
    let at = View::of_scene(scene).project(at_m).expect("in front").at_px;
    picture.rgb(at.x as u32, at.y as u32)
}

fn apart(a: [i32; 3], b: [i32; 3]) -> i32 {
    (0..3).map(|channel| (a[channel] - b[channel]).abs()).max().unwrap_or_default()
}

/// A red box of 0.2 m before or behind the water as the camera sees it.
fn red_box(along_view_m: f64, more: &str) -> (String, DVec3) {
    let plain = scene("", "none");
    let middle_m = DVec3::new(3.5, -1.5, 1.5);
    let toward_eye = (View::of_scene(&plain).camera.eye_m - middle_m).normalize();
    let [x, y, z] = (middle_m + along_view_m * toward_eye).to_array();
    let text = format!(
        "[[solid]]\nbox = {{ size_m = [0.12, 0.12, 0.12] }}\ncentre_m = [{x}, {y}, {z}]\ncolor = [0.9, 0.05, 0.05]\n{more}"
    );
    (text, DVec3::new(x, y, z))
}

fn is_red([red, green, blue]: [i32; 3]) -> bool {
    red > 2 * green && red > 2 * blue
}

#[test]
fn a_solid_hides_what_is_behind_it_and_not_what_is_before_it() {
    for method in METHODS {
        let bare = picture(&scene("", method), 1);
        let (before, at_m) = red_box(0.4, "");
        let with = scene(&before, method);
        let color = seen(&picture(&with, 1), &with, at_m);
        assert!(is_red(color), "{method}: {color:?} where a red box is before all");
        assert!(!is_red(seen(&bare, &with, at_m)), "{method}: red without a box");
        // Behind the fluid it is hidden by balls, seen through water, and there where nothing is drawn.
        let (behind, at_m) = red_box(-0.4, "");
        let with = scene(&behind, method);
        let color = seen(&picture(&with, 1), &with, at_m);
        match method {
            "none" => assert!(is_red(color), "{method}: {color:?} where nothing hides a red box"),
            _ => assert!(!is_red(color), "{method}: {color:?} where the fluid hides a red box"),
        }
        if method == "points" {
            let unlike = apart(color, seen(&bare, &with, at_m));
            assert!(unlike <= 2, "balls before a box: {unlike} of 255 from those alone");
        }
    }
}

#[test]
fn a_solid_is_drawn_where_it_moved_to_and_where_it_began() {
    for method in ["none", "screen-space"] {
        let (moving, from_m) = red_box(0.4, "velocity_m_s = [0, 30, 0]\n");
        let scene = scene(&moving, method);
        // 10 steps of 1 ms.
        let to_m = from_m + DVec3::Y * 0.3;
        for (steps, is_there) in [(0, [true, false]), (10, [false, true])] {
            let picture = picture(&scene, steps);
            let found = [from_m, to_m].map(|at_m| is_red(seen(&picture, &scene, at_m)));
            assert_eq!(found, is_there, "{method}: after {steps} steps");
        }
    }
}

#[test]
fn a_solid_shades_the_floor() {
    for method in METHODS {
        let (above, at_m) = red_box(0.4, "");
        let with = scene(&above, method);
        let [bare, drawn] = [scene("", method), with.clone()].map(|scene| picture(&scene, 1));
        // From the sun past the box to the floor.
        let to_sun = DVec3::new(-0.55, 0.75, -0.25);
        let shaded_m = at_m - to_sun * ((at_m.y + 2.0) / to_sun.y);
        let [lit, shaded] = [&bare, &drawn].map(|picture| seen(picture, &with, shaded_m).iter().sum::<i32>());
        assert!(f64::from(shaded) < 0.85 * f64::from(lit), "{method}: {shaded} of {lit} in the box's shadow");
    }
}

#[test]
fn glass_shows_the_water_in_it_and_paint_does_not() {
    let vessel = |look: &str| {
        format!(
            "[[solid]]\nbox = {{ size_m = [0.56, 0.56, 0.56] }}\nthickness_m = 0.04\nopen = \"y_max\"\n\
             centre_m = [3.5, -1.5, 1.5]\nlook = \"{look}\"\n"
        )
    };
    let front_m = DVec3::new(3.55, -1.6, 1.7);
    for method in ["points", "screen-space", "marching-cubes", "auto"] {
        let bare = picture(&scene("", method), 1);
        let [glass, paint] = ["glass", "solid"].map(|look| {
            let scene = scene(&vessel(look), method);
            seen(&picture(&scene, 1), &scene, front_m)
        });
        let alone = seen(&bare, &scene("", method), front_m);
        assert!(apart(glass, alone) < 60, "{method}: {glass:?} behind glass, {alone:?} alone");
        assert!(glass[2] > glass[0] + 15, "{method}: {glass:?} is no water");
        assert!(paint[0] > paint[2], "{method}: {paint:?} where paint hides water");
        // The glass itself is seen: its rim is bright before the sky and the floor.
        let whole = picture(&scene(&vessel("glass"), method), 1);
        let changed = whole.rgba.chunks(4).zip(bare.rgba.chunks(4)).filter(|(a, b)| a[0].abs_diff(b[0]) > 6).count();
        assert!(changed > 200, "{method}: glass changes {changed} pixels");
    }
}

#[test]
fn what_draws_solids_is_in_no_plan_without_them() {
    let opaque = "[[solid]]\nsphere = { radius_m = 0.1 }\ncentre_m = [3.2, -1.8, 1.2]\n";
    let clear = opaque.replace("centre_m", "look = \"glass\"\ncentre_m");
    for (method, tier) in METHODS.into_iter().flat_map(|method| [(method, Tier::Desktop), (method, Tier::Floor)]) {
        let planned = |solids: &str| ScenePlan::new(&scene(solids, method), tier).expect("a plan");
        let stages = |solids: &str| {
            let passes = planned(solids).plan().passes();
            ["draw_solids", "draw_solids_shadow", "draw_glass"].map(|name| passes.iter().any(|pass| pass.stage == name))
        };
        let bare = planned("");
        assert!(!bare.plan().passes().iter().any(|pass| pass.module.name.contains("solids")), "{method}: solids' code");
        let labels =
            bare.plan().buffers().into_iter().map(|buffer| buffer.label).filter(|label| label.contains("solid"));
        assert_eq!(labels.collect::<Vec<_>>(), Vec::<String>::new(), "{method}: solids' buffers");
        assert_eq!(stages(""), [false; 3], "{method}");
        assert_eq!(stages(opaque), [true, true, false], "{method}");
        assert_eq!(stages(&clear), [false, false, true], "{method}");
    }
}
