// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/solids/collide_solids.compute.
//! Kernels of `boundary/solids/collide_solids.compute`.

use super::{BodyState, Position, Solid, SolidPose, SolidsParams, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CollideSolids`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CollideSolidsVariant {
    /// Keyword `BODIES`.
    pub bodies: bool,
}

/// Stops particles at the solids that they would run into: the whole of a path, so that none passes a solid however thin it
/// is and however fast it or the particle moves. In the frame of a solid that moves, a path goes from where the particle was
/// in the frame's last pose to where it is in the new one. Along it the particle goes as far as the surface is away, at least
/// a quarter of what it keeps from surfaces, and where it touches one the rest of the path loses what leads into it. What a
/// solid takes of a path it takes of the velocity, as walls do (ConfinePath).
#[derive(Debug)]
pub struct CollideSolids<'a> {
    /// Its variant.
    pub variant: CollideSolidsVariant,
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Buf<'a, Solid>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `StructuredBuffer<float2> solid_fields`.
    pub solid_fields: Buf<'a, [f32; 2]>,
    /// `StructuredBuffer<uint4> solid_blocks`.
    pub solid_blocks: Buf<'a, [u32; 4]>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
    /// `StructuredBuffer<BodyState> body_states`.
    pub body_states: Option<Buf<'a, BodyState>>,
    /// `RWStructuredBuffer<uint> reactions`.
    pub reactions: Option<BufMut<'a, u32>>,
}

impl Kernel for CollideSolids<'_> {
    const STAGE: &'static str = "collide_solids";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.bodies { &COLLIDE_SOLIDS_WITH_BODIES } else { &COLLIDE_SOLIDS }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("solids", Some(self.solids.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_fields", Some(self.solid_fields.id)),
                ("solid_blocks", Some(self.solid_blocks.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("solids_params", Some(self.solids_params.id)),
                ("body_states", self.body_states.as_ref().map(|bound| bound.id)),
                ("reactions", self.reactions.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COLLIDE_SOLIDS, &COLLIDE_SOLIDS_WITH_BODIES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "solids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "solids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "body_states", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "reactions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "positions",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 10, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_solids_collide_solids.deflate"));

static COLLIDE_SOLIDS: Module = Module {
    name: "CollideSolids",
    entry: "CollideSolids",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 19884 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/collide_solids.compute",
    hash: "684c89b4c34c3aec4856e5fca299a7fba850e6e8fec05a4050dca1f16b62010c",
};

static COLLIDE_SOLIDS_WITH_BODIES: Module = Module {
    name: "CollideSolids+BODIES",
    entry: "CollideSolids",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19884, bytes: 24084 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/collide_solids.compute",
    hash: "34461c41488fdb615c6afc5ef17d9e0698217446400d022e7926a2cd0908572f",
};
