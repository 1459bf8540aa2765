// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/bodies/gather_reactions.compute.
//! Kernels of `boundary/bodies/gather_reactions.compute`.

use super::{BodyState, Position, SolidContact, SolidsParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// What bodies feel of what their solids gave particles while a substep's iterations moved these: one sum a body.
#[derive(Debug)]
pub struct GatherReactions<'a> {
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Buf<'a, SolidContact>,
    /// `StructuredBuffer<BodyState> body_states`.
    pub body_states: Buf<'a, BodyState>,
    /// `RWStructuredBuffer<uint> reactions`.
    pub reactions: BufMut<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
}

impl Kernel for GatherReactions<'_> {
    const STAGE: &'static str = "gather_reactions";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &GATHER_REACTIONS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("solid_contacts", Some(self.solid_contacts.id)),
                ("body_states", Some(self.body_states.id)),
                ("reactions", Some(self.reactions.id)),
                ("step_state", Some(self.step_state.id)),
                ("solids_params", Some(self.solids_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&GATHER_REACTIONS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "solid_contacts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo { name: "body_states", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "reactions",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_params", slot: 5, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_bodies_gather_reactions.deflate"));

static GATHER_REACTIONS: Module = Module {
    name: "GatherReactions",
    entry: "GatherReactions",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7688 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/bodies/gather_reactions.compute",
    hash: "a2b79b59649aa602c8309fbf0ec51f87c8bf85bb5e112eab61af8888ed7a7a15",
};
