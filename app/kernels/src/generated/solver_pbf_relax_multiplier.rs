// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/relax_multiplier.compute.
//! Kernels of `solver/pbf/relax_multiplier.compute`.

use super::{CoarseCell, CoarseGridParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`RelaxMultiplier`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RelaxMultiplierVariant {
    /// Keyword `PROLONGED`.
    pub prolonged: bool,
}

/// The coarse multiplier at one level, by red-black Gauss-Seidel sweeps over a tile of it in shared memory: one dispatch
/// whatever the sweeps. It starts from the level above, interpolated (nested iteration, Hackbusch 1985), and what
/// surrounds the tile stays as that says; the coarsest level is a single tile, and starts from nothing.
#[derive(Debug)]
pub struct RelaxMultiplier<'a> {
    /// Its variant.
    pub variant: RelaxMultiplierVariant,
    /// `StructuredBuffer<CoarseCell> coarse_cells`.
    pub coarse_cells: Buf<'a, CoarseCell>,
    /// `RWStructuredBuffer<float> multipliers`.
    pub multipliers: BufMut<'a, f32>,
    /// `ConstantBuffer<CoarseGridParams> coarse`.
    pub coarse: Uniform<'a, CoarseGridParams>,
    /// `StructuredBuffer<float> coarser_multipliers`.
    pub coarser_multipliers: Option<Buf<'a, f32>>,
}

impl Kernel for RelaxMultiplier<'_> {
    const STAGE: &'static str = "relax_multiplier";
    const GROUP_SIZE: [u32; 3] = [256, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.prolonged { &RELAX_MULTIPLIER_WITH_PROLONGED } else { &RELAX_MULTIPLIER }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("coarse_cells", Some(self.coarse_cells.id)),
                ("multipliers", Some(self.multipliers.id)),
                ("coarse", Some(self.coarse.id)),
                ("coarser_multipliers", self.coarser_multipliers.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&RELAX_MULTIPLIER, &RELAX_MULTIPLIER_WITH_PROLONGED];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "coarse_cells", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "multipliers",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "coarse", slot: 2, kind: BindingKind::Uniform { bytes: 96 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "coarse_cells", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "coarser_multipliers",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "multipliers",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "coarse", slot: 3, kind: BindingKind::Uniform { bytes: 96 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_pbf_relax_multiplier.deflate"));

static RELAX_MULTIPLIER: Module = Module {
    name: "RelaxMultiplier",
    entry: "RelaxMultiplier",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 25548 },
    bindings: BINDINGS_0,
    group_size: [256, 1, 1],
    shared_bytes: 4000,
    tier: Tier::Floor,
    source: "solver/pbf/relax_multiplier.compute",
    hash: "7dd8351c04908dca29465846fb1b83088be1dc37a2180caf3dafa0718f9cb50b",
};

static RELAX_MULTIPLIER_WITH_PROLONGED: Module = Module {
    name: "RelaxMultiplier+PROLONGED",
    entry: "RelaxMultiplier",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 25548, bytes: 40152 },
    bindings: BINDINGS_1,
    group_size: [256, 1, 1],
    shared_bytes: 4000,
    tier: Tier::Floor,
    source: "solver/pbf/relax_multiplier.compute",
    hash: "4ecb268186ad38b353514a246e30319f22149867bb1cf5fe6c8cf43674e78fdc",
};
