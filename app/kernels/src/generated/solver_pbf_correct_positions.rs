// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/correct_positions.compute.
//! Kernels of `solver/pbf/correct_positions.compute`.

use super::{
    Counters, ListHead, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, SolidContact,
    SolidsParams, StepParams, StepState, WallsKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CorrectPositions`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CorrectPositionsVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
    /// Keyword `S_CORR`.
    pub s_corr: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// One Jacobi correction of the positions (Macklin & Muller 2013, eq. 12-14), under-relaxed:
/// plain Jacobi is unstable at ordinary neighbour counts. A wall answers with its particle's own
/// lambda, as the fluid mirrored in it would, so that even pressure leaves a wall's layer alone.
#[derive(Debug)]
pub struct CorrectPositions<'a> {
    /// Its variant.
    pub variant: CorrectPositionsVariant,
    /// `StructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<Buf<'a, PositionLambda>>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: BufMut<'a, [u32; 2]>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `StructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<Buf<'a, [u32; 2]>>,
    /// `RWStructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Option<BufMut<'a, SolidContact>>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Option<Uniform<'a, SolidsParams>>,
}

impl Kernel for CorrectPositions<'_> {
    const STAGE: &'static str = "correct_positions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.s_corr, self.variant.precision) {
            (WallsKeyword::Off, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS,
            (WallsKeyword::Off, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
            (WallsKeyword::Off, false, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_HALF_PRECISION,
            (WallsKeyword::Off, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_S_CORR,
            (WallsKeyword::Off, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Off, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_WALLS,
            (WallsKeyword::Walls, false, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, false, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
            (WallsKeyword::Walls, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_SOLID_WALLS,
            (WallsKeyword::SolidWalls, false, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, false, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::SolidWalls, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR,
            (WallsKeyword::SolidWalls, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::SolidWalls, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
                ("solid_contacts", self.solid_contacts.as_ref().map(|bound| bound.id)),
                ("solids_params", self.solids_params.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CORRECT_POSITIONS,
    &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_SOLID_WALLS,
    &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_HALF_PRECISION,
    &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR,
    &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION,
    &CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR_WITH_HALF_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "position_lambdas",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo {
        name: "position_lambdas",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 10, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "solids_params", slot: 11, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo {
        name: "counters",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 10, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "solids_params", slot: 11, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_correct_positions.deflate"));

static CORRECT_POSITIONS: Module = Module {
    name: "CorrectPositions",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15176 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "f7c35de0d4cf3812c128b0e574faf67be6879d059331d855fa7fb01649c33762",
};

static CORRECT_POSITIONS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15176, bytes: 15592 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "90df3ac6621338405cd3f33e4e40eaa6155219762dc002eb4778ab2d4e9aef08",
};

static CORRECT_POSITIONS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30768, bytes: 15680 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "79748135545f378ea3a0f5a49e71a430696ad7aac5abe8968a72cc05d90948d5",
};

static CORRECT_POSITIONS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 46448, bytes: 16172 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "dc4e207723aedd843b3108f42831d093837f92755842fe0ff85cbd26d56f0a26",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 62620, bytes: 16780 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "7609029bd76ee902eb1524bcc465fd8facdd9da8b115f45b4f393342984b28bd",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 79400, bytes: 16888 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "2c097fd8f88a72bacd73bd04d9a8f71e54e5f543174479fd96b83ad6c6e1907c",
};

static CORRECT_POSITIONS_WITH_WALLS: Module = Module {
    name: "CorrectPositions+WALLS",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 96288, bytes: 17468 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "a4540f950c241c2801f3da9ca86f7fec60a1228a14ec4462e2109508103c27e4",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 113756, bytes: 17868 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "e9457aae6f735e16eebeee9c5b09ef6df5cc1b8e3b7ec87b7e2f7aaab2220a37",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 131624, bytes: 17956 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "f8fb726a3286f3a162c9d7785485f3d2b472f23d0b6fa4f9fa27827b69661362",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 149580, bytes: 18448 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "481373993839f7a46566befa24ca83fa7f1ee2ed04b866fadc015b5cb865d6cd",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 168028, bytes: 19040 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "7d89c805c990616db9fd923b063941d1852d75f65f0125853a9d71e5a80adfc4",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 187068, bytes: 19164 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "a2e12978251390a4f1ab70484bfa1ec8a54a643a1a8b2cb769fa9ece6e2dc760",
};

static CORRECT_POSITIONS_WITH_SOLID_WALLS: Module = Module {
    name: "CorrectPositions+SOLID_WALLS",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 206232, bytes: 21416 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "c0d1ab0cca586c855bff4927290486ebf54a19eee06e5b66732d88b24ba39f8c",
};

static CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+SOLID_WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 227648, bytes: 21816 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "1ce148191946f99ab775d8c2c3e3e9f38b707c9a6eca50d0e57a38e827f2af79",
};

static CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+SOLID_WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 249464, bytes: 21904 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "6ee588ac938ed76e7d9924a2bd7d149ab0b43a5cbc936114b5339b9490d8e3d6",
};

static CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+SOLID_WALLS+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 271368, bytes: 22396 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "4196cac19f9ae8553c432817ba03562d3764e31bdb88f18164d6457c8111f484",
};

static CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+SOLID_WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 293764, bytes: 22988 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "22331a28ef5bdd3b0329f15d6d998b5fae45221b6c5f6a7e3bd7c347ceec3fab",
};

static CORRECT_POSITIONS_WITH_SOLID_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+SOLID_WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 316752, bytes: 23112 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "9523ee535669fb2d4f84a66764d0251784b365888e87b76ffd39ed1fb11fd9aa",
};
