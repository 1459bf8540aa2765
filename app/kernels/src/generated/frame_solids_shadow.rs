// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/solids_shadow.hlsl.
//! Kernels of `frame/solids_shadow.hlsl`.

use super::{FrameLight, SolidPose, SolidVertex};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// The opaque solids' shadow map, seen along the sun's rays. Depth only.
#[derive(Debug)]
pub struct DrawSolidsShadow<'a> {
    /// `StructuredBuffer<uint> solid_indices`.
    pub solid_indices: Buf<'a, u32>,
    /// `StructuredBuffer<SolidVertex> solid_vertices`.
    pub solid_vertices: Buf<'a, SolidVertex>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
}

impl Draw for DrawSolidsShadow<'_> {
    const STAGE: &'static str = "draw_solids_shadow";

    fn vertex(&self) -> &'static Module {
        &DRAW_SOLIDS_SHADOW_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SOLIDS_SHADOW_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("solid_indices", Some(self.solid_indices.id)),
                ("solid_vertices", Some(self.solid_vertices.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("light", Some(self.light.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_SOLIDS_SHADOW_VERTEX, &DRAW_SOLIDS_SHADOW_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "solid_indices",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solid_vertices",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "solid_poses", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_solids_shadow.deflate"));

static DRAW_SOLIDS_SHADOW_VERTEX: Module = Module {
    name: "DrawSolidsShadow.vertex",
    entry: "SolidsShadowVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3508 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids_shadow.hlsl",
    hash: "fb4d49d676ebac3df1c2369f8c826e74b83ecb822e30a0fb139234656c20fdd5",
};

static DRAW_SOLIDS_SHADOW_FRAGMENT: Module = Module {
    name: "DrawSolidsShadow.fragment",
    entry: "SolidsShadowFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 3508, bytes: 188 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/solids_shadow.hlsl",
    hash: "54dbe71844a9a98d5771e94afabef9cb6f68725258562a3b77795823dc25c615",
};
