//! Bodies of particles drawn by the product's own passes, and what that cost.

use brooklet_fluid::{Scene, scene::Smoothing};
use brooklet_gpu::{Engine, Gpu, Plan, Quantiles, Resources, Shape as Kind};
use brooklet_kernels::{Position, Tier};
use brooklet_render::{
    Coloring, FrameOptions, Particles, SurfaceOptions, View,
    frame::FrameValues,
    surface::screen_space::{self, ScreenSpaceOptions},
};
use glam::DVec3;

use super::{
    listed::Listed,
    seen::Seen,
    shapes::{DOMAIN_M, SPACING_M, Shape},
};
use crate::{BenchError, Observer};

/// Pictures drawn before those that are timed.
const WARM_UP: usize = 2;

/// A way to smooth, as a scene names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    pub name: &'static str,
    smoothing: Smoothing,
    iterations: u32,
    anisotropic: bool,
}

const fn filter(name: &'static str, smoothing: Smoothing, iterations: u32) -> Filter {
    Filter { name, smoothing, iterations, anisotropic: false }
}

const fn ellipsoids(name: &'static str, smoothing: Smoothing, iterations: u32) -> Filter {
    Filter { name, smoothing, iterations, anisotropic: true }
}

/// What is compared; curvature flow as often as the mobile deck's figure has it.
pub const FILTERS: [Filter; 9] = [
    filter("none", Smoothing::None, 0),
    filter("gaussian", Smoothing::Gaussian, 1),
    filter("bilateral", Smoothing::Bilateral, 1),
    filter("bilateral-2d", Smoothing::Bilateral2d, 1),
    filter("narrow-range", Smoothing::NarrowRange, 1),
    filter("curvature-flow 40", Smoothing::CurvatureFlow, 40),
    filter("curvature-flow 60", Smoothing::CurvatureFlow, 60),
    ellipsoids("ellipsoids", Smoothing::None, 0),
    ellipsoids("ellipsoids, narrow-range", Smoothing::NarrowRange, 1),
];

/// A drawn surface.
pub struct Drawn {
    pub seen: Seen,
    /// Of the smoothing's passes and of all, ms of a picture.
    pub smoothing_ms: f64,
    pub all_ms: f64,
    /// Of the textures it needs.
    pub texture_bytes: u64,
}

/// A scene of nothing but these settings.
fn scene(shape: Shape, filter: Filter) -> Result<Scene, BenchError> {
    let text = format!(
        "spacing_m = {SPACING_M}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{DOMAIN_M}, {DOMAIN_M}, {DOMAIN_M}]\nwalls = {}\n",
        shape.in_walls()
    );
    let mut scene = Scene::from_toml(&text, "bench surfaces", &[]).map_err(BenchError::stopped)?;
    scene.surface.smoothing = filter.smoothing;
    scene.surface.iterations = Some(filter.iterations);
    scene.surface.anisotropic = filter.anisotropic;
    Ok(scene)
}

/// Draws `particles_m` `repeats` times and more.
pub fn draw(
    gpu: &Gpu,
    (shape, particles_m): (Shape, &[DVec3]),
    filter: Filter,
    view: &View,
    repeats: usize,
    observer: &dyn Observer,
) -> Result<Drawn, BenchError> {
    let tier: Tier = gpu.tier();
    let scene = scene(shape, filter)?;
    let options = ScreenSpaceOptions::for_scene(&scene, tier);
    let frame = FrameOptions {
        tier,
        surface: SurfaceOptions::ScreenSpace(options),
        radius_m: options.radius_m,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 64,
        edges: false,
    };
    let values = FrameValues::new(view, &frame).map_err(BenchError::stopped)?;
    let positions: Vec<Position> = particles_m
        .iter()
        .enumerate()
        .map(|(i, at)| Position { position_m: at.as_vec3().to_array(), tag: i as u32 })
        .collect();
    let mut resources = Resources::new();
    let mut frame_view = resources.persistent("frame_view", 1);
    let (mut init, mut recording) = (resources.recording("init"), resources.recording("draw"));
    init.upload(&mut frame_view, &[values.view]);
    let listed = Listed::record(&mut resources, &mut init, &scene, &positions);
    // The bodies are no spray: spheres are drawn as they are.
    let neighbours = filter.anisotropic.then_some(&listed.neighbours);
    let particles = Particles {
        positions: &listed.positions,
        velocities: &listed.velocities,
        slots: &listed.slots,
        neighbours,
        densities: None,
    };
    let into = (&mut init, &mut recording);
    let surface = screen_space::record(&mut resources, into, &frame_view, &particles, view.size_px, tier, &options);
    let (init_id, draw_id) = (init.id(), recording.id());
    let plan = Plan::sweep(resources, vec![init, recording], &[surface.normals.id]).map_err(BenchError::stopped)?;
    let is_texture = |id| plan.resources().get(id).is_some_and(|entry| !matches!(entry.shape, Kind::Buffer { .. }));
    let texture_bytes = plan.buffers().iter().filter(|kept| is_texture(kept.id)).map(|kept| kept.bytes).sum();
    let mut engine = Engine::new(gpu, plan).map_err(BenchError::input)?;
    engine.run(&[init_id], &[]).map_err(BenchError::stopped)?;
    engine.finish().map_err(BenchError::stopped)?;

    let mut times = Vec::new();
    for _ in 0..WARM_UP + repeats {
        observer.check()?;
        engine.run(&[draw_id], &[]).map_err(BenchError::stopped)?;
        times.extend(engine.reports());
    }
    times.extend(engine.finish().map_err(BenchError::stopped)?);
    let ms_of = |wanted: &dyn Fn(&str) -> bool| {
        let stages = |report: &brooklet_gpu::FrameReport| -> f64 {
            report.stage_ms().iter().filter(|(stage, ..)| wanted(stage)).fold(0.0, |sum, (_, ms, _)| sum + ms)
        };
        Quantiles::of(times.iter().skip(WARM_UP).map(stages).collect()).map_or(0.0, |quantiles| quantiles.median)
    };
    // The normals' own pass is the study's: the water restores them where it shades.
    let smoothing_ms = ms_of(&|stage| stage.contains("smooth_"));
    let all_ms = ms_of(&|stage| stage != "draw_surface_normals");
    let bytes = engine.read_texture(&surface.normals).map_err(BenchError::stopped)?;
    let texels: Vec<f32> = bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    let normals = texels
        .chunks_exact(4)
        .map(|t| (t[3] > 0.5).then(|| DVec3::new(t[0].into(), t[1].into(), t[2].into()).normalize_or_zero()))
        .collect();
    Ok(Drawn { seen: Seen { size_px: view.size_px, normals }, smoothing_ms, all_ms, texture_bytes })
}
