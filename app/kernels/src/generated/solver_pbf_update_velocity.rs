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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7396 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "b9cf3d69ebcb43b64f0f6f97f08df2f778ed6c6a0e4810ef61bb76e0b9a207db",
};

static UPDATE_VELOCITY_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7396, bytes: 5064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "8e84371dc81b3637e01b1ab19a6a576a0d4b3216be11e1019ecb9e7d57d7269f",
};

static UPDATE_VELOCITY_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12460, bytes: 7180 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "6a465a3f590175cc638c65446b3cff9a04af0c7a0ad887fd59d6877062885e68",
};

static UPDATE_VELOCITY_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19640, bytes: 8380 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "c99bc7565437ab7883eef3a2daa9f0dd14121dfb7a9bd4835271527855433d00",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 28020, bytes: 6788 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "cebba962d37ec7ef030aa932829a14945a4db92762074ef2f6d2850f451b17d3",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 34808, bytes: 8164 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "3bf77f445eb924e6d286075806d3ff4d6961a1a3cc00e872a49f0eb86a02bb38",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42972, bytes: 7772 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "c5a0a437c26e8a7ea0183973f9d4ee53a011652412183a2db163880e720ed9c7",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 50744, bytes: 5440 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "629c027b7656c60f1c2190f97197124104df2588eebf1397748ecfee3c3ae2ed",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 56184, bytes: 7556 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "f3b472e5688c45eeb96dc06c8051c8084cc1417ba605551a73aeab217d7ec108",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 63740, bytes: 8772 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "15765c08958990e5015b08db49a6140bb818d1efd7546b9305d0d4a1596987cc",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 72512, bytes: 7180 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "5c6615733c696599dd4028cb9c48b14a7619100493bb1609edc35074d7c93b96",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 79692, bytes: 8556 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "cfff64bfa9172d6868b2efa4651820ecde2a242a7e218bdfe2ec7a5ccfda05de",
};
