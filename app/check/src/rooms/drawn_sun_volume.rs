//! The water's own shadow: how much water is nearer the sun, against its twins and against what geometry says of a ball
//! over a pool, and where a picture is the darker for it.

use crate::cases::{out_of_part, vectors};
use crate::device::Device;
use crate::drawn::record_frame;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq, note};
use brooklet_fluid::particles::is_simulated;
use brooklet_fluid::scene::Smoothing;
use brooklet_gpu::Plan;
use brooklet_kernels::{FrameLight, FrameView, Position, SunVolumeParams};
use brooklet_reference::surface::sun_volume::{count_sun_volume, sum_sun_volume, water_toward_sun};
use brooklet_render::frame::FrameValues;
use brooklet_render::surface::screen_space::sun_volume;
use brooklet_render::{Camera, Coloring, FrameOptions, ScreenSpaceOptions, SurfaceOptions, View};
use glam::DVec3;
use rand::RngExt as _;

const SPACING_M: f64 = 0.03;
/// Side of the picture, pixels.
const SIDE_PX: u32 = 96;
/// Of a sum over a ray, relative: one product of f32.
const SUM_TOLERANCE: f64 = 1e-6;

fn view() -> View {
    View {
        camera: Camera { eye_m: DVec3::new(0.5, 2.2, 1.8), target_m: DVec3::new(0.55, 0.3, 0.5), fov_deg: 32.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px: [SIDE_PX; 2],
    }
}

fn options(device: &Device, self_shadow: bool) -> FrameOptions {
    let surface = ScreenSpaceOptions {
        spacing_m: SPACING_M,
        radius_m: 0.75 * SPACING_M,
        wall_bounds_m: [DVec3::ZERO, DVec3::ONE],
        anisotropic: false,
        support_m: 2.0 * SPACING_M,
        smoothing: Smoothing::NarrowRange,
        iterations: 1,
        smoothing_m: 2.0 * SPACING_M,
        most_reach_px: 24,
        range_m: 0.07,
        clamp_m: 0.02,
        thickness_divisor: 2,
        absorption_per_m: DVec3::new(7.0, 1.7, 0.75),
        refraction: 1.0,
        metal_reflectance: None,
        photons: 0,
        self_shadow,
    };
    FrameOptions {
        tier: device.gpu().tier(),
        surface: SurfaceOptions::ScreenSpace(surface),
        radius_m: 0.02,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 128,
        edges: false,
        diffuse: None,
    }
}

struct Drawn {
    counts: Vec<u32>,
    above_m: Vec<f64>,
    rgba: Vec<u8>,
}

/// What `positions` look like, and the volume, if the water shades itself.
fn draw(device: &Device, positions: &[Position], self_shadow: bool) -> Drawn {
    let (resources, passes) = record_frame(&view(), &options(device, self_shadow), positions);
    let volume = passes.water.or_raise().sun_volume;
    let wanted = volume.iter().flat_map(|volume| [volume.counts.id, volume.above_m.id]);
    let wanted: Vec<_> = wanted.chain([passes.color.id]).collect();
    let ids = [passes.init.id(), passes.draw.id()];
    let plan = Plan::sweep(resources, vec![passes.init, passes.draw], &wanted).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids, &[]).or_raise();
    let rgba = engine.read_texture(&passes.color).or_raise();
    let (counts, above_m) = volume.map_or((Vec::new(), Vec::new()), |volume| {
        let above_m = engine.read(&volume.above_m).or_raise();
        (engine.read(&volume.counts).or_raise(), above_m.into_iter().map(f64::from).collect())
    });
    Drawn { counts, above_m, rgba }
}

fn given(device: &Device) -> (SunVolumeParams, FrameLight, FrameView) {
    let values = FrameValues::new(&view(), &options(device, true)).or_raise();
    (sun_volume::params(SPACING_M, &values.light), values.light, values.view)
}

/// How many counts differ, and the largest difference.
fn differences(got: &[u32], expected: &[u32]) -> (usize, u32) {
    ensure_eq!(got.len(), expected.len());
    let differences = got.iter().zip(expected).map(|(got, expected)| got.abs_diff(*expected));
    differences.fold((0, 0), |(count, worst), by| (count + usize::from(by > 0), worst.max(by)))
}

