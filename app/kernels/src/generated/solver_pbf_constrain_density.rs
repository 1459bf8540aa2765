// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/constrain_density.compute.
//! Kernels of `solver/pbf/constrain_density.compute`.

use super::{Constrained, KernelParams, PbfParams, Position, PrecisionKeyword, StepParams, WallsKeyword};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`ConstrainDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConstrainDensityVariant {
    /// Keyword `WALLS` or `NARROW_WALLS`.
    pub walls: WallsKeyword,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// The density constraint's multiplier lambda of each particle (Macklin & Muller 2013, eq. 8-11),
/// with lengths in units of h and the density as its ratio to the rest density. Only compression
/// is a violation: a free surface does not pull.
#[derive(Debug)]
pub struct ConstrainDensity<'a> {
    /// Its variant.
    pub variant: ConstrainDensityVariant,
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint4> neighbours`.
    pub neighbours: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> neighbour_counts`.
    pub neighbour_counts: Buf<'a, u32>,
    /// `RWStructuredBuffer<Constrained> constrained`.
    pub constrained: Option<BufMut<'a, Constrained>>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<KernelParams> kernel`.
    pub kernel: Uniform<'a, KernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
    /// `RWStructuredBuffer<uint2> packed_constrained`.
    pub packed_constrained: Option<BufMut<'a, [u32; 2]>>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Option<Buf<'a, Position>>,
    /// xyz: gradient over the three distances, 1/h; w: density ratio.
    ///
    /// `StructuredBuffer<float4> wall_weights`.
    pub wall_weights: Option<Buf<'a, [f32; 4]>>,
}

impl Kernel for ConstrainDensity<'_> {
    const STAGE: &'static str = "constrain_density";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.precision, self.variant.packed) {
            (WallsKeyword::Off, PrecisionKeyword::Off, false) => &CONSTRAIN_DENSITY,
            (WallsKeyword::Off, PrecisionKeyword::Off, true) => &CONSTRAIN_DENSITY_WITH_PACKED,
            (WallsKeyword::Off, PrecisionKeyword::RelaxedPrecision, false) => &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION,
            (WallsKeyword::Off, PrecisionKeyword::RelaxedPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Off, PrecisionKeyword::HalfPrecision, false) => &CONSTRAIN_DENSITY_WITH_HALF_PRECISION,
            (WallsKeyword::Off, PrecisionKeyword::HalfPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Walls, PrecisionKeyword::Off, false) => &CONSTRAIN_DENSITY_WITH_WALLS,
            (WallsKeyword::Walls, PrecisionKeyword::Off, true) => &CONSTRAIN_DENSITY_WITH_WALLS_WITH_PACKED,
            (WallsKeyword::Walls, PrecisionKeyword::RelaxedPrecision, false) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::Walls, PrecisionKeyword::RelaxedPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::Walls, PrecisionKeyword::HalfPrecision, false) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::Walls, PrecisionKeyword::HalfPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_WALLS_WITH_HALF_PRECISION_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, PrecisionKeyword::Off, false) => &CONSTRAIN_DENSITY_WITH_NARROW_WALLS,
            (WallsKeyword::NarrowWalls, PrecisionKeyword::Off, true) => {
                &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, PrecisionKeyword::RelaxedPrecision, false) => {
                &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION
            }
            (WallsKeyword::NarrowWalls, PrecisionKeyword::RelaxedPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED
            }
            (WallsKeyword::NarrowWalls, PrecisionKeyword::HalfPrecision, false) => {
                &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_HALF_PRECISION
            }
            (WallsKeyword::NarrowWalls, PrecisionKeyword::HalfPrecision, true) => {
                &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_HALF_PRECISION_WITH_PACKED
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("places", Some(self.places.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("neighbour_counts", Some(self.neighbour_counts.id)),
                ("constrained", self.constrained.as_ref().map(|bound| bound.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
                ("packed_constrained", self.packed_constrained.as_ref().map(|bound| bound.id)),
                ("sorted_positions", self.sorted_positions.as_ref().map(|bound| bound.id)),
                ("wall_weights", self.wall_weights.as_ref().map(|bound| bound.id)),
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
    &CONSTRAIN_DENSITY_WITH_NARROW_WALLS,
    &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION,
    &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_HALF_PRECISION,
    &CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_HALF_PRECISION_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "constrained",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "packed_constrained",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "constrained",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo {
        name: "wall_weights",
        slot: 8,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "packed_constrained",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo {
        name: "wall_weights",
        slot: 8,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
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
    hash: "193614e5c85dc239e1ec102a8864318eb1a62e1b23bf2a2f1177d78775ecd899",
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
    hash: "6702316c95d185ba0b4fdd97f261afcd39f6f71559204475175ba0da15c56518",
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
    hash: "bc85e6c2c4f9f8d66f94275fdced73b9eb78d40d57d188ffb4355f0754815dc4",
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
    hash: "0d162eedd3e4d69987db8f20344c6591cf2f52fcf973675884b3cd5305b44e53",
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
    hash: "c7ac8696b1cb9ce4d57ffc919e0c65b17c03f2601d19c28003cc8e308db3d496",
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
    hash: "9143bbded45dbdc88c063189a457500cb826b90b838512bad2092ce1161086d0",
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
    hash: "d86ff5c703b0ea34244b33327e3f5539a7860b4dc05e09292ab8526f5d2e2e7d",
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
    hash: "932be47f320bc0bc543b3d5b60587b88c84f80fb50b5387ecdfab667dab2ffdf",
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
    hash: "29c5e1d653a2e07f57df4b957e573640a8197d82a8b4c86a690cc3b03d61a1d7",
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
    hash: "8d02aec82d4911e825e34b7e632b27c58519306f333fec8a562c0aad916b95dc",
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
    hash: "2b98c71ba200ae9fdc5fd4f33c2cd2c9387215ad59c138632185ea4d65b45bd4",
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
    hash: "05be4dc779d30e235444416d4481b480ac931430cb4f3ef129ebd1ca2ddac05c",
};

static CONSTRAIN_DENSITY_WITH_NARROW_WALLS: Module = Module {
    name: "ConstrainDensity+NARROW_WALLS",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+narrow_walls.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "7c2cf74e362a61f674504938b177e6b69a99bd9fb719c123e3e96df8d9d73580",
};

static CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+NARROW_WALLS+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+narrow_walls+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "6273c55b0fdefc7edddb9410fda9b6dcc6bbd68e3e7e3978eb60af3a712b96af",
};

static CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConstrainDensity+NARROW_WALLS+RELAXED_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+narrow_walls+relaxed_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "75cbb29b496cd6e086675e589f15a1fea8e87259d23234fdd511c497624f5365",
};

static CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+NARROW_WALLS+RELAXED_PRECISION+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+narrow_walls+relaxed_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/constrain_density.compute",
    hash: "3ab98b00f1243dceee9b9a5e68a66e72d772ac66193405e76618e80812d8b24b",
};

static CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ConstrainDensity+NARROW_WALLS+HALF_PRECISION",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+narrow_walls+half_precision.spv"),
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "a5918ad858f82d5f8ea3bca3d0baaf89e4391509e5a7e1178e6d3f7cdf9a0a87",
};

static CONSTRAIN_DENSITY_WITH_NARROW_WALLS_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "ConstrainDensity+NARROW_WALLS+HALF_PRECISION+PACKED",
    entry: "ConstrainDensity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density+narrow_walls+half_precision+packed.spv"),
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/constrain_density.compute",
    hash: "142a947213da08968c80908c45b452d5358fe66b649b9bef26dd87b4d4d78ca8",
};
