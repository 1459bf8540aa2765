// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/collide_diffuse.compute.
//! Kernels of `diffuse/collide_diffuse.compute`.

use super::{
    Counters, DiffuseParams, DiffuseParticle, DiffuseState, Solid, SolidPose, SolidsParams, StepParams, StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Stops diffuse particles at the solids that they would run into, as boundary/solids/collide\_solids.compute stops the fluid's, but in
/// as many parts as the step has substeps: solids that a path may meet are marked for one substep's way. Solids stand where they are
/// at the step's end. What touches one ages, unless it ages already.
#[derive(Debug)]
pub struct CollideDiffuse<'a> {
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Buf<'a, Solid>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `StructuredBuffer<float2> solid_fields`.
    pub solid_fields: Buf<'a, [f32; 2]>,
    /// `StructuredBuffer<uint4> solid_blocks`.
    pub solid_blocks: Buf<'a, [u32; 4]>,
    /// `RWStructuredBuffer<DiffuseParticle> diffuse`.
    pub diffuse: BufMut<'a, DiffuseParticle>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<DiffuseState> diffuse_state`.
    pub diffuse_state: Uniform<'a, DiffuseState>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
    /// `ConstantBuffer<DiffuseParams> diffuse_params`.
    pub diffuse_params: Uniform<'a, DiffuseParams>,
}

impl Kernel for CollideDiffuse<'_> {
    const STAGE: &'static str = "collide_diffuse";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COLLIDE_DIFFUSE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("solids", Some(self.solids.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_fields", Some(self.solid_fields.id)),
                ("solid_blocks", Some(self.solid_blocks.id)),
                ("diffuse", Some(self.diffuse.id)),
                ("counters", Some(self.counters.id)),
                ("diffuse_state", Some(self.diffuse_state.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("solids_params", Some(self.solids_params.id)),
                ("diffuse_params", Some(self.diffuse_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COLLIDE_DIFFUSE];

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
        name: "diffuse",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "diffuse_state", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 9, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "diffuse_params", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/diffuse_collide_diffuse.deflate"));

static COLLIDE_DIFFUSE: Module = Module {
    name: "CollideDiffuse",
    entry: "CollideDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 22672 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/collide_diffuse.compute",
    hash: "5b5791082aa0ad8946c77416b3635c1045a2d63612d76ccf924ec008c3ba72ca",
};
