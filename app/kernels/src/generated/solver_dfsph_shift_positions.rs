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
    hash: "f71515e984500cf61bf06efa4c2b16d90dc9cd8281ab2887ef228b2bc3eaf010",
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
    hash: "b0382b8287ffb1007eeb3ba08bff3db001398e2ba848954e34197e007e687484",
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
    hash: "fd20ba0538f32dec103c970bdccd41b2beaba91378924e34ff722fef87ee6d21",
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
    hash: "21375a5e2636140095233243febffb7228f5061314fc77f40f140c834159ecfa",
};
