// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/repel_walls.compute.
//! Kernels of `boundary/repel_walls.compute`.

use super::{Position, RepelParams, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Walls that keep the fluid by what they do to a velocity across them, and not by its pressure: at a substep's end, wall by
/// wall, u being the velocity away from the wall and s the distance. `reach_m` is where they begin.
#[derive(Debug)]
pub struct RepelWalls<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<RepelParams> repel`.
    pub repel: Uniform<'a, RepelParams>,
}

impl Kernel for RepelWalls<'_> {
    const STAGE: &'static str = "repel_walls";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &REPEL_WALLS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("repel", Some(self.repel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&REPEL_WALLS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 3, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "repel", slot: 4, kind: BindingKind::Uniform { bytes: 32 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_repel_walls.deflate"));

static REPEL_WALLS: Module = Module {
    name: "RepelWalls",
    entry: "RepelWalls",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 5732 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/repel_walls.compute",
    hash: "220d9175e10671f4ac0a36824d9361bf0af75232a53891f8f4c69c18a84b0fc2",
};
