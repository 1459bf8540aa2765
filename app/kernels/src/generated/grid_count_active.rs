// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/count_active.compute.
//! Kernels of `grid/count_active.compute`.

use super::{GridParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// How many particles the sort has put before the inactive slots.
#[derive(Debug)]
pub struct CountActive<'a> {
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<StepState> step_state`.
    pub step_state: BufMut<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for CountActive<'_> {
    const STAGE: &'static str = "count_active";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_ACTIVE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("cell_starts", Some(self.cell_starts.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_ACTIVE];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "cell_starts", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "step_state",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "grid", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_count_active.deflate"));

static COUNT_ACTIVE: Module = Module {
    name: "CountActive",
    entry: "CountActive",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2196 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/count_active.compute",
    hash: "5039538a8b28c3c9b336b7168a470b9fee6f0dca17a4a80392164a589abd26ae",
};
