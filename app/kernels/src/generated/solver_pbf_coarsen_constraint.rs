// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/coarsen_constraint.compute.
//! Kernels of `solver/pbf/coarsen_constraint.compute`.

use super::{CoarseCell, CoarseGridParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// The particles of eight coarse cells as those of one, twice as wide: what a slow mode looks like from further away.
#[derive(Debug)]
pub struct CoarsenConstraint<'a> {
    /// `StructuredBuffer<CoarseCell> finer_cells`.
    pub finer_cells: Buf<'a, CoarseCell>,
    /// `RWStructuredBuffer<CoarseCell> coarse_cells`.
    pub coarse_cells: BufMut<'a, CoarseCell>,
    /// `ConstantBuffer<CoarseGridParams> coarse`.
    pub coarse: Uniform<'a, CoarseGridParams>,
}

impl Kernel for CoarsenConstraint<'_> {
    const STAGE: &'static str = "coarsen_constraint";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &COARSEN_CONSTRAINT
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("finer_cells", Some(self.finer_cells.id)),
                ("coarse_cells", Some(self.coarse_cells.id)),
                ("coarse", Some(self.coarse.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COARSEN_CONSTRAINT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "finer_cells", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "coarse_cells",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "coarse", slot: 2, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_coarsen_constraint.deflate"));

static COARSEN_CONSTRAINT: Module = Module {
    name: "CoarsenConstraint",
    entry: "CoarsenConstraint",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3764 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/coarsen_constraint.compute",
    hash: "9038f51559349c53491cc3bf864ab8421e6822239146f4a1b26e9321a80640c6",
};
