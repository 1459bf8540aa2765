// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/shift_positions.compute.
//! Kernels of `solver/dfsph/shift_positions.compute`.

use super::{Counters, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ShiftPositions`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ShiftPositionsVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Moves particles by what takes out their compression, and leaves their velocities: fluid that was squashed is not flung
/// apart (implicit density projection, Kugelstadt, Longva, Thuerey & Bender 2021).
#[derive(Debug)]
pub struct ShiftPositions<'a> {
    /// Its variant.
    pub variant: ShiftPositionsVariant,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// displacements over dt
    ///
    /// `StructuredBuffer<Velocity> shifts`.
    pub shifts: Buf<'a, Velocity>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
}

impl Kernel for ShiftPositions<'_> {
    const STAGE: &'static str = "shift_positions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (false, false) => &SHIFT_POSITIONS,
            (false, true) => &SHIFT_POSITIONS_WITH_PERIODIC,
            (true, false) => &SHIFT_POSITIONS_WITH_WALLS,
            (true, true) => &SHIFT_POSITIONS_WITH_WALLS_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("shifts", Some(self.shifts.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &SHIFT_POSITIONS,
    &SHIFT_POSITIONS_WITH_PERIODIC,
    &SHIFT_POSITIONS_WITH_WALLS,
    &SHIFT_POSITIONS_WITH_WALLS_WITH_PERIODIC,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "shifts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "counters",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_shift_positions.deflate"));

static SHIFT_POSITIONS: Module = Module {
    name: "ShiftPositions",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4584 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "2a0ab4963c3b18d6cbdeda44bf7665d3e17ec2a18d874e5e9b558b1aebefa29b",
};

static SHIFT_POSITIONS_WITH_PERIODIC: Module = Module {
    name: "ShiftPositions+PERIODIC",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4584, bytes: 5568 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "3155620e9cba2453a5daf0b2e50690bc5a2eb9f8823e2951c12d35c89863bee7",
};

static SHIFT_POSITIONS_WITH_WALLS: Module = Module {
    name: "ShiftPositions+WALLS",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10152, bytes: 4836 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "cbdc6c84fecd8cc4959bfa496516435b9e0fedb6738a0fc7d1c987799a8b10aa",
};

static SHIFT_POSITIONS_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "ShiftPositions+WALLS+PERIODIC",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 14988, bytes: 5820 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "6e2a91de3ac20fc10887f292597ed86dccf63a66907f7aedf18445aaf0addf33",
};
