//! Pictures of water: a perceptual metric between pictures that must look alike, calm water over
//! time, and what must not break them.

use crate::support::{Picture, QUARANTINED, Sphere, draw, options, sphere, view};
use brooklet_fluid::scene::Smoothing;
use brooklet_fluid::{Recorded, Scene, record};
use brooklet_gpu::{Engine, Plan, Resources, Tier};
use brooklet_render::{Camera, FrameOptions, Particles, ScreenSpaceOptions, SurfaceOptions, View, frame};
use brooklet_tests::{gpu, rng};
use glam::DVec3;
use rand::RngExt;

/// Structural similarity (Wang et al. 2004, in windows of 8 pixels) of pictures that differ in the
/// bits of a depth buffer: a person sees no difference well below this.
const ALIKE: f64 = 0.985;
/// Steps of 255 that a pixel of calm water may change by from one frame to the next, in the mean
/// over the picture: an eighth of what a display can show.
const FLICKER_STEPS: f64 = 0.125;

pub fn water(smoothing: Smoothing) -> FrameOptions {
    let surface = ScreenSpaceOptions {
        spacing_m: 0.1,
        radius_m: 0.08,
        wall_bounds_m: [DVec3::ZERO, DVec3::new(2.0, 1.0, 1.0)],
        anisotropic: false,
        support_m: 0.2,
        smoothing,
        iterations: smoothing.default_iterations(),
        smoothing_m: 0.2,
        most_reach_px: 64,
        range_m: 0.24,
        clamp_m: 0.08,
        thickness_divisor: 2,
        absorption_per_m: DVec3::new(3.0, 0.8, 0.4),
        refraction: 1.0,
        metal_reflectance: None,
        photons: 128,
        self_shadow: false,
    };
    FrameOptions { surface: SurfaceOptions::ScreenSpace(surface), supersample: 2, ..options() }
}

/// A pool with an uneven surface, and a ball above it.
fn pool() -> Vec<Sphere> {
    let mut rng = rng(41);
    let mut all: Vec<Sphere> = (0..20 * 10 * 4)
        .map(|i| {
            let [x, y, z] = [i % 20, i / 200, i / 20 % 10].map(|n| 0.05 + 0.1 * f64::from(n));
            let wave = 1.0 + 0.3 * (4.0 * x).sin() + 0.1 * rng.random::<f64>();
            sphere(x, y * wave, z, 0)
        })
        .collect();
    all.extend((0..64).map(|i| {
        let [x, y, z] = [i % 4, i / 16, i / 4 % 4].map(|n| 0.08 * f64::from(n));
        sphere(1.2 + x, 0.62 + 0.3 * y, 0.3 + z, 0)
    }));
    all
}

/// Mean, over windows of 8 x 8 pixels, of the structural similarity of luma in 0..=255 (Wang et al.
/// 2004, eq. 13 with its constants): 1 for equal pictures. Written out, because the crates that have it bring
/// whole trees (image decoders, a thread pool) for these lines.
fn similarity(a: &Picture, b: &Picture) -> f64 {
    let [width, height] = a.size_px.map(|side| side as usize);
    assert_eq!(a.size_px, b.size_px);
    let luma = |picture: &Picture, x: usize, y: usize| {
        let [r, g, b] = picture.rgb(x as u32, y as u32).map(f64::from);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    };
    let window = |left: usize, top: usize| {
        let pixels =
            || (top..(top + 8).min(height)).flat_map(move |y| (left..(left + 8).min(width)).map(move |x| (x, y)));
        let count = pixels().count() as f64;
        let mean = |of: &dyn Fn(usize, usize) -> f64| pixels().map(|(x, y)| of(x, y)).sum::<f64>() / count;
        let (mean_a, mean_b) = (mean(&|x, y| luma(a, x, y)), mean(&|x, y| luma(b, x, y)));
        let variance_a = mean(&|x, y| (luma(a, x, y) - mean_a).powi(2));
        let variance_b = mean(&|x, y| (luma(b, x, y) - mean_b).powi(2));
        let covariance = mean(&|x, y| (luma(a, x, y) - mean_a) * (luma(b, x, y) - mean_b));
        let (c1, c2) = ((0.01f64 * 255.0).powi(2), (0.03f64 * 255.0).powi(2));
        (2.0 * mean_a * mean_b + c1) * (2.0 * covariance + c2)
            / ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2))
    };
    let corners: Vec<(usize, usize)> =
        (0..height).step_by(8).flat_map(|top| (0..width).step_by(8).map(move |left| (left, top))).collect();
    corners.iter().map(|&(left, top)| window(left, top)).sum::<f64>() / corners.len() as f64
}

