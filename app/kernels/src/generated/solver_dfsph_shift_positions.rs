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
    /// `StructuredBuffer<float2> solid_fields`.
    pub solid_fields: Option<Buf<'a, [f32; 2]>>,
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
                ("solid_fields", self.solid_fields.as_ref().map(|bound| bound.id)),
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "solids", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 6,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_shift_positions.deflate"));

static SHIFT_POSITIONS: Module = Module {
    name: "ShiftPositions",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4788 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "a9e47b89bd96ede6cebcc395b1d031cd7c809a772e1cfbb8b785e017804472e0",
};

static SHIFT_POSITIONS_WITH_PERIODIC: Module = Module {
    name: "ShiftPositions+PERIODIC",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4788, bytes: 5772 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "26f6c7c98f9ed68b307dca654a7cd954403b3cd48e898a19e947d2d3bd576d12",
};

static SHIFT_POSITIONS_WITH_WALLS: Module = Module {
    name: "ShiftPositions+WALLS",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10560, bytes: 5040 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "18ac92a847b05af292ee88e832ff1aa4837c772258d93c15084e9f9eb74bcbca",
};

static SHIFT_POSITIONS_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "ShiftPositions+WALLS+PERIODIC",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15600, bytes: 6024 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "dc2ee3a9b565d7b6e7d3e60721371eba756f1b3ef41e721f3382d011c80225bb",
};

static SHIFT_POSITIONS_WITH_SOLID_WALLS: Module = Module {
    name: "ShiftPositions+SOLID_WALLS",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 21624, bytes: 20620 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "e6b1ae6a278cc1ebdb552f1c7bedd6a1b97bea16d63239db37f9ca2d20f0ddee",
};

static SHIFT_POSITIONS_WITH_SOLID_WALLS_WITH_PERIODIC: Module = Module {
    name: "ShiftPositions+SOLID_WALLS+PERIODIC",
    entry: "ShiftPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42244, bytes: 21588 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/shift_positions.compute",
    hash: "e765159490fc2af4677a11e3c81530600c96f0656fbd7a3eb2302b247aecee47",
};
