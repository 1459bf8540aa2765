// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/count_sun_volume.compute.
//! Kernels of `surface/count_sun_volume.compute`.

use super::{FrameLight, Position, StepState, SunVolumeParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// First of the sun's volume: each particle's volume in the eight cells around it, as integers, whose sum does not
/// depend on the order.
#[derive(Debug)]
pub struct CountSunVolume<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<uint> sun_volume_counts`.
    pub sun_volume_counts: BufMut<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<SunVolumeParams> volume`.
    pub volume: Uniform<'a, SunVolumeParams>,
}

impl Kernel for CountSunVolume<'_> {
    const STAGE: &'static str = "count_sun_volume";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_SUN_VOLUME
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("sun_volume_counts", Some(self.sun_volume_counts.id)),
                ("step_state", Some(self.step_state.id)),
                ("light", Some(self.light.id)),
                ("volume", Some(self.volume.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_SUN_VOLUME];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "sun_volume_counts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "volume", slot: 4, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_count_sun_volume.deflate"));

static COUNT_SUN_VOLUME: Module = Module {
    name: "CountSunVolume",
    entry: "CountSunVolume",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5052 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/count_sun_volume.compute",
    hash: "7bff8482549d673e130d3dbf412adce28baeae13496bb01728b7aa755132cfcb",
};
