//! Spray, foam and bubbles as they are splatted, against their twin: `diffuse/diffuse`.

use crate::cases::out_of_part;
use crate::device::Device;
use crate::numbers::rng;
use crate::rooms::diffuse_moves::of;
use crate::wrong::{OrRaise as _, ensure, note};
use brooklet_fluid::diffuse::DiffuseSlots;
use brooklet_fluid::scene::Smoothing;
use brooklet_fluid::{Slots, visit_slots};
use brooklet_gpu::{Plan, Resources, Tier};
use brooklet_kernels::{DiffuseParticle, DiffuseState, DiffuseStyle, Position};
use brooklet_reference::diffuse::Particle;
use brooklet_reference::diffuse::draw_diffuse::{Behind, draw_diffuse};
use brooklet_render::diffuse::DiffuseLook;
use brooklet_render::frame::{self, FrameValues};
use brooklet_render::{Camera, Coloring, FrameOptions, Particles, ScreenSpaceOptions, SurfaceOptions, View};
use glam::{DVec3, DVec4};
use rand::RngExt as _;

const SIZE_PX: [u32; 2] = [161, 93];
/// Of the thickest place: some discs add up in f16, and a device may move a disc by a sixteenth of a pixel of the two or so
/// that it is wide.
const TOLERANCE: f64 = 0.06;
/// Share of the covered pixels where a disc may be on either side of what is opaque.
const GRAZING: f64 = 0.02;

/// A slab of water, and what is above, in and below it.
fn particles() -> (Vec<Position>, Vec<DiffuseParticle>) {
    let mut rng = rng(91);
    let fluid = (0..12 * 12 * 4)
        .map(|i| {
            let at = [i % 12, i / 144, i / 12 % 12].map(|n| 0.04 + 0.08 * n as f32);
            Position { position_m: at, tag: i | if i % 50 == 7 { out_of_part(3) } else { 0 } }
        })
        .collect();
    let diffuse = (0..900)
        .map(|i| DiffuseParticle {
            position_m: [rng.random(), 0.02 + 0.7 * rng.random::<f32>(), rng.random()],
            lifetime_s: [2.0, 0.2, 0.0, 0.7][i % 4],
            velocity_m_s: [0.0; 3],
            crowd: [0.05, 0.3, 0.9, 0.12][i / 4 % 4],
        })
        .collect();
    (fluid, diffuse)
}

fn options(device: &Device, look: DiffuseLook) -> FrameOptions {
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
        absorption_per_m: DVec3::new(6.0, 2.0, 1.0),
        refraction: 1.0,
        metal_reflectance: None,
        photons: 0,
        self_shadow: false,
    };
    FrameOptions {
        tier: device.gpu().tier(),
        surface: SurfaceOptions::ScreenSpace(surface),
        radius_m: 0.03,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 64,
        edges: false,
        diffuse: Some(look),
    }
}

fn beyond(got: &[DVec4], expected: &[DVec4]) -> (usize, usize, f64) {
    let most = expected.iter().fold(0.0, |most: f64, light| most.max(light.w));
    let covered = expected.iter().filter(|light| light.w > 0.0).count();
    let differences = got.iter().zip(expected).map(|(got, expected)| (*got - *expected).length() / most / TOLERANCE);
    // Written so that a NaN is beyond.
    let within: Vec<f64> = differences.filter(|difference| *difference <= 1.0).collect();
    (covered, got.len() - within.len(), within.into_iter().fold(0.0, f64::max))
}

