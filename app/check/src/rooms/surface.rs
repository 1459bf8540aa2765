//! Smoothing filters and normals of the surface in screen space, against their twins: the twin
//! gets the raw surface that the device drew, bit for bit.

use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{Named as _, OrRaise as _, Wrong, ensure, ensure_eq, note};
use brooklet_fluid::Slots;
use brooklet_fluid::scene::Smoothing;
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::{FrameView, Position, QUARANTINED, SurfaceParams};
use brooklet_reference::surface::smooth_bilateral::smooth_bilateral;
use brooklet_reference::surface::smooth_curvature_flow::smooth_curvature_flow;
use brooklet_reference::surface::smooth_gaussian::smooth_gaussian;
use brooklet_reference::surface::smooth_narrow_range::smooth_narrow_range;
use brooklet_reference::surface::surface_normals::surface_normals;
use brooklet_reference::surface::{Along, InverseDepth};
use brooklet_render::frame::FrameValues;
use brooklet_render::surface::screen_space::{self, ScreenSpaceOptions};
use brooklet_render::{Camera, Coloring, FrameOptions, Particles, SurfaceOptions, View};
use glam::DVec3;
use rand::RngExt as _;

/// Of a pixel's inverse_depth. Sums of at most 260 taps whose weights come from a device's `exp`, with
/// errors of a few roundings each, that weigh differences of at most a tenth.
const FILTER_TOLERANCE: f64 = 2e-6;
/// Share of the fluid's pixels where f32 may decide a comparison of depths the other way than f64.
const UNDECIDED: f64 = 2e-3;
/// Angle in radians: slopes are exact differences of neighbouring f32 numbers, then a few roundings.
const NORMAL_TOLERANCE: f64 = 1e-5;

/// Sizes that no block of 2, 4, 8 or 16 pixels divides, and a sliver.
const SIZES: [[u32; 2]; 3] = [[161, 93], [64, 48], [3, 37]];

