//! The surface as an indexed mesh with shared vertices, made on the GPU by marching cubes (Lorensen & Cline 1987) over the
//! blocks that it may cross. (Shaders: `surface/mesh/`.)
//!
//! Particles are sorted into bins; blocks that are full all around, or empty, are never looked at again. The others get the
//! field at their points; those that the surface cuts count their vertices and triangles, learn by two prefix sums where
//! these go, and write them. Nothing is read back: what comes after draws as many as `counts` says.

mod bins;
mod blocks;
mod counted;
mod drawn;
pub mod export;
mod options;
pub mod refine;
mod room;
pub mod table;

use brooklet_fluid::grid::Scan;
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, CountMesh, Ellipsoid, EmitTriangles, EmitVertices, FinishMesh, GatherField, GatherFieldVariant, MeshCounts,
    MeshNormals, MeshNormalsVariant, MeshParams, MeshVertex,
};
use std::mem::offset_of;

pub use counted::{MESH_FIELDS, is_whole, mesh_values};
pub(crate) use drawn::record as record_drawn;
pub use options::MarchingCubesOptions;
pub use refine::RefineOptions;
pub use room::MeshRoom;

use super::Particles;
use refine::TriangleMesh;
use table::TRIANGLE_TABLE;

/// A mesh on the GPU.
pub struct SurfaceMesh {
    /// Its vertices; the first `counts.vertices` are this frame's.
    pub vertices: Buffer<MeshVertex>,
    /// Three vertices a triangle, counter-clockwise as seen from outside.
    pub indices: Buffer<u32>,
    /// What there is of both, and what found no room.
    pub counts: Buffer<MeshCounts>,
    /// The field at the points of the listed blocks, m, 64 a block.
    pub field_m: Buffer<f32>,
    /// Each block's place in the list, or what all of it is.
    pub block_entries: Buffer<u32>,
    /// Which points of each block are inside, a bit each.
    pub block_inside: Buffer<[u32; 2]>,
    /// The settings on the GPU.
    pub params: Buffer<MeshParams>,
}

/// Records the mesh of `particles`, or of their `ellipsoids` where the options want them and there are some. `init` uploads
/// the settings and runs once before.
pub fn record(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    (particles, ellipsoids): (&Particles<'_>, Option<&Buffer<Ellipsoid>>),
    options: &MarchingCubesOptions,
) -> SurfaceMesh {
    let ellipsoids = ellipsoids.filter(|_| options.anisotropic);
    let options = &MarchingCubesOptions { anisotropic: ellipsoids.is_some(), ..*options };
    let params = options.params();
    let mut mesh = resources.persistent("mesh_params", 1);
    init.upload(&mut mesh, &[params]);
    let mut triangle_table = resources.persistent("triangle_table", TRIANGLE_TABLE.len() as u32);
    init.upload(&mut triangle_table, &TRIANGLE_TABLE);

    let bins = bins::record(resources, recording, (particles, ellipsoids), (&mesh, &params));
    let mut counts = resources.buffer("mesh_counts", 1);
    let mut blocks = match options.dense {
        true => blocks::record_dense(resources, (init, &mut *recording), &params, &mut counts),
        false => blocks::record_sparse(resources, recording, &bins, (&mesh, &params), &mut counts),
    };

    let groups_at = offset_of!(MeshCounts, block_groups) as u32;
    let most = params.most_blocks.saturating_mul(64);
    let mut field_m = resources.buffer("field_m", most);
    recording.dispatch_indirect(
        &GatherField {
            variant: GatherFieldVariant { anisotropic: options.anisotropic },
            bin_particles: bins.contents.particles(),
            bin_kernels: bins.contents.kernels(),
            bin_starts: bins.starts.read(),
            listed_blocks: blocks.listed.read(),
            mesh_counts: counts.read(),
            field_m: field_m.write(),
            block_inside: blocks.inside.write(),
            mesh: mesh.uniform(),
        },
        &counts,
        offset_of!(MeshCounts, field_groups) as u32,
        most.div_ceil(brooklet_kernels::FIELD_BLOCKS),
    );

    // One more than there are places: the scans end with the sums.
    let places = params.most_blocks + 1;
    let mut vertex_counts = resources.buffer("vertex_counts", places);
    let mut triangle_counts = resources.buffer("triangle_counts", places);
    recording.clear(&mut vertex_counts);
    recording.clear(&mut triangle_counts);
    recording.dispatch_indirect(
        &CountMesh {
            block_inside: blocks.inside.read(),
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
            field_m: field_m.read(),
            block_inside: blocks.inside.read(),
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
    recording.dispatch_indirect(
        &MeshNormals {
            variant: MeshNormalsVariant { anisotropic: options.anisotropic },
            bin_particles: bins.contents.particles(),
            bin_kernels: bins.contents.kernels(),
            bin_starts: bins.starts.read(),
            mesh_counts: counts.read(),
            mesh_vertices: vertices.write(),
            mesh: mesh.uniform(),
        },
        &counts,
        offset_of!(MeshCounts, vertex_groups) as u32,
        params.most_vertices,
    );
    let mut indices = resources.buffer("mesh_indices", params.most_triangles.saturating_mul(3));
    // The counts are written here as well, so the number of groups comes of a copy.
    let mut groups = resources.buffer("mesh_groups", 1);
    recording.copy(&counts, &mut groups);
    recording.dispatch_indirect(
        &EmitTriangles {
            block_inside: blocks.inside.read(),
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
    let coarse = TriangleMesh { vertices, indices, counts };
    let TriangleMesh { vertices, indices, counts } =
        refine::record(resources, (init, recording), coarse, &options.refine);
    SurfaceMesh {
        vertices,
        indices,
        counts,
        field_m,
        block_entries: blocks.entries,
        block_inside: blocks.inside,
        params: mesh,
    }
}

fn scanned(resources: &mut Resources, recording: &mut Recording, label: &str, values: &Buffer<u32>) -> Buffer<u32> {
    let mut scanned = resources.buffer(label, values.len);
    Scan::declare(resources, label, values.len).record(recording, values, &mut scanned);
    scanned
}