pub(crate) fn what_is_splatted_is_its_twin(device: &Device) {
    let (positions, diffuse) = particles();
    let look = DiffuseLook { radius_m: 0.02, opacity: 0.8, spacing_m: 0.08, fade_s: 0.5 };
    let options = options(device, look);
    let view = View {
        camera: Camera { eye_m: DVec3::new(0.7, 0.9, 2.6), target_m: DVec3::new(0.5, 0.3, 0.5), fov_deg: 32.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px: SIZE_PX,
    };
    let (fluid_count, count) = (positions.len() as u32, diffuse.len() as u32);
    let mut resources = Resources::new();
    let mut buffer = resources.persistent::<Position>("positions", fluid_count);
    let velocities = resources.persistent("velocities", fluid_count);
    let mut slots = Slots::declare(&mut resources, fluid_count);
    let mut ring = DiffuseSlots {
        particles: resources.persistent("diffuse", count),
        state: resources.persistent("diffuse_state", 1),
    };
    let drawn = Particles {
        positions: &buffer,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: Some(&ring),
    };
    let mut passes = frame::record(&mut resources, &view, &drawn, &options).or_raise();
    passes.init.upload(&mut slots.state, &[visit_slots(fluid_count)]);
    passes.init.upload(&mut buffer, &positions);
    passes.init.upload(&mut ring.particles, &diffuse);
    let state = DiffuseState { vertex_count: 3, instance_count: count, ..DiffuseState::default() };
    passes.init.upload(&mut ring.state, &[state]);
    let water = passes.water.or_raise();
    let light = water.diffuse_light.or_raise();
    let ids = [passes.init.id(), passes.draw.id()];
    let wanted = [light.id, water.surface.inverse_depth.id, passes.depth.id];
    let plan = Plan::sweep(resources, vec![passes.init, passes.draw], &wanted).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids, &[]).or_raise();
    let halves = engine.read_texture(&light).or_raise();
    let halves: Vec<f64> =
        halves.chunks_exact(2).map(|pair| half::f16::from_le_bytes([pair[0], pair[1]]).into()).collect();
    let got: Vec<DVec4> = halves.chunks_exact(4).map(DVec4::from_slice).collect();
    let surface: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(&water.surface.inverse_depth).or_raise());
    let surface: Vec<f64> = surface.into_iter().map(f64::from).collect();
    let values = FrameValues::new(&view, &options).or_raise();
    // Nothing is below the floor, which alone is opaque: where its depth cannot be read back nothing is hidden.
    let scene: Vec<f64> = match device.gpu().tier() {
        Tier::Floor => vec![0.0; surface.len()],
        _ => {
            let depth: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(&passes.depth).or_raise());
            depth.into_iter().map(|depth| f64::from(depth) / f64::from(values.view.near_m)).collect()
        }
    };
    let size_px = SIZE_PX.map(|side| side as usize);
    let SurfaceOptions::ScreenSpace(screen_space) = options.surface else { return };
    let all: Vec<Particle> = diffuse.iter().map(of).collect();
    let twin = |style: &DiffuseStyle, surface: &[f64]| {
        let behind = Behind { water: surface, scene: &scene, size_px };
        draw_diffuse(&all, &behind, &values.view, style, &screen_space.water())
    };
    let expected = twin(&look.style(), &surface);
    let (covered, off, worst) = beyond(&got, &expected);
    device.compared("draw_diffuse", covered, [worst * TOLERANCE, TOLERANCE]);
    note!(
        device,
        "kernel draw_diffuse {SIZE_PX:?}: {off} of {covered} pixels beyond {TOLERANCE:.0e} of the thickest, the others within {worst:.2} of it"
    );
    ensure!(covered > 1000 && off as f64 <= GRAZING * covered as f64, "{off} of {covered}");
    let larger = DiffuseStyle { radius_m: 1.2 * look.style().radius_m, ..look.style() };
    let (_, off, _) = beyond(&got, &twin(&larger, &surface));
    ensure!(off as f64 > 0.05 * covered as f64, "discs a fifth larger must differ: {off} of {covered}");
    let (_, off, _) = beyond(&got, &twin(&look.style(), &vec![0.0; surface.len()]));
    ensure!(off as f64 > 0.05 * covered as f64, "without water they must be brighter: {off} of {covered}");
}
