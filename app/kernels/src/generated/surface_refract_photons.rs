// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/refract_photons.compute.
//! Kernels of `surface/refract_photons.compute`.

use super::{FrameLight, Photon, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tex, Tier,
    Uniform, bind,
};

/// Where sunlight goes through the water: a photon for each cell of a grid over the sun's map is bent by
/// the surface (Snell) and carried to the floor.
#[derive(Debug)]
pub struct RefractPhotons<'a> {
    /// `Texture2D<float> sun_depth`.
    pub sun_depth: Tex<'a>,
    /// `Texture2D<float> sun_thickness`.
    pub sun_thickness: Tex<'a>,
    /// `RWStructuredBuffer<Photon> photons`.
    pub photons: BufMut<'a, Photon>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Kernel for RefractPhotons<'_> {
    const STAGE: &'static str = "refract_photons";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &REFRACT_PHOTONS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sun_depth", Some(self.sun_depth.id)),
                ("sun_thickness", Some(self.sun_thickness.id)),
                ("photons", Some(self.photons.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&REFRACT_PHOTONS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "sun_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "sun_thickness", slot: 1, kind: BindingKind::Texture { filterable: true } },
    BindingInfo { name: "sampler_linear_clamp", slot: 2, kind: BindingKind::Sampler },
    BindingInfo {
        name: "photons",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 5, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_refract_photons.deflate"));

static REFRACT_PHOTONS: Module = Module {
    name: "RefractPhotons",
    entry: "RefractPhotons",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 19608 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/refract_photons.compute",
    hash: "0400dc6b2d5a31408a911db0f9a66ed483d43941a1491173eed74a3f869b9343",
};
