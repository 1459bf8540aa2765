// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/smooth_photons.compute.
//! Kernels of `surface/smooth_photons.compute`.

use super::{AlongKeyword, FrameLight, Photon, SurfaceParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tex, Tier,
    Uniform, bind,
};

/// Which variant of [`SmoothPhotons`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct SmoothPhotonsVariant {
    /// Keyword `ALONG_X` or `ALONG_Y`.
    pub along: AlongKeyword,
}

/// Where photons land without the particles' pattern: how far each is moved, and through how much water, becomes a Gaussian's
/// mean over those that met the same surface, one direction a pass. Where the sun grazes water, along a steep front and at
/// outlines, what is left of a lattice's rows moves photons by more than the rows are apart, and combs the light.
/// Photons that met a wall keep their place: it is flat, and its edges are sharp. So do those at an outline, the less of a
/// window is of their surface: the mean would move it by what stands to one side.
#[derive(Debug)]
pub struct SmoothPhotons<'a> {
    /// Its variant.
    pub variant: SmoothPhotonsVariant,
    /// `Texture2D<float> sun_depth`.
    pub sun_depth: Tex<'a>,
    /// `StructuredBuffer<Photon> photons`.
    pub photons: Buf<'a, Photon>,
    /// `RWStructuredBuffer<Photon> smoothed_photons`.
    pub smoothed_photons: BufMut<'a, Photon>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SurfaceParams> surface`.
    pub surface: Uniform<'a, SurfaceParams>,
}

impl Kernel for SmoothPhotons<'_> {
    const STAGE: &'static str = "smooth_photons";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.along {
            AlongKeyword::AlongX => &SMOOTH_PHOTONS_WITH_ALONG_X,
            AlongKeyword::AlongY => &SMOOTH_PHOTONS_WITH_ALONG_Y,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sun_depth", Some(self.sun_depth.id)),
                ("photons", Some(self.photons.id)),
                ("smoothed_photons", Some(self.smoothed_photons.id)),
                ("light", Some(self.light.id)),
                ("surface", Some(self.surface.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SMOOTH_PHOTONS_WITH_ALONG_X, &SMOOTH_PHOTONS_WITH_ALONG_Y];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "sun_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "photons", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "smoothed_photons",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "surface", slot: 4, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_smooth_photons.deflate"));

static SMOOTH_PHOTONS_WITH_ALONG_X: Module = Module {
    name: "SmoothPhotons+ALONG_X",
    entry: "SmoothPhotons",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8644 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_photons.compute",
    hash: "fd11d5f17cf2b92203ebdbbb003ad3c07104c6f13eb04f9a46c1ea3da4621a13",
};

static SMOOTH_PHOTONS_WITH_ALONG_Y: Module = Module {
    name: "SmoothPhotons+ALONG_Y",
    entry: "SmoothPhotons",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8644, bytes: 8644 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/smooth_photons.compute",
    hash: "dd8aa6419bfce5f3aaefe00955dc76bd28a29cad3dbf081a249421965bec55b2",
};
