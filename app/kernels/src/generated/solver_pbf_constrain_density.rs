// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/constrain_density.compute.
//! Kernels of `solver/pbf/constrain_density.compute`.

use super::{ListHead, PbfParams, Position, PositionLambda, PrecisionKeyword, SmoothingKernelParams, StepParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`ConstrainDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConstrainDensityVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// The density constraint's multiplier lambda of each particle (Macklin & Muller 2013, eq. 8-11).
#[derive(Debug)]
pub struct ConstrainDensity<'a> {
    /// Its variant.
    pub variant: ConstrainDensityVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: Option<BufMut<'a, PositionLambda>>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `RWStructuredBuffer<uint2> packed_position_lambdas`.
    pub packed_position_lambdas: Option<BufMut<'a, [u32; 2]>>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Option<Buf<'a, Position>>,
}

impl Kernel for ConstrainDensity<'_> {
    const STAGE: &'static str = "constrain_density";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.precision, self.variant.packed) {
            (false, PrecisionKeyword::Off, false) => &CONSTRAIN_DENSITY,
            (false, PrecisionKeyword::Off, true) => &CONSTRAIN_DENSITY_WITH_PACKED,
            (false, PrecisionKeyword::RelaxedPrecision, false) => &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION,
            (false, PrecisionKeyword::RelaxedPrecision, true) => &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION_WITH_PACKED,
            (false, PrecisionKeyword::HalfPrecision, false) => &CONSTRAIN_DENSITY_WITH_HALF_PRECISION,
            (false, PrecisionKeyword::HalfPrecision, true) => &CONSTRAIN_DENSITY_WITH_HALF_PRECISION_WITH_PACKED,
            (true, PrecisionKeyword::Off, false) => &CONSTRAIN_DENSITY_WITH_WALLS,
            (true, PrecisionKeyword::Off, true) => &CONSTRAIN_DENSITY_WITH_WALLS_WITH_PACKED,
            (true, PrecisionKeyword::RelaxedPrecision, false) => &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::RelaxedPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (true, PrecisionKeyword::HalfPrecision, false) => &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION,
            (true, PrecisionKeyword::HalfPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("position_lambdas", self.position_lambdas.as_ref().map(|bound| bound.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_position_lambdas", self.packed_position_lambdas.as_ref().map(|bound| bound.id)),
                ("sorted_positions", self.sorted_positions.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CONSTRAIN_DENSITY,
    &CONSTRAIN_DENSITY_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_HALF_PRECISION_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_WALLS,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "packed_position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
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
        name: "packed_position_lambdas",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static CONSTRAIN_DENSITY: Module = Module {
    name: "ConstrainDensity",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "39a9db101a2f67d036e6cba15faaf4596fd94081622e54353f0163a295c7e9c1",
};

static CONSTRAIN_DENSITY_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "2f37a99846b594c2b613a71032220d6854310c074785f2023daf21bcf8060977",
};

static CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "1842d6f49cf72d6f6472549f0ce4c7f031d818d3a5417e4def9feaad32ed4413",
};

static CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+RELAXED_PRECISION+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+relaxed_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "add510414cc39d6451f6dd50bf0f4fe94286c5a556c3cd39ecd5c4b34e80fbcb",
};

static CONSTRAIN_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "aae373edf0e981993a5c0a7e4f651912207e83664f6888981897d6cebf7889f7",
};

static CONSTRAIN_DENSITY_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+HALF_PRECISION+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+half_precision+packed.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "9e775eb1ca63f581599fa2047f1951c81ba096091097331025a1de794d586cf9",
};

static CONSTRAIN_DENSITY_WITH_WALLS: Module = Module {
    name: "ConstrainDensity+WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "8c469d55cda5cdcca419132009e8390fc980f0020c1fd6c9d88b29b98956ca91",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+WALLS+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "583be71b710397f5c1a853ff84ff82e7fae5d788490610dc6bf8da92ba16d063",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+relaxed_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "78b0a6fdb26a36999a07a3a9cc0930818ddd5c4b2fe4fc5f432d2a3e439e4752",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+WALLS+RELAXED_PRECISION+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+relaxed_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "774fb1c28e875f6bbc3b16351a78d9d9164f694ee0d3b9ffc2bb92bedb9b3296",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+half_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "fc00082cddcdafd6faf54a31f9d1024bbc7a197bab5a8bfb91e917a008f0e59f",
};

static CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+WALLS+HALF_PRECISION+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+walls+half_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "d220d05f4e600a4724e1bb20ac2b647c1afe27c9c7cba728a2f075a7f558982a",
};
