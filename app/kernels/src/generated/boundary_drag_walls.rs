// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/drag_walls.compute.
//! Kernels of `boundary/drag_walls.compute`.

use super::{Position, SmoothingKernelParams, StepParams, StepState, Velocity, WallFace};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// How walls drag the fluid along them, face by face, at a substep's end: dv/dt = k (v\_wall - v) along a wall, integrated in
/// closed form, so stable at any dt. For no slip k is a constant of the place, and v - v\_wall falls by exp(-k dt): forces of a
/// leap-frog see velocities half a kick away from here, with which its steady state is that of k but for (k dt)^2/12. Friction
/// grows with |v - v\_wall|, which falls by 1/(1 + k dt) then.
#[derive(Debug)]
pub struct DragWalls<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// lowest end of each axis first: face f stands across axis f / 2
    ///
    /// `StructuredBuffer<WallFace> wall_faces`.
    pub wall_faces: Buf<'a, WallFace>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for DragWalls<'_> {
    const STAGE: &'static str = "drag_walls";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &DRAG_WALLS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("wall_faces", Some(self.wall_faces.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAG_WALLS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "velocities",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "wall_faces", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_drag_walls.deflate"));

static DRAG_WALLS: Module = Module {
    name: "DragWalls",
    entry: "DragWalls",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8836 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/drag_walls.compute",
    hash: "0b10d851753ab52f324eaa78f57691ff18d8a9c46064f368cc6b6181816c7c0f",
};
