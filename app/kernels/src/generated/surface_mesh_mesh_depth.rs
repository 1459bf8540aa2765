// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/mesh_depth.hlsl.
//! Kernels of `surface/mesh/mesh_depth.hlsl`.

use super::{FrameView, MeshParams, MeshVertex};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// The surface's mesh as the eye sees it: inverse depth, and the normal that the field gave each vertex. What lies in a
/// wall has the wall's, so that the water's edge at the glass is sharp though its vertices have one normal each.
#[derive(Debug)]
pub struct DrawMeshDepth<'a> {
    /// `StructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: Buf<'a, u32>,
    /// `StructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: Buf<'a, MeshVertex>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Draw for DrawMeshDepth<'_> {
    const STAGE: &'static str = "draw_mesh_depth";

    fn vertex(&self) -> &'static Module {
        &DRAW_MESH_DEPTH_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_MESH_DEPTH_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("mesh_indices", Some(self.mesh_indices.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("view", Some(self.view.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_MESH_DEPTH_VERTEX, &DRAW_MESH_DEPTH_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "mesh_indices", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "mesh", slot: 3, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_mesh_depth.deflate"));

static DRAW_MESH_DEPTH_VERTEX: Module = Module {
    name: "DrawMeshDepth.vertex",
    entry: "MeshDepthVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2576 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_depth.hlsl",
    hash: "baf0701f0fa2357546da0c00cd81d039d3ce012922e618267c2a4ff1e80b22a2",
};

static DRAW_MESH_DEPTH_FRAGMENT: Module = Module {
    name: "DrawMeshDepth.fragment",
    entry: "MeshDepthFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 2576, bytes: 3996 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_depth.hlsl",
    hash: "a28aecd15628d4bef00633e820643868b800070d8ecd07b2f66f237812d71f53",
};
