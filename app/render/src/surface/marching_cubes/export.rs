//! The mesh of some particles on the host: made on the GPU in an engine of its own, and again with more room until
//! nothing of it is lost.

use brooklet_fluid::{Slots, visit_slots};
use brooklet_gpu::{Engine, Gpu, GpuError, Plan, PlanError, RecordingId, Resources};
use brooklet_kernels::{BLOCK_CELLS, Buffer, MeshCounts, MeshVertex, Position};
use glam::DVec3;

use super::{MarchingCubesOptions, SurfaceMesh, is_whole, record};
use crate::start::largest;
use crate::surface::Particles;

/// Cells that many times as large are not tried.
const COARSEST: f64 = 1.0e9;

/// A closed mesh on the host.
#[derive(Clone, Debug, Default)]
pub struct HostMesh {
    /// Positions relative to the domain's lowest corner, and normals out of the fluid.
    pub vertices: Vec<MeshVertex>,
    /// Three vertices each, counter-clockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Blocks of 4 x 4 x 4 cells that the surface may cross.
    pub blocks: u32,
    /// Times it was made, with more room each time.
    pub runs: u32,
}

impl HostMesh {
    /// Volume inside, m^3: the sum of the triangles' tetrahedra with a vertex of the mesh.
    pub fn volume_m3(&self) -> f64 {
        let Some(first) = self.vertices.first() else { return 0.0 };
        let origin_m = DVec3::from_array(first.position_m.map(f64::from));
        let at = |vertex: u32| DVec3::from_array(self.vertices[vertex as usize].position_m.map(f64::from)) - origin_m;
        self.triangles.iter().map(|&[a, b, c]| at(a).dot(at(b).cross(at(c))) / 6.0).sum()
    }
}

impl SurfaceMesh {
    /// The mesh that an engine made of it, which came to `counts`.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read(&self, engine: &mut Engine, counts: &MeshCounts) -> Result<HostMesh, GpuError> {
        let mut vertices: Vec<MeshVertex> = engine.read(&self.vertices)?;
        vertices.truncate(counts.vertices as usize);
        let mut indices: Vec<u32> = engine.read(&self.indices)?;
        indices.truncate(counts.index_count as usize);
        Ok(HostMesh { vertices, triangles: indices.as_chunks().0.to_vec(), blocks: counts.blocks, runs: 1 })
    }
}

/// Why there is no mesh.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The grid of blocks, or a buffer, is too large; with larger cells it is not.
    #[error("cells of {cell_m:.3e} m are too small here: {reason}; cells of {fits_m:.3e} m fit")]
    TooFine {
        /// Side of a cell, m.
        cell_m: f64,
        /// What was refused.
        reason: String,
        /// Side of a cell that fits, m.
        fits_m: f64,
    },
    /// The particles by themselves are too many for the device.
    #[error("{count} particles are too many: {reason}; {fits} fit")]
    TooMany {
        /// How many there are.
        count: usize,
        /// What was refused.
        reason: String,
        /// How many fit.
        fits: u32,
    },
    /// The device, in another way.
    #[error(transparent)]
    Gpu(GpuError),
    /// The recordings (a fault of this program).
    #[error(transparent)]
    Plan(#[from] PlanError),
}

impl ExportError {
    /// Whether what was asked for is at fault.
    pub fn is_input(&self) -> bool {
        matches!(self, Self::TooFine { .. } | Self::TooMany { .. })
    }
}

/// Meshes the particles at `positions`, relative to the domain's lowest corner, as balls: without their neighbours they
/// have no ellipsoids. `options` say with how much room to begin.
///
/// # Errors
/// Every [`ExportError`].
pub fn mesh_particles(
    gpu: &Gpu,
    positions: &[Position],
    options: &MarchingCubesOptions,
) -> Result<HostMesh, ExportError> {
    if positions.is_empty() {
        return Ok(HostMesh::default());
    }
    let (mut options, mut runs) = (*options, 0);
    loop {
        runs += 1;
        let planned = check(gpu, positions.len(), &options)?;
        let bytes = planned.plan.bytes();
        let mut engine =
            Engine::new(gpu, planned.plan).map_err(|error| refused(gpu, positions.len(), &options, error, bytes))?;
        engine.write(&planned.positions, positions);
        engine.run(&[planned.init, planned.mesh], &[]).map_err(ExportError::Gpu)?;
        let surface = &planned.surface;
        let counts: MeshCounts = engine.read(&surface.counts).map_err(ExportError::Gpu)?[0];
        match options.lacked_room(&counts, 0.0) {
            Some(room) => options = options.with_room(room),
            None if !is_whole(&counts) => {
                let reason = "their mesh has more than 2^29 vertices".into();
                return Err(too_large(gpu, positions.len(), &options, reason, bytes));
            }
            None => {
                let mesh = surface.read(&mut engine, &counts).map_err(ExportError::Gpu)?;
                return Ok(HostMesh { runs, ..mesh });
            }
        }
    }
}

