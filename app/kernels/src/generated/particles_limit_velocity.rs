// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/limit_velocity.compute.
//! Kernels of `particles/limit_velocity.compute`.

use super::{Counters, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Holds velocities to the speed that no particle exceeds, where a solver left them.
#[derive(Debug)]
pub struct LimitVelocity<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
}

impl Kernel for LimitVelocity<'_> {
    const STAGE: &'static str = "limit_velocity";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &LIMIT_VELOCITY
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
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&LIMIT_VELOCITY];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
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

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_limit_velocity.deflate"));

static LIMIT_VELOCITY: Module = Module {
    name: "LimitVelocity",
    entry: "LimitVelocity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4640 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/limit_velocity.compute",
    hash: "fe264be14e6efdd38658dc2cf8b76f9a2822e2dda52d01944ec60cdebc293b26",
};
