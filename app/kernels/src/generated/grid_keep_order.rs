// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from grid/keep_order.compute.
//! Kernels of `grid/keep_order.compute`.

use super::{GridParams, Position, PrecisionKeyword, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`KeepOrder`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct KeepOrderVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// In place of a sort: particles stay in the order of the last one, and are where they have moved since. Lists of that order
/// stay what they are.
#[derive(Debug)]
pub struct KeepOrder<'a> {
    /// Its variant.
    pub variant: KeepOrderVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `RWStructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> sorted_velocities`.
    pub sorted_velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: BufMut<'a, [u32; 2]>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<GridParams> grid`.
    pub grid: Uniform<'a, GridParams>,
}

impl Kernel for KeepOrder<'_> {
    const STAGE: &'static str = "keep_order";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.precision {
            PrecisionKeyword::Off => &KEEP_ORDER,
            PrecisionKeyword::RelaxedPrecision => &KEEP_ORDER_WITH_RELAXED_PRECISION,
            PrecisionKeyword::HalfPrecision => &KEEP_ORDER_WITH_RELAXED_PRECISION,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("sorted_velocities", Some(self.sorted_velocities.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("step_state", Some(self.step_state.id)),
                ("grid", Some(self.grid.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&KEEP_ORDER, &KEEP_ORDER_WITH_RELAXED_PRECISION];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "sorted_positions",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_velocities",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "grid", slot: 6, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/grid_keep_order.deflate"));

static KEEP_ORDER: Module = Module {
    name: "KeepOrder",
    entry: "KeepOrder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4272 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/keep_order.compute",
    hash: "c8e4965724b6b499569c7618ea2c3618d728a4940b2cdb325889a555c18e697f",
};

static KEEP_ORDER_WITH_RELAXED_PRECISION: Module = Module {
    name: "KeepOrder+RELAXED_PRECISION",
    entry: "KeepOrder",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 4272, bytes: 4424 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "grid/keep_order.compute",
    hash: "152222b3ac817da62a514ae5f9db7cf68e3a0770d5af319ad6c58619b532d9dd",
};