/// That the device has room for what `options` say of so many particles, as far as its limits tell.
///
/// # Errors
/// [`ExportError::TooFine`] and [`ExportError::TooMany`], which say what would fit.
pub fn check_room(gpu: &Gpu, count: usize, options: &MarchingCubesOptions) -> Result<(), ExportError> {
    check(gpu, count, options).map(drop)
}

/// What meshes particles that the host writes.
struct Planned {
    plan: Plan,
    init: RecordingId,
    mesh: RecordingId,
    positions: Buffer<Position>,
    surface: SurfaceMesh,
}

fn check(gpu: &Gpu, count: usize, options: &MarchingCubesOptions) -> Result<Planned, ExportError> {
    let Ok(slots) = u32::try_from(count) else {
        let reason = "they are numbered with 32 bits".into();
        return Err(ExportError::TooMany { count, reason, fits: u32::MAX });
    };
    if options.check().is_err() {
        let blocks: f64 = options.blocks().iter().map(|&n| f64::from(n)).product();
        let reason =
            format!("the box has {blocks:.3e} blocks of {BLOCK_CELLS} x {BLOCK_CELLS} x {BLOCK_CELLS} of them");
        return Err(too_large(gpu, count, options, reason, u64::MAX));
    }
    let planned = plan(slots, options)?;
    let bytes = planned.plan.bytes();
    Engine::check_sizes(gpu, &planned.plan).map_err(|error| refused(gpu, count, options, error, bytes))?;
    Ok(planned)
}

fn plan(count: u32, options: &MarchingCubesOptions) -> Result<Planned, PlanError> {
    let mut resources = Resources::new();
    let positions = resources.persistent("positions", count);
    // Nothing reads them, so the plan has none.
    let velocities = resources.persistent("velocities", count);
    let mut slots = Slots::declare(&mut resources, count);
    let mut init = resources.recording("mesh_init");
    init.upload(&mut slots.state, &[visit_slots(count)]);
    let mut mesh = resources.recording("mesh");
    let particles = Particles {
        positions: &positions,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let surface = record(&mut resources, (&mut init, &mut mesh), (&particles, None), options);
    let wanted = [surface.counts.id, surface.vertices.id, surface.indices.id];
    let (init_id, mesh_id) = (init.id(), mesh.id());
    let plan = Plan::sweep(resources, vec![init, mesh], &wanted)?;
    Ok(Planned { plan, init: init_id, mesh: mesh_id, positions, surface })
}

/// What the device says of a plan of so many bytes, and what would fit.
fn refused(gpu: &Gpu, count: usize, options: &MarchingCubesOptions, error: GpuError, bytes: u64) -> ExportError {
    match &error {
        GpuError::BufferTooLarge { .. } => too_large(gpu, count, options, error.to_string(), u64::MAX),
        // As much as it gave before it refused.
        GpuError::OutOfMemory { allocated, .. } => {
            too_large(gpu, count, options, error.to_string(), (*allocated).min(bytes))
        }
        _ => ExportError::Gpu(error),
    }
}

/// The smallest cells, or else the most particles, that a plan of at most so many bytes has room for.
fn too_large(gpu: &Gpu, count: usize, options: &MarchingCubesOptions, reason: String, most_bytes: u64) -> ExportError {
    let room = options.room();
    let over = |ratio: f64| {
        let coarser = MarchingCubesOptions { cell_m: ratio * options.cell_m, ..*options };
        coarser.with_room(room.over_cells(ratio))
    };
    let fits = |ratio: f64, count: u32| {
        let options = over(ratio);
        options.check().is_ok()
            && plan(count, &options).is_ok_and(|planned| {
                planned.plan.bytes() <= most_bytes && Engine::check_sizes(gpu, &planned.plan).is_ok()
            })
    };
    let slots = u32::try_from(count).unwrap_or(u32::MAX);
    if !fits(COARSEST, slots) {
        return ExportError::TooMany { count, reason, fits: largest(slots, |fewer| fits(COARSEST, fewer)) };
    }
    let (mut too_small, mut ratio) = (1.0_f64, COARSEST);
    while ratio > 1.01 * too_small {
        let middle = (too_small * ratio).sqrt();
        match fits(middle, slots) {
            true => ratio = middle,
            false => too_small = middle,
        }
    }
    // A surface has not quite the square's share fewer crossings.
    ExportError::TooFine { cell_m: options.cell_m, reason, fits_m: 1.05 * ratio * options.cell_m }
}
