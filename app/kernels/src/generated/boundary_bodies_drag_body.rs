// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/bodies/drag_body.compute.
//! Kernels of `boundary/bodies/drag_body.compute`.

use super::{BodyDragParams, BodyState, RigidBody};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Draws a body by a point of it to a place, as a critically damped spring does: over dt the point's velocity v, x away from
/// the place, becomes (v - w^2 dt x) / (1 + w dt)^2, the implicit step of x'' = -2 w x' - w^2 x, which no dt makes unstable.
/// What the body is given for that is an impulse there, so that it turns as it would if it were held.
#[derive(Debug)]
pub struct DragBody<'a> {
    /// `StructuredBuffer<RigidBody> bodies`.
    pub bodies: Buf<'a, RigidBody>,
    /// `RWStructuredBuffer<BodyState> body_states`.
    pub body_states: BufMut<'a, BodyState>,
    /// `ConstantBuffer<BodyDragParams> body_drag`.
    pub body_drag: Uniform<'a, BodyDragParams>,
}

impl Kernel for DragBody<'_> {
    const STAGE: &'static str = "drag_body";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &DRAG_BODY
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bodies", Some(self.bodies.id)),
                ("body_states", Some(self.body_states.id)),
                ("body_drag", Some(self.body_drag.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAG_BODY];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "bodies", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 128 } },
    BindingInfo {
        name: "body_states",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 96 },
    },
    BindingInfo { name: "body_drag", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_bodies_drag_body.deflate"));

static DRAG_BODY: Module = Module {
    name: "DragBody",
    entry: "DragBody",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10704 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/bodies/drag_body.compute",
    hash: "7f56723d31671f71ae61aa7cf1a5e3b49eb39dd0ad9653be0233ca3947a60cef",
};
