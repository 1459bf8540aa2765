//! Smoothing of a mesh's normals, and its subdivision along curves: what comes between marching cubes and a picture or a
//! file. (Shaders: `surface/refine/`.)
//!
//! Both go by each vertex's ring, the ends of the sides that start at it: a counting sort of the triangles' sides by
//! where they start. An edge is that of its lower end, where both of its triangles find it, so that a subdivided mesh
//! shares its new vertices and is as closed as it was.

use std::mem::offset_of;

use brooklet_fluid::Scene;
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, CountEdges, CountRings, FinishSubdivision, ListRings, MeshCounts, MeshSize, MeshVertex, RefineParams,
    SizeMesh, SmoothNormals, SortRings, SubdivideEdges, SubdivideMiddles, SubdivideTriangles,
};

use super::scanned;

/// Standard deviation of the weight over the distance, over the spacing: that of the particles' bumps, two cells.
const DISTANCE_RATIO: f64 = 1.0;
/// Standard deviation of the weight over the difference of two unit normals, 14 degrees. With it smoothing lowers the
/// error of normals on round bodies and on a box; from 0.3 on the box's edges blur (`app/render/SURFACES.md`).
const DIFFERENCE: f64 = 0.25;
/// Vertices there may be at most: 128 MiB, which every device binds.
const MOST_VERTICES: u32 = 1 << 22;

/// Vertices that become of each: n² for n parts a side where a mesh is closed, and more where it has handles.
fn finer(parts: u32) -> f64 {
    1.05 * f64::from(parts.pow(2))
}

/// How a mesh is refined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefineOptions {
    /// How often normals are smoothed; 0: not at all.
    pub smooth_normals: u32,
    /// Parts of each side of a triangle, 1 to 3; 1: triangles stay as they are.
    pub parts: u32,
    /// Standard deviation of smoothing's weight over the distance, m.
    pub distance_m: f64,
    /// Vertices there is room for when it is subdivided.
    pub most_vertices: u32,
    /// Triangles there is room for when it is subdivided.
    pub most_triangles: u32,
}

/// A mesh's buffers.
pub struct TriangleMesh {
    /// Its vertices; the first `counts.vertices` are this frame's.
    pub vertices: Buffer<MeshVertex>,
    /// Three vertices a triangle, counter-clockwise as seen from outside; all one vertex where a triangle was lost.
    pub indices: Buffer<u32>,
    /// What there is of both, and what found no room.
    pub counts: Buffer<MeshCounts>,
}

/// Each vertex's ring.
struct Rings {
    starts: Buffer<u32>,
    ends: Buffer<u32>,
}

impl RefineOptions {
    /// What a scene asks for of a mesh with room for `most_vertices`.
    pub fn for_scene(scene: &Scene, most_vertices: u32) -> Self {
        let mesh = &scene.surface.mesh;
        let most_coarse = (f64::from(MOST_VERTICES) / finer(mesh.subdivide)) as u32;
        Self { smooth_normals: mesh.smooth_normals, parts: mesh.subdivide, ..Self::none(scene.fitted_spacing_m()) }
            .with_room(most_vertices.min(most_coarse), 2 * most_vertices.min(most_coarse))
    }

    /// The mesh as it is, of particles `spacing_m` apart.
    pub fn none(spacing_m: f64) -> Self {
        Self {
            smooth_normals: 0,
            parts: 1,
            distance_m: DISTANCE_RATIO * spacing_m,
            most_vertices: 0,
            most_triangles: 0,
        }
    }

    /// With room for what becomes of so many vertices and triangles.
    pub fn with_room(self, vertices: u32, triangles: u32) -> Self {
        let most_vertices = (finer(self.parts) * f64::from(vertices)).ceil() as u32;
        let most_triangles = triangles.saturating_mul(self.parts.pow(2)).max(most_vertices.saturating_mul(2));
        Self { most_vertices, most_triangles, ..self }
    }

    /// Vertices and triangles for what becomes of which there is room.
    pub(super) fn coarse_room(&self) -> [u32; 2] {
        match self.parts {
            0 | 1 => [u32::MAX; 2],
            parts => [(f64::from(self.most_vertices) / finer(parts)) as u32, self.most_triangles / parts.pow(2)],
        }
    }

    /// What the shaders are given of a mesh with room for so many vertices.
    pub fn params(&self, most_coarse_vertices: u32) -> RefineParams {
        RefineParams {
            distance_m: self.distance_m as f32,
            difference: DIFFERENCE as f32,
            parts: self.parts,
            most_coarse_vertices,
            most_vertices: self.most_vertices,
            most_triangles: self.most_triangles,
        }
    }
}

/// A mesh, its rings and what there is of both, while it is refined.
struct Refining {
    params: Buffer<RefineParams>,
    mesh: TriangleMesh,
    size: Buffer<MeshSize>,
    rings: Rings,
}

/// Records what is to be done with a mesh; nothing, if nothing is. `init` uploads the settings and runs once before.
pub fn record(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    mesh: TriangleMesh,
    options: &RefineOptions,
) -> TriangleMesh {
    if options.smooth_normals == 0 && options.parts < 2 {
        return mesh;
    }
    let mut params = resources.persistent("refine_params", 1);
    init.upload(&mut params, &[options.params(mesh.vertices.len)]);
    let mut size = resources.buffer("mesh_size", 1);
    recording.dispatch_groups(&SizeMesh { mesh_counts: mesh.counts.read(), mesh_size: size.write() }, [1; 3]);
    let rings = list_rings(resources, recording, &mesh, &size);
    let mut refining = Refining { params, mesh, size, rings };
    if options.smooth_normals > 0 {
        refining.smooth_normals(resources, recording, options.smooth_normals);
    }
    match options.parts {
        0 | 1 => refining.mesh,
        _ => refining.subdivided(resources, recording, options),
    }
}

