// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/count_bins.compute.
//! Kernels of `surface/mesh/count_bins.compute`.

use super::{CellSlot, Ellipsoid, MeshParams, Position, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`CountBins`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CountBinsVariant {
    /// Keyword `ANISOTROPIC`.
    pub anisotropic: bool,
}

/// How many particles each bin holds, and how many of its bin came before each particle: the counting sort's first pass
/// over bins that fit the mesh's blocks.
#[derive(Debug)]
pub struct CountBins<'a> {
    /// Its variant.
    pub variant: CountBinsVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// and one more, of those that take no part
    ///
    /// `RWStructuredBuffer<uint> bin_counts`.
    pub bin_counts: BufMut<'a, u32>,
    /// `RWStructuredBuffer<CellSlot> bin_slots`.
    pub bin_slots: BufMut<'a, CellSlot>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
}

impl Kernel for CountBins<'_> {
    const STAGE: &'static str = "count_bins";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.anisotropic { &COUNT_BINS_WITH_ANISOTROPIC } else { &COUNT_BINS }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("bin_counts", Some(self.bin_counts.id)),
                ("bin_slots", Some(self.bin_slots.id)),
                ("step_state", Some(self.step_state.id)),
                ("mesh", Some(self.mesh.id)),
                ("ellipsoids", self.ellipsoids.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_BINS, &COUNT_BINS_WITH_ANISOTROPIC];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "bin_counts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "bin_slots",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "mesh", slot: 4, kind: BindingKind::Uniform { bytes: 160 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "ellipsoids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "bin_counts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "bin_slots",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "mesh", slot: 4, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_count_bins.deflate"));

static COUNT_BINS: Module = Module {
    name: "CountBins",
    entry: "CountBins",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4768 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/count_bins.compute",
    hash: "7afcf42bf778508b4d057c5db0b7d7383b3b21267e99299db7c8d384281d2acf",
};

static COUNT_BINS_WITH_ANISOTROPIC: Module = Module {
    name: "CountBins+ANISOTROPIC",
    entry: "CountBins",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4768, bytes: 4860 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/count_bins.compute",
    hash: "9f92c310bb305f666007458e64e37cbde75e3f0aff9dc0b256bfb6531bb176d8",
};
