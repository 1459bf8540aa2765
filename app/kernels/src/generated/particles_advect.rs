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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5568 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "6c68aeb87c8de7213e56497a2fc2e941e8d4407b398db099cbc663f6292a96f0",
};

static ADVECT_WITH_PERIODIC: Module = Module {
    name: "Advect+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5568, bytes: 6552 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "1ab76ef24683f037571378106c2faafa3d24785f8f09a2741a9f8c7c925cfe7b",
};

static ADVECT_WITH_WALLS: Module = Module {
    name: "Advect+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 12120, bytes: 6068 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "634724107400c358747898b92c96891f230d50bae65d3d71e15961aeba377ea1",
};

static ADVECT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 18188, bytes: 7036 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "bd93cacab79b081f36c77c8efae7f692ffbdeb64f51838c20d7c26988784d893",
};

static ADVECT_WITH_ACCELERATED: Module = Module {
    name: "Advect+ACCELERATED",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 25224, bytes: 6536 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "273b8a5134c6f271895d2e2a6e2eb0a94124bcf709dec385a150b59114c599fc",
};

static ADVECT_WITH_ACCELERATED_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31760, bytes: 7504 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "b0c23138650d6861e5a58d01d9121396b9645ebc4bba444b3ad376f72a4b64f1",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS: Module = Module {
    name: "Advect+ACCELERATED+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 39264, bytes: 7020 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "a09485a66079c6ca36568e57e33455c781682ff5f7671f59afddaca3385064ac",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 46284, bytes: 7988 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "a72b11ecaa227ae7e73b67d689ac6b8b819fd7440ac0892176169fdd9139e2f5",
};
