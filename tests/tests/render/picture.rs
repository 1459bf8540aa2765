//! Pictures against what geometry says must be in them.

use crate::support::{
    Picture, QUARANTINED, Sphere, compare_colors, compare_depth, draw, draw_moving, options, sphere, view,
};
use brooklet_fluid::Slots;
use brooklet_gpu::{Resources, Tier};
use brooklet_render::{Coloring, FrameOptions, Particles, View, frame};
use glam::DVec3;

/// Relative, of reversed depth, beyond what a device may displace: roundings of f32, most of them
/// in interpolating the floor's two huge triangles.
const DEPTH_TOLERANCE: f64 = 5e-5;
/// Two drawings of one picture: the device may round a channel the other way.
const SAME_STEPS: i32 = 1;

fn some_spheres() -> Vec<Sphere> {
    vec![
        sphere(0.4, 0.11, 0.5, 0),
        sphere(0.5, 0.21, 0.55, 1),
        sphere(1.0, 0.5, 0.5, 2),
        sphere(1.05, 0.52, 0.2, 3),
        sphere(1.7, 0.8, 0.9, 4),
        sphere(1.9, 0.11, 0.1, 5),
    ]
}

/// The pixel in which a point of the domain is seen.
fn pixel(view: &View, at_m: DVec3) -> (u32, u32) {
    let at = view.project(view.domain_min_m + at_m).expect("in front").at_px;
    (at.x as u32, at.y as u32)
}

#[test]
fn every_pixel_has_the_depth_of_the_sphere_that_covers_it() {
    for (size_px, supersample) in [([320, 180], 1), ([161, 93], 2)] {
        let view = view(size_px);
        let options = FrameOptions { supersample, ..options() };
        let spheres = some_spheres();
        let picture = draw(&view, &options, &spheres);
        let (worst, undecided) = compare_depth(&picture, &view, &options, &spheres, DEPTH_TOLERANCE)
            .unwrap_or_else(|error| panic!("{error}"));
        println!("draw_particles: depth within {worst:.1e} of {DEPTH_TOLERANCE:.0e}, {undecided} pixels on an outline");
        assert!(undecided < picture.depth.len() / 4, "{undecided} pixels were not compared");

        // The comparator notices a sphere that is half a pixel elsewhere, a little larger, or missing.
        let mut moved = spheres.clone();
        moved[2].at_m.x += 0.5 * view.diagonal_m() / f64::from(size_px[0]);
        let mut missing = spheres.clone();
        missing.pop();
        let larger = FrameOptions { radius_m: 1.02 * options.radius_m, ..options };
        for (wrong, options) in [(&moved, options), (&missing, options), (&spheres, larger)] {
            compare_depth(&picture, &view, &options, wrong, DEPTH_TOLERANCE).expect_err("a wrong twin must differ");
        }
    }
}

#[test]
fn a_sphere_covers_the_circle_that_geometry_says() {
    let view = view([320, 180]);
    let ball = sphere(1.0, 0.5, 0.5, 1);
    let with = draw(&view, &options(), &[ball]);
    let without = draw(&view, &options(), &[]);
    let center = view.project(view.domain_min_m + ball.at_m).expect("in front");
    // Angular radius asin(r/D); on the picture's middle that is a circle of r / sqrt(D^2 - r^2).
    let distance_m = (view.domain_min_m + ball.at_m - view.camera.eye_m).length();
    let radius_m = options().radius_m;
    let tan = radius_m / (distance_m * distance_m - radius_m * radius_m).sqrt();
    let radius_px = tan / view.tan_half().y * 0.5 * f64::from(view.size_px[1]);
    let mut covered = 0;
    for y in 0..view.size_px[1] {
        for x in 0..view.size_px[0] {
            let at = glam::DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let away_px = at.distance(center.at_px);
            let nearer = with.depth[(y * 320 + x) as usize] > without.depth[(y * 320 + x) as usize];
            covered += usize::from(nearer);
            // Away from the axis the outline is an ellipse, here at most 0.5 pixels off the circle.
            assert!(nearer || away_px > radius_px - 0.5, "hole at {x}, {y}");
            assert!(!nearer || away_px < radius_px + 0.5, "spill at {x}, {y}");
        }
    }
    let area = std::f64::consts::PI * radius_px * radius_px;
    assert!((covered as f64 / area - 1.0).abs() < 0.02, "{covered} pixels of {area:.0}");
}

