// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/opaque_planes.hlsl.
//! Kernels of `surface/opaque_planes.hlsl`.

use super::{FrameView, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// What is opaque behind the water, as the plane that touches it in each texel of the thickness: worked out once
/// and not for each of the discs that cover the texel.
#[derive(Debug)]
pub struct DrawOpaquePlanes<'a> {
    /// `Texture2D<float> scene_depth`.
    pub scene_depth: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawOpaquePlanes<'_> {
    const STAGE: &'static str = "draw_opaque_planes";

    fn vertex(&self) -> &'static Module {
        &DRAW_OPAQUE_PLANES_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_OPAQUE_PLANES_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("scene_depth", Some(self.scene_depth.id)),
                ("view", Some(self.view.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_OPAQUE_PLANES_VERTEX, &DRAW_OPAQUE_PLANES_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "scene_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_opaque_planes.deflate"));

static DRAW_OPAQUE_PLANES_VERTEX: Module = Module {
    name: "DrawOpaquePlanes.vertex",
    entry: "OpaquePlanesVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 804 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/opaque_planes.hlsl",
    hash: "fc0960b64529231f16595fe3609dec2ca8ec425e5bb0821bd4f6b326f3b4f00c",
};

static DRAW_OPAQUE_PLANES_FRAGMENT: Module = Module {
    name: "DrawOpaquePlanes.fragment",
    entry: "OpaquePlanesFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 804, bytes: 6580 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/opaque_planes.hlsl",
    hash: "48dbd932c01756dd6199b5b20f8f08f3da13d01c94dc267d91716809fd699a15",
};
