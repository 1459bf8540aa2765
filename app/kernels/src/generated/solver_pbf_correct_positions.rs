// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/correct_positions.compute.
//! Kernels of `solver/pbf/correct_positions.compute`.

use super::{
    Counters, ListHead, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepParams,
    StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CorrectPositions`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CorrectPositionsVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
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
}

impl Kernel for CorrectPositions<'_> {
    const STAGE: &'static str = "correct_positions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.s_corr, self.variant.precision) {
            (false, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS,
            (false, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_RELAXED_PRECISION,
            (false, false, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_HALF_PRECISION,
            (false, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_S_CORR,
            (false, true, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION,
            (false, true, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION,
            (true, false, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_WALLS,
            (true, false, PrecisionKeyword::RelaxedPrecision) => &CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, false, PrecisionKeyword::HalfPrecision) => &CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION,
            (true, true, PrecisionKeyword::Off) => &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR,
            (true, true, PrecisionKeyword::RelaxedPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION
            }
            (true, true, PrecisionKeyword::HalfPrecision) => {
                &CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 9, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_correct_positions.deflate"));

static CORRECT_POSITIONS: Module = Module {
    name: "CorrectPositions",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 14972 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "da2bb1179540b1e3eca12744c8d2de4118c964d199cc0dced3ad6174f741f624",
};

static CORRECT_POSITIONS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 14972, bytes: 14448 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "0c8f86e89577fb54a83a5349d04469ca6125868c56c3b1e0f5fb8f31a91f35cb",
};

static CORRECT_POSITIONS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 29420, bytes: 14536 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "20f4776350b01c26131c848ed0959650953521545effd8d0b41a4c55d84f4dc3",
};

static CORRECT_POSITIONS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 43956, bytes: 15968 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "500c21fa2b09cfe034a53f56bdc612ba506a4c2761e1fb471c3cd9cb1753b946",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 59924, bytes: 15636 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "51c7ee1ab406f1b433f062c54ddb1a9c891423189f0f0046c030ed9ac0691d62",
};

static CORRECT_POSITIONS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 75560, bytes: 15744 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "78742484b64e2e0cdb8787baa2f3b870d7ac94529457521622d3bf04ee512972",
};

static CORRECT_POSITIONS_WITH_WALLS: Module = Module {
    name: "CorrectPositions+WALLS",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 91304, bytes: 17264 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "d91054b3d344765350620f2d685805db578fc1ca74b37543494f1bac386982e5",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 108568, bytes: 16740 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "b23fe0c1ad1062bc7dbc0e2e14cb77f8ba6d7920e062d902d5d739318537d450",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 125308, bytes: 16828 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "637b45a9c4a4102724b2abdf34e7de19aaea55b26e36a2ac142ffe753eb631dc",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 142136, bytes: 18244 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "9e0c1bd84bd81817c6a7098142b17023e750b79af239804a261b19199e523533",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_RELAXED_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+RELAXED_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 160380, bytes: 17912 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/correct_positions.compute",
    hash: "aa9e17d983ea55a7f0121b22b3f3b630d797840cdb95b772410fd7d95f134189",
};

static CORRECT_POSITIONS_WITH_WALLS_WITH_S_CORR_WITH_HALF_PRECISION: Module = Module {
    name: "CorrectPositions+WALLS+S_CORR+HALF_PRECISION",
    entry: "CorrectPositions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 178292, bytes: 18036 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/correct_positions.compute",
    hash: "f738fbe6af3f08c7a238bc33d3b5e9b02ae60eaa670538a0f66434d6608a6776",
};
