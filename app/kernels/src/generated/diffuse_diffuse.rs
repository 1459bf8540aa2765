// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/diffuse.hlsl.
//! Kernels of `diffuse/diffuse.hlsl`.

use super::{DiffuseParticle, DiffuseStyle, FrameView, WaterStyle};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawDiffuse`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawDiffuseVariant {
    /// Keyword `WATER`.
    pub water: bool,
}

/// Diffuse particles as optical depth and what is left of their white, both added up: small soft discs before what is opaque. With
/// WATER those behind its surface are seen through it: what the water takes of their light it takes of their colour (Beer-Lambert,
/// there and back).
#[derive(Debug)]
pub struct DrawDiffuse<'a> {
    /// Its variant.
    pub variant: DrawDiffuseVariant,
    /// `StructuredBuffer<DiffuseParticle> diffuse`.
    pub diffuse: Buf<'a, DiffuseParticle>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<DiffuseStyle> diffuse_style`.
    pub diffuse_style: Uniform<'a, DiffuseStyle>,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Option<Tex<'a>>,
    /// `ConstantBuffer<WaterStyle> water`.
    pub water: Option<Uniform<'a, WaterStyle>>,
}

impl Draw for DrawDiffuse<'_> {
    const STAGE: &'static str = "draw_diffuse";

    fn vertex(&self) -> &'static Module {
        if self.variant.water { &DRAW_DIFFUSE_VERTEX_WITH_WATER } else { &DRAW_DIFFUSE_VERTEX }
    }
    fn fragment(&self) -> Option<&'static Module> {
        if self.variant.water { Some(&DRAW_DIFFUSE_FRAGMENT_WITH_WATER) } else { Some(&DRAW_DIFFUSE_FRAGMENT) }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("diffuse", Some(self.diffuse.id)),
                ("view", Some(self.view.id)),
                ("diffuse_style", Some(self.diffuse_style.id)),
                ("inverse_depth", self.inverse_depth.as_ref().map(|bound| bound.id)),
                ("water", self.water.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&DRAW_DIFFUSE_VERTEX, &DRAW_DIFFUSE_FRAGMENT, &DRAW_DIFFUSE_VERTEX_WITH_WATER, &DRAW_DIFFUSE_FRAGMENT_WITH_WATER];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "diffuse", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "diffuse_style", slot: 2, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "diffuse", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "diffuse_style", slot: 4, kind: BindingKind::Uniform { bytes: 16 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "water", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "diffuse_style", slot: 4, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/diffuse_diffuse.deflate"));

static DRAW_DIFFUSE_VERTEX: Module = Module {
    name: "DrawDiffuse.vertex",
    entry: "DiffuseVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4140 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/diffuse.hlsl",
    hash: "5c943a670946c066a15b1600fb193c92183c74d6e60b80566eed2cf041fd971e",
};

static DRAW_DIFFUSE_FRAGMENT: Module = Module {
    name: "DrawDiffuse.fragment",
    entry: "DiffuseFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4140, bytes: 832 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/diffuse.hlsl",
    hash: "3ce6869bdbed70c96b1add7a8b955c9849f137a194b59bd347ff2c3403942a4b",
};

static DRAW_DIFFUSE_VERTEX_WITH_WATER: Module = Module {
    name: "DrawDiffuse.vertex+WATER",
    entry: "DiffuseVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 4972, bytes: 4140 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/diffuse.hlsl",
    hash: "c11ee0593a6cd7160638b5a35bb89c6420197cd2903cbc5a9bfd41047d93e309",
};

static DRAW_DIFFUSE_FRAGMENT_WITH_WATER: Module = Module {
    name: "DrawDiffuse.fragment+WATER",
    entry: "DiffuseFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 9112, bytes: 2548 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/diffuse.hlsl",
    hash: "f9ebb42221b84e6906d8340f66a12d2d7716e8147c805736b097a3dad642cef9",
};
