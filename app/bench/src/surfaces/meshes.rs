//! How far meshes are from surfaces that are known, at what cost.

use brooklet_fluid::Scene;
use brooklet_gpu::{Engine, Gpu, Plan, Resources};
use brooklet_kernels::{MeshCounts, MeshVertex, Position};
use brooklet_render::{
    Particles,
    surface::{
        MarchingCubesOptions,
        marching_cubes::{self, export::HostMesh},
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
use super::timed;
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
        let Some(room) = options.lacked_room(&made.counts, 0.0) else {
            return row(shape, filter, &options, &made);
        };
        options = options.with_room(room);
    }
}

/// What the GPU made.
struct Made {
    counts: MeshCounts,
    mesh: HostMesh,
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
    let ids = (init.id(), recording.id());
    let wanted = [mesh.counts.id, mesh.vertices.id, mesh.indices.id];
    let plan = Plan::sweep(resources, vec![init, recording], &wanted).map_err(BenchError::stopped)?;
    let bytes = plan.bytes();
    let mut engine = Engine::new(gpu, plan).map_err(BenchError::input)?;
    let reports = timed::run(&mut engine, ids, (WARM_UP, repeats), observer)?;
    let counts: MeshCounts = engine.read(&mesh.counts).map_err(BenchError::stopped)?[0];
    let mesh = mesh.read(&mut engine, &counts).map_err(BenchError::stopped)?;
    Ok(Made { counts, mesh, ms: timed::median_ms(&reports, |_| true), bytes })
}

/// How far a mesh is from its body.
fn row(shape: Shape, filter: Filter, options: &MarchingCubesOptions, made: &Made) -> Result<MeshRow, BenchError> {
    let HostMesh { vertices, triangles, .. } = &made.mesh;
    let at = |vertex: u32| DVec3::from_array(vertices[vertex as usize].position_m.map(f64::from));
    let corners_m: Vec<[DVec3; 3]> = triangles.iter().map(|corners| corners.map(at)).collect();
    let points_m = points_on(&shape, DOMAIN_M, 0.75 * SPACING_M);
    let off = distances(&corners_m, &shape, &points_m, 3.0 * SPACING_M)
        .ok_or_else(|| BenchError::stopped(format_args!("the {} has no mesh with {}", shape.name(), filter.name)))?;
    let angle_deg = |vertex: &MeshVertex| {
        let [at_m, normal] = [vertex.position_m, vertex.normal].map(|v| DVec3::from_array(v.map(f64::from)));
        (2.0 * (0.5 * (normal - shape.normal(at_m)).length()).min(1.0).asin()).to_degrees()
    };
    Ok(MeshRow {
        shape: shape.name(),
        mesh: filter.name,
        cell_ratio: options.cell_m / SPACING_M,
        vertices: made.counts.vertices,
        triangles: made.counts.triangles,
        mean_spacings: off.mean_m / SPACING_M,
        hausdorff_spacings: off.hausdorff_m / SPACING_M,
        volume_error: made.mesh.volume_m3() / shape.volume_m3() - 1.0,
        normal_mean_deg: vertices.iter().map(angle_deg).sum::<f64>() / vertices.len().max(1) as f64,
        ms: made.ms,
        bytes: made.bytes,
    })
}
