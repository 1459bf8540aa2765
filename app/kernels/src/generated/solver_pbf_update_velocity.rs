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
    hash: "dda9ed81731bd8e7e62f4787e0e445b75b1fe96fa975a3a1f1b8a5517e24dee0",
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
    hash: "18c90d0414b4ed6b2835cc0fbcc043c13ea2fae7ada99bddd0fa7c0ceb0bb638",
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
    hash: "ec573edd57350461214229759a73ae2f0fcec34e6f245c8440928912a9576c1d",
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
    hash: "fcd0ef58ef9a7c60a11b88e99dc91903613b977f0c03a840ec10c3673d002676",
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
    hash: "961db514b31272e65f71382364bd936026a2f402bf2781de026582be24f1b868",
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
    hash: "2fa2fd763429ed380ce722eb3628ac270c46856020f94be8aa730e9a6db92f5f",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42972, bytes: 7168 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "67bec63c290af6390f16e9a6d53a3d47b4b7267717f3f6d0d9ad29741a0b319f",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 50140, bytes: 4836 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "123783b3cf011c62ee0207d66065b9b17590dde8f106a4dc0e3b48324115ce1c",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 54976, bytes: 6952 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "345c2e0b44850ae1fa69273a4463fe4eb99ab8ffa0ca1bd052b3605f1cd371c3",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 61928, bytes: 8168 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "b5155fd14de084e6d28dcae7c6003c6e5542368138c1895877a23010703a902a",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 70096, bytes: 6576 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "ce48f777f560c9e62a2763b09bd6cdebd755451cfd38208753500fe06b99b796",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 76672, bytes: 7952 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "805801428006a71bd07a2d6ade64fadc2eebc61fc54e1f0072d7f3bd179f0865",
};
