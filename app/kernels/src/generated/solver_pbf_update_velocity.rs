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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7192 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "0720e12e1d6033f5049c983fadfc1e8160667cdb0f42eac7945ae95e9a396fc4",
};

static UPDATE_VELOCITY_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7192, bytes: 5064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "f5e38c23ad362af126322854a989a90222f539e3fb13adb394059588f46d440f",
};

static UPDATE_VELOCITY_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12256, bytes: 6976 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "58d0a8e6b8fadb9e60ae78fe6af4b03c1a61095bb3e8980b7833713a1126716a",
};

static UPDATE_VELOCITY_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19232, bytes: 8176 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "6a1c627af28ba6772576bd7778bc914d2ff90bc51b7740930d356c917d9dcb1f",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 27408, bytes: 6788 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "06ed106fb6d2b3db8456d232bdbab317df04c109189a2df5fe2aa3586eff0d55",
};

static UPDATE_VELOCITY_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 34196, bytes: 7960 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "3585bef93bec86d8a09d7b1357fe088a580981985f71ba4b29837917def98848",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42156, bytes: 6964 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "cd2cf813dce3cd07ec5a76c92112c36721ba0e978aa4695da7c91ac56d7f5cee",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 49120, bytes: 4836 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "e086aa39ea6ec69f7685ea77ea98b77623e4e84cd2be5227a564f323d6020b4d",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 53956, bytes: 6748 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "163003c9d3fd18597b847c1fb9f7ce641b824f8a667ec793c9c250d455609d5d",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 60704, bytes: 7964 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "e2f82ed657b70a6550b8dc4b9ae320ecf1cb507637644dab5498411039ca6067",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_KEEP_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+KEEP_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 68668, bytes: 6576 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "27b78926c033561b2844ad078fbd9cab26b9d13729ccb0935d0c0b6420fd6ac9",
};

static UPDATE_VELOCITY_WITH_RELAXED_PRECISION_WITH_PERIODIC_WITH_IN_PLACE_VELOCITY: Module = Module {
    name: "UpdateVelocity+RELAXED_PRECISION+PERIODIC+IN_PLACE_VELOCITY",
    entry: "UpdateVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 75244, bytes: 7748 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/update_velocity.compute",
    hash: "4c819049a70ae1c99bf6107b6b450a57cc1d5f4d66196fe3737b563dac6a3d58",
};
