//! How far meshes are from surfaces that are known, at what cost.

use brooklet_fluid::Scene;
use brooklet_gpu::{Engine, Gpu, Plan, Quantiles, Resources};
use brooklet_kernels::{MeshCounts, MeshVertex, Position};
use brooklet_render::{
    Particles,
    surface::{
        MarchingCubesOptions, marching_cubes,
        screen_space::{self, ScreenSpaceOptions},
    },
};
use glam::DVec3;
use serde::Serialize;

use super::distance::{distances, points_on};
use super::drawn::{Filter, meshing, positions, scene};
use super::listed::Listed;
use super::seen::Implicit;
use super::shapes::{DOMAIN_M, SPACING_M, Shape};
use crate::{BenchError, Observer};

/// Meshes made before those that are timed.
const WARM_UP: usize = 1;

/// A body's mesh.
#[derive(Clone, Debug, Serialize)]
pub struct MeshRow {
    /// The body.
    pub shape: &'static str,
    /// How it was meshed.
    pub mesh: &'static str,
    /// Side of a cell, over the spacing.
    pub cell_ratio: f64,
    /// Of the mesh.
    pub vertices: u32,
    /// Of the mesh.
    pub triangles: u32,
    /// From the mesh to the known surface, over the spacing: the mean by area,
    pub mean_spacings: f64,
    /// and the largest either way (Hausdorff).
    pub hausdorff_spacings: f64,
    /// Volume over the known one, less 1.
    pub volume_error: f64,
    /// Angle between a vertex' normal and the known surface's there, degrees: the mean.
    pub normal_mean_deg: f64,
    /// Of all passes, ms.
    pub ms: f64,
    /// Of buffers.
    pub bytes: u64,
}

/// Meshes `particles_m` as `filter` says, `repeats` times and more, with all the room that takes.
///
/// # Errors
/// Every [`BenchError`]; a mesh with nothing in it among them.
pub fn mesh(
    gpu: &Gpu,
    (shape, particles_m): (Shape, &[DVec3]),
    filter: Filter,
    repeats: usize,
    observer: &dyn Observer,
) -> Result<MeshRow, BenchError> {
    let scene = scene(shape, filter)?;
    let positions = positions(particles_m);
    let mut options = meshing(&scene, positions.len());
    loop {
        let made = make(gpu, (&scene, &positions), &options, repeats, observer)?;
        let Some(room) = options.room().needed(&made.counts, 0.0, options.refine.parts) else {
            return row(shape, filter, &options, &made);
        };
        options = options.with_room(room);
    }
}

/// What the GPU made.
struct Made {
    counts: MeshCounts,
    vertices: Vec<MeshVertex>,
    indices: Vec<u32>,
    ms: f64,
    bytes: u64,
}

fn make(
    gpu: &Gpu,
    (scene, positions): (&Scene, &[Position]),
    options: &MarchingCubesOptions,
    repeats: usize,
    observer: &dyn Observer,
) -> Result<Made, BenchError> {
    let screen_space = ScreenSpaceOptions::for_scene(scene, gpu.tier());
    let mut resources = Resources::new();
    let (mut init, mut recording) = (resources.recording("init"), resources.recording("mesh"));
    let listed = Listed::record(&mut resources, &mut init, scene, positions);
    let particles = Particles {
        positions: &listed.positions,
        velocities: &listed.velocities,
        slots: &listed.slots,
        neighbours: options.anisotropic.then_some(&listed.neighbours),
        densities: None,
    };
    let ellipsoids =
        screen_space::record_ellipsoids(&mut resources, (&mut init, &mut recording), &particles, &screen_space);
    let mesh =
        marching_cubes::record(&mut resources, (&mut init, &mut recording), (&particles, ellipsoids.as_ref()), options);
    let ids = [init.id(), recording.id()];
    let wanted = [mesh.counts.id, mesh.vertices.id, mesh.indices.id];
    let plan = Plan::sweep(resources, vec![init, recording], &wanted).map_err(BenchError::stopped)?;
    let bytes = plan.bytes();
    let mut engine = Engine::new(gpu, plan).map_err(BenchError::input)?;
    engine.run(&ids[..1], &[]).map_err(BenchError::stopped)?;
    engine.finish().map_err(BenchError::stopped)?;
    let mut times = Vec::new();
    for _ in 0..WARM_UP + repeats {
        observer.check()?;
        engine.run(&ids[1..], &[]).map_err(BenchError::stopped)?;
        times.extend(engine.reports());
    }
    times.extend(engine.finish().map_err(BenchError::stopped)?);
    let all_ms = |report: &brooklet_gpu::FrameReport| report.stage_ms().iter().map(|(_, ms, _)| *ms).sum::<f64>();
    let ms = Quantiles::of(times.iter().skip(WARM_UP).map(all_ms).collect()).map_or(0.0, |quantiles| quantiles.median);

    Ok(Made {
        counts: engine.read(&mesh.counts).map_err(BenchError::stopped)?[0],
        vertices: engine.read(&mesh.vertices).map_err(BenchError::stopped)?,
        indices: engine.read(&mesh.indices).map_err(BenchError::stopped)?,
        ms,
        bytes,
    })
}

/// How far a mesh is from its body.
fn row(shape: Shape, filter: Filter, options: &MarchingCubesOptions, made: &Made) -> Result<MeshRow, BenchError> {
    let Made { counts, vertices, indices, .. } = made;
    let at = |vertex: u32| DVec3::from_array(vertices[vertex as usize].position_m.map(f64::from));
    let corners = indices[..counts.index_count as usize].as_chunks().0;
    let triangles: Vec<[DVec3; 3]> = corners.iter().map(|corners: &[u32; 3]| corners.map(at)).collect();
    let middle_m = shape.middle_m();
    let volume_m3: f64 =
        triangles.iter().map(|[a, b, c]| (*a - middle_m).dot((*b - middle_m).cross(*c - middle_m)) / 6.0).sum();
    let points_m = points_on(&shape, DOMAIN_M, 0.75 * SPACING_M);
    let off = distances(&triangles, &shape, &points_m, 3.0 * SPACING_M)
        .ok_or_else(|| BenchError::stopped(format_args!("the {} has no mesh with {}", shape.name(), filter.name)))?;
    let drawn = &vertices[..counts.vertices as usize];
    let angle_deg = |vertex: &MeshVertex| {
        let [at_m, normal] = [vertex.position_m, vertex.normal].map(|v| DVec3::from_array(v.map(f64::from)));
        (2.0 * (0.5 * (normal - shape.normal(at_m)).length()).min(1.0).asin()).to_degrees()
    };
    Ok(MeshRow {
        shape: shape.name(),
        mesh: filter.name,
        cell_ratio: options.cell_m / SPACING_M,
        vertices: counts.vertices,
        triangles: counts.triangles,
        mean_spacings: off.mean_m / SPACING_M,
        hausdorff_spacings: off.hausdorff_m / SPACING_M,
        volume_error: volume_m3 / shape.volume_m3() - 1.0,
        normal_mean_deg: drawn.iter().map(angle_deg).sum::<f64>() / f64::from(counts.vertices.max(1)),
        ms: made.ms,
        bytes: made.bytes,
    })
}
