// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/scan_groups_tree.compute.
//! Kernels of `bench/scan_groups_tree.compute`.

use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, bind,
};

/// Which variant of [`ScanGroupsTree`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ScanGroupsTreeVariant {
    /// Keyword `GROUP_OFFSETS`.
    pub group_offsets: bool,
    /// Keyword `PADDED`.
    pub padded: bool,
}

/// ScanGroups with the threads' sums scanned by a tree (Blelloch 1990) instead of Hillis & Steele's
/// doubling: less work and more barriers, and strides of powers of two, whose threads meet in one
/// bank of the groupshared memory. PADDED puts a word behind every 32nd, as in Harris et al. 2007
/// (GPU Gems 3, chapter 39). What `brooklet bench sorting` holds against it is grid/scan.compute.
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
    spirv: include_bytes!("../../spirv/scan_groups_tree.spv"),
    bindings: BINDINGS_0,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "2bf9ece4b8c1436d0d631150f3a41b80733d2ce63571213e1fa25bb04c00df21",
};

static SCAN_GROUPS_TREE_WITH_PADDED: Module = Module {
    name: "ScanGroupsTree+PADDED",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/scan_groups_tree+padded.spv"),
    bindings: BINDINGS_0,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "994445aea624de4b4831fb09425ede2103e023565f11d8fa80ef34e788a188e4",
};

static SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS: Module = Module {
    name: "ScanGroupsTree+GROUP_OFFSETS",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/scan_groups_tree+group_offsets.spv"),
    bindings: BINDINGS_1,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "079bf31ec565bf8e91b60aefeb1812e172a065fc72d14369273224936a2f51e9",
};

static SCAN_GROUPS_TREE_WITH_GROUP_OFFSETS_WITH_PADDED: Module = Module {
    name: "ScanGroupsTree+GROUP_OFFSETS+PADDED",
    entry: "ScanGroupsTree",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/scan_groups_tree+group_offsets+padded.spv"),
    bindings: BINDINGS_1,
    group_size: [128, 1, 1],
    shared_bytes: 528,
    tier: Tier::Floor,
    source: "bench/scan_groups_tree.compute",
    hash: "f0141cdb289ebb823cf631987b88e3d066ddfbc3284040e3cf46d13e6ad1c113",
};