#[test]
fn the_near_sphere_hides_the_far_one_in_either_order() {
    let view = view([160, 90]);
    let toward_eye = (view.camera.eye_m - view.domain_min_m - DVec3::new(1.0, 0.5, 0.5)).normalize();
    let near_m = DVec3::new(1.0, 0.5, 0.5) + 0.4 * toward_eye;
    let (far, near) = (sphere(1.0, 0.5, 0.5, 0), sphere(near_m.x, near_m.y, near_m.z, 1));
    let (x, y) = pixel(&view, far.at_m);
    for spheres in [[far, near], [near, far]] {
        let [red, _, blue] = draw(&view, &options(), &spheres).rgb(x, y);
        assert!(red > blue, "the near sphere is orange, not blue: {red} {blue}");
    }
    let [red, _, blue] = draw(&view, &options(), &[far]).rgb(x, y);
    assert!(blue > red, "alone, the far one is seen: {red} {blue}");
}

#[test]
fn a_quarantined_particle_is_not_drawn_wherever_it_is() {
    let view = view([160, 90]);
    let good = sphere(0.5, 0.3, 0.5, 0);
    let expected = draw(&view, &options(), &[good]);
    for at_m in [DVec3::new(1.2, 0.6, 0.6), DVec3::NAN, DVec3::INFINITY, DVec3::splat(-1e30)] {
        let bad = Sphere { at_m, tag: QUARANTINED };
        let got = draw(&view, &options(), &[bad, good, bad]);
        compare_colors(&got, &expected, SAME_STEPS).unwrap_or_else(|error| panic!("{at_m}: {error}"));
    }
    // The same particle unmarked is seen.
    let shown = draw(&view, &options(), &[good, sphere(1.2, 0.6, 0.6, 0)]);
    compare_colors(&shown, &expected, SAME_STEPS).expect_err("a drawn particle changes the picture");
}

#[test]
fn without_particles_there_is_floor_and_sky() {
    for size_px in [[160, 90], [1, 1], [3, 200]] {
        let view = view(size_px);
        for coloring in [Coloring::Fluid, Coloring::Speed { foam_m_s: 3.0 }] {
            let options = FrameOptions { coloring, ..options() };
            let picture = draw(&view, &options, &[]);
            // In a sliver of a picture the floor's corners lie so far outside that clipping moves them.
            if size_px[0] > 3 {
                compare_depth(&picture, &view, &options, &[], DEPTH_TOLERANCE)
                    .unwrap_or_else(|error| panic!("{error}"));
            }
            assert!((0..size_px[0]).all(|x| (0..size_px[1]).all(|y| picture.brightness(x, y) > 90)), "a dark hole");
        }
    }
}

#[test]
fn a_dense_block_has_no_holes() {
    let view = view([320, 180]);
    let options = FrameOptions { radius_m: 0.055, supersample: 2, ..options() };
    let cells = |count: u32| (0..count).map(|i| 0.05 + 0.1 * f64::from(i));
    let block: Vec<Sphere> =
        cells(8).flat_map(|x| cells(6).flat_map(move |y| cells(10).map(move |z| sphere(x, y, z, 0)))).collect();
    for coloring in [Coloring::Fluid, Coloring::Speed { foam_m_s: 3.0 }] {
        let picture = draw(&view, &FrameOptions { coloring, ..options }, &block);
        let darkest = (0..320).flat_map(|x| (0..180).map(move |y| (x, y))).map(|(x, y)| picture.brightness(x, y)).min();
        assert!(darkest > Some(24), "{darkest:?}");
    }
}

#[test]
fn pictures_repeat_and_a_wrong_one_is_noticed() {
    let view = view([160, 90]);
    let spheres = some_spheres();
    let first = draw(&view, &options(), &spheres);
    let second = draw(&view, &options(), &spheres);
    compare_colors(&second, &first, SAME_STEPS).unwrap_or_else(|error| panic!("{error}"));
    let mut moved = spheres.clone();
    moved[0].at_m.x += 0.02;
    compare_colors(&draw(&view, &options(), &moved), &first, SAME_STEPS).expect_err("a moved sphere");
    let other_fluid: Vec<Sphere> = spheres.iter().map(|s| Sphere { tag: 1 << 24, ..*s }).collect();
    compare_colors(&draw(&view, &options(), &other_fluid), &first, SAME_STEPS).expect_err("other colours");
}

