// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/scan_groups_tree.compute.
//! Kernels of `bench/scan_groups_tree.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// Which variant of [`ScanGroupsTree`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ScanGroupsTreeVariant {
    /// Keyword `GROUP_OFFSETS`.
    pub group_offsets: bool,
    /// Keyword `PADDED`.
    pub padded: bool,
}

/// ScanGroups with the threads' sums scanned by a tree (Blelloch 1990) instead of in blocks: more
/// barriers, and strides of powers of two, whose threads meet in one bank of the groupshared memory.
/// PADDED puts a word behind every 32nd, as in Harris et al. 2007 (GPU Gems 3, chapter 39). What `brooklet bench sorting` holds against it is grid/scan.compute.
#[derive(Debug)]
pub struct ScanGroupsTree<'a> {
    /// Its variant.
    pub variant: ScanGroupsTreeVariant,
    /// `StructuredBuffer<uint> values`.
    pub values: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> scanned`.
    pub scanned: BufMut<'a, u32>,
    /// `StructuredBuffer<uint> group_offsets`.
    pub group_offsets: Option<Buf<'a, u32>>,
}

impl Kernel for ScanGroupsTree<'_> {
    const STAGE: &'static str = "scan_groups_tree";
    const GROUP_SIZE: [u32; 3] = [128, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.group_offsets, self.variant.padded) {
            (false, false) => &SCAN_GROUPS_TREE,
            (false, true) => &SCAN_GROUPS_TREE_WITH_PADDED,
            (true, false) => &SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS,
            (true, true) => &SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS_WITH_PADDED,
        }
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
pub(super) static MODULES: &[&Module] = &[
    &SCAN_GROUPS_TREE,
    &SCAN_GROUPS_TREE_WITH_PADDED,
    &SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS,
    &SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS_WITH_PADDED,
];

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

static SCAN_GROUPS_TREE: Module = Module {
    name: "ScanGroupsTree",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_groups_tree.spv")),
    bindings: BINDINGS_0,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "40903317cd7323a7b6fc24b64bf879ceb84566dab9f7fd44120b5ca1a42744b0",
};

static SCAN_GROUPS_TREE_WITH_PADDED: Module = Module {
    name: "ScanGroupsTree+PADDED",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_groups_tree+padded.spv")),
    bindings: BINDINGS_0,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "68c4b914d6c2845f96d796749f247440f36982bdbfd280f24a2dca13d588aacd",
};

static SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS: Module = Module {
    name: "ScanGroupsTree+GROUP_OFFSETS",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_groups_tree+group_offsets.spv")),
    bindings: BINDINGS_1,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "47de42854f834d0964674678a11ea39fc96fb2c94345194977ef3e704b636d77",
};

static SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS_WITH_PADDED: Module = Module {
    name: "ScanGroupsTree+GROUP_OFFSETS+PADDED",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/scan_groups_tree+group_offsets+padded.spv")),
    bindings: BINDINGS_1,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "bcda33d53f9e22fe50cff79f7f37c1af7645bac541e4dd5a0277d8987caf4777",
};
