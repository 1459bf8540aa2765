// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from particles/bounce_walls.compute.
//! Kernels of `particles/bounce_walls.compute`.

use super::{NoneParams, Position, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tier, Uniform,
    bind,
};

/// Particles that bounce off the domain's walls, once solids have stopped their paths: the other way round a path that was
/// mirrored in a wall would be taken for one through the solids before it.
#[derive(Debug)]
pub struct BounceWalls<'a> {
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<NoneParams> none`.
    pub none: Uniform<'a, NoneParams>,
}

impl Kernel for BounceWalls<'_> {
    const STAGE: &'static str = "bounce_walls";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &BOUNCE_WALLS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("none", Some(self.none.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&BOUNCE_WALLS];

static BINDINGS_0: &[BindingInfo] = &[
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
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 3, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "none", slot: 4, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/particles_bounce_walls.deflate"));

static BOUNCE_WALLS: Module = Module {
    name: "BounceWalls",
    entry: "BounceWalls",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4188 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "particles/bounce_walls.compute",
    hash: "8e25ef75f085683a518f364fff15b12e79007a43de098f7544a97cb5355692d9",
};
