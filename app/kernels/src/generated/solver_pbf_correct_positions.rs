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
    hash: "c5728aef06cebb12746d54cb072fe18b54af159423d0561747ff877843eef200",
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
    hash: "731f0dac848ea78f1ffc127b24f0ad528ac476e91d7c03ec44cbd83df8b15ea4",
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
    hash: "62e3f066b97bdd990eec073bbe552bd2beb4804d32f5d3663861848822dc5f7e",
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
    hash: "712b4a5f3b1229ee7c5648b3f0f98f25728fbf8058620f8ba8f8afb4a800495d",
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
    hash: "bbb2487745ea4f5333539a209e17e05a7c2a4df987546d00dc4a4793357acc7f",
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
    hash: "18d8966a9b259f1f8e1347a83b01789720c7a8679f3d80f8cdbdc1a4c82314c8",
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
    hash: "bd3c36538c36da30a808f7ad94f966f545edddf9af9b507ef32142d52fb92ad2",
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
    hash: "abbad09f538b6178d7491fc87a83ef47c03dea597f8c7c41e30f01a451edeb7a",
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
    hash: "a4b068e54758c47a13e8df64e6b435e77e7524fb6800519f2e30fe674543059d",
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
    hash: "d92231e34e2c924421d283f3d84b8a74e42767ca13edf67a67987d7a28711f1e",
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
    hash: "35e8fc6e2b6d9db7035b60f85aede8bef019bf47c2c20f459a97ec871a80b7e3",
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
    hash: "50333bf9410f1bc247be4b75cc1975a05c0f7de6f02f5759ee79c645498feaad",
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
    hash: "6d311c729b7673105f99b00fdddcf1d802d2efe2e252ae6e534ff6119caf419c",
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
    hash: "39d18816debd3faa3f310e297d7853c8debcc96878fb5a18d8d75d6663a65c20",
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
    hash: "fe9c4f782e3f8ee3d1b006ec84aebeb5016f9796f5f3b43e763dee714f178b30",
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
    hash: "d16a2b21f0ee6ac826bea26fd667b7240f5c1f0e96adf5dd52a213a6c1aacd3e",
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
    hash: "54d9d0154d913e854526420cfcdc7f85d30926b286f7705ccc81a43336b1a8fe",
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
    hash: "f4e02f14f0d4d3fb5f6ec063a8ca2e5f7c3b148dad9cbffac8ab5b891b10552c",
};
