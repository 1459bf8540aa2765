//! What is drawn of each particle before anything smooths: the nearest sphere, and how much fluid the eye looks
//! through, against their twins.

use crate::cases::{out_of_part, vectors};
use crate::compare::nearest_of;
use crate::device::Device;
use crate::drawn::record_frame;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq, note};
use brooklet_fluid::particles::is_simulated;
use brooklet_fluid::scene::Smoothing;
use brooklet_gpu::{Plan, Tier};
use brooklet_kernels::{FrameView, Position, SurfaceParams};
use brooklet_reference::surface::InverseDepth;
use brooklet_reference::surface::fluid_depth::fluid_depth;
use brooklet_reference::surface::thickness::{opaque_planes, thickness};
use brooklet_render::frame::FrameValues;
use brooklet_render::{Camera, Coloring, FrameOptions, ScreenSpaceOptions, SurfaceOptions, View};
use glam::{DVec2, DVec3, DVec4};
use rand::RngExt as _;

/// Of a pixel's inverse_depth: a few roundings, at slopes of up to 10.
const INVERSE_DEPTH_TOLERANCE: f64 = 1e-5;
/// Of the thickest place: some tens of discs add up in f16, each sum rounded to 2^-11 of itself, and a device may
/// move a disc by a sixteenth of a pixel of some eight that it is wide.
const THICKNESS_TOLERANCE: f64 = 0.02;
/// Share of the covered pixels whose rays graze a sphere: there no tolerance would do.
const GRAZING: f64 = 0.005;
/// Of a distance to a plane, in half spacings, at about 2 m: slopes are differences of neighbours' depths, f32's roundings of
/// which (24 bits at the floor tier, of the whole range) reach over some hundred pixels.
fn plane_tolerance(device: &Device) -> f64 {
    if device.gpu().tier() == Tier::Floor { 0.3 } else { 1e-3 }
}
/// Sizes that no block of 2, 4, 8 or 16 pixels divides, and a sliver.
const SIZES: [[u32; 2]; 3] = [[161, 93], [64, 48], [3, 37]];

fn particles() -> Vec<Position> {
    let mut rng = rng(81);
    let mut all: Vec<Position> = (0..12 * 12 * 4)
        .map(|i| {
            let at = [i % 12, i / 144, i / 12 % 12].map(|n| 0.04 + 0.08 * (f64::from(n) + 0.4 * rng.random::<f64>()));
            Position { position_m: at.map(|x| x as f32), tag: 0 }
        })
        .collect();
    all.extend((0..60).map(|i| Position {
        position_m: [rng.random(), 0.3 + 0.6 * rng.random::<f32>(), rng.random()],
        tag: out_of_part(i),
    }));
    // Around and below the floor, which hides them.
    all.extend(
        (0..80)
            .map(|i| Position { position_m: [rng.random(), -0.2 + 0.22 * rng.random::<f32>(), rng.random()], tag: i }),
    );
    all
}

/// Inverse depth of the floor, y = 0, as far as it is drawn around the middle of the domain.
fn floor_depth(view: &FrameView, size_px: [usize; 2], reach_m: f64) -> InverseDepth {
    let [width, height] = size_px;
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let inverse_depth = |i: usize| {
        let x = 2.0 * ((i % width) as f64 + 0.5) / width as f64 - 1.0;
        let y = 1.0 - 2.0 * ((i / width) as f64 + 0.5) / height as f64;
        let ray = vector(view.forward)
            + x * f64::from(view.tan_half_width) * vector(view.right)
            + y * f64::from(view.tan_half_height) * vector(view.up);
        let inverse_depth = -ray.y / f64::from(view.eye_m[1]);
        let at_m = vector(view.eye_m) + ray / inverse_depth - DVec3::new(0.5, 0.0, 0.5);
        let is_drawn = inverse_depth > 0.0 && at_m.abs().max_element() < reach_m;
        if is_drawn { inverse_depth } else { 0.0 }
    };
    InverseDepth { size_px, values: (0..width * height).map(inverse_depth).collect() }
}

struct Drawn {
    inverse_depth: Vec<f64>,
    thickness: Vec<f64>,
    thickness_px: [usize; 2],
    /// What is opaque: the floor.
    scene: InverseDepth,
    planes: Vec<DVec4>,
    params: SurfaceParams,
    view: FrameView,
}