pub(crate) fn the_suns_volume_is_its_twin(device: &Device) {
    let (params, light, _) = given(device);
    for count in [0u32, 1, 63, 64, 65, 5003] {
        let mut rng = rng(101);
        let mut positions: Vec<Position> = (0..count)
            .map(|i| Position {
                // Some lie outside of the sun's map.
                position_m: std::array::from_fn(|_| 2.4 * rng.random::<f32>() - 0.7),
                tag: out_of_part(i as usize),
            })
            .collect();
        if count > 1 {
            positions[1].position_m = [f32::NAN; 3];
        }
        let drawn = draw(device, &positions, true);
        let seen: Vec<Position> = positions.iter().copied().filter(|p| is_simulated(p.tag)).collect();
        let expected = count_sun_volume(&vectors(&seen), &params, &light);
        let (beyond, worst) = differences(&drawn.counts, &expected);
        note!(device, "kernel count_sun_volume, {count} particles: {beyond} counts differ, by {worst} at most");
        // A weight is a whole number of 128ths: where f32 and f64 fall to two sides of a half, they differ by one.
        ensure!(beyond as u32 <= count / 100 + 1 && worst <= 1, "{beyond}, {worst}");

        let sums = sum_sun_volume(&drawn.counts, &params);
        let is_off = |(got, expected): (&f64, &f64)| (got - expected).abs() > SUM_TOLERANCE * expected;
        ensure!(!drawn.above_m.iter().zip(&sums).any(is_off), "sum_sun_volume, {count} particles");
        if count == 5003 {
            let moved: Vec<DVec3> = vectors(&seen).into_iter().map(|at_m| at_m + 0.1 * SPACING_M).collect();
            let (beyond, _) = differences(&drawn.counts, &count_sun_volume(&moved, &params, &light));
            ensure!(beyond > 5003, "particles a tenth of a spacing off must differ: {beyond}");
            let mut more = drawn.counts.clone();
            more[params.cells as usize * 77] += 1;
            let wrong = sum_sun_volume(&more, &params);
            ensure!(drawn.above_m.iter().zip(&wrong).any(is_off), "one unit more must differ");
        }
    }
}

const BALL_M: (DVec3, f64) = (DVec3::new(0.33, 0.75, 0.33), 0.12);
const TOP_M: f64 = 0.3;

fn lattice(inside: impl Fn(DVec3) -> bool) -> Vec<Position> {
    let side = (1.0 / SPACING_M) as u32;
    let at = |i: u32| [i % side, i / side % side, i / side / side].map(|n| SPACING_M * (f64::from(n) + 0.5));
    let all = (0..side.pow(3)).map(|i| DVec3::from_array(at(i))).filter(|&at_m| inside(at_m));
    all.enumerate().map(|(i, at_m)| Position { position_m: at_m.as_vec3().into(), tag: i as u32 }).collect()
}

pub(crate) fn a_ball_shades_the_pool_below_it(device: &Device) {
    let (params, light, view) = given(device);
    let in_pool = |at_m: DVec3| at_m.y < TOP_M;
    let in_ball = |at_m: DVec3| (at_m - BALL_M.0).length() < BALL_M.1;
    let to_sun = DVec3::from_array(light.to_sun.map(f64::from));
    let shaded_m = BALL_M.0 - to_sun * ((BALL_M.0.y - TOP_M) / to_sun.y);
    let lit_m = DVec3::new(0.3, TOP_M, 0.75);

    let with_ball = lattice(|at_m| in_pool(at_m) || in_ball(at_m));
    let drawn = draw(device, &with_ball, true);
    let above_m = |at_m: DVec3| water_toward_sun(&drawn.above_m, &params, &light, at_m);
    let (shaded, lit) = (above_m(shaded_m), above_m(lit_m));
    note!(device, "water toward the sun: {shaded:.3} m below a ball of {:.3} m, {lit:.4} m beside", 2.0 * BALL_M.1);
    // Tents of two spacings take some of the middle of so small a ball aside.
    ensure!((shaded / (2.0 * BALL_M.1) - 1.0).abs() < 0.2, "{shaded}");
    ensure!(lit < 0.3 * SPACING_M, "calm water does not shade itself: {lit}");

    let pixel = |at_m: DVec3| {
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let offset_m = at_m - vector(view.eye_m);
        let ahead_m = offset_m.dot(vector(view.forward));
        let x = offset_m.dot(vector(view.right)) / (ahead_m * f64::from(view.tan_half_width));
        let y = offset_m.dot(vector(view.up)) / (ahead_m * f64::from(view.tan_half_height));
        let [x, y] = [0.5 + 0.5 * x, 0.5 - 0.5 * y].map(|at| (at * f64::from(SIDE_PX)) as usize);
        4 * (y * SIDE_PX as usize + x)
    };
    // How much darker red, green and blue are where the water shades itself.
    let darker = |positions: &[Position], at_m: DVec3| -> i32 {
        let [with, without] = [true, false].map(|self_shadow| draw(device, positions, self_shadow).rgba);
        let at = pixel(at_m);
        (at..at + 3).map(|channel| i32::from(without[channel]) - i32::from(with[channel])).sum()
    };
    let calm = lattice(in_pool);
    let [below, beside, none] =
        [(&with_ball, shaded_m), (&with_ball, lit_m), (&calm, shaded_m)].map(|(of, at_m)| darker(of, at_m));
    note!(device, "darker by {below} of 765 below the ball, {beside} beside it, {none} without one");
    ensure!(below > 15 && beside.abs() <= 3 && none.abs() <= 3, "{below} {beside} {none}");
}
