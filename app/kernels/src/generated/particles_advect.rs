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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
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
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5300 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "d082884933ceb4bab960db72cf426b0f78d981c00d2116700dc53e3893761300",
};

static ADVECT_WITH_PERIODIC: Module = Module {
    name: "Advect+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5300, bytes: 6284 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "f35c8076b23455cf7a7de4c51cfc4fdcfdf392ca4f0c41bf7de23e0d43fe3dfc",
};

static ADVECT_WITH_WALLS: Module = Module {
    name: "Advect+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 11584, bytes: 5800 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "fb5b09a5769d3f4581b436605b802868558c5385998ff10d4e015c6746478a97",
};

static ADVECT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17384, bytes: 6768 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "5d26a52b9dda92b057618221c2e6e5ce8e64e5453f9a150bddd4ab4f013e966a",
};

static ADVECT_WITH_ACCELERATED: Module = Module {
    name: "Advect+ACCELERATED",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24152, bytes: 6268 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "4dda24adfec80f93433741a72af1c2470f6ded92aad5118d6529f1047020bfbb",
};

static ADVECT_WITH_ACCELERATED_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30420, bytes: 7236 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "b5241b88baff77d4c9fb60d275894e3dc66e59283b40a97c2f1eb1a1f322f980",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS: Module = Module {
    name: "Advect+ACCELERATED+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 37656, bytes: 6752 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "06e2d0ad73921127ce67ecfa17ef61b9af1ff5950273b6330b59a04422f79a7c",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 44408, bytes: 7720 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "a8a4e72493db2d292a6644c55c9f7140802ef939069f6f62682fdf203f17bb12",
};
