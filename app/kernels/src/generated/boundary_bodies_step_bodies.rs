// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/bodies/step_bodies.compute.
//! Kernels of `boundary/bodies/step_bodies.compute`.

use super::{BodyContact, BodyState, RigidBody, SolidPose, SolidsParams, StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Moves bodies by what the fluid pushed them in the last substep, by gravity, and by what they touch. One group: a thread a
/// body, all of them over the contacts.
#[derive(Debug)]
pub struct StepBodies<'a> {
    /// `StructuredBuffer<RigidBody> bodies`.
    pub bodies: Buf<'a, RigidBody>,
    /// `StructuredBuffer<BodyContact> body_contacts`.
    pub body_contacts: Buf<'a, BodyContact>,
    /// `RWStructuredBuffer<BodyState> body_states`.
    pub body_states: BufMut<'a, BodyState>,
    /// `RWStructuredBuffer<uint> reactions`.
    pub reactions: BufMut<'a, u32>,
    /// `RWStructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: BufMut<'a, SolidPose>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
}

impl Kernel for StepBodies<'_> {
    const STAGE: &'static str = "step_bodies";
    const GROUP_SIZE: [u32; 3] = [256, 1, 1];

    fn module(&self) -> &'static Module {
        &STEP_BODIES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bodies", Some(self.bodies.id)),
                ("body_contacts", Some(self.body_contacts.id)),
                ("body_states", Some(self.body_states.id)),
                ("reactions", Some(self.reactions.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("solids_params", Some(self.solids_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&STEP_BODIES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "bodies", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 128 } },
    BindingInfo {
        name: "body_contacts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "body_states",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 96 },
    },
    BindingInfo {
        name: "reactions",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solid_poses",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 96 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_bodies_step_bodies.deflate"));

static STEP_BODIES: Module = Module {
    name: "StepBodies",
    entry: "StepBodies",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 26336 },
    bindings: BINDINGS_0,
    group_size: [256, 1, 1],
    shared_bytes: 4352,
    tier: Tier::Floor,
    source: "boundary/bodies/step_bodies.compute",
    hash: "22d046a11bac4558fcfe1c2fc847e57cbdefb1f735234f2d4d774300ba4fd983",
};
