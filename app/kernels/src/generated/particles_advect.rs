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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5264 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "119dbad76773a72e977471097e0e6bd65f8da659c175b542eb87eab03767c960",
};

static ADVECT_WITH_PERIODIC: Module = Module {
    name: "Advect+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 5264, bytes: 6248 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "566b78f07f7751011325943eee8436df32a2936e999bff299ae42799daf83286",
};

static ADVECT_WITH_WALLS: Module = Module {
    name: "Advect+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 11512, bytes: 5764 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "1f3af2ef628a5da04737167d6244e55a759dd1192694acf93381a730d03ea369",
};

static ADVECT_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17276, bytes: 6732 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "28b48b78058e7a831d6a309b91ec0a680e069fac89e49cbf6dfec34d0bb98786",
};

static ADVECT_WITH_ACCELERATED: Module = Module {
    name: "Advect+ACCELERATED",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24008, bytes: 6232 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "735b337f592d68370944b5854c6586a361789c111e57ea8bfcda97bed2941763",
};

static ADVECT_WITH_ACCELERATED_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30240, bytes: 7200 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "11c09d8fa18ac3140d9213ded82cd427a437c2a29c4dbf395178c66053b7de0f",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS: Module = Module {
    name: "Advect+ACCELERATED+WALLS",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 37440, bytes: 6716 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "c66186884218ea9784bb0f927069d8f289c3e6043b8fb54d1948955a49c134b0",
};

static ADVECT_WITH_ACCELERATED_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "Advect+ACCELERATED+WALLS+PERIODIC",
    entry: "Advect",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 44156, bytes: 7684 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/advect.compute",
    hash: "115972b3ad25771a56d54fcdb859ec0b512d48b1f81f3396309d8f818a0e095d",
};
