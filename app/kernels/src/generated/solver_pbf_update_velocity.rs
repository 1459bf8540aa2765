// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/update_velocity.compute.
//! Kernels of `solver/pbf/update_velocity.compute`.

use super::{
    Counters, Position, PrecisionKeyword, SmoothingKernelParams, StepParams, StepState, Velocity, VelocityKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`UpdateVelocity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct UpdateVelocityVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
    /// Keyword `KEEP_VELOCITY` or `IN_PLACE_VELOCITY`.
    pub velocity: VelocityKeyword,
}

/// The velocity that the corrections amount to (Macklin & Muller 2013, algorithm 1, line 21).
/// Only what the corrections added is divided by dt: (x\* - x)/dt of the whole path would lose
/// x's last bits to the velocity, and a particle falling freely would not fall exactly.
/// With KEEP\_VELOCITY time stands: compression is taken out, and is to make no motion. With IN\_PLACE\_VELOCITY velocities
/// stand where the sort left them, for a force that takes them from there.
#[derive(Debug)]
pub struct UpdateVelocity<'a> {
    /// Its variant.
    pub variant: UpdateVelocityVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> sorted_velocities`.
    pub sorted_velocities: Option<Buf<'a, Velocity>>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: Option<BufMut<'a, Counters>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Option<Uniform<'a, StepParams>>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for UpdateVelocity<'_> {
    const STAGE: &'static str = "update_velocity";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.precision, self.variant.periodic, self.variant.velocity) {
            (PrecisionKeyword::Off, false, VelocityKeyword::Off) => &UPDATE_VELOCITY,
            (PrecisionKeyword::Off, false, VelocityKeyword::KeepVelocity) => &UPDATE_VELOCITY_WITH_KEEP_VELOCITY,
            (PrecisionKeyword::Off, false, VelocityKeyword::InPlaceVelocity) => &UPDATE_VELOCITY_WITH_IN_PLACE_VELOCITY,
            (PrecisionKeyword::Off, true, VelocityKeyword::Off) => &UPDATE_VELOCITY_WITH_PERIODIC,
            (PrecisionKeyword::Off, true, VelocityKeyword::KeepVelocity) => {
                &UPDATE_VELOCITY_WITH_PERIODIC_WITH_KEEP_VELOCITY
            }
            (PrecisionKeyword::Off, true, VelocityKeyword::InPlaceVelocity) => {
                &UPDATE_VELOCITY_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY
            }
            (PrecisionKeyword::RelaxedPrecision, false, VelocityKeyword::Off) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION
            }
            (PrecisionKeyword::RelaxedPrecision, false, VelocityKeyword::KeepVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY
            }
            (PrecisionKeyword::RelaxedPrecision, false, VelocityKeyword::InPlaceVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY
            }
            (PrecisionKeyword::RelaxedPrecision, true, VelocityKeyword::Off) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC
            }
            (PrecisionKeyword::RelaxedPrecision, true, VelocityKeyword::KeepVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY
            }
            (PrecisionKeyword::RelaxedPrecision, true, VelocityKeyword::InPlaceVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY
            }
            (PrecisionKeyword::HalfPrecision, false, VelocityKeyword::Off) => &UPDATE_VELOCITY_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::HalfPrecision, false, VelocityKeyword::KeepVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY
            }
            (PrecisionKeyword::HalfPrecision, false, VelocityKeyword::InPlaceVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY
            }
            (PrecisionKeyword::HalfPrecision, true, VelocityKeyword::Off) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC
            }
            (PrecisionKeyword::HalfPrecision, true, VelocityKeyword::KeepVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY
            }
            (PrecisionKeyword::HalfPrecision, true, VelocityKeyword::InPlaceVelocity) => {
                &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("sorted_velocities", self.sorted_velocities.as_ref().map(|bound| bound.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("counters", self.counters.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", self.step_params.as_ref().map(|bound| bound.id)),
                ("kernel", Some(self.kernel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &UPDATE_VELOCITY,
    &UPDATE_VELOCITY_WITH_KEEP_VELOCITY,
    &UPDATE_VELOCITY_WITH_IN_PLACE_VELOCITY,
    &UPDATE_VELOCITY_WITH_PERIODIC,
    &UPDATE_VELOCITY_WITH_PERIODIC_WITH_KEEP_VELOCITY,
    &UPDATE_VELOCITY_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY,
    &UPDATE_VELOCITY_WITH_RELAXED_PRECISION,
    &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY,
    &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY,
    &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC,
    &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY,
    &UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY,
];

static BINDINGS_0: &[BindingInfo] = &[
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
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "positions",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
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
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "positions",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
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
    BindingInfo {
        name: "positions",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
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
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "positions",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_update_velocity.deflate"));

static UPDATE_VELOCITY: Module = Module {
    name: "UpdateVelocity",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7156 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "9081b7ffeb3b6c41270ce345b66a97f42e9a5574e066f36d8a47ac921ed68199",
};

static UPDATE_VELOCITY_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7156, bytes: 5064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "8ceacac443dee4ff452859f479d0537217f81fa93b85bb4237032437bd630b19",
};

static UPDATE_VELOCITY_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12220, bytes: 6940 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "4b99761205f498dfed137980a078cad37911309e61b37ae806fd05eab28563c2",
};

static UPDATE_VELOCITY_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19160, bytes: 8140 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "2b3eff1e79f635ea925e6854cfb7b0053a7c706680376c87972fea3250aab16f",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 27300, bytes: 6788 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "b4ed8051ad9a664e80a2c64d3bb9a06ed80fa5a556315f63d1e4e476c76011af",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 34088, bytes: 7924 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "42d6da6cb03ac50adc5b99b778c76b00e886a303ec027aea1d6eeb7b132a08f5",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42012, bytes: 6928 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "243eae12370a727fd6427a7950f9c99f937ab3960caa8e98b74d1966ef92a76d",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 48940, bytes: 4836 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "c6e11fe38d1fa1d041d956081e622e510194d994306976fff7bb56a6163e04c4",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 53776, bytes: 6712 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "e13e881746f0f50cfc737594a7afde7a8d7d69e86230a020d546d7f7dd1eb17d",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 60488, bytes: 7928 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "ec0994f719a8a4f1723228ffb8cc170004a806fd5beb09c66c4e140e6122f2df",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 68416, bytes: 6576 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "1a3ed5168b930cc67773492ac92c79884e876047ad7e5e38fa366ed709ac5511",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 74992, bytes: 7712 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "5473ce2d3b2d488541245a6abb956fb3627623e0923b27723c4cd94034d1d556",
};
