// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/apply_fields.compute.
//! Kernels of `forces/apply_fields.compute`.

use super::{ForceField, ForceFieldCount, Position, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Body forces that depend on place and time: v += a(x, t) dt, a the sum of the scene's fields. Uniform, or around an axis
/// (a swirl), each for a while, and swinging if it has a frequency. The time is the middle of the substep.
#[derive(Debug)]
pub struct ApplyFields<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<ForceField> fields`.
    pub fields: Buf<'a, ForceField>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<ForceFieldCount> field_count`.
    pub field_count: Uniform<'a, ForceFieldCount>,
}

impl Kernel for ApplyFields<'_> {
    const STAGE: &'static str = "apply_fields";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &APPLY_FIELDS
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("fields", Some(self.fields.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("field_count", Some(self.field_count.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&APPLY_FIELDS];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "fields", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 48 } },
    BindingInfo {
        name: "velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "field_count", slot: 4, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/forces_apply_fields.deflate"));

static APPLY_FIELDS: Module = Module {
    name: "ApplyFields",
    entry: "ApplyFields",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4316 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/apply_fields.compute",
    hash: "6acccc0bbbb09e772c014df1ccbb2c3a302cc6850cbc8afe971b7362d1ed2dea",
};
