// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/water.hlsl.
//! Kernels of `surface/water.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, SunVolumeParams, SurfaceParams, WaterStyle};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tex, Tier, Uniform,
    bind_draw,
};

/// Which variant of [`DrawWater`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawWaterVariant {
    /// Keyword `MESH_NORMALS`.
    pub mesh_normals: bool,
    /// Keyword `SELF_SHADOW`.
    pub self_shadow: bool,
    /// Keyword `SOLIDS_SHADOW`.
    pub solids_shadow: bool,
}

/// The water as it is seen: every pixel that the smoothed surface covers, shaded once, over the scene
/// behind it. Alpha is 1 there. What is opaque and in front stays in front.
#[derive(Debug)]
pub struct DrawWater<'a> {
    /// Its variant.
    pub variant: DrawWaterVariant,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `Texture2D<float> thickness`.
    pub thickness: Tex<'a>,
    /// `Texture2D<float4> scene`.
    pub scene: Tex<'a>,
    /// `Texture2D<float> scene_depth`.
    pub scene_depth: Tex<'a>,
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
    /// `StructuredBuffer<float> sun_volume`.
    pub sun_volume: Option<Buf<'a, f32>>,
    /// `ConstantBuffer<SunVolumeParams> volume`.
    pub volume: Option<Uniform<'a, SunVolumeParams>>,
    /// `Texture2D<float4> mesh_normals`.
    pub mesh_normals: Option<Tex<'a>>,
}

impl Draw for DrawWater<'_> {
    const STAGE: &'static str = "draw_water";

    fn vertex(&self) -> &'static Module {
        match (self.variant.mesh_normals, self.variant.self_shadow, self.variant.solids_shadow) {
            (false, false, false) => &DRAW_WATER_VERTEX,
            (false, false, true) => &DRAW_WATER_VERTEX,
            (false, true, false) => &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
            (false, true, true) => &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
            (true, false, false) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
            (true, false, true) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
            (true, true, false) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
            (true, true, true) => &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
        }
    }
    fn fragment(&self) -> Option<&'static Module> {
        match (self.variant.mesh_normals, self.variant.self_shadow, self.variant.solids_shadow) {
            (false, false, false) => Some(&DRAW_WATER_FRAGMENT),
            (false, false, true) => Some(&DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW),
            (false, true, false) => Some(&DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW),
            (false, true, true) => Some(&DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW),
            (true, false, false) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS),
            (true, false, true) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW),
            (true, true, false) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW),
            (true, true, true) => Some(&DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW),
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("view", Some(self.view.id)),
                ("inverse_depth", Some(self.inverse_depth.id)),
                ("thickness", Some(self.thickness.id)),
                ("scene", Some(self.scene.id)),
                ("scene_depth", Some(self.scene_depth.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
                ("surface", Some(self.surface.id)),
                ("water", Some(self.water.id)),
                ("solids_shadow_map", self.solids_shadow_map.as_ref().map(|bound| bound.id)),
                ("sun_volume", self.sun_volume.as_ref().map(|bound| bound.id)),
                ("volume", self.volume.as_ref().map(|bound| bound.id)),
                ("mesh_normals", self.mesh_normals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_WATER_VERTEX,
    &DRAW_WATER_FRAGMENT,
    &DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW,
    &DRAW_WATER_VERTEX_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW,
    &DRAW_WATER_VERTEX_WITH_MESH_NORMALS,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW,
    &DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW,
    &DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW,
];

static BINDINGS_0: &[BindingInfo] = &[BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 4, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 4, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 6, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 10, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_3: &[BindingInfo] = &[BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_4: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 6, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 8, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 9, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 10, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_5: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 6, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 8, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 9, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 10, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 12, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_6: &[BindingInfo] = &[BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_7: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 5, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 7, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_8: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sampler_linear_clamp", slot: 5, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 6, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 7, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 11, kind: BindingKind::Texture { filterable: false } },
];

static BINDINGS_9: &[BindingInfo] = &[BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } }];

static BINDINGS_10: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 7, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 9, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 11, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_11: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene", slot: 2, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "scene_depth", slot: 3, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "mesh_normals", slot: 4, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_volume", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "volume", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "sampler_linear_clamp", slot: 7, kind: BindingKind::Sampler },
    BindingInfo { name: "view", slot: 8, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 9, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "surface", slot: 11, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_shadow_map", slot: 13, kind: BindingKind::Texture { filterable: false } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_water.deflate"));

static DRAW_WATER_VERTEX: Module = Module {
    name: "DrawWater.vertex",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1716 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "66ba7eb160911efc1545dcd679a93edb5303e57150a4da615c6634167d5ecd71",
};

static DRAW_WATER_FRAGMENT: Module = Module {
    name: "DrawWater.fragment",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 1716, bytes: 14920 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "f637ce1651c54a3c7822bd994077c822c872f4a8d889cbb8d61a7faaa09ca52d",
};

static DRAW_WATER_FRAGMENT_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 16636, bytes: 17660 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "784a9e8c6e005234947be5a798b5665db61ed99b7b601b4430faa02c9a0d4944",
};

static DRAW_WATER_VERTEX_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 34296, bytes: 1716 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "18dc03397c71c214594ec73041db514d8bacc4e5d8f0680da2aae9c3e40225e5",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 36012, bytes: 17736 },
    bindings: BINDINGS_4,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "bd22a414468056276caa164b2d3880d51664466cb3b517b9f26403b38e9e63c0",
};

static DRAW_WATER_FRAGMENT_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+SELF_SHADOW+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 53748, bytes: 20204 },
    bindings: BINDINGS_5,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "6c8d94b40b7aed3362556285d6e7808ae94a5b4c2120be36a868e2536d8c3611",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 73952, bytes: 1716 },
    bindings: BINDINGS_6,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "8a09de199255ccffdfb081b2bff3fe70bde4b0b5ea68b55036c7b2e7001ca3dd",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 75668, bytes: 11920 },
    bindings: BINDINGS_7,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "b6b8c3365f0e1b12af34439b8e9ac58e892b27b4a779993dc852cea5283127d9",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 87588, bytes: 14676 },
    bindings: BINDINGS_8,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "ced4515a77ba5fb71073e7e4eb550a4570c827ba7c1d7151bc1eb583658b83cc",
};

static DRAW_WATER_VERTEX_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.vertex+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 102264, bytes: 1716 },
    bindings: BINDINGS_9,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "7a2d5a96a3bb2fda9146f516ab8fc79d48498855ea67a1a772b3f20d0d0dece2",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 103980, bytes: 14736 },
    bindings: BINDINGS_10,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "de90a5962e5d54757c9de8ec861b2267d4e1ed2fba5c4c3dad42cd5f045ea319",
};

static DRAW_WATER_FRAGMENT_WITH_MESH_NORMALS_WITH_SELF_SHADOW_WITH_SOLIDS_SHADOW: Module = Module {
    name: "DrawWater.fragment+MESH_NORMALS+SELF_SHADOW+SOLIDS_SHADOW",
    entry: "WaterFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 118716, bytes: 17220 },
    bindings: BINDINGS_11,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/water.hlsl",
    hash: "add0435ab827c410b515940247a8c5a49c3c3062d60584d8c50cc58bf806499b",
};
