// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/crest_normals.compute.
//! Kernels of `diffuse/crest_normals.compute`.

use super::{DiffuseParams, ListHead, Position, SmoothingKernelParams, StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The surface's normal at each fluid particle, and how much of a surface there is: what its neighbours leave of a ball around it,
/// sum over j of (x\_i - x\_j)/r (1 - r/h), and walls as if there were fluid beyond them. Inside the fluid the sum is nearly
/// nothing and points anywhere.
#[derive(Debug)]
pub struct CrestNormals<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// its direction, and 0 inside the fluid to 1 at its surface
    ///
    /// `RWStructuredBuffer<float4> crest_normals`.
    pub crest_normals: BufMut<'a, [f32; 4]>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<DiffuseParams> diffuse_params`.
    pub diffuse_params: Uniform<'a, DiffuseParams>,
}

impl Kernel for CrestNormals<'_> {
    const STAGE: &'static str = "crest_normals";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &CREST_NORMALS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("crest_normals", Some(self.crest_normals.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("diffuse_params", Some(self.diffuse_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&CREST_NORMALS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "crest_normals",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "diffuse_params", slot: 7, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/diffuse_crest_normals.deflate"));

static CREST_NORMALS: Module = Module {
    name: "CrestNormals",
    entry: "CrestNormals",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 9496 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/crest_normals.compute",
    hash: "8b956253eda8cf623ff49a5d2adca7c052bf447164eea0b057d675f7329925a4",
};
