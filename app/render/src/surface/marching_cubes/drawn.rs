//! The mesh as the eye sees it: what the water is shaded from.

use brooklet_gpu::{DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{Buffer, DrawMeshDepth, FrameView, Texture, Tier};

use super::SurfaceMesh;
use crate::formats;

/// Inverse depth, 1/m, and normals of a mesh; the depth buffer that both were tested against.
pub(crate) struct DrawnMesh {
    pub inverse_depth: Texture,
    pub normals: Texture,
    pub covered: Texture,
}

/// Draws the mesh in a picture of `size_px`, as many triangles as the GPU counted.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    view: &Buffer<FrameView>,
    mesh: &SurfaceMesh,
    (size_px, tier): ([u32; 2], Tier),
) -> DrawnMesh {
    let inverse_depth = resources.texture_in("mesh_inverse_depth", formats::DEPTH, size_px);
    let normals = resources.texture_in("mesh_normals", formats::LIGHT, size_px);
    let covered = resources.texture_in("mesh_depth", formats::depth_buffer(tier), size_px);
    recording.draw_indirect(
        &DrawMeshDepth {
            mesh_indices: mesh.indices.read(),
            mesh_vertices: mesh.vertices.read(),
            view: view.uniform(),
            mesh: mesh.params.uniform(),
        },
        &Targets {
            color: vec![(&inverse_depth, Load::Clear([0.0; 4])), (&normals, Load::Clear([0.0; 4]))],
            depth: Some((&covered, Load::Clear(0.0))),
        },
        DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() },
        &mesh.counts,
        0,
        1,
    );
    DrawnMesh { inverse_depth, normals, covered }
}
