//! Bodies of particles drawn by the product's own passes, and what that cost.

use brooklet_fluid::Scene;
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
    ways::Filter,
};
use crate::{BenchError, Observer};

/// Pictures drawn before those that are timed.
const WARM_UP: usize = 2;

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
        scene.surface.mesh.cell_ratio = mesh.cells.ratio;
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

/// Draws `particles_m` from each of `views`, all of one size, `repeats` times and more: one engine, whose camera moves.
pub fn draw(
    gpu: &Gpu,
    (shape, particles_m): (Shape, &[DVec3]),
    filter: Filter,
    views: &[View],
    repeats: usize,
    observer: &dyn Observer,
) -> Result<Vec<Drawn>, BenchError> {
    let Some(first) = views.first() else { return Ok(Vec::new()) };
    let size_px = first.size_px;
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
        diffuse: None,
    };
    let positions = positions(particles_m);
    let mut resources = Resources::new();
    let frame_view = resources.persistent("frame_view", 1);
    let (mut init, mut recording) = (resources.recording("init"), resources.recording("draw"));
    let listed = Listed::record(&mut resources, &mut init, &scene, &positions);
    // The bodies are no spray: spheres are drawn as they are.
    let neighbours = filter.anisotropic.then_some(&listed.neighbours);
    let particles = Particles {
        positions: &listed.positions,
        velocities: &listed.velocities,
        slots: &listed.slots,
        neighbours,
        densities: None,
        diffuse: None,
    };
    let into = (&mut init, &mut recording);
    let surface = match filter.mesh {
        Some(_) => screen_space::record_meshed(
            &mut resources,
            into,
            &frame_view,
            &particles,
            (size_px, tier),
            (&options, &meshing(&scene, positions.len())),
        ),
        None => screen_space::record(&mut resources, into, &frame_view, &particles, size_px, tier, &options),
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
    let mut drawn = Vec::new();
    for view in views {
        let values = FrameValues::new(view, &frame).map_err(BenchError::stopped)?;
        engine.write(&frame_view, &[values.view]);
        let reports = timed::run(&mut engine, (init_id, draw_id), (WARM_UP, repeats), observer)?;
        let texels = engine.read_texture(&surface.normals).map_err(BenchError::stopped)?;
        drawn.push(Drawn {
            seen: Seen { size_px, normals: normals(&texels, filter.mesh.is_some()) },
            // The normals' own pass is the study's: the water restores them where it shades.
            smoothing_ms: timed::median_ms(&reports, |stage| stage.contains("smooth_") || stage.contains("rings")),
            all_ms: timed::median_ms(&reports, |stage| stage != "draw_surface_normals"),
            texture_bytes: bytes,
        });
    }
    Ok(drawn)
}

/// Normals of four numbers a texel, of 16 bits or of 32; the last is whether there is any.
fn normals(texels: &[u8], is_half: bool) -> Vec<Option<DVec3>> {
    let values: Vec<f32> = match is_half {
        true => texels.as_chunks().0.iter().map(|&bits| half::f16::from_le_bytes(bits).to_f32()).collect(),
        false => texels.as_chunks().0.iter().map(|&bits| f32::from_le_bytes(bits)).collect(),
    };
    let normal =
        |t: &[f32]| (t[3] > 0.5).then(|| DVec3::new(t[0].into(), t[1].into(), t[2].into()).normalize_or_zero());
    values.chunks_exact(4).map(normal).collect()
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
