// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/metal.hlsl.
//! Kernels of `surface/metal.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, SurfaceParams, WaterStyle};
use crate::{
    BindingError, BindingInfo, BindingKind, Bound, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawMetal`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawMetalVariant {
    /// Keyword `MESH_NORMALS`.
    pub mesh_normals: bool,
    /// Keyword `SOLIDS_SHADOW`.
    pub solids_shadow: bool,
}

/// A fluid of metal as it is seen: light that meets it is mirrored or gone, so nothing is read of what lies behind it, nor how
/// thick it is. Alpha is 1 there. What is opaque and in front stays in front.
#[derive(Debug)]
pub struct DrawMetal<'a> {
    /// Its variant.
    pub variant: DrawMetalVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `Texture2D<float> scene_depth`.
    pub scene_depth: Tex<'a>,
    /// `Texture2D<float> sun_thickness`.
    pub sun_thickness: Tex<'a>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `ConstantBuffer<WaterStyle> water`.
    pub water: Uniform<'a, WaterStyle>,
    /// `Texture2D<float> solids_shadow_map`.
    pub solids_shadow_map: Option<Tex<'a>>,
    /// `Texture2D<float4> mesh_normals`.
    pub mesh_normals: Option<Tex<'a>>,
}

impl Draw for DrawMetal<'_> {
    const STAGE: &'static str = "draw_metal";

    fn vertex(&self) -> &'static Module {
        match (self.variant.mesh_normals, self.variant.solids_shadow) {
            (false, false) => &DRAW_METAL_VERTEX,
            (false, true) => &DRAW_METAL_VERTEX,
            (true, false) => &DRAW_METAL_VERTEX_WITH_MESH_NORMALS,
            (true, true) => &DRAW_METAL_VERTEX_WITH_MESH_NORMALS,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match (self.variant.mesh_normals, self.variant.solids_shadow) {
            (false, false) => Some(&DRAW_METAL_FRAGMENT),
            (false, true) => Some(&DRAW_METAL_FRAGMENT_WITH_SOLIDS_SHADOW),
            (true, false) => Some(&DRAW_METAL_FRAGMENT_WITH_MESH_NORMALS),
            (true, true) => Some(&DRAW_METAL_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("inverse_depth", Some(self.inverse_depth.id)),
                ("scene_depth", Some(self.scene_depth.id)),
                ("sun_thickness", Some(self.sun_thickness.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("surface", Some(self.surface.id)),
                ("water", Some(self.water.id)),
                ("solids_shadow_map", self.solids_shadow_map.as_ref().map(|bound| bound.id)),
                ("mesh_normals", self.mesh_normals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_METAL_VERTEX,
    &DRAW_METAL_FRAGMENT,
    &DRAW_METAL_FRAGMENT_WITH_SOLIDS_SHADOW,
    &DRAW_METAL_VERTEX_WITH_MESH_NORMALS,
    &DRAW_METAL_FRAGMENT_WITH_MESH_NORMALS,
    &DRAW_METAL_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW,
];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "scene_depth", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_thickness", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 3, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "scene_depth", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_thickness", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 3, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 5, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 9, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_3: &[BindingInfo] = &[BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "scene_depth", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_thickness", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 3, kind: BindingKind::Sampler },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "scene_depth", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_thickness", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 3, kind: BindingKind::Sampler },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 10, kind: BindingKind::Texture { filterable: false } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_metal.deflate"));

static DRAW_METAL_VERTEX: Module = Module {
    name: "DrawMetal.vertex",
    entry: "MetalVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1716 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/metal.hlsl",
    hash: "0b9eeba0e1208e13d736dd41e0d2feab1773c40b07a6633dadfa8b577566057f",
};

static DRAW_METAL_FRAGMENT: Module = Module {
    name: "DrawMetal.fragment",
    entry: "MetalFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 1716, bytes: 14772 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/metal.hlsl",
    hash: "38d17595e67b2648c4b3d5bc6a1d34b212a48fc72a2b30a4d2f7690c6bbf070b",
};

static DRAW_METAL_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawMetal.fragment+SOLIDS_SHADOW",
    entry: "MetalFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 16488, bytes: 18492 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/metal.hlsl",
    hash: "c7cbe167451fe4a492b2e87c1d777317b8dc6dcb6a29b212af00c2d16d59f18e",
};

static DRAW_METAL_VERTEX_WITH_MESH_NORMALS: Module = Module {
    name: "DrawMetal.vertex+MESH_NORMALS",
    entry: "MetalVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 34980, bytes: 1716 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/metal.hlsl",
    hash: "840faf258a02035d6d158de396dbeaf1458cf3084025543f3909e44260ccd11f",
};

static DRAW_METAL_FRAGMENT_WITH_MESH_NORMALS: Module = Module {
    name: "DrawMetal.fragment+MESH_NORMALS",
    entry: "MetalFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 36696, bytes: 11540 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/metal.hlsl",
    hash: "035effa11384e3bbb1cdba404a47870e53c4f51bc8b892d9c6f1f0e5612570a7",
};

static DRAW_METAL_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawMetal.fragment+MESH_NORMALS+SOLIDS_SHADOW",
    entry: "MetalFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 48236, bytes: 15312 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/metal.hlsl",
    hash: "5db731ac7f2bc2c80df49258d08f90d2d2fdee4da7b864cb0a9a5115d6e335af",
};
