//! The mesh as the eye sees it: what the water is shaded from.

use brooklet_gpu::{DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{Buffer, DrawMeshDepth, Format, FrameView, Texture};

use super::SurfaceMesh;

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
    (size_px, depth_format): ([u32; 2], Format),
) -> DrawnMesh {
    let inverse_depth = resources.texture("mesh_inverse_depth", Format::R32Float, size_px);
    let normals = resources.texture("mesh_normals", Format::Rgba16Float, size_px);
    let covered = resources.texture("mesh_depth", depth_format, size_px);
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
