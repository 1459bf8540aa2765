// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/scatter_bins.compute.
//! Kernels of `surface/mesh/scatter_bins.compute`.

use super::{CellSlot, Position, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// The particles side by side, bin after bin, each with its slot: what looks at a bin reads from end to end.
#[derive(Debug)]
pub struct ScatterBins<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<CellSlot> bin_slots`.
    pub bin_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// the tag is the slot's number
    ///
    /// `RWStructuredBuffer<Position> bin_particles`.
    pub bin_particles: BufMut<'a, Position>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for ScatterBins<'_> {
    const STAGE: &'static str = "scatter_bins";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SCATTER_BINS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("bin_slots", Some(self.bin_slots.id)),
                ("bin_starts", Some(self.bin_starts.id)),
                ("bin_particles", Some(self.bin_particles.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SCATTER_BINS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "bin_slots", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "bin_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "bin_particles",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
];

static SCATTER_BINS: Module = Module {
    name: "ScatterBins",
    entry: "ScatterBins",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/scatter_bins.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/scatter_bins.compute",
    hash: "c2bbca19d0edf65e0e41db0a0dec2e1fdeb030c309003ddfa11e16bc26c966ed",
};