#[test]
fn faster_is_whiter() {
    let view = view([160, 90]);
    let options = FrameOptions { coloring: Coloring::Speed { foam_m_s: 3.0 }, ..options() };
    let ball = sphere(1.0, 0.5, 0.5, 0);
    let (x, y) = pixel(&view, ball.at_m);
    let brightness: Vec<i32> = [0.0, 0.75, 1.5, 2.25, 3.0]
        .iter()
        .map(|&speed| draw_moving(&view, &options, &[ball], &[DVec3::new(0.0, -speed, 0.0)]).brightness(x, y))
        .collect();
    assert!(brightness.is_sorted_by(|a, b| a < b), "{brightness:?}");
}

#[test]
fn a_sphere_shades_the_floor_where_the_sun_says() {
    let view = view([320, 180]);
    // Toward the sun, as the frame's light has it.
    let values = brooklet_render::frame::FrameValues::new(&view, &options()).expect("values");
    let to_sun = glam::Vec3::from(values.light.to_sun).as_dvec3();
    let ball = sphere(0.9, 0.3, 0.5, 0);
    let shadow_m = ball.at_m - to_sun * (ball.at_m.y / to_sun.y);
    let (with, without) = (draw(&view, &options(), &[ball]), draw(&view, &options(), &[]));
    let darker = |at_m: DVec3| {
        let (x, y) = pixel(&view, at_m);
        f64::from(with.brightness(x, y)) / f64::from(without.brightness(x, y))
    };
    assert!(darker(shadow_m) < 0.85, "in the shadow: {}", darker(shadow_m));
    let lit_m = shadow_m + DVec3::new(0.45, 0.0, 0.3);
    assert!(darker(lit_m) > 0.98, "beside it: {}", darker(lit_m));
}

#[test]
fn the_floor_tier_draws_the_same_picture() {
    let view = view([160, 90]);
    let spheres = some_spheres();
    let desktop = draw(&view, &options(), &spheres);
    let floor = draw(&view, &FrameOptions { tier: Tier::Floor, ..options() }, &spheres);
    // Only depth has fewer bits: some pixels where spheres meet go the other way.
    let differing = |a: &Picture, b: &Picture| {
        let pixels = (0..90).flat_map(|y| (0..160).map(move |x| (x, y)));
        pixels.filter(|&(x, y)| (a.brightness(x, y) - b.brightness(x, y)).abs() > 12).count()
    };
    assert!(differing(&floor, &desktop) < 40, "{} pixels differ", differing(&floor, &desktop));
    assert!(differing(&floor, &draw(&view, &options(), &[])) > 400, "the comparator sees missing spheres");
}

/// Whoever brings no neighbours is told so, and not shown another colour.
#[test]
fn densities_of_particles_without_neighbours_are_refused() {
    let mut resources = Resources::new();
    let (positions, velocities) = (resources.persistent("positions", 1), resources.persistent("velocities", 1));
    let slots = Slots::declare(&mut resources, 1);
    let particles = Particles {
        positions: &positions,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let wanted = FrameOptions { coloring: Coloring::Density, ..options() };
    let error = frame::record(&mut resources, &view([16, 9]), &particles, &wanted).expect_err("no densities");
    assert!(error.to_string().contains("coloring"), "{error}");
}

#[test]
fn options_that_cannot_be_drawn_are_refused_by_name() {
    let view = view([160, 90]);
    let cases = [
        (FrameOptions { radius_m: 0.0, ..options() }, "radius_m"),
        (FrameOptions { radius_m: f64::NAN, ..options() }, "radius_m"),
        (FrameOptions { supersample: 0, ..options() }, "supersample"),
        (FrameOptions { supersample: 9, ..options() }, "supersample"),
        (FrameOptions { shadow_texels: 1, ..options() }, "shadow_texels"),
        (FrameOptions { coloring: Coloring::Speed { foam_m_s: 0.0 }, ..options() }, "foam_m_s"),
    ];
    for (options, field) in cases {
        let error = brooklet_render::frame::FrameValues::new(&view, &options).expect_err(field).to_string();
        assert!(error.contains(field), "{error}");
    }
}