const VERTEX_GROUPS_AT: u32 = offset_of!(MeshSize, vertex_groups) as u32;
const TRIANGLE_GROUPS_AT: u32 = offset_of!(MeshSize, triangle_groups) as u32;

fn list_rings(
    resources: &mut Resources,
    recording: &mut Recording,
    mesh: &TriangleMesh,
    size: &Buffer<MeshSize>,
) -> Rings {
    let (most_vertices, most_sides) = (mesh.vertices.len, mesh.indices.len);
    let most_triangles = most_sides / 3;
    // One more than there are vertices: the scan ends with the sum.
    let mut counts = resources.buffer("ring_counts", most_vertices + 1);
    let mut places = resources.buffer("ring_places", most_sides);
    recording.clear(&mut counts);
    recording.dispatch_indirect(
        &CountRings {
            mesh_indices: mesh.indices.read(),
            mesh_size: size.read(),
            ring_counts: counts.write(),
            ring_places: places.write(),
        },
        size,
        TRIANGLE_GROUPS_AT,
        most_triangles,
    );
    let starts = scanned(resources, recording, "ring_starts", &counts);
    let mut ends = resources.buffer("rings", most_sides);
    recording.dispatch_indirect(
        &ListRings {
            mesh_indices: mesh.indices.read(),
            mesh_size: size.read(),
            ring_starts: starts.read(),
            ring_places: places.read(),
            rings: ends.write(),
        },
        size,
        TRIANGLE_GROUPS_AT,
        most_triangles,
    );
    recording.dispatch_indirect(
        &SortRings { mesh_size: size.read(), ring_starts: starts.read(), rings: ends.write() },
        size,
        VERTEX_GROUPS_AT,
        most_vertices,
    );
    Rings { starts, ends }
}

impl Refining {
    /// From one buffer of vertices to another and back.
    fn smooth_normals(&mut self, resources: &mut Resources, recording: &mut Recording, times: u32) {
        let most = self.mesh.vertices.len;
        let mut smoothed = resources.buffer("smoothed_vertices", most);
        for _ in 0..times {
            recording.dispatch_indirect(
                &SmoothNormals {
                    mesh_size: self.size.read(),
                    ring_starts: self.rings.starts.read(),
                    rings: self.rings.ends.read(),
                    mesh_vertices: self.mesh.vertices.read(),
                    smoothed_vertices: smoothed.write(),
                    refine: self.params.uniform(),
                },
                &self.size,
                VERTEX_GROUPS_AT,
                most,
            );
            std::mem::swap(&mut self.mesh.vertices, &mut smoothed);
        }
    }

    /// The mesh with each side of its triangles cut into parts.
    fn subdivided(
        &self,
        resources: &mut Resources,
        recording: &mut Recording,
        options: &RefineOptions,
    ) -> TriangleMesh {
        let (mesh, most) = (&self.mesh, self.mesh.vertices.len);
        let most_triangles = mesh.indices.len / 3;
        let mut edge_counts = resources.buffer("edge_counts", most + 1);
        recording.clear(&mut edge_counts);
        recording.dispatch_indirect(
            &CountEdges {
                mesh_size: self.size.read(),
                ring_starts: self.rings.starts.read(),
                rings: self.rings.ends.read(),
                edge_counts: edge_counts.write(),
            },
            &self.size,
            VERTEX_GROUPS_AT,
            most,
        );
        let edge_starts = scanned(resources, recording, "edge_starts", &edge_counts);
        let mut counts = resources.buffer("fine_counts", 1);
        recording.dispatch_groups(
            &FinishSubdivision {
                mesh_counts: mesh.counts.read(),
                edge_starts: edge_starts.read(),
                fine_counts: counts.write(),
                refine: self.params.uniform(),
            },
            [1; 3],
        );
        let mut vertices = resources.buffer("fine_vertices", options.most_vertices);
        recording.dispatch_indirect(
            &SubdivideEdges {
                mesh_size: self.size.read(),
                ring_starts: self.rings.starts.read(),
                rings: self.rings.ends.read(),
                edge_starts: edge_starts.read(),
                mesh_vertices: mesh.vertices.read(),
                fine_vertices: vertices.write(),
                refine: self.params.uniform(),
            },
            &self.size,
            VERTEX_GROUPS_AT,
            most,
        );
        if options.parts > 2 {
            recording.dispatch_indirect(
                &SubdivideMiddles {
                    mesh_indices: mesh.indices.read(),
                    mesh_size: self.size.read(),
                    edge_starts: edge_starts.read(),
                    mesh_vertices: mesh.vertices.read(),
                    fine_vertices: vertices.write(),
                    refine: self.params.uniform(),
                },
                &self.size,
                TRIANGLE_GROUPS_AT,
                most_triangles,
            );
        }
        let mut indices = resources.buffer("fine_indices", options.most_triangles.saturating_mul(3));
        recording.dispatch_indirect(
            &SubdivideTriangles {
                mesh_indices: mesh.indices.read(),
                mesh_size: self.size.read(),
                ring_starts: self.rings.starts.read(),
                rings: self.rings.ends.read(),
                edge_starts: edge_starts.read(),
                fine_indices: indices.write(),
                fine_counts: counts.write(),
                refine: self.params.uniform(),
            },
            &self.size,
            TRIANGLE_GROUPS_AT,
            most_triangles,
        );
        TriangleMesh { vertices, indices, counts }
    }
}
