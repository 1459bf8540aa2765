// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/resolve.hlsl.
//! Kernels of `frame/resolve.hlsl`.

use super::{FrameLight, FrameStyle, FrameView};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawResolve`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawResolveVariant {
    /// Keyword `WATER`.
    pub water: bool,
}

/// From linear light to the picture: ambient occlusion from the depth (of points), tone mapping of
/// every drawn pixel, their mean, sRGB, and a dither of one step against banding.
#[derive(Debug)]
pub struct DrawResolve<'a> {
    /// Its variant.
    pub variant: DrawResolveVariant,
    /// `Texture2D<float4> radiance`.
    pub radiance: Tex<'a>,
    /// `Texture2D<float> depth_map`.
    pub depth_map: Option<Tex<'a>>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Option<Uniform<'a, FrameStyle>>,
    /// premultiplied; alpha is 1 where water is seen
    ///
    /// `Texture2D<float4> water`.
    pub water: Option<Tex<'a>>,
}

impl Draw for DrawResolve<'_> {
    const STAGE: &'static str = "draw_resolve";

    fn vertex(&self) -> &'static Module {
        &DRAW_RESOLVE_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        if self.variant.water { Some(&DRAW_RESOLVE_FRAGMENT_WITH_WATER) } else { Some(&DRAW_RESOLVE_FRAGMENT) }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("radiance", Some(self.radiance.id)),
                ("depth_map", self.depth_map.as_ref().map(|bound| bound.id)),
                ("view", Some(self.view.id)),
                ("light", Some(self.light.id)),
                ("style", self.style.as_ref().map(|bound| bound.id)),
                ("water", self.water.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&DRAW_RESOLVE_VERTEX, &DRAW_RESOLVE_FRAGMENT, &DRAW_RESOLVE_FRAGMENT_WITH_WATER];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "radiance", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "depth_map", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "radiance", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "water", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_resolve.deflate"));

static DRAW_RESOLVE_VERTEX: Module = Module {
    name: "DrawResolve.vertex",
    entry: "ResolveVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 556 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/resolve.hlsl",
    hash: "176b0659ffcd8ad595be04a393a1a665c0f6b98e661fc5e66a6b1dbaf2f9c07f",
};

static DRAW_RESOLVE_FRAGMENT: Module = Module {
    name: "DrawResolve.fragment",
    entry: "ResolveFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 556, bytes: 20656 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/resolve.hlsl",
    hash: "f4cc91ca289a2229d6ab76275d6c41027e31da6971f712e544c28a2d1d768887",
};

static DRAW_RESOLVE_FRAGMENT_WITH_WATER: Module = Module {
    name: "DrawResolve.fragment+WATER",
    entry: "ResolveFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 21212, bytes: 4668 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/resolve.hlsl",
    hash: "5c51fd259409cf9145dc5dca1e0a126b1a1007d6aa191e441826cef5e03322a2",
};
