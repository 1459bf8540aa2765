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
    hash: "a62a8d8f31ba21c037f0bb5321279d0c97300e2cfde78e8f53bd366119c5b1ae",
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
    hash: "cbfa7e82df80a55f797780b9810ca75fc92b77804b94c3bd18a3f295c52af39c",
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
    hash: "58d2057d0b3c4a9154b7e81ebdcb08e354962b2aab2996e21021b57b11507efd",
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
    hash: "4bfd3507a311ba857e2267a73e5a2961abd40db7646816f0ec33c9b03797b669",
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
    hash: "6d0f91e79260cf56f2c30a8d4e6da353150214decc6dd9593d636344c0e0ae2c",
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
    hash: "1e5c881bf7cbf2a0e4d1a863493fad5267b8ba1465ca00ff0377c3fd357d9409",
};
