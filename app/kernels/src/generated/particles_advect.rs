// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/advect.compute.
//! Kernels of `particles/advect.compute`.

use super::{Counters, KickParams, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`Advect`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct AdvectVariant {
    /// Keyword `ACCELERATED`.
    pub accelerated: bool,
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Moves particles with their velocities: the first stage of solvers whose forces are of where particles are. With
/// ACCELERATED the last substep's acceleration is split around the move, as the integrator has it (KickParams).
#[derive(Debug)]
pub struct Advect<'a> {
    /// Its variant.
    pub variant: AdvectVariant,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `StructuredBuffer<float4> accelerations`.
    pub accelerations: Option<Buf<'a, [f32; 4]>>,
    /// `ConstantBuffer<KickParams> kicks`.
    pub kicks: Option<Uniform<'a, KickParams>>,
}

impl Kernel for Advect<'_> {
    const STAGE: &'static str = "advect";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.accelerated, self.variant.walls, self.variant.periodic) {
            (false, false, false) => &ADVECT,
            (false, false, true) => &ADVECT_WITH_PERIODIC,
            (false, true, false) => &ADVECT_WITH_WALLS,
            (false, true, true) => &ADVECT_WITH_WALLS_WITH_PERIODIC,
            (true, false, false) => &ADVECT_WITH_ACCELERATED,
            (true, false, true) => &ADVECT_WITH_ACCELERATED_WITH_PERIODIC,
            (true, true, false) => &ADVECT_WITH_ACCELERATED_WITH_WALLS,
            (true, true, true) => &ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("accelerations", self.accelerations.as_ref().map(|bound| bound.id)),
                ("kicks", self.kicks.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &ADVECT,
    &ADVECT_WITH_PERIODIC,
    &ADVECT_WITH_WALLS,
    &ADVECT_WITH_WALLS_WITH_PERIODIC,
    &ADVECT_WITH_ACCELERATED,
    &ADVECT_WITH_ACCELERATED_WITH_PERIODIC,
    &ADVECT_WITH_ACCELERATED_WITH_WALLS,
    &ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "accelerations",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kicks", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_advect.deflate"));

static ADVECT: Module = Module {
    name: "Advect",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5504 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "e5b034c922403799cb00b1794d6adee8892fc79e3680f2399a4d3e340545c063",
};

static ADVECT_WITH_PERIODIC: Module = Module {
    name: "Advect+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5504, bytes: 6488 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "ee28325d17eaaca9a2a8821f45b2471f2503ad3bf24b8ad21690db1ab56dff05",
};

static ADVECT_WITH_WALLS: Module = Module {
    name: "Advect+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 11992, bytes: 6004 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "723ef2eb485325acbdc0eabd6b43b82ce7a9377c495e36be0120c618ff4cb52d",
};

static ADVECT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17996, bytes: 6972 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "389f54f177a4688bb1f2b38f1d46fddedfb4545f56ac36292b881380918e67c8",
};

static ADVECT_WITH_ACCELERATED: Module = Module {
    name: "Advect+ACCELERATED",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24968, bytes: 6472 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "b2214d685697cb895bd16d6e851106d3b4af0e2615b5c28458264e2c475cfc6a",
};

static ADVECT_WITH_ACCELERATED_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31440, bytes: 7440 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "0871f3d9dc5b936dac888684a44b88fbbd30fd4da27d3fd43a89a4a2b87c2e18",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS: Module = Module {
    name: "Advect+ACCELERATED+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 38880, bytes: 6956 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "765ba29689e85f7daea38f991f5d3edb8ef5e2fdc1d069bce8b1b0397fe2eb30",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 45836, bytes: 7924 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "869a2cde114068e0ff7dfc77d6637d49ec9f5f65944fff4c2bd3a6343d10e6cb",
};
