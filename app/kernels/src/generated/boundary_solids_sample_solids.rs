// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/solids/sample_solids.compute.
//! Kernels of `boundary/solids/sample_solids.compute`.

use super::{Position, SmoothingKernelParams, Solid, SolidContact, SolidPose, SolidsParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// What each particle knows of the solids near it for as long as a substep's iterations last: the half-space that adds as
/// much density as all of them, with the direction in which that grows, and the plane of the nearest surface. A particle
/// asks for no more while iterations move it, so their cost does not grow with the solids.
#[derive(Debug)]
pub struct SampleSolids<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Buf<'a, Solid>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `StructuredBuffer<float2> solid_fields`.
    pub solid_fields: Buf<'a, [f32; 2]>,
    /// `StructuredBuffer<uint4> solid_blocks`.
    pub solid_blocks: Buf<'a, [u32; 4]>,
    /// `RWStructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: BufMut<'a, SolidContact>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for SampleSolids<'_> {
    const STAGE: &'static str = "sample_solids";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SAMPLE_SOLIDS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("solids", Some(self.solids.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_fields", Some(self.solid_fields.id)),
                ("solid_blocks", Some(self.solid_blocks.id)),
                ("solid_contacts", Some(self.solid_contacts.id)),
                ("step_state", Some(self.step_state.id)),
                ("solids_params", Some(self.solids_params.id)),
                ("kernel", Some(self.kernel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SAMPLE_SOLIDS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "solids", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "solid_contacts",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solids_params", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_solids_sample_solids.deflate"));

static SAMPLE_SOLIDS: Module = Module {
    name: "SampleSolids",
    entry: "SampleSolids",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 32900 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/sample_solids.compute",
    hash: "07e33ffc1f6573fa76c28e9254c408d97df43ebedde29f1fa96e74e0d4703ddc",
};
