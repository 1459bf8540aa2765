// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/carry_pressure.compute.
//! Kernels of `solver/dfsph/carry_pressure.compute`.

use super::{CellSlot, Position, PressureSolve, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Brings a share of the pressures that the last substep's solve ended with to where the sort put their particles, for the next
/// one to begin with.
#[derive(Debug)]
pub struct CarryPressure<'a> {
    /// As they were before the sort.
    ///
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<CellSlot> cell_slots`.
    pub cell_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `StructuredBuffer<float> pressures`.
    pub pressures: Buf<'a, f32>,
    /// `RWStructuredBuffer<float> carried_pressures`.
    pub carried_pressures: BufMut<'a, f32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<PressureSolve> solve`.
    pub solve: Uniform<'a, PressureSolve>,
}

impl Kernel for CarryPressure<'_> {
    const STAGE: &'static str = "carry_pressure";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &CARRY_PRESSURE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("cell_slots", Some(self.cell_slots.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("pressures", Some(self.pressures.id)),
                ("carried_pressures", Some(self.carried_pressures.id)),
                ("step_state", Some(self.step_state.id)),
                ("solve", Some(self.solve.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&CARRY_PRESSURE];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_slots", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "cell_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "pressures", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "carried_pressures",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solve", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_carry_pressure.deflate"));

static CARRY_PRESSURE: Module = Module {
    name: "CarryPressure",
    entry: "CarryPressure",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4000 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/carry_pressure.compute",
    hash: "51ac5107142a5b019e9875bab8e55339e8a336bc3b707d156c53e080c3491fc9",
};
