// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/compact.compute.
//! Kernels of `emitters/compact.compute`.

use super::{Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Every slot, so that the scan finds zeros behind those that are visited.
#[derive(Debug)]
pub struct MarkActive<'a> {
    /// `StructuredBuffer<Position> marked_positions`.
    pub marked_positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<uint> active_marks`.
    pub active_marks: BufMut<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for MarkActive<'_> {
    const STAGE: &'static str = "mark_active";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MARK_ACTIVE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("marked_positions", Some(self.marked_positions.id)),
                ("active_marks", Some(self.active_marks.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// Brings inactive slots behind all particles where no sort does: the k-th particle that stands behind as many slots as there are
/// particles moves into the k-th empty one before. MarkActive and a scan count them; ListMovers names those that move;
/// FillHoles moves them, and slots change ids; CountCompacted says how many there are. In the order of slots: the same each time.
#[derive(Debug)]
pub struct ListMovers<'a> {
    /// `StructuredBuffer<uint> marked_slots`.
    pub marked_slots: Buf<'a, u32>,
    /// `StructuredBuffer<uint> active_ranks`.
    pub active_ranks: Buf<'a, u32>,
    /// `RWStructuredBuffer<uint> movers`.
    pub movers: BufMut<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for ListMovers<'_> {
    const STAGE: &'static str = "list_movers";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &LIST_MOVERS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("marked_slots", Some(self.marked_slots.id)),
                ("active_ranks", Some(self.active_ranks.id)),
                ("movers", Some(self.movers.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// Brings inactive slots behind all particles where no sort does: the k-th particle that stands behind as many slots as there are
/// particles moves into the k-th empty one before. MarkActive and a scan count them; ListMovers names those that move;
/// FillHoles moves them, and slots change ids; CountCompacted says how many there are. In the order of slots: the same each time.
#[derive(Debug)]
pub struct FillHoles<'a> {
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `StructuredBuffer<uint> marked_slots`.
    pub marked_slots: Buf<'a, u32>,
    /// `StructuredBuffer<uint> active_ranks`.
    pub active_ranks: Buf<'a, u32>,
    /// `StructuredBuffer<uint> listed_movers`.
    pub listed_movers: Buf<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for FillHoles<'_> {
    const STAGE: &'static str = "fill_holes";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &FILL_HOLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("marked_slots", Some(self.marked_slots.id)),
                ("active_ranks", Some(self.active_ranks.id)),
                ("listed_movers", Some(self.listed_movers.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// Brings inactive slots behind all particles where no sort does: the k-th particle that stands behind as many slots as there are
/// particles moves into the k-th empty one before. MarkActive and a scan count them; ListMovers names those that move;
/// FillHoles moves them, and slots change ids; CountCompacted says how many there are. In the order of slots: the same each time.
#[derive(Debug)]
pub struct CountCompacted<'a> {
    /// `StructuredBuffer<uint> marked_slots`.
    pub marked_slots: Buf<'a, u32>,
    /// `StructuredBuffer<uint> active_ranks`.
    pub active_ranks: Buf<'a, u32>,
    /// `RWStructuredBuffer<StepState> compacted_state`.
    pub compacted_state: BufMut<'a, StepState>,
}

impl Kernel for CountCompacted<'_> {
    const STAGE: &'static str = "count_compacted";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &COUNT_COMPACTED
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("marked_slots", Some(self.marked_slots.id)),
                ("active_ranks", Some(self.active_ranks.id)),
                ("compacted_state", Some(self.compacted_state.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MARK_ACTIVE, &LIST_MOVERS, &FILL_HOLES, &COUNT_COMPACTED];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "marked_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "active_marks",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "marked_slots", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "active_ranks", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "movers", slot: 2, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo {
        name: "positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "marked_slots", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "active_ranks", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "listed_movers",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "marked_slots", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "active_ranks", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "compacted_state",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/emitters_compact.deflate"));

static MARK_ACTIVE: Module = Module {
    name: "MarkActive",
    entry: "MarkActive",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2180 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/compact.compute",
    hash: "b4bc7ab8f0ac2eed3ac40d1cff3fccebf72898f769f10be0371f9dd224f3900b",
};

static LIST_MOVERS: Module = Module {
    name: "ListMovers",
    entry: "ListMovers",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 2180, bytes: 2264 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/compact.compute",
    hash: "d73306e49af6629f09025f0dd8b68efcc2ae137b1326eced749b2486817f916f",
};

static FILL_HOLES: Module = Module {
    name: "FillHoles",
    entry: "FillHoles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4444, bytes: 3028 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/compact.compute",
    hash: "fe974ac42684d03642fb88ba739236414af533010f0e809fcc9037bb7038951c",
};

static COUNT_COMPACTED: Module = Module {
    name: "CountCompacted",
    entry: "CountCompacted",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7472, bytes: 2116 },
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/compact.compute",
    hash: "a643419ec61203371fe47813a66d09973133b4ebb7d25086d6d1c55532785abf",
};
