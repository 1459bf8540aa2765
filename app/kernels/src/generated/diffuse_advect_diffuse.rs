// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from diffuse/advect_diffuse.compute.
//! Kernels of `diffuse/advect_diffuse.compute`.

use super::{
    Counters, DiffuseParams, DiffuseParticle, DiffuseState, GridParams, Position, StepParams, StepState, Velocity,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`AdvectDiffuse`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct AdvectDiffuseVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `CELL_BY_CELL`.
    pub cell_by_cell: bool,
}

/// Moves the diffuse particles over a step (Ihmsen et al. 2012, section 3.2): spray, with little fluid near it, falls freely; foam
/// goes with the fluid, and ages; bubbles, with fluid all around, rise and are dragged along. Each is told by how many fluid
/// particles are near it, of those that could be inside the walls. What touches a wall ages too: drops on a dry floor run off.
#[derive(Debug)]
pub struct AdvectDiffuse<'a> {
    /// Its variant.
    pub variant: AdvectDiffuseVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint> cell_starts`.
    pub cell_starts: Buf<'a, u32>,
    /// `RWStructuredBuffer<DiffuseParticle> diffuse`.
    pub diffuse: BufMut<'a, DiffuseParticle>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<DiffuseState> diffuse_state`.
    pub diffuse_state: Uniform<'a, DiffuseState>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
    /// `ConstantBuffer<DiffuseParams> diffuse_params`.
    pub diffuse_params: Uniform<'a, DiffuseParams>,
}

impl Kernel for AdvectDiffuse<'_> {
    const STAGE: &'static str = "advect_diffuse";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.cell_by_cell) {
            (false, false) => &ADVECT_DIFFUSE,
            (false, true) => &ADVECT_DIFFUSE_WITH_CELL_BY_CELL,
            (true, false) => &ADVECT_DIFFUSE_WITH_WALLS,
            (true, true) => &ADVECT_DIFFUSE_WITH_WALLS_WITH_CELL_BY_CELL,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("cell_starts", Some(self.cell_starts.id)),
                ("diffuse", Some(self.diffuse.id)),
                ("counters", Some(self.counters.id)),
                ("diffuse_state", Some(self.diffuse_state.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("grid", Some(self.grid.id)),
                ("diffuse_params", Some(self.diffuse_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &ADVECT_DIFFUSE,
    &ADVECT_DIFFUSE_WITH_CELL_BY_CELL,
    &ADVECT_DIFFUSE_WITH_WALLS,
    &ADVECT_DIFFUSE_WITH_WALLS_WITH_CELL_BY_CELL,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "cell_starts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "diffuse",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "diffuse_state", slot: 5, kind: BindingKind::Uniform { bytes: 32 } },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "grid", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "diffuse_params", slot: 9, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/diffuse_advect_diffuse.deflate"));

static ADVECT_DIFFUSE: Module = Module {
    name: "AdvectDiffuse",
    entry: "AdvectDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 13796 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/advect_diffuse.compute",
    hash: "012bbe44c667a0ba275d23cae25de02b02aa4c669f92e09f33149beee64f8ed2",
};

static ADVECT_DIFFUSE_WITH_CELL_BY_CELL: Module = Module {
    name: "AdvectDiffuse+CELL_BY_CELL",
    entry: "AdvectDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 13796, bytes: 15316 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/advect_diffuse.compute",
    hash: "a25f51db017c5a040778f39332bcbce18205cca8bf565e2feb4867a7081596f4",
};

static ADVECT_DIFFUSE_WITH_WALLS: Module = Module {
    name: "AdvectDiffuse+WALLS",
    entry: "AdvectDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 29112, bytes: 14188 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/advect_diffuse.compute",
    hash: "0e0a3b205253f7b11e2b1c0ec5663b19785a8a4247cda990a5dc2646cfb17473",
};

static ADVECT_DIFFUSE_WITH_WALLS_WITH_CELL_BY_CELL: Module = Module {
    name: "AdvectDiffuse+WALLS+CELL_BY_CELL",
    entry: "AdvectDiffuse",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 43300, bytes: 15708 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "diffuse/advect_diffuse.compute",
    hash: "b5704c880e8d9c6640fe838b6a8b31350811a063c37529b5ee453ab300acbc23",
};
