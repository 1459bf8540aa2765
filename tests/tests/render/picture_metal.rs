//! Pictures of a fluid of metal: what is left out for it, what it mirrors, and what it cannot be told beside.

use std::collections::BTreeSet;

use brooklet_fluid::Scene;
use brooklet_fluid::scene::Smoothing;
use brooklet_render::{FrameOptions, ScenePlan};
use brooklet_tests::gpu;
use glam::DVec3;

use crate::picture_water::water;
use crate::support::{Picture, Sphere, draw, sphere, view};

fn scene(settings: &[&str]) -> Result<Scene, String> {
    let small = ["spacing_m=0.1", "outputs.width_px=32", "outputs.height_px=32", "forces.xsph=0"];
    let settings: Vec<String> = small.iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("calm-pool", &settings).map_err(|error| error.to_string())
}

fn drawn_stages(settings: &[&str]) -> BTreeSet<&'static str> {
    let planned = ScenePlan::new(&scene(settings).expect("a scene"), gpu().tier()).expect("a plan");
    planned.session.plan.passes().iter().map(|pass| pass.stage).collect()
}

#[test]
fn what_light_does_in_water_is_not_there_in_a_metal() {
    let light_in_water = [
        "draw_water",
        "draw_thickness",
        "draw_opaque_planes",
        "count_sun_volume",
        "sum_sun_volume",
        "draw_sun_depth",
        "refract_photons",
        "draw_caustics",
    ];
    for method in ["surface.method=screen-space", "surface.method=marching-cubes"] {
        let water = drawn_stages(&[method, "surface.caustics=true", "surface.self_shadow=true"]);
        assert!(light_in_water.iter().all(|stage| water.contains(stage)), "{water:?}");
        let metal = drawn_stages(&[method, "surface.metal_reflectance=[0.8, 0.8, 0.8]"]);
        assert!(!light_in_water.iter().any(|stage| metal.contains(stage)), "{metal:?}");
        let brought: Vec<_> = metal.difference(&water).copied().collect();
        assert_eq!(brought, ["draw_metal"]);
    }
}

#[test]
fn a_metal_that_lets_light_pass_is_refused() {
    let metal = "surface.metal_reflectance=[0.8, 0.8, 0.8]";
    for (setting, words) in [
        ("surface.caustics=true", "surface.caustics = true: must be false or left out with surface.metal_reflectance"),
        ("surface.self_shadow=true", "surface.self_shadow = true: must be false or left out"),
        ("surface.absorption_per_m=[1, 2, 3]", "surface.absorption_per_m = [1, 2, 3]: must be left out with"),
        (
            "surface.metal_reflectance=[0.8, 1.2, 0.8]",
            "surface.metal_reflectance = [0.8, 1.2, 0.8]: must be three numbers, each from 0 to 1",
        ),
    ] {
        let got = scene(&[metal, setting]).expect_err(setting);
        assert!(got.contains(words) && !got.contains('\n'), "{setting}: {got}");
    }
    assert!(scene(&[metal, "surface.caustics=false", "surface.self_shadow=false"]).is_ok());
}

/// A ball of a hundred spheres and more, of a metal that reflects so much of each colour.
fn ball(reflectance: DVec3) -> Picture {
    let spheres: Vec<Sphere> = (0..12 * 12 * 12)
        .map(|i| DVec3::new(f64::from(i % 12), f64::from(i / 144), f64::from(i / 12 % 12)) - 5.5)
        .filter(|at| at.length() < 5.5)
        .map(|at| DVec3::new(1.0, 0.5, 0.5) + 0.06 * at)
        .map(|at_m| sphere(at_m.x, at_m.y, at_m.z, 0))
        .collect();
    assert!(spheres.len() > 100);
    let mut options = FrameOptions { edges: false, ..water(Smoothing::NarrowRange) };
    let surface = options.surface.water_mut().expect("a surface");
    (surface.metal_reflectance, surface.photons) = (Some(reflectance), 0);
    draw(&view([160, 90]), &options, &spheres)
}

/// Where it faces the eye a ball that reflects red alone is as red as a white one, and nearly without the other colours.
#[test]
fn a_metal_mirrors_its_own_share_of_each_colour() {
    let [white, red] = [DVec3::ONE, DVec3::X].map(ball);
    // The mean around the picture's middle, up to 8 pixels away.
    let middle = |picture: &Picture, channel: usize| {
        let pixels = (0..160 * 90u32).map(|i| (i % 160, i / 160));
        let pixels = pixels.filter(|&(x, y)| (f64::from(x) - 80.0).hypot(f64::from(y) - 45.0) < 8.0);
        let values: Vec<f64> = pixels.map(|(x, y)| f64::from(picture.rgb(x, y)[channel])).collect();
        values.iter().sum::<f64>() / values.len() as f64
    };
    let reds = [&white, &red].map(|picture| middle(picture, 0));
    assert!((reds[0] - reds[1]).abs() < 3.0, "{reds:?} of red");
    for channel in [1, 2] {
        let [all, none] = [&white, &red].map(|picture| middle(picture, channel));
        assert!(none < 0.25 * all, "channel {channel}: {all} reflected, and {none} of what is not");
    }
}
