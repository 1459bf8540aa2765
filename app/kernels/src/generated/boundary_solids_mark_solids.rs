// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/solids/mark_solids.compute.
//! Kernels of `boundary/solids/mark_solids.compute`.

use super::{SolidPose, SolidsParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which solids a particle of each block of the domain may meet in a substep: a bit each, of those whose box overlaps the
/// block. What is outside an open domain is in the block nearest to it, so those at its faces go on without end.
#[derive(Debug)]
pub struct MarkSolids<'a> {
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `RWStructuredBuffer<uint4> solid_blocks`.
    pub solid_blocks: BufMut<'a, [u32; 4]>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
}

impl Kernel for MarkSolids<'_> {
    const STAGE: &'static str = "mark_solids";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MARK_SOLIDS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_blocks", Some(self.solid_blocks.id)),
                ("solids_params", Some(self.solids_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MARK_SOLIDS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "solid_poses", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "solids_params", slot: 2, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_solids_mark_solids.deflate"));

static MARK_SOLIDS: Module = Module {
    name: "MarkSolids",
    entry: "MarkSolids",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4032 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/mark_solids.compute",
    hash: "87b2707b6df3fff26c81dd1999f8d9ae6aa2d6e13d0de8e3fd7a6e6bc52157d0",
};
