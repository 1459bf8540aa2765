// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/scan_groups_doubling.compute.
//! Kernels of `bench/scan_groups_doubling.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// Which variant of [`ScanGroupsDoubling`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ScanGroupsDoublingVariant {
    /// Keyword `GROUP_OFFSETS`.
    pub group_offsets: bool,
}

/// ScanGroups with the threads' sums scanned by doubling the reach (Hillis & Steele 1986) instead of in blocks: one
/// barrier a doubling. What `brooklet bench sorting` holds against it is grid/scan.compute.
#[derive(Debug)]
pub struct ScanGroupsDoubling<'a> {
    /// Its variant.
    pub variant: ScanGroupsDoublingVariant,
    /// `StructuredBuffer<uint> values`.
    pub values: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> scanned`.
    pub scanned: BufMut<'a, u32>,
    /// `StructuredBuffer<uint> group_offsets`.
    pub group_offsets: Option<Buf<'a, u32>>,
}

impl Kernel for ScanGroupsDoubling<'_> {
    const STAGE: &'static str = "scan_groups_doubling";
    const GROUP_SIZE: [u32; 3] = [128, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.group_offsets { &SCAN_GROUPS_DOUBLING_WITH_GROUP_OFFSETS } else { &SCAN_GROUPS_DOUBLING }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("values", Some(self.values.id)),
                ("scanned", Some(self.scanned.id)),
                ("group_offsets", self.group_offsets.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SCAN_GROUPS_DOUBLING, &SCAN_GROUPS_DOUBLING_WITH_GROUP_OFFSETS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "values", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "scanned", slot: 1, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "values", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "group_offsets",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "scanned", slot: 2, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static SCAN_GROUPS_DOUBLING: Module = Module {
    name: "ScanGroupsDoubling",
    entry: "ScanGroupsDoubling",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_groups_doubling.spv")),
    bindings: BINDINGS_0,
    group_size: [128, 1, 1],
    shared_bytes: 1024,
    tier: Tier::Floor,
    source: "bench/scan_groups_doubling.compute",
    hash: "c5617303b70312051a5b81ed073797f58992118529d4b759f2c330ccc254c5a2",
};

static SCAN_GROUPS_DOUBLING_WITH_GROUP_OFFSETS: Module = Module {
    name: "ScanGroupsDoubling+GROUP_OFFSETS",
    entry: "ScanGroupsDoubling",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_groups_doubling+group_offsets.spv")),
    bindings: BINDINGS_1,
    group_size: [128, 1, 1],
    shared_bytes: 1024,
    tier: Tier::Floor,
    source: "bench/scan_groups_doubling.compute",
    hash: "520da0f23b60a0229bcd73578a7560433e403358b8729db968023278a9d8e57c",
};
