// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/deactivate.compute.
//! Kernels of `particles/deactivate.compute`.

use super::{DeactivateParams, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Empties the slots of the particles in a box.
#[derive(Debug)]
pub struct DeactivateParticles<'a> {
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<DeactivateParams> deactivate`.
    pub deactivate: Uniform<'a, DeactivateParams>,
}

impl Kernel for DeactivateParticles<'_> {
    const STAGE: &'static str = "deactivate_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &DEACTIVATE_PARTICLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("deactivate", Some(self.deactivate.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DEACTIVATE_PARTICLES];

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
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "deactivate", slot: 3, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_deactivate.deflate"));

static DEACTIVATE_PARTICLES: Module = Module {
    name: "DeactivateParticles",
    entry: "DeactivateParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3156 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/deactivate.compute",
    hash: "9dddd6d7e1d6270bcc5e6d3109ee2b52f9cc7b18f813bf28d000e9163aea3f3d",
};
