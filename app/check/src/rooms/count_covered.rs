//! How many pixels show the fluid, by either method's surface: its twin is given the surface that the device drew.

use crate::device::Device;
use crate::drawn::record_frame;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_fluid::Scene;
use brooklet_gpu::{Plan, Recording};
use brooklet_kernels::{Position, Texture};
use brooklet_reference::surface::InverseDepth;
use brooklet_reference::surface::count_covered::count_covered;
use brooklet_render::{Camera, FrameOptions, View};
use glam::DVec3;
use rand::RngExt as _;

/// A group looks at 29 pixels from its first to its last one: one group, just one, just two, and some.
const SIZES: [[u32; 2]; 6] = [[1, 1], [3, 29], [32, 32], [33, 31], [29, 65], [101, 67]];

fn scene() -> Scene {
    let settings = ["spacing_m=0.1", "surface={ method = 'auto', caustics = false, self_shadow = false }"];
    Scene::load("calm-pool", &settings.map(Into::into)).or_raise()
}

/// The surface by each method, and what was counted of it.
fn drawn(device: &Device, size_px: [u32; 2], positions: &[Position]) -> [(InverseDepth, u32); 2] {
    let view = View {
        camera: Camera { eye_m: DVec3::new(0.2, 0.6, 1.4), target_m: DVec3::new(0.25, 0.2, 0.25), fov_deg: 40.0 },
        size_px,
        ..View::of_scene(&scene())
    };
    let options = FrameOptions { supersample: 1, ..FrameOptions::for_scene(&scene(), device.gpu().tier()) };
    let (resources, passes) = record_frame(&view, &options, positions);
    let recordings: Vec<Recording> = passes.recordings().chain([&passes.init]).cloned().collect();
    let (water, auto) = (passes.water.or_raise(), passes.auto.or_raise());
    let surfaces: [&Texture; 2] = [&water.surface.inverse_depth, &auto.meshed_water.surface.inverse_depth];
    let wanted = [surfaces[0].id, surfaces[1].id, auto.covered_px.id];
    let plan = Plan::sweep(resources, recordings, &wanted).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&[passes.init.id()], &[]).or_raise();
    [(passes.draw.id(), surfaces[0]), (auto.meshed.id(), surfaces[1])].map(|(draw, surface)| {
        engine.run(&[draw], &[]).or_raise();
        let values: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(surface).or_raise());
        let size_px = size_px.map(|side| side as usize);
        let surface = InverseDepth { size_px, values: values.into_iter().map(f64::from).collect() };
        (surface, engine.read(&auto.covered_px).or_raise()[0])
    })
}

pub(crate) fn what_is_covered_is_counted(device: &Device) {
    let mut rng = rng(14);
    let mut ball = |_| DVec3::from_array(std::array::from_fn(|_| 0.05 + 0.4 * rng.random::<f64>()));
    let positions: Vec<Position> = (0..60).map(|i| Position { position_m: ball(i).as_vec3().into(), tag: i }).collect();
    let mut differ = 0;
    for size_px in SIZES {
        for (surface, counted) in drawn(device, size_px, &positions) {
            ensure_eq!(counted, count_covered(&surface), "{size_px:?}");
            let moved = surface.values.iter().copied().cycle().skip(1).take(surface.values.len()).collect();
            differ += u32::from(counted != count_covered(&InverseDepth { values: moved, ..surface }));
        }
    }
    ensure!(differ > 0, "a surface a pixel aside has another number");
    for (_, counted) in drawn(device, [33, 31], &[]) {
        ensure_eq!(counted, 0, "no particles");
    }
}