fn draw(device: &Device, size_px: [u32; 2], eye_m: DVec3, positions: &[Position]) -> Drawn {
    let view = View {
        camera: Camera { eye_m, target_m: DVec3::new(0.5, 0.3, 0.5), fov_deg: 32.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px,
    };
    let surface = ScreenSpaceOptions {
        spacing_m: 0.08,
        radius_m: 0.06,
        wall_bounds_m: [DVec3::ZERO, DVec3::ONE],
        anisotropic: false,
        support_m: 0.16,
        smoothing: Smoothing::None,
        iterations: 0,
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
    };
    let options = FrameOptions {
        tier: device.gpu().tier(),
        surface: SurfaceOptions::ScreenSpace(surface),
        radius_m: 0.03,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 64,
        edges: false,
        diffuse: None,
    };
    let (resources, passes) = record_frame(&view, &options, positions);
    let water = passes.water.or_raise();
    let ids = [passes.init.id(), passes.draw.id()];
    let plan = Plan::sweep(
        resources,
        vec![passes.init, passes.draw],
        &[water.surface.raw.id, water.thickness.eye.id, water.thickness.opaque_planes.id, passes.depth.id],
    )
    .or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids, &[]).or_raise();
    let inverse_depth: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(&water.surface.raw).or_raise());
    let halves = engine.read_texture(&water.thickness.eye).or_raise();
    let halves = halves.chunks_exact(2).map(|pair| half::f16::from_le_bytes([pair[0], pair[1]]));
    let FrameValues { view: values, style, .. } = FrameValues::new(&view, &options).or_raise();
    let size = size_px.map(|side| side as usize);
    let scene = match options.tier {
        // Its depth cannot be read back: y = 0.
        Tier::Floor => floor_depth(&values, size, 4.0 * f64::from(style.floor_fade_m)),
        _ => {
            let depth: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(&passes.depth).or_raise());
            let values = depth.into_iter().map(|depth| f64::from(depth) / f64::from(values.near_m));
            InverseDepth { size_px: size, values: values.collect() }
        }
    };
    let planes: Vec<[f32; 4]> =
        bytemuck::pod_collect_to_vec(&engine.read_texture(&water.thickness.opaque_planes).or_raise());
    Drawn {
        planes: planes.into_iter().map(|plane| DVec4::from_array(plane.map(f64::from))).collect(),
        scene,
        inverse_depth: inverse_depth.into_iter().map(f64::from).collect(),
        thickness: halves.map(f64::from).collect(),
        thickness_px: water.thickness.eye.size_px.map(|side| side as usize),
        params: surface.params(),
        view: values,
    }
}

/// How many of the covered are beyond the tolerance, which may be relative to each or absolute; and the largest
/// difference of the others.
fn beyond(got: &[f64], expected: &[f64], tolerance: impl Fn(f64) -> f64) -> (usize, usize, f64) {
    ensure_eq!(got.len(), expected.len());
    let covered = expected.iter().filter(|&&value| value > 0.0).count();
    let differences = got.iter().zip(expected).map(|(got, expected)| (got - expected).abs() / tolerance(*expected));
    // Written so that a NaN is beyond.
    let within: Vec<f64> = differences.filter(|difference| *difference <= 1.0).collect();
    (covered, got.len() - within.len(), within.into_iter().fold(0.0, f64::max))
}

