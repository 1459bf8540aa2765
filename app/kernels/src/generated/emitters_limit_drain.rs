// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from emitters/limit_drain.compute.
//! Kernels of `emitters/limit_drain.compute`.

use super::{Counters, Drain, DrainState, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Every slot, so that the scan finds zeros behind those that are visited.
#[derive(Debug)]
pub struct MarkDrained<'a> {
    /// `RWStructuredBuffer<uint> drain_marks`.
    pub drain_marks: BufMut<'a, u32>,
    /// `StructuredBuffer<Position> drained_positions`.
    pub drained_positions: Buf<'a, Position>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<Drain> drain`.
    pub drain: Uniform<'a, Drain>,
}

impl Kernel for MarkDrained<'_> {
    const STAGE: &'static str = "mark_drained";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &MARK_DRAINED
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("drain_marks", Some(self.drain_marks.id)),
                ("drained_positions", Some(self.drained_positions.id)),
                ("step_state", Some(self.step_state.id)),
                ("drain", Some(self.drain.id)),
            ],
        )
    }
}

/// A drain that takes no more than so many particles a second. MarkDrained says who is in it, a scan gives each a rank by its
/// slot, TakeDrained empties the slots of the first as many as it may take, and SettleDrain keeps account: what it could not
/// take, because too few were in it, it does not take later, but for a part of a particle.
#[derive(Debug)]
pub struct TakeDrained<'a> {
    /// `StructuredBuffer<uint> marked_drains`.
    pub marked_drains: Buf<'a, u32>,
    /// `StructuredBuffer<uint> drain_ranks`.
    pub drain_ranks: Buf<'a, u32>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `StructuredBuffer<DrainState> drain_state`.
    pub drain_state: Buf<'a, DrainState>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for TakeDrained<'_> {
    const STAGE: &'static str = "take_drained";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &TAKE_DRAINED
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("marked_drains", Some(self.marked_drains.id)),
                ("drain_ranks", Some(self.drain_ranks.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("drain_state", Some(self.drain_state.id)),
                ("step_state", Some(self.step_state.id)),
            ],
        )
    }
}

/// A drain that takes no more than so many particles a second. MarkDrained says who is in it, a scan gives each a rank by its
/// slot, TakeDrained empties the slots of the first as many as it may take, and SettleDrain keeps account: what it could not
/// take, because too few were in it, it does not take later, but for a part of a particle.
#[derive(Debug)]
pub struct SettleDrain<'a> {
    /// `StructuredBuffer<uint> marked_drains`.
    pub marked_drains: Buf<'a, u32>,
    /// `StructuredBuffer<uint> drain_ranks`.
    pub drain_ranks: Buf<'a, u32>,
    /// `RWStructuredBuffer<DrainState> settled_drain`.
    pub settled_drain: BufMut<'a, DrainState>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<Drain> drain`.
    pub drain: Uniform<'a, Drain>,
}

impl Kernel for SettleDrain<'_> {
    const STAGE: &'static str = "settle_drain";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &SETTLE_DRAIN
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("marked_drains", Some(self.marked_drains.id)),
                ("drain_ranks", Some(self.drain_ranks.id)),
                ("settled_drain", Some(self.settled_drain.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("drain", Some(self.drain.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MARK_DRAINED, &TAKE_DRAINED, &SETTLE_DRAIN];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "drain_marks",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "drained_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "drain", slot: 3, kind: BindingKind::Uniform { bytes: 32 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "marked_drains",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "drain_ranks", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "positions",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "drain_state", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo {
        name: "marked_drains",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "drain_ranks", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "settled_drain",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "counters",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "drain", slot: 5, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/emitters_limit_drain.deflate"));

static MARK_DRAINED: Module = Module {
    name: "MarkDrained",
    entry: "MarkDrained",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 3228 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/limit_drain.compute",
    hash: "0739feb9da0ea25cf0c27fce8c115bf268abe0c24dca404a8968222b2f6c8f7b",
};

static TAKE_DRAINED: Module = Module {
    name: "TakeDrained",
    entry: "TakeDrained",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 3228, bytes: 3236 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/limit_drain.compute",
    hash: "e10816921d6e0c928b8a431cdfd7b7576a813e2ab3240213f6c06cbb4d7f5626",
};

static SETTLE_DRAIN: Module = Module {
    name: "SettleDrain",
    entry: "SettleDrain",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 6464, bytes: 3752 },
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "emitters/limit_drain.compute",
    hash: "63b1b297ab3cd502d85f29fd3b4e7e4e2aa64c5c6b4b39f8821ffc74d5c32761",
};
