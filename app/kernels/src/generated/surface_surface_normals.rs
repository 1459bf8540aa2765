// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/surface_normals.hlsl.
//! Kernels of `surface/surface_normals.hlsl`.

use super::{FrameView, SurfaceParams};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// The surface's normals as a texture, for who wants them (measuring a filter's error); the water
/// itself restores them where it shades. w is 1 on the fluid.
#[derive(Debug)]
pub struct DrawSurfaceNormals<'a> {
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Draw for DrawSurfaceNormals<'_> {
    const STAGE: &'static str = "draw_surface_normals";

    fn vertex(&self) -> &'static Module {
        &DRAW_SURFACE_NORMALS_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_SURFACE_NORMALS_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("inverse_depth", Some(self.inverse_depth.id)),
                ("view", Some(self.view.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_SURFACE_NORMALS_VERTEX, &DRAW_SURFACE_NORMALS_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_surface_normals.deflate"));

static DRAW_SURFACE_NORMALS_VERTEX: Module = Module {
    name: "DrawSurfaceNormals.vertex",
    entry: "SurfaceNormalsVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 572 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/surface_normals.hlsl",
    hash: "9c7edd4ff8389b6f4032ddace00b4aa0cc324a8b3f54a6fb92b6b35a7d016a96",
};

static DRAW_SURFACE_NORMALS_FRAGMENT: Module = Module {
    name: "DrawSurfaceNormals.fragment",
    entry: "SurfaceNormalsFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 572, bytes: 6376 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/surface_normals.hlsl",
    hash: "84927ce7b5b9d6dad8cc83a8010d3425842bbff439530efbddfd89208af4c16b",
};
