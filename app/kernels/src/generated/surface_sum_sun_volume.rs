// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/sum_sun_volume.compute.
//! Kernels of `surface/sum_sun_volume.compute`.

use super::SunVolumeParams;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Second of the sun's volume: the water between the sun and the middle of each cell, m.
#[derive(Debug)]
pub struct SumSunVolume<'a> {
    /// `StructuredBuffer<uint> sun_volume_counts`.
    pub sun_volume_counts: Buf<'a, u32>,
    /// `RWStructuredBuffer<float> sun_volume`.
    pub sun_volume: BufMut<'a, f32>,
    /// `ConstantBuffer<SunVolumeParams> volume`.
    pub volume: Uniform<'a, SunVolumeParams>,
}

impl Kernel for SumSunVolume<'_> {
    const STAGE: &'static str = "sum_sun_volume";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SUM_SUN_VOLUME
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sun_volume_counts", Some(self.sun_volume_counts.id)),
                ("sun_volume", Some(self.sun_volume.id)),
                ("volume", Some(self.volume.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SUM_SUN_VOLUME];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "sun_volume_counts",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "sun_volume",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "volume", slot: 2, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_sum_sun_volume.deflate"));

static SUM_SUN_VOLUME: Module = Module {
    name: "SumSunVolume",
    entry: "SumSunVolume",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2188 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/sum_sun_volume.compute",
    hash: "471199d97af19d659e5ef60d43569350b6711d491ae55ba005dd7606c2c3e874",
};
