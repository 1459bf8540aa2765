//! The surface as an indexed mesh with shared vertices, made on the GPU by marching cubes (Lorensen & Cline 1987) over the
//! blocks that it may cross. (Shaders: `surface/mesh/`.)
//!
//! Particles are sorted into bins of a block's size; blocks that are full all around, or empty, are never looked at again.
//! The others get the field at their points, count their vertices and triangles, learn by two prefix sums where these go,
//! and write them. Nothing is read back: what comes after draws as many as `counts` says.

mod drawn;
mod options;
pub mod table;

use brooklet_fluid::grid::{NO_SEAM, Scan};
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, CountCells, CountCellsVariant, CountMesh, EmitTriangles, EmitVertices, FieldPoint, FinishMesh, GatherField,
    GridParams, ListBlocks, MarkBlocks, MeshCounts, MeshParams, MeshVertex, ScatterCellMembers,
};
use std::mem::offset_of;

pub(crate) use drawn::record as record_drawn;
pub use options::MarchingCubesOptions;

use super::Particles;
use table::TRIANGLE_TABLE;

/// A mesh on the GPU.
pub struct SurfaceMesh {
    /// Its vertices; the first `counts.vertices` are this frame's.
    pub vertices: Buffer<MeshVertex>,
    /// Three vertices a triangle, counter-clockwise as seen from outside.
    pub indices: Buffer<u32>,
    /// What there is of both, and what found no room.
    pub counts: Buffer<MeshCounts>,
    /// The field at the points of the listed blocks, 64 a block.
    pub field_points: Buffer<FieldPoint>,
    /// Each block's place in the list, or what all of it is.
    pub block_entries: Buffer<u32>,
    /// The settings on the GPU.
    pub params: Buffer<MeshParams>,
}

/// Particles sorted into the bins of a mesh.
struct Bins {
    starts: Buffer<u32>,
    members: Buffer<u32>,
}

/// Records the mesh of `particles`. `init` uploads the settings and runs once before.
pub fn record(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    particles: &Particles<'_>,
    options: &MarchingCubesOptions,
) -> SurfaceMesh {
    let params = options.params();
    let mut mesh = resources.persistent("mesh_params", 1);
    init.upload(&mut mesh, &[params]);
    let mut triangle_table = resources.persistent("triangle_table", TRIANGLE_TABLE.len() as u32);
    init.upload(&mut triangle_table, &TRIANGLE_TABLE);

    let bins = bin_particles(resources, (init, recording), particles, &params);
    let mut counts = resources.buffer("mesh_counts", 1);
    recording.clear(&mut counts);
    let blocks = list_blocks(resources, recording, &mesh, &bins, &params, &mut counts);

    let groups_at = offset_of!(MeshCounts, block_groups) as u32;
    let most = params.most_blocks.saturating_mul(64);
    let mut field_points = resources.buffer("field_points", most);
    recording.dispatch_indirect(
        &GatherField {
            positions: particles.positions.read(),
            bin_starts: bins.starts.read(),
            bin_members: bins.members.read(),
            listed_blocks: blocks.listed.read(),
            mesh_counts: counts.read(),
            field_points: field_points.write(),
            mesh: mesh.uniform(),
        },
        &counts,
        groups_at,
        most,
    );

    // One more than there are places: the scans end with the sums.
    let places = params.most_blocks + 1;
    let mut vertex_counts = resources.buffer("vertex_counts", places);
    let mut triangle_counts = resources.buffer("triangle_counts", places);
    recording.clear(&mut vertex_counts);
    recording.clear(&mut triangle_counts);
    recording.dispatch_indirect(
        &CountMesh {
            field_points: field_points.read(),
            block_entries: blocks.entries.read(),
            listed_blocks: blocks.listed.read(),
            triangle_table: triangle_table.read(),
            mesh_counts: counts.read(),
            vertex_counts: vertex_counts.write(),
            triangle_counts: triangle_counts.write(),
            mesh: mesh.uniform(),
        },
        &counts,
        groups_at,
        most,
    );
    let vertex_starts = scanned(resources, recording, "vertex_starts", &vertex_counts);
    let triangle_starts = scanned(resources, recording, "triangle_starts", &triangle_counts);
    recording.dispatch_groups(
        &FinishMesh {
            vertex_starts: vertex_starts.read(),
            triangle_starts: triangle_starts.read(),
            mesh_counts: counts.write(),
            mesh: mesh.uniform(),
        },
        [1; 3],
    );

    let mut point_vertices = resources.buffer("point_vertices", most);
    let mut vertices = resources.buffer("mesh_vertices", params.most_vertices);
    recording.dispatch_indirect(
        &EmitVertices {
            field_points: field_points.read(),
            block_entries: blocks.entries.read(),
            listed_blocks: blocks.listed.read(),
            mesh_counts: counts.read(),
            vertex_starts: vertex_starts.read(),
            point_vertices: point_vertices.write(),
            mesh_vertices: vertices.write(),
            mesh: mesh.uniform(),
        },
        &counts,
        groups_at,
        most,
    );
    let mut indices = resources.buffer("mesh_indices", params.most_triangles.saturating_mul(3));
    // The counts are written here as well, so the number of groups comes of a copy.
    let mut groups = resources.buffer("mesh_groups", 1);
    recording.copy(&counts, &mut groups);
    recording.dispatch_indirect(
        &EmitTriangles {
            field_points: field_points.read(),
            block_entries: blocks.entries.read(),
            listed_blocks: blocks.listed.read(),
            triangle_table: triangle_table.read(),
            triangle_starts: triangle_starts.read(),
            point_vertices: point_vertices.read(),
            mesh_indices: indices.write(),
            mesh_counts: counts.write(),
            mesh: mesh.uniform(),
        },
        &groups,
        groups_at,
        most,
    );
    SurfaceMesh { vertices, indices, counts, field_points, block_entries: blocks.entries, params: mesh }
}

