// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/caustics.hlsl.
//! Kernels of `surface/caustics.hlsl`.

use super::{FrameLight, Photon, SurfaceParams, WaterStyle};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// The light that photons bring to the floor, in the sun's map: 1 where the sun shines on it unhindered.
#[derive(Debug)]
pub struct DrawCaustics<'a> {
    /// `StructuredBuffer<Photon> photons`.
    pub photons: Buf<'a, Photon>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
    /// `ConstantBuffer<WaterStyle> water`.
    pub water: Uniform<'a, WaterStyle>,
}

impl Draw for DrawCaustics<'_> {
    const STAGE: &'static str = "draw_caustics";

    fn vertex(&self) -> &'static Module {
        &DRAW_CAUSTICS_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_CAUSTICS_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("photons", Some(self.photons.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
                ("water", Some(self.water.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_CAUSTICS_VERTEX, &DRAW_CAUSTICS_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "photons", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "light", slot: 1, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "water", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_caustics.deflate"));

static DRAW_CAUSTICS_VERTEX: Module = Module {
    name: "DrawCaustics.vertex",
    entry: "CausticsVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7116 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/caustics.hlsl",
    hash: "dfdbb67abd81633f937cee0027929114188da24681d137fc3afd95ef0d35921f",
};

static DRAW_CAUSTICS_FRAGMENT: Module = Module {
    name: "DrawCaustics.fragment",
    entry: "CausticsFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 7116, bytes: 876 },
    bindings: &[],
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/caustics.hlsl",
    hash: "20a7675a0626b72e695e0afb82e97d563b78681e9c68a7334c7839bb793b1947",
};
