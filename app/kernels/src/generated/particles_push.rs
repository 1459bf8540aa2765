// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/push.compute.
//! Kernels of `particles/push.compute`.

use super::{Position, PushParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Draws particles near a ray, the eye's through a cursor, toward a velocity:
/// v += w(q) (1 - exp(-dt/tau)) (u - v) with u the drag's velocity, q the distance from the ray over the radius and
/// w(q) = (1 - q^2)^2, which ends at q = 1 with slope 0, so that no edge shows in the fluid.
#[derive(Debug)]
pub struct Push<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<PushParams> push`.
    pub push: Uniform<'a, PushParams>,
}

impl Kernel for Push<'_> {
    const STAGE: &'static str = "push";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &PUSH
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("push", Some(self.push.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&PUSH];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "push", slot: 3, kind: BindingKind::Uniform { bytes: 64 } },
];

static PUSH: Module = Module {
    name: "Push",
    entry: "Push",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/push.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/push.compute",
    hash: "73302146340b5d543d32e751d0580a6d4149a610ceb9adf9ff339dce037b1a37",
};