fn view(size_px: [u32; 2], distance_m: f64) -> View {
    View {
        camera: Camera { eye_m: DVec3::new(0.7, 0.9, distance_m), target_m: DVec3::new(0.5, 0.4, 0.5), fov_deg: 32.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px,
    }
}

fn options(smoothing: Smoothing, iterations: u32) -> ScreenSpaceOptions {
    ScreenSpaceOptions {
        spacing_m: 0.05,
        radius_m: 0.04,
        wall_bounds_m: [DVec3::ZERO, DVec3::ONE],
        anisotropic: false,
        support_m: 0.1,
        smoothing,
        iterations,
        smoothing_m: 0.1,
        most_reach_px: 24,
        range_m: 0.1,
        clamp_m: 0.04,
        thickness_divisor: 2,
        absorption_per_m: DVec3::ONE,
        refraction: 1.0,
        metal_reflectance: None,
        photons: 0,
        self_shadow: false,
    }
}

/// A rough pool with a splash above it: slopes, steps from one surface to another, and holes.
fn particles(seed: u64) -> Vec<Position> {
    let mut rng = rng(seed);
    let mut at = |x: f64, y: f64, z: f64| {
        let mut jitter = || 0.01 * (rng.random::<f64>() - 0.5);
        Position { position_m: [x + jitter(), y + jitter(), z + jitter()].map(|v| v as f32), tag: 0 }
    };
    let mut all: Vec<Position> = (0..20 * 20 * 8)
        .map(|i| {
            at(
                0.025 + 0.05 * f64::from(i % 20),
                0.025 + 0.05 * f64::from(i / 400),
                0.025 + 0.05 * f64::from(i / 20 % 20),
            )
        })
        .collect();
    let mut rng = crate::numbers::rng(seed + 1);
    all.extend((0..60).map(|i| Position {
        position_m: [0.2 + 0.6 * rng.random::<f32>(), 0.45 + 0.4 * rng.random::<f32>(), rng.random::<f32>()],
        tag: crate::cases::out_of_part(i),
    }));
    all
}

struct Drawn {
    raw: InverseDepth,
    smoothed: InverseDepth,
    normals: Vec<[f32; 4]>,
    params: SurfaceParams,
    view: FrameView,
}

/// The smoothed surface of particles, by the room's own entry point.
fn draw(device: &Device, view: &View, options: &ScreenSpaceOptions, positions: &[Position]) -> Drawn {
    let tier = device.gpu().tier();
    let frame = FrameOptions {
        tier,
        surface: SurfaceOptions::ScreenSpace(*options),
        radius_m: 0.03,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 64,
        edges: false,
        diffuse: None,
    };
    let values = FrameValues::new(view, &frame).or_raise();
    let count = positions.len() as u32;
    let mut resources = Resources::new();
    let buffer = resources.persistent::<Position>("positions", count);
    let velocities = resources.persistent("velocities", count);
    let mut frame_view = resources.persistent("frame_view", 1);
    let (mut init, mut recording) = (resources.recording("init"), resources.recording("draw"));
    init.upload(&mut frame_view, &[values.view]);
    let slots = Slots::declare(&mut resources, count);
    let particles = Particles {
        positions: &buffer,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let into = (&mut init, &mut recording);
    let surface = screen_space::record(&mut resources, into, &frame_view, &particles, view.size_px, tier, options);
    let wanted = [surface.raw.id, surface.inverse_depth.id, surface.normals.id];
    let ids = [init.id(), recording.id()];
    let plan = Plan::sweep(resources, vec![init, recording], &wanted).or_raise();
    let mut engine = device.engine(plan);
    if count > 0 {
        engine.write(&buffer, positions);
    }
    engine.run(&ids, &[]).or_raise();
    let mut read = |texture| {
        let values: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(texture).or_raise());
        InverseDepth {
            size_px: view.size_px.map(|side| side as usize),
            values: values.into_iter().map(f64::from).collect(),
        }
    };
    let (raw, smoothed) = (read(&surface.raw), read(&surface.inverse_depth));
    let normals = bytemuck::pod_collect_to_vec(&engine.read_texture(&surface.normals).or_raise());
    Drawn { raw, smoothed, normals, params: options.params(), view: values.view }
}

fn twin(drawn: &Drawn, smoothing: Smoothing, iterations: u32, params: &SurfaceParams) -> InverseDepth {
    let view = &drawn.view;
    let mut inverse_depth = drawn.raw.clone();
    for _ in 0..iterations {
        inverse_depth = match smoothing {
            Smoothing::None => inverse_depth,
            Smoothing::Gaussian => {
                smooth_gaussian(&smooth_gaussian(&inverse_depth, params, view, Along::X), params, view, Along::Y)
            }
            Smoothing::Bilateral => {
                smooth_bilateral(&smooth_bilateral(&inverse_depth, params, view, Along::X), params, view, Along::Y)
            }
            Smoothing::Bilateral2d => smooth_bilateral(&inverse_depth, params, view, Along::Plane),
            Smoothing::NarrowRange => smooth_narrow_range(
                &smooth_narrow_range(&inverse_depth, params, view, Along::X),
                params,
                view,
                Along::Y,
            ),
            Smoothing::CurvatureFlow => smooth_curvature_flow(&inverse_depth, params, view),
        };
    }
    match smoothing {
        Smoothing::NarrowRange => smooth_narrow_range(&inverse_depth, params, view, Along::Plane),
        _ => inverse_depth,
    }
}

/// Largest relative difference of pixels that agree, and how many do not.
fn compare(got: &InverseDepth, expected: &InverseDepth) -> Result<(f64, usize), Wrong> {
    let covered = expected.values.iter().filter(|&&value| value > 0.0).count();
    let (mut worst, mut beyond) = (0.0f64, 0);
    for (index, (&got, &expected)) in got.values.iter().zip(&expected.values).enumerate() {
        let difference = (got - expected).abs() / expected.max(1e-9);
        if (got > 0.0) != (expected > 0.0) {
            return Err(format!("pixel {index}: inverse_depth {got}, expected {expected}").into());
        }
        match difference <= FILTER_TOLERANCE {
            true => worst = worst.max(difference),
            false => beyond += 1,
        }
    }
    match beyond as f64 <= UNDECIDED * covered as f64 {
        true => Ok((worst, beyond)),
        false => Err(format!("{beyond} of {covered} pixels differ by more than {FILTER_TOLERANCE:e}").into()),
    }
}

pub(crate) fn every_filter_is_its_twin(device: &Device) {
    let filters = [
        (Smoothing::NarrowRange, 1),
        (Smoothing::NarrowRange, 2),
        (Smoothing::CurvatureFlow, 12),
        (Smoothing::Bilateral, 1),
        (Smoothing::Bilateral2d, 1),
        (Smoothing::Gaussian, 1),
        (Smoothing::None, 3),
    ];
    let particles = particles(31);
    for (smoothing, iterations) in filters {
        for size_px in SIZES {
            // Near, where the reach is clamped, and far.
            for distance_m in [2.2, 6.0] {
                let options = options(smoothing, iterations);
                let drawn = draw(device, &view(size_px, distance_m), &options, &particles);
                ensure!(
                    size_px[0] < 10 || drawn.raw.values.iter().filter(|&&v| v > 0.0).count() > 100,
                    "little is seen"
                );
                let expected = twin(&drawn, smoothing, iterations, &drawn.params);
                let (worst, beyond) =
                    compare(&drawn.smoothed, &expected).named(format_args!("{smoothing:?} {size_px:?} {distance_m} m"));
                device.compared("draw_smooth", drawn.smoothed.values.len(), [worst, FILTER_TOLERANCE]);
                if size_px == SIZES[0] {
                    note!(
                        device,
                        "kernel smooth {smoothing:?} x{iterations}: tolerance {FILTER_TOLERANCE:.0e}, largest difference {worst:.1e}, {beyond} undecided"
                    );
                }
                // The comparator notices a filter that reaches a tenth further, or flows less.
                if smoothing != Smoothing::None && size_px == SIZES[0] && distance_m < 3.0 {
                    let params = SurfaceParams {
                        smoothing_m: 1.1 * drawn.params.smoothing_m,
                        most_reach_px: 1.1 * drawn.params.most_reach_px,
                        flow_m2: 0.3 * drawn.params.flow_m2,
                        ..drawn.params
                    };
                    let wrong = twin(&drawn, smoothing, iterations, &params);
                    compare(&drawn.smoothed, &wrong).expect_err("a wrong reach must differ");
                }
            }
        }
    }
}

pub(crate) fn normals_are_their_twins(device: &Device) {
    let particles = particles(32);
    let mut worst = 0.0f64;
    for size_px in SIZES {
        let drawn = draw(device, &view(size_px, 2.2), &options(Smoothing::NarrowRange, 1), &particles);
        let expected = surface_normals(&drawn.smoothed, &drawn.params, &drawn.view);
        let mut undecided = 0;
        for (got, expected) in drawn.normals.iter().zip(&expected) {
            let normal = DVec3::new(f64::from(got[0]), f64::from(got[1]), f64::from(got[2]));
            match expected {
                None => ensure_eq!(*got, [0.0; 4]),
                Some(expected) if (normal - expected).length() <= NORMAL_TOLERANCE => {
                    worst = worst.max((normal - expected).length());
                    ensure_eq!(got[3], 1.0);
                }
                Some(_) => undecided += 1,
            }
        }
        ensure!(undecided as f64 <= UNDECIDED * expected.len() as f64, "{undecided} normals differ");
        // Fed another surface's normals, the comparison fails.
        let other = surface_normals(&drawn.raw, &drawn.params, &drawn.view);
        let differing = expected.iter().zip(&other).filter(|(a, b)| match (a, b) {
            (Some(a), Some(b)) => (*a - *b).length() > NORMAL_TOLERANCE,
            _ => false,
        });
        ensure!(differing.count() as f64 > 0.05 * expected.len() as f64 || size_px[0] < 10, "it cannot fail");
    }
    device.compared("draw_surface_normals", 1, [worst, NORMAL_TOLERANCE]);
    note!(device, "kernel surface_normals: tolerance {NORMAL_TOLERANCE:.0e}, largest difference {worst:.1e}");
}

pub(crate) fn nothing_and_one_particle_make_no_holes_in_numbers(device: &Device) {
    for smoothing in [Smoothing::NarrowRange, Smoothing::CurvatureFlow, Smoothing::Bilateral2d, Smoothing::Gaussian] {
        let empty = draw(device, &view([37, 21], 2.2), &options(smoothing, 2), &[]);
        ensure!(empty.smoothed.values.iter().all(|&value| value == 0.0));
        let one = [Position { position_m: [0.5, 0.5, 0.5], tag: 0 }];
        let one = draw(device, &view([37, 21], 2.2), &options(smoothing, 2), &one);
        ensure!(one.smoothed.values.iter().any(|&value| value > 0.0));
        ensure!(one.smoothed.values.iter().all(|value| value.is_finite()));
        // Quarantined ones, wherever they are, draw nothing.
        let lost = [f32::NAN, f32::INFINITY, 0.5].map(|x| Position { position_m: [x; 3], tag: QUARANTINED });
        let lost = draw(device, &view([37, 21], 2.2), &options(smoothing, 2), &lost);
        ensure!(lost.smoothed.values.iter().all(|&value| value == 0.0));
    }
}
