// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/spawn_diffuse.compute.
//! Kernels of `diffuse/spawn_diffuse.compute`.

use super::{Counters, DiffuseParams, DiffuseParticle, DiffuseState, ListHead, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Puts what fluid particles spawn into slots, in their order: in a cylinder along the way that a particle came, where nothing
/// stood, and parting from its axis as fast as they are off it (eqs. 9 to 11; the paper's offset in metres is taken for one in m/s, here it is a share of the speed). The
/// ring's next slots are taken; whose slot it was is over. SettleDiffuse then moves the ring on.
#[derive(Debug)]
pub struct SpawnDiffuse<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `StructuredBuffer<uint> spawn_counts`.
    pub spawn_counts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> spawn_offsets`.
    pub spawn_offsets: Buf<'a, u32>,
    /// `RWStructuredBuffer<DiffuseParticle> diffuse`.
    pub diffuse: BufMut<'a, DiffuseParticle>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<DiffuseState> diffuse_state`.
    pub diffuse_state: Uniform<'a, DiffuseState>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<DiffuseParams> diffuse_params`.
    pub diffuse_params: Uniform<'a, DiffuseParams>,
}

impl Kernel for SpawnDiffuse<'_> {
    const STAGE: &'static str = "spawn_diffuse";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SPAWN_DIFFUSE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("spawn_counts", Some(self.spawn_counts.id)),
                ("spawn_offsets", Some(self.spawn_offsets.id)),
                ("diffuse", Some(self.diffuse.id)),
                ("counters", Some(self.counters.id)),
                ("diffuse_state", Some(self.diffuse_state.id)),
                ("step_state", Some(self.step_state.id)),
                ("diffuse_params", Some(self.diffuse_params.id)),
            ],
        )
    }
}

/// Puts what fluid particles spawn into slots, in their order: in a cylinder along the way that a particle came, where nothing
/// stood, and parting from its axis as fast as they are off it (eqs. 9 to 11; the paper's offset in metres is taken for one in m/s, here it is a share of the speed). The
/// ring's next slots are taken; whose slot it was is over. SettleDiffuse then moves the ring on.
#[derive(Debug)]
pub struct SettleDiffuse<'a> {
    /// `StructuredBuffer<uint> spawn_counts`.
    pub spawn_counts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> spawn_offsets`.
    pub spawn_offsets: Buf<'a, u32>,
    /// `RWStructuredBuffer<DiffuseState> settled_state`.
    pub settled_state: BufMut<'a, DiffuseState>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<DiffuseParams> diffuse_params`.
    pub diffuse_params: Uniform<'a, DiffuseParams>,
}

impl Kernel for SettleDiffuse<'_> {
    const STAGE: &'static str = "settle_diffuse";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &SETTLE_DIFFUSE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("spawn_counts", Some(self.spawn_counts.id)),
                ("spawn_offsets", Some(self.spawn_offsets.id)),
                ("settled_state", Some(self.settled_state.id)),
                ("counters", Some(self.counters.id)),
                ("diffuse_params", Some(self.diffuse_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SPAWN_DIFFUSE, &SETTLE_DIFFUSE];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "spawn_counts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "spawn_offsets",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "diffuse",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "diffuse_state", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "diffuse_params", slot: 9, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "spawn_counts", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "spawn_offsets",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "settled_state",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "diffuse_params", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/diffuse_spawn_diffuse.deflate"));

static SPAWN_DIFFUSE: Module = Module {
    name: "SpawnDiffuse",
    entry: "SpawnDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10152 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/spawn_diffuse.compute",
    hash: "2c48f525d780e1518b29275337a0664eeb80519e846c3ea0d82d6c0802f81f11",
};

static SETTLE_DIFFUSE: Module = Module {
    name: "SettleDiffuse",
    entry: "SettleDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10152, bytes: 4304 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/spawn_diffuse.compute",
    hash: "2117d3d9aea7fe1628e1461c95379392b9d1c8e2bb0189d6cc421cff26cc1637",
};