pub(crate) fn the_nearest_spheres_and_their_thickness_are_their_twins(device: &Device) {
    let positions = particles();
    let seen: Vec<Position> = positions.iter().copied().filter(|p| is_simulated(p.tag)).collect();
    let centers_m = vectors(&seen);
    for size_px in SIZES {
        for eye_m in [DVec3::new(0.7, 0.9, 2.6), DVec3::new(-1.4, 0.4, 0.3), DVec3::new(0.45, 0.5, 0.8)] {
            let drawn = draw(device, size_px, eye_m, &positions);
            let is_large = size_px[0] > 10;

            // What of the depths around a pixel's middle, as far as a device may move a sphere, is nearest.
            let snap_px = device.snap_px();
            let depth_of = |params: &SurfaceParams| {
                let aside = [DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
                let around = aside.map(|aside| fluid_depth(&centers_m, params, &drawn.view, snap_px * aside).values);
                nearest_of(&drawn.inverse_depth, &around)
            };
            let relative = |inverse_depth: f64| INVERSE_DEPTH_TOLERANCE * inverse_depth.max(1e-9);
            let (covered, off, worst) = beyond(&drawn.inverse_depth, &depth_of(&drawn.params), relative);
            device.compared("draw_fluid_depth", covered, [worst * INVERSE_DEPTH_TOLERANCE, INVERSE_DEPTH_TOLERANCE]);
            note!(
                device,
                "kernel fluid_depth {size_px:?}: {off} of {covered} pixels beyond {INVERSE_DEPTH_TOLERANCE:.0e}, the others within {worst:.2} of it"
            );
            ensure!(
                off as f64 <= GRAZING * covered as f64 + 1.0 && (covered > 1000 || !is_large),
                "{off} of {covered}"
            );
            // Spheres a hundredth larger; a twentieth where they may be moved by a sixteenth of a pixel.
            let larger = 1.0 + f64::max(0.01, 0.8 * snap_px);
            let wrong = SurfaceParams { radius_m: larger as f32 * drawn.params.radius_m, ..drawn.params };
            let (_, off, _) = beyond(&drawn.inverse_depth, &depth_of(&wrong), relative);
            ensure!(off as f64 > 0.3 * covered as f64, "spheres {larger} as large must differ: {off} of {covered}");

            // How far points of the fluid lie before the planes, in half spacings.
            let ahead = |planes: &[DVec4]| -> Vec<f64> {
                let middle_m = DVec3::new(0.5, 0.1, 0.5) - DVec3::from_array(drawn.view.eye_m.map(f64::from));
                planes.iter().map(|plane| plane.w - plane.truncate().dot(middle_m)).collect()
            };
            let planes_of =
                |params: &SurfaceParams| opaque_planes(&drawn.scene, params, &drawn.view, drawn.thickness_px);
            let (_, off, worst) =
                beyond(&ahead(&drawn.planes), &ahead(&planes_of(&drawn.params)), |_| plane_tolerance(device));
            let texels = drawn.planes.len() as f64;
            device.compared(
                "draw_opaque_planes",
                drawn.planes.len(),
                [worst * plane_tolerance(device), plane_tolerance(device)],
            );
            note!(
                device,
                "kernel opaque_planes {size_px:?}: {off} of {texels} texels beyond {:.0e}, the others within {worst:.2} of it",
                plane_tolerance(device)
            );
            ensure!(off as f64 <= GRAZING * texels, "{off} of {texels}");
            let wrong = SurfaceParams { spacing_m: 1.5 * drawn.params.spacing_m, ..drawn.params };
            let (_, off, _) = beyond(&ahead(&drawn.planes), &ahead(&planes_of(&wrong)), |_| plane_tolerance(device));
            ensure!(off as f64 > 0.3 * texels, "half spacings half as long again must differ: {off} of {texels}");

            let before = |planes: &[DVec4], params: &SurfaceParams| {
                thickness(&centers_m, params, &drawn.view, drawn.thickness_px, planes)
            };
            let through = |params: &SurfaceParams| before(&drawn.planes, params);
            let expected = through(&drawn.params);
            let most = expected.iter().fold(0.0, |most: f64, t| most.max(*t));
            let (covered, off, worst) = beyond(&drawn.thickness, &expected, |_| THICKNESS_TOLERANCE * most);
            device.compared("draw_thickness", covered, [worst * THICKNESS_TOLERANCE, THICKNESS_TOLERANCE]);
            note!(
                device,
                "kernel thickness {size_px:?}: {off} of {covered} texels beyond {:.0e} of {most:.2} spacings, the others within {worst:.2} of it",
                THICKNESS_TOLERANCE
            );
            ensure!(off as f64 <= GRAZING * covered as f64, "{off} of {covered}");
            let wrong = SurfaceParams { spacing_m: 1.05 * drawn.params.spacing_m, ..drawn.params };
            let (_, off, _) = beyond(&drawn.thickness, &through(&wrong), |_| THICKNESS_TOLERANCE * most);
            ensure!(off as f64 > 0.1 * covered as f64, "a twentieth more spacing must differ: {off} of {covered}");
            let nothing = vec![DVec4::W; drawn.planes.len()];
            let (_, off, _) =
                beyond(&drawn.thickness, &before(&nothing, &drawn.params), |_| THICKNESS_TOLERANCE * most);
            ensure!(
                off as f64 > 0.03 * covered as f64 || !is_large,
                "without a floor more would be seen: {off} of {covered}"
            );
        }
    }
}

/// Thickness spreads each particle's volume: what all rays look through is all the fluid there is.
pub(crate) fn thickness_of_one_particle_is_its_volume(device: &Device) {
    let drawn = draw(device, [161, 93], DVec3::new(0.5, 0.3, 3.0), &[Position { position_m: [0.5, 0.3, 0.5], tag: 0 }]);
    let at_m = 2.5;
    let texel_m = 2.0 * at_m * f64::from(drawn.view.tan_half_height) / drawn.thickness_px[1] as f64;
    let volume = drawn.thickness.iter().sum::<f64>() * 0.08 * texel_m * texel_m;
    note!(device, "thickness of one particle: {volume:.3e} m^3 of {:.3e}", 0.08f64.powi(3));
    // A disc of some seven texels is summed by their middles.
    ensure!((volume / 0.08f64.powi(3) - 1.0).abs() < 0.03, "{volume}");
}