/// Sorts the particles' indices into bins, with the sort's own kernels over a grid of bins.
fn bin_particles(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    particles: &Particles<'_>,
    params: &MeshParams,
) -> Bins {
    let slots = particles.slots;
    let bin_m = brooklet_kernels::BLOCK_CELLS as f32 * params.cell_m;
    let grid_params = GridParams {
        cells: params.bins,
        cell_count: params.bins.iter().product(),
        cell_size_m: bin_m,
        inverse_cell_size_per_m: 1.0 / bin_m,
        domain_cells: params.bins,
        seam_cells: [NO_SEAM; 3],
        ..GridParams::default()
    };
    let mut grid = resources.persistent("mesh_grid_params", 1);
    init.upload(&mut grid, &[grid_params]);
    let length = grid_params.cell_count + 2;
    let mut counts = resources.buffer("bin_counts", length);
    let mut bin_slots = resources.buffer("bin_slots", slots.capacity);
    recording.clear(&mut counts);
    slots.dispatch(
        recording,
        &CountCells {
            variant: CountCellsVariant { wrapped: false, periodic: false },
            positions: particles.positions.read(),
            cell_counts: counts.write(),
            cell_slots: bin_slots.write(),
            step_state: slots.state.uniform(),
            grid: grid.uniform(),
        },
    );
    let starts = scanned(resources, recording, "bin_starts", &counts);
    let mut members = resources.buffer("bin_members", slots.capacity);
    if slots.capacity == 0 {
        // Nothing else writes it.
        recording.clear(&mut members);
    }
    slots.dispatch(
        recording,
        &ScatterCellMembers {
            cell_slots: bin_slots.read(),
            cell_starts: starts.read(),
            cell_members: members.write(),
            step_state: slots.state.uniform(),
        },
    );
    Bins { starts, members }
}

/// The blocks that the surface may cross.
struct Blocks {
    entries: Buffer<u32>,
    listed: Buffer<u32>,
}

fn list_blocks(
    resources: &mut Resources,
    recording: &mut Recording,
    mesh: &Buffer<MeshParams>,
    bins: &Bins,
    params: &MeshParams,
    counts: &mut Buffer<MeshCounts>,
) -> Blocks {
    let mut is_listed = resources.buffer("block_listed", params.block_count);
    let mut entries = resources.buffer("block_entries", params.block_count);
    recording.dispatch(
        &MarkBlocks {
            bin_starts: bins.starts.read(),
            block_listed: is_listed.write(),
            block_entries: entries.write(),
            mesh: mesh.uniform(),
        },
        params.block_count,
    );
    let starts = scanned(resources, recording, "block_starts", &is_listed);
    let mut listed = resources.buffer("listed_blocks", params.most_blocks);
    recording.dispatch(
        &ListBlocks {
            block_listed: is_listed.read(),
            block_starts: starts.read(),
            block_entries: entries.write(),
            listed_blocks: listed.write(),
            mesh_counts: counts.write(),
            mesh: mesh.uniform(),
        },
        params.block_count,
    );
    Blocks { entries, listed }
}

fn scanned(resources: &mut Resources, recording: &mut Recording, label: &str, values: &Buffer<u32>) -> Buffer<u32> {
    let mut scanned = resources.buffer(label, values.len);
    Scan::declare(resources, label, values.len).record(recording, values, &mut scanned);
    scanned
}
