// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/shift_positions.compute.
//! Kernels of `solver/dfsph/shift_positions.compute`.

use super::{Counters, Position, Solid, SolidPose, SolidsParams, StepParams, StepState, Velocity, WallsKeyword};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ShiftPositions`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ShiftPositionsVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
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
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Option<Buf<'a, Solid>>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Option<Buf<'a, SolidPose>>,
    /// `StructuredBuffer<uint4> solid_blocks`.
    pub solid_blocks: Option<Buf<'a, [u32; 4]>>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Option<Uniform<'a, SolidsParams>>,
}

impl Kernel for ShiftPositions<'_> {
    const STAGE: &'static str = "shift_positions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (WallsKeyword::Off, false) => &SHIFT_POSITIONS,
            (WallsKeyword::Off, true) => &SHIFT_POSITIONS_WITH_PERIODIC,
            (WallsKeyword::Walls, false) => &SHIFT_POSITIONS_WITH_WALLS,
            (WallsKeyword::Walls, true) => &SHIFT_POSITIONS_WITH_WALLS_WITH_PERIODIC,
            (WallsKeyword::SolidWalls, false) => &SHIFT_POSITIONS_WITH_SOLID_WALLS,
            (WallsKeyword::SolidWalls, true) => &SHIFT_POSITIONS_WITH_SOLID_WALLS_WITH_PERIODIC,
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
                ("solids", self.solids.as_ref().map(|bound| bound.id)),
                ("solid_poses", self.solid_poses.as_ref().map(|bound| bound.id)),
                ("solid_blocks", self.solid_blocks.as_ref().map(|bound| bound.id)),
                ("solids_params", self.solids_params.as_ref().map(|bound| bound.id)),
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
    &SHIFT_POSITIONS_WITH_SOLID_WALLS,
    &SHIFT_POSITIONS_WITH_SOLID_WALLS_WITH_PERIODIC,
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

static BINDINGS_1: &[BindingInfo] = &[
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
    BindingInfo { name: "solids", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo { name: "solid_poses", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 5,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
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
    hash: "e61b36da24f0b206fef12814f0d5729014bd2b5c275580c5ac8c5a7f0dc0311d",
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
    hash: "dd4efeb854f10fbec9255101d72b9067f6ddb89f0e1db6f4aa0bab340085b631",
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
    hash: "5d6f57b24be4d02953dd1aacab01f195f27ed3825b17cccaf88f8537b83d9593",
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
    hash: "b6601e87366e6df8552808bfa6e2511fd2d00e223d6e756527867dcbd500531d",
};

static SHIFT_POSITIONS_WITH_SOLID_WALLS: Module = Module {
    name: "ShiftPositions+SOLID_WALLS",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20808, bytes: 32544 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "69be2fff37fecf2590fb8eb36d834c6940f69a67e263147661a5fafcbbc8814d",
};

static SHIFT_POSITIONS_WITH_SOLID_WALLS_WITH_PERIODIC: Module = Module {
    name: "ShiftPositions+SOLID_WALLS+PERIODIC",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 53352, bytes: 33512 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "2658aaeb146615ba38aa74e4654c206fce8f902a5625ccff0ded4b5ebe22ccf7",
};
