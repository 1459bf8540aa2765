//! Bodies of particles drawn by the product's own passes, and what that cost.

use brooklet_fluid::{Scene, scene::Smoothing};
use brooklet_gpu::{Engine, Gpu, Plan, Resources, Shape as Kind};
use brooklet_kernels::{Position, Tier};
use brooklet_render::{
    Coloring, FrameOptions, Particles, SurfaceOptions, View,
    frame::FrameValues,
    surface::{
        MarchingCubesOptions,
        screen_space::{self, ScreenSpaceOptions},
    },
};
use glam::DVec3;

use super::{
    listed::Listed,
    seen::Seen,
    shapes::{DOMAIN_M, SPACING_M, Shape},
    timed,
};
use crate::{BenchError, Observer};

/// Pictures drawn before those that are timed.
const WARM_UP: usize = 2;

/// A way to smooth, as a scene names it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter {
    pub name: &'static str,
    smoothing: Smoothing,
    iterations: u32,
    anisotropic: bool,
    /// Meshed instead.
    pub mesh: Option<Mesh>,
}

/// A way to mesh, as a scene names it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    /// Side of a cell, over the spacing.
    pub cell_ratio: f64,
    smooth_normals: u32,
    anisotropic: bool,
}

const fn mesh(name: &'static str, cell_ratio: f64) -> Filter {
    let mesh = Some(Mesh { cell_ratio, smooth_normals: 4, anisotropic: false });
    Filter { mesh, ..filter(name, Smoothing::None, 0) }
}

const fn filter(name: &'static str, smoothing: Smoothing, iterations: u32) -> Filter {
    Filter { name, smoothing, iterations, anisotropic: false, mesh: None }
}

const fn ellipsoids(name: &'static str, smoothing: Smoothing, iterations: u32) -> Filter {
    Filter { anisotropic: true, ..filter(name, smoothing, iterations) }
}

/// What is compared; curvature flow as often as the mobile deck's figure has it.
pub const FILTERS: [Filter; 15] = [
    filter("none", Smoothing::None, 0),
    filter("gaussian", Smoothing::Gaussian, 1),
    filter("bilateral", Smoothing::Bilateral, 1),
    filter("bilateral-2d", Smoothing::Bilateral2d, 1),
    filter("narrow-range", Smoothing::NarrowRange, 1),
    filter("curvature-flow 40", Smoothing::CurvatureFlow, 40),
    filter("curvature-flow 60", Smoothing::CurvatureFlow, 60),
    ellipsoids("ellipsoids", Smoothing::None, 0),
    ellipsoids("ellipsoids, narrow-range", Smoothing::NarrowRange, 1),
    mesh("mesh, cells d", 1.0),
    mesh("mesh, cells 2d/3", 2.0 / 3.0),
    mesh("mesh, cells d/2", 0.5),
    mesh("mesh, cells d/3", 1.0 / 3.0),
    Filter {
        mesh: Some(Mesh { cell_ratio: 0.5, smooth_normals: 0, anisotropic: false }),
        ..filter("mesh, not smoothed", Smoothing::None, 0)
    },
    Filter {
        mesh: Some(Mesh { cell_ratio: 0.5, smooth_normals: 4, anisotropic: true }),
        ..ellipsoids("mesh of ellipsoids", Smoothing::None, 0)
    },
];

/// A drawn surface.
pub struct Drawn {
    pub seen: Seen,
    /// Of the smoothing's passes and of all, ms of a picture.
    pub smoothing_ms: f64,
    pub all_ms: f64,
    /// Of the textures it needs, and of a mesh's buffers with them.
    pub texture_bytes: u64,
}

/// A scene of nothing but these settings.
pub fn scene(shape: Shape, filter: Filter) -> Result<Scene, BenchError> {
    let text = format!(
        "spacing_m = {SPACING_M}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{DOMAIN_M}, {DOMAIN_M}, {DOMAIN_M}]\nwalls = {}\n",
        shape.in_walls()
    );
    let mut scene = Scene::from_toml(&text, "bench surfaces", &[]).map_err(BenchError::stopped)?;
    scene.surface.smoothing = filter.smoothing;
    scene.surface.iterations = Some(filter.iterations);
    scene.surface.anisotropic = filter.anisotropic;
    if let Some(mesh) = filter.mesh {
        scene.surface.mesh.cell_ratio = mesh.cell_ratio;
        scene.surface.mesh.smooth_normals = mesh.smooth_normals;
        scene.surface.mesh.anisotropic = mesh.anisotropic;
    }
    Ok(scene)
}

/// As the GPU has them.
pub fn positions(particles_m: &[DVec3]) -> Vec<Position> {
    let position = |(i, at): (usize, &DVec3)| Position { position_m: at.as_vec3().to_array(), tag: i as u32 };
    particles_m.iter().enumerate().map(position).collect()
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
    let positions = positions(particles_m);
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
    let surface = match filter.mesh {
        Some(_) => screen_space::record_meshed(
            &mut resources,
            into,
            &frame_view,
            &particles,
            (view.size_px, tier),
            (&options, &meshing(&scene, positions.len())),
        ),
        None => screen_space::record(&mut resources, into, &frame_view, &particles, view.size_px, tier, &options),
    };
    let (init_id, draw_id) = (init.id(), recording.id());
    let plan = Plan::sweep(resources, vec![init, recording], &[surface.normals.id]).map_err(BenchError::stopped)?;
    let is_kept = |id| {
        plan.resources().get(id).is_some_and(|entry| match &entry.shape {
            Kind::Buffer { .. } => filter.mesh.is_some(),
            _ => true,
        })
    };
    let bytes = plan.buffers().iter().filter(|kept| is_kept(kept.id)).map(|kept| kept.bytes).sum();
    let mut engine = Engine::new(gpu, plan).map_err(BenchError::input)?;
    let reports = timed::run(&mut engine, (init_id, draw_id), (WARM_UP, repeats), observer)?;
    // The normals' own pass is the study's: the water restores them where it shades.
    let smoothing_ms = timed::median_ms(&reports, |stage| stage.contains("smooth_") || stage.contains("rings"));
    let all_ms = timed::median_ms(&reports, |stage| stage != "draw_surface_normals");
    let texels = engine.read_texture(&surface.normals).map_err(BenchError::stopped)?;
    let values: Vec<f32> = match filter.mesh {
        Some(_) => texels.as_chunks().0.iter().map(|&bits| half::f16::from_le_bytes(bits).to_f32()).collect(),
        None => texels.as_chunks().0.iter().map(|&bits| f32::from_le_bytes(bits)).collect(),
    };
    let normals = values
        .chunks_exact(4)
        .map(|t| (t[3] > 0.5).then(|| DVec3::new(t[0].into(), t[1].into(), t[2].into()).normalize_or_zero()))
        .collect();
    Ok(Drawn { seen: Seen { size_px: view.size_px, normals }, smoothing_ms, all_ms, texture_bytes: bytes })
}

/// How a scene's surface is meshed, with room for so many particles.
pub fn meshing(scene: &Scene, particles: usize) -> MarchingCubesOptions {
    let meshed = MarchingCubesOptions::for_scene(scene);
    let room = MarchingCubesOptions::for_particles(
        // A layer of them crosses more blocks than a body.
        4 * particles,
        meshed.spacing_m,
        meshed.cell_m,
        meshed.domain_size_m,
        meshed.wall_bounds_m,
    )
    .room();
    meshed.with_room(room)
}
