// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/solids/move_solids.compute.
//! Kernels of `boundary/solids/move_solids.compute`.

use super::{Keyframe, Solid, SolidPose, SolidsParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Where solids are at a substep's end, and the boxes around them (motion.hlsli).
#[derive(Debug)]
pub struct MoveSolids<'a> {
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Buf<'a, Solid>,
    /// `StructuredBuffer<Keyframe> keyframes`.
    pub keyframes: Buf<'a, Keyframe>,
    /// `RWStructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: BufMut<'a, SolidPose>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
}

impl Kernel for MoveSolids<'_> {
    const STAGE: &'static str = "move_solids";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MOVE_SOLIDS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("solids", Some(self.solids.id)),
                ("keyframes", Some(self.keyframes.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("step_state", Some(self.step_state.id)),
                ("solids_params", Some(self.solids_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MOVE_SOLIDS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "solids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "keyframes", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "solid_poses",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 96 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_params", slot: 4, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_solids_move_solids.deflate"));

static MOVE_SOLIDS: Module = Module {
    name: "MoveSolids",
    entry: "MoveSolids",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10536 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/move_solids.compute",
    hash: "3ea83429a0ca277f25a22e5aeb35503d298fe15309875745245c03becd4ff8b0",
};
