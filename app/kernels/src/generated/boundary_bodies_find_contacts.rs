// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/bodies/find_contacts.compute.
//! Kernels of `boundary/bodies/find_contacts.compute`.

use super::{BodyContact, BodyState, RigidBody, Solid, SolidPose, SolidsParams, StepParams, StepState, SurfacePoint};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// What bodies touch, or may touch in the coming substep: points of each one's surface against the distance to all others and
/// to the domain's walls. Corners and rims are points, an edge in the middle of another's face is seen by the points along it.
#[derive(Debug)]
pub struct FindContacts<'a> {
    /// `StructuredBuffer<SurfacePoint> surface_points`.
    pub surface_points: Buf<'a, SurfacePoint>,
    /// `StructuredBuffer<RigidBody> bodies`.
    pub bodies: Buf<'a, RigidBody>,
    /// `StructuredBuffer<BodyState> body_states`.
    pub body_states: Buf<'a, BodyState>,
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Buf<'a, Solid>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `StructuredBuffer<float2> solid_fields`.
    pub solid_fields: Buf<'a, [f32; 2]>,
    /// `RWStructuredBuffer<BodyContact> body_contacts`.
    pub body_contacts: BufMut<'a, BodyContact>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
}

impl Kernel for FindContacts<'_> {
    const STAGE: &'static str = "find_contacts";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &FIND_CONTACTS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("surface_points", Some(self.surface_points.id)),
                ("bodies", Some(self.bodies.id)),
                ("body_states", Some(self.body_states.id)),
                ("solids", Some(self.solids.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_fields", Some(self.solid_fields.id)),
                ("body_contacts", Some(self.body_contacts.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("solids_params", Some(self.solids_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&FIND_CONTACTS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "surface_points",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "bodies", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 128 } },
    BindingInfo { name: "body_states", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solids", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 5, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "body_contacts",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_bodies_find_contacts.deflate"));

static FIND_CONTACTS: Module = Module {
    name: "FindContacts",
    entry: "FindContacts",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 19604 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/bodies/find_contacts.compute",
    hash: "19a0988edf35091853a5213bd597bf47f4ae2f22c521f07fc66377cfc7b8d59c",
};
