// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/resolve.hlsl.
//! Kernels of `frame/resolve.hlsl`.

use super::{FrameLight, FrameStyle, FrameView};
use crate::{BindingError, BindingInfo, BindingKind, Bound, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw};

/// From linear light to the picture: ambient occlusion from the depth, tone mapping of every drawn
/// pixel, their mean, sRGB, and a dither of one step against banding.
#[derive(Debug)]
pub struct DrawResolve<'a> {
    /// `Texture2D<float4> radiance`.
    pub radiance: Tex<'a>,
    /// `Texture2D<float> depth_map`.
    pub depth_map: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
}

impl Draw for DrawResolve<'_> {
    const STAGE: &'static str = "draw_resolve";

    fn vertex(&self) -> &'static Module {
        &DRAW_RESOLVE_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_RESOLVE_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("radiance", Some(self.radiance.id)),
                ("depth_map", Some(self.depth_map.id)),
                ("view", Some(self.view.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_RESOLVE_VERTEX, &DRAW_RESOLVE_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "radiance", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "depth_map", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
];

static DRAW_RESOLVE_VERTEX: Module = Module {
    name: "DrawResolve.vertex",
    entry: "ResolveVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_resolve.vertex.spv"),
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/resolve.hlsl",
    hash: "675a49588ef5d492c5cd2c5319b814bdafe609c0d553c7f18b8978dc4b0a308f",
};

static DRAW_RESOLVE_FRAGMENT: Module = Module {
    name: "DrawResolve.fragment",
    entry: "ResolveFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_resolve.fragment.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/resolve.hlsl",
    hash: "cfccab23fc6b96c95509e54dae14c4485b5978c6ceb518b704dd30c699b763be",
};
