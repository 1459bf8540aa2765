// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/advect.compute.
//! Kernels of `particles/advect.compute`.

use super::{Counters, KickParams, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kicks", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
];

static ADVECT: Module = Module {
    name: "Advect",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "65bae3b43f3df2c351549b8af20f1a8e7212ce9c8d5b52ebb2dab7a2022fef73",
};

static ADVECT_WITH_PERIODIC: Module = Module {
    name: "Advect+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "2202540f1f9124bf388512e7fb9c054f2e30818dc2aecf41147438c0bda25524",
};

static ADVECT_WITH_WALLS: Module = Module {
    name: "Advect+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+walls.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "2d53b41cdc8c510b37de24ffb0f6b15e401db7becb06c4ab3a957165502235c5",
};

static ADVECT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+walls+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "2c2203dbfa3b72367400e0d48ffe7ef57efb1b787f1695a5ce928ca2816ff555",
};

static ADVECT_WITH_ACCELERATED: Module = Module {
    name: "Advect+ACCELERATED",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+accelerated.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "545cca876a3c138a602049ec3bcb15e848f8ae7a2af97dc930e975d2b8dcd5f4",
};

static ADVECT_WITH_ACCELERATED_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+accelerated+periodic.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "7806d1087631e90a5a5566339389764f0278ea70562ec34cd6a1c8239d8c4603",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS: Module = Module {
    name: "Advect+ACCELERATED+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+accelerated+walls.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "f604b037ed1d483bde62ea2f17332ad750cc951004c752e220981f4fb56f6305",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/advect+accelerated+walls+periodic.spv"),
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "d2df4d4aae5a02da31a2a2c569cf9865e8ae4532402345738c966276aca0312e",
};