fn darkest(picture: &Picture) -> u8 {
    picture.rgba.chunks(4).map(|p| p[..3].iter().copied().max().unwrap_or(0)).min().expect("pixels")
}

#[test]
fn tiers_and_repetitions_look_alike_and_other_pictures_do_not() {
    let view = view([240, 136]);
    let spheres = pool();
    let desktop = draw(&view, &water(Smoothing::NarrowRange), &spheres);
    let again = draw(&view, &water(Smoothing::NarrowRange), &spheres);
    let floor = draw(&view, &FrameOptions { tier: Tier::Floor, ..water(Smoothing::NarrowRange) }, &spheres);
    let scores = [similarity(&again, &desktop), similarity(&floor, &desktop)];
    println!("water: similarity {:.4} again, {:.4} at the floor tier; {ALIKE} is needed", scores[0], scores[1]);
    assert!(scores.iter().all(|&score| score >= ALIKE), "{scores:?}");
    // What is wrong must be noticed: bumps, another place, no refraction, no water.
    let moved: Vec<Sphere> =
        spheres.iter().map(|s| Sphere { at_m: s.at_m + DVec3::new(0.05, 0.02, 0.0), ..*s }).collect();
    let mut unbent = water(Smoothing::NarrowRange);
    if let SurfaceOptions::ScreenSpace(surface) = &mut unbent.surface {
        surface.refraction = 0.0;
    }
    for (what, wrong) in [
        ("bumps", draw(&view, &water(Smoothing::None), &spheres)),
        ("moved", draw(&view, &water(Smoothing::NarrowRange), &moved)),
        ("no refraction", draw(&view, &unbent, &spheres)),
        ("no water", draw(&view, &water(Smoothing::NarrowRange), &[])),
    ] {
        let score = similarity(&wrong, &desktop);
        println!("water: similarity {score:.4} with {what}");
        assert!(score < ALIKE, "{what}: {score}");
    }
}

/// Calm water over 60 frames of a simulation, and the mean change of a pixel from frame to frame.
fn flicker(settings: &[&str], jitter_m: f32) -> f64 {
    let base = ["outputs.width_px=160", "outputs.height_px=90", "spacing_m=0.05", "outputs.measure_every_steps=0"];
    let settings: Vec<String> = base.iter().chain(settings).map(|&s| s.into()).collect();
    let scene = Scene::load("calm-pool", &settings).expect("a scene");
    let mut resources = Resources::new();
    let recorded: Recorded = record(&mut resources, &scene);
    let options = FrameOptions::for_scene(&scene, gpu().tier());
    let passes =
        frame::record(&mut resources, &View::of_scene(&scene), &Particles::of(&recorded), &options).expect("a frame");
    let mut recordings = recorded.recordings();
    let step = recorded.step.id();
    let (init, draw) = ([recorded.init.id(), passes.init.id()], passes.draw.id());
    recordings.extend([passes.init, passes.draw]);
    let color = passes.color;
    let mut engine =
        Engine::new(&gpu(), Plan::sweep(resources, recordings, &[color.id]).expect("a plan")).expect("an engine");
    engine.run(&init, &[]).expect("it starts");
    let mut rng = rng(42);
    // What an emitted lattice needs to come to rest is not flicker.
    for _ in 0..120 {
        engine.run(&[step], &[]).expect("a step");
    }
    let mut before: Option<Vec<u8>> = None;
    let mut sum = 0.0;
    for _ in 0..60 {
        engine.run(&[step], &[]).expect("a step");
        if jitter_m > 0.0 {
            let mut positions = engine.read(&recorded.positions).expect("positions");
            for position in &mut positions {
                position.position_m = position.position_m.map(|x| x + jitter_m * (rng.random::<f32>() - 0.5));
            }
            engine.write(&recorded.positions, &positions);
        }
        engine.run(&[draw], &[]).expect("a picture");
        let rgba = engine.read_texture(&color).expect("a picture");
        if let Some(before) = &before {
            let change: u64 = rgba.iter().zip(before).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
            sum += change as f64 / (0.75 * rgba.len() as f64);
        }
        before = Some(rgba);
    }
    sum / 59.0
}

