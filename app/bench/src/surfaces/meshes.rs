//! How far meshes are from surfaces that are known, at what cost.

use brooklet_fluid::Scene;
use brooklet_gpu::{Engine, Gpu, Plan, Resources};
use brooklet_kernels::{MeshCounts, Position};
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

use super::drawn::{meshing, positions, scene};
use super::listed::Listed;
use super::mesh_errors::{MeshErrors, mesh_errors};
use super::shapes::Shape;
use super::timed;
use super::ways::{Filter, Mesh};
use crate::{BenchError, Observer};

/// This program, in tables.
pub const THIS: &str = "brooklet";
/// Meshes made before those that are timed.
const WARM_UP: usize = 1;

/// A body's mesh.
#[derive(Clone, Debug, Serialize)]
pub struct MeshRow {
    /// The body.
    pub shape: &'static str,
    /// What meshed it: this, or another program and its version.
    pub program: String,
    /// How; another program's name comes first.
    pub mesh: String,
    /// Side of a cell, as figures call it,
    pub cells: &'static str,
    /// and over the spacing.
    pub cell_ratio: f64,
    /// Of the mesh.
    pub vertices: u32,
    /// Of the mesh.
    pub triangles: u32,
    /// How far it is from the known surface.
    #[serde(flatten)]
    pub errors: MeshErrors,
    /// Of all passes, or what another program says of itself without reading and writing, ms; none if it says nothing.
    pub ms: Option<f64>,
    /// Of buffers; none of another program.
    pub bytes: Option<u64>,
}

/// Meshes `particles_m` as `mesh` of `filter` says, `repeats` times and more, with all the room that takes.
///
/// # Errors
/// Every [`BenchError`]; a mesh with nothing in it among them.
pub fn mesh(
    gpu: &Gpu,
    (shape, particles_m): (Shape, &[DVec3]),
    (filter, mesh): (Filter, Mesh),
    repeats: usize,
    observer: &dyn Observer,
) -> Result<MeshRow, BenchError> {
    let scene = scene(shape, filter)?;
    let positions = positions(particles_m);
    let mut options = meshing(&scene, positions.len());
    loop {
        let made = make(gpu, (&scene, &positions), &options, repeats, observer)?;
        let Some(room) = options.lacked_room(&made.counts, 0.0) else {
            let errors = mesh_errors(shape, &made.mesh).ok_or_else(|| {
                BenchError::stopped(format_args!("the {} has no mesh with {}", shape.name(), filter.name))
            })?;
            return Ok(MeshRow {
                shape: shape.name(),
                program: THIS.into(),
                mesh: filter.name.into(),
                cells: mesh.cells.name,
                cell_ratio: mesh.cells.ratio,
                vertices: made.counts.vertices,
                triangles: made.counts.triangles,
                errors,
                ms: Some(made.ms),
                bytes: Some(made.bytes),
            });
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
        diffuse: None,
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
