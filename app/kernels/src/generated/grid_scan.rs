// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/scan.compute.
//! Kernels of `grid/scan.compute`.

use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier, bind,
};

/// Exclusive prefix sums of any length in the two phases of the mobile deck (inside groups, then
/// across them), by reduce-then-scan: ReduceGroups sums each group, the sums are scanned by the
/// same kernels one level up, and ScanGroups adds them as offsets. No group waits for another:
/// Adrenos promise no forward progress, so a look-back scan could hang there.
#[derive(Debug)]
pub struct ReduceGroups<'a> {
    /// `StructuredBuffer<uint> values`.
    pub values: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> group_sums`.
    pub group_sums: BufMut<'a, u32>,
}

impl Kernel for ReduceGroups<'_> {
    const STAGE: &'static str = "reduce_groups";
    const GROUP_SIZE: [u32; 3] = [128, 1, 1];

    fn module(&self) -> &'static Module {
        &REDUCE_GROUPS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("values", Some(self.values.id)), ("group_sums", Some(self.group_sums.id))])
    }
}

/// Which variant of [`ScanGroups`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ScanGroupsVariant {
    /// Keyword `GROUP_OFFSETS`.
    pub group_offsets: bool,
}

/// Exclusive prefix sums of any length in the two phases of the mobile deck (inside groups, then
/// across them), by reduce-then-scan: ReduceGroups sums each group, the sums are scanned by the
/// same kernels one level up, and ScanGroups adds them as offsets. No group waits for another:
/// Adrenos promise no forward progress, so a look-back scan could hang there.
#[derive(Debug)]
pub struct ScanGroups<'a> {
    /// Its variant.
    pub variant: ScanGroupsVariant,
    /// `StructuredBuffer<uint> values`.
    pub values: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> scanned`.
    pub scanned: BufMut<'a, u32>,
    /// `StructuredBuffer<uint> group_offsets`.
    pub group_offsets: Option<Buf<'a, u32>>,
}

impl Kernel for ScanGroups<'_> {
    const STAGE: &'static str = "scan_groups";
    const GROUP_SIZE: [u32; 3] = [128, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.group_offsets { &SCAN_GROUPS_WITH_GROUP_OFFSETS } else { &SCAN_GROUPS }
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
pub(super) static MODULES: &[&Module] = &[&REDUCE_GROUPS, &SCAN_GROUPS, &SCAN_GROUPS_WITH_GROUP_OFFSETS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "values", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "group_sums",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "values", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "scanned", slot: 1, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "values", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "group_offsets",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "scanned", slot: 2, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_scan.deflate"));

static REDUCE_GROUPS: Module = Module {
    name: "ReduceGroups",
    entry: "ReduceGroups",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4220 },
    bindings: BINDINGS_0,
    group_size: [128, 1, 1],
    shared_bytes: 576,
    tier: Tier::Floor,
    source: "grid/scan.compute",
    hash: "7d5d16236705806c5cdc308d64d5b5782d6cf98b34e0451ee12c4278ffd3fb93",
};

static SCAN_GROUPS: Module = Module {
    name: "ScanGroups",
    entry: "ScanGroups",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4220, bytes: 5772 },
    bindings: BINDINGS_1,
    group_size: [128, 1, 1],
    shared_bytes: 576,
    tier: Tier::Floor,
    source: "grid/scan.compute",
    hash: "d7438879a9eb4e8ffd9a92ecc397fe6de96d6e3994ab4a646bdf78c856198336",
};

static SCAN_GROUPS_WITH_GROUP_OFFSETS: Module = Module {
    name: "ScanGroups+GROUP_OFFSETS",
    entry: "ScanGroups",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 9992, bytes: 5968 },
    bindings: BINDINGS_2,
    group_size: [128, 1, 1],
    shared_bytes: 576,
    tier: Tier::Floor,
    source: "grid/scan.compute",
    hash: "22323c62186d634fd9de34120f9d6dc6600240e1e8b2139d33fac9616315ad65",
};