#[test]
fn calm_water_does_not_flicker() {
    let calm = flicker(&[], 0.0);
    let shaken = flicker(&[], 0.02);
    println!(
        "flicker over 60 frames: {calm:.4} steps of 255 a pixel and frame, {shaken:.4} when shaken; at most {FLICKER_STEPS}"
    );
    assert!(calm <= FLICKER_STEPS, "{calm}");
    assert!(shaken > FLICKER_STEPS, "the measure cannot fail: {shaken}");
}

#[test]
fn extremes_are_drawn_without_a_hole() {
    let pool = pool();
    let lost = [DVec3::NAN, DVec3::INFINITY, DVec3::splat(0.5)].map(|at_m| Sphere { at_m, tag: QUARANTINED });
    let one_place: Vec<Sphere> = (0..300).map(|_| sphere(1.0, 0.5, 0.5, 0)).collect();
    let usual = view([160, 90]);
    let from = |eye_m: DVec3| View { camera: Camera { eye_m: usual.domain_min_m + eye_m, ..usual.camera }, ..usual };
    let inside = from(DVec3::new(1.0, 0.2, 0.5));
    let behind = from(DVec3::new(1.0, 0.4, -2.5));
    let below = from(DVec3::new(1.0, -1.5, 0.6));
    let far = from(DVec3::new(1.0, 3.0e3, 9.5e3));
    let cases: [(&str, View, &[Sphere]); 12] = [
        ("nothing", usual, &[]),
        ("one", usual, &pool[..1]),
        ("all in one place", usual, &one_place),
        ("quarantined", usual, &lost),
        ("a camera inside", inside, &pool),
        ("a camera behind", behind, &pool),
        ("a camera below", below, &pool),
        ("a camera at 10 km", far, &pool),
        ("one pixel", view([1, 1]), &pool),
        ("a row of 4096", view([4096, 2]), &pool),
        ("a row of 8192", view([8192, 1]), &pool),
        ("a column of 999", view([3, 999]), &pool),
    ];
    for tier in [Tier::Desktop, Tier::Floor] {
        for smoothing in [Smoothing::NarrowRange, Smoothing::CurvatureFlow] {
            for (what, view, spheres) in &cases {
                let options = FrameOptions { tier, supersample: 1, ..water(smoothing) };
                let picture = draw(view, &options, spheres);
                // A NaN is black: saturation takes it to 0. Nothing in these pictures is as dark as this.
                assert!(darkest(&picture) > 60, "{what}, {smoothing:?}: a hole, {}", darkest(&picture));
            }
        }
    }
    // What is quarantined is as if it were not there, also among others.
    let options = water(Smoothing::NarrowRange);
    let mixed: Vec<Sphere> = pool.iter().chain(&lost).copied().collect();
    assert!(similarity(&draw(&usual, &options, &mixed), &draw(&usual, &options, &pool)) > 0.9999);
    assert!(frame::FrameValues::new(&view([0, 9]), &options).is_err(), "no pixels");
}

#[test]
fn water_settings_that_cannot_be_drawn_are_refused_by_name() {
    let SurfaceOptions::ScreenSpace(good) = water(Smoothing::NarrowRange).surface else { panic!("water") };
    let cases = [
        (ScreenSpaceOptions { radius_m: 0.0, ..good }, "radius_m"),
        (ScreenSpaceOptions { spacing_m: f64::NAN, ..good }, "spacing_m"),
        (ScreenSpaceOptions { support_m: f64::INFINITY, ..good }, "support_m"),
        (ScreenSpaceOptions { smoothing_m: -1.0, ..good }, "smoothing_m"),
        (ScreenSpaceOptions { most_reach_px: 0, ..good }, "most_reach_px"),
        (ScreenSpaceOptions { thickness_divisor: 0, ..good }, "thickness_divisor"),
        (ScreenSpaceOptions { absorption_per_m: DVec3::NAN, ..good }, "absorption_per_m"),
        (ScreenSpaceOptions { refraction: 9.0, ..good }, "refraction"),
        (ScreenSpaceOptions { wall_bounds_m: [DVec3::ONE, DVec3::ZERO], ..good }, "wall_bounds_m"),
    ];
    for (surface, field) in cases {
        let options = FrameOptions { surface: SurfaceOptions::ScreenSpace(surface), ..options() };
        let error = frame::FrameValues::new(&view([9, 9]), &options).expect_err(field).to_string();
        assert!(error.contains(field), "{error}");
    }
}
