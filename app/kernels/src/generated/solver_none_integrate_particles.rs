// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/none/integrate_particles.compute.
//! Kernels of `solver/none/integrate_particles.compute`.

use super::{Counters, NoneParams, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Which variant of [`IntegrateParticles`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct IntegrateParticlesVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Particles that know nothing of each other, as sparks and dust do: they age, fall, are dragged, and bounce off
/// walls. Symplectic Euler. One whose lifetime is over leaves its slot inactive.
#[derive(Debug)]
pub struct IntegrateParticles<'a> {
    /// Its variant.
    pub variant: IntegrateParticlesVariant,
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
    /// `ConstantBuffer<NoneParams> none`.
    pub none: Uniform<'a, NoneParams>,
}

impl Kernel for IntegrateParticles<'_> {
    const STAGE: &'static str = "integrate_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (false, false) => &INTEGRATE_PARTICLES,
            (false, true) => &INTEGRATE_PARTICLES_WITH_PERIODIC,
            (true, false) => &INTEGRATE_PARTICLES_WITH_WALLS,
            (true, true) => &INTEGRATE_PARTICLES_WITH_WALLS_WITH_PERIODIC,
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
                ("none", Some(self.none.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &INTEGRATE_PARTICLES,
    &INTEGRATE_PARTICLES_WITH_PERIODIC,
    &INTEGRATE_PARTICLES_WITH_WALLS,
    &INTEGRATE_PARTICLES_WITH_WALLS_WITH_PERIODIC,
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
    BindingInfo { name: "none", slot: 5, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_none_integrate_particles.deflate"));

static INTEGRATE_PARTICLES: Module = Module {
    name: "IntegrateParticles",
    entry: "IntegrateParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 6872 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/none/integrate_particles.compute",
    hash: "2c0791c4c2a77b6049741ec1cddc8263cdf34b55f7b27125e83a61e8bee5d22a",
};

static INTEGRATE_PARTICLES_WITH_PERIODIC: Module = Module {
    name: "IntegrateParticles+PERIODIC",
    entry: "IntegrateParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 6872, bytes: 7824 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/none/integrate_particles.compute",
    hash: "3aee30ac68305e34c22386dbe7f0145c7e1ffc4d0fbe1bc0a9255bfb3febf7e0",
};

static INTEGRATE_PARTICLES_WITH_WALLS: Module = Module {
    name: "IntegrateParticles+WALLS",
    entry: "IntegrateParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 14696, bytes: 7416 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/none/integrate_particles.compute",
    hash: "40a8290f2fd64a0b9e4921e3ce214947a4312d544f6ca484c94d949955950fd0",
};

static INTEGRATE_PARTICLES_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "IntegrateParticles+WALLS+PERIODIC",
    entry: "IntegrateParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 22112, bytes: 8368 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/none/integrate_particles.compute",
    hash: "4a88400a2a2f7a87e85745b04484ad4d07449a555ba19caa572715e3a8679da5",
};
