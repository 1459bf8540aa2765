// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/foam.hlsl.
//! Kernels of `diffuse/foam.hlsl`.

use super::{FrameLight, FrameStyle, FrameView};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawFoam`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawFoamVariant {
    /// Keyword `SOLIDS_SHADOW`.
    pub solids_shadow: bool,
}

/// The diffuse particles over the picture: as much of them as their optical depth hides (1 - exp(-depth)), white by sun and sky. Where
/// the depth falls away toward the sun a bank of foam is lit, away from it shaded: it is not a flat white.
#[derive(Debug)]
pub struct DrawFoam<'a> {
    /// Its variant.
    pub variant: DrawFoamVariant,
    /// premultiplied with optical depth, which is its alpha
    ///
    /// `Texture2D<float4> diffuse_light`.
    pub diffuse_light: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Option<Tex<'a>>,
    /// `Texture2D<float> solids_shadow_map`.
    pub solids_shadow_map: Option<Tex<'a>>,
}

impl Draw for DrawFoam<'_> {
    const STAGE: &'static str = "draw_foam";

    fn vertex(&self) -> &'static Module {
        &DRAW_FOAM_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        if self.variant.solids_shadow {
            Some(&DRAW_FOAM_FRAGMENT_WITH_SOLIDS_SHADOW)
        } else {
            Some(&DRAW_FOAM_FRAGMENT)
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("diffuse_light", Some(self.diffuse_light.id)),
                ("view", Some(self.view.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("inverse_depth", self.inverse_depth.as_ref().map(|bound| bound.id)),
                ("solids_shadow_map", self.solids_shadow_map.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&DRAW_FOAM_VERTEX, &DRAW_FOAM_FRAGMENT, &DRAW_FOAM_FRAGMENT_WITH_SOLIDS_SHADOW];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "diffuse_light", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 2, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "diffuse_light", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "inverse_depth", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "solids_shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/diffuse_foam.deflate"));

static DRAW_FOAM_VERTEX: Module = Module {
    name: "DrawFoam.vertex",
    entry: "FoamVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 548 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/foam.hlsl",
    hash: "0a17738eb116a6f40973d648e1aba2ba1a957938cc0f4032e512b1d50d27d308",
};

static DRAW_FOAM_FRAGMENT: Module = Module {
    name: "DrawFoam.fragment",
    entry: "FoamFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 548, bytes: 5724 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/foam.hlsl",
    hash: "b9da310d2e74d86ccc491a4d521721d157f9fd304aac12699b451a4692120562",
};

static DRAW_FOAM_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawFoam.fragment+SOLIDS_SHADOW",
    entry: "FoamFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 6272, bytes: 10524 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/foam.hlsl",
    hash: "d2a4cd48ee04ca381cfb1757ee45a7207dd4becaafd17c53ee0113b91a5056f3",
};
