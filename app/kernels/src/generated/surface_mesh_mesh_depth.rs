// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/mesh_depth.hlsl.
//! Kernels of `surface/mesh/mesh_depth.hlsl`.

use super::{FrameView, MeshVertex};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tier, Uniform, bind_draw,
};

/// The surface's mesh as the eye sees it: inverse depth, and the normal that the field gave each vertex.
#[derive(Debug)]
pub struct DrawMeshDepth<'a> {
    /// `StructuredBuffer<uint> mesh_indices`.
    pub mesh_indices: Buf<'a, u32>,
    /// `StructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: Buf<'a, MeshVertex>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
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

static BINDINGS_1: &[BindingInfo] = &[BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } }];

static DRAW_MESH_DEPTH_VERTEX: Module = Module {
    name: "DrawMeshDepth.vertex",
    entry: "MeshDepthVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_mesh_depth.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_depth.hlsl",
    hash: "8a2d3e6ca0e4de8d9657017aa008eba4f06e851cd079a1e366239c654f62efe1",
};

static DRAW_MESH_DEPTH_FRAGMENT: Module = Module {
    name: "DrawMeshDepth.fragment",
    entry: "MeshDepthFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_mesh_depth.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_depth.hlsl",
    hash: "b69032391b46e831530c448d1fe601bbbbf9765e531865dbbd9addb7707e4467",
};
