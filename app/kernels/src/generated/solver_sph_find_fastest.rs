// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/find_fastest.compute.
//! Kernels of `solver/sph/find_fastest.compute`.

use super::{SphTimeStep, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The largest speed and acceleration of the particles behind all forces, those of solids too: what limits the next substep
/// (choose\_time\_step.compute). A stage of its own: behind solids, and without its barriers accelerate.compute is quicker to build on
/// a CPU's driver.
#[derive(Debug)]
pub struct FindFastest<'a> {
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// w: 1 of particles that have one
    ///
    /// `StructuredBuffer<float4> accelerations`.
    pub accelerations: Buf<'a, [f32; 4]>,
    /// `RWStructuredBuffer<SphTimeStep> time_step`.
    pub time_step: BufMut<'a, SphTimeStep>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for FindFastest<'_> {
    const STAGE: &'static str = "find_fastest";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &FIND_FASTEST
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("velocities", Some(self.velocities.id)),
                ("accelerations", Some(self.accelerations.id)),
                ("time_step", Some(self.time_step.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&FIND_FASTEST];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "velocities", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "accelerations",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "time_step",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_find_fastest.deflate"));

static FIND_FASTEST: Module = Module {
    name: "FindFastest",
    entry: "FindFastest",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3452 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/find_fastest.compute",
    hash: "8d213c658ba44de1cdced9d6c553457f9fde56b90ad7405d73de4771c3ae9002",
};
