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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7184 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "e0721f38f69ac0289666ae0434382c91a0c5b659071abcf44d0125743594bf78",
};

static UPDATE_VELOCITY_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7184, bytes: 5064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "263749b9b5574d6cc80c7b085c584618efd5c5a66bbeb86d2d1cb37adc9f2fc9",
};

static UPDATE_VELOCITY_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12248, bytes: 6968 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "790e12da3d232ec7357c34c14867a16916eb040e313dac24c2e574ce76c55559",
};

static UPDATE_VELOCITY_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19216, bytes: 8168 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "8d85a16229a6e7738977a0314a41ce7146c13a87c17a04a3268298f305353ab7",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 27384, bytes: 6788 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "77ea94db7a250b2fe8697b47d7e8182d0a3e2db26a0e7e373d124507834b922a",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 34172, bytes: 7952 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "a570e8639bfba602b771069743536183fa3a26966275b1a73354c7f7e2ce1d32",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42124, bytes: 7560 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "f5a45b2071aaa8f0bd0b4faeb16bb9b7f5c64b5a9d1c1f7f2d0853cf3d7ffe43",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 49684, bytes: 5440 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "345a5d4cef095b8f99b3ebec006ba8b8023d7dfd62019af389bce29f60ad212a",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 55124, bytes: 7344 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "a0a1a3dd04c8567a91702054f62534a7069d7f3bb489e0fea17669ee748cd474",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 62468, bytes: 8560 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "e8cf62465db64603edeb7db52a7c0e3e232b5f50546f8e30c4c1e344550668a7",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 71028, bytes: 7180 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "d7156e0cbc7148b334926ce392efaca99543bbfbf0c0a673909f7513d0253099",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 78208, bytes: 8344 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "31a06f7cb9bc9f2369e519d4a0ced224a40c9e6a0837642e27a0038cdfe869c0",
};
