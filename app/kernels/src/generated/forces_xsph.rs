// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/xsph.compute.
//! Kernels of `forces/xsph.compute`.

use super::{ForceParams, ListHead, PrecisionKeyword, SmoothingKernelParams, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`Xsph`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct XsphVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// XSPH viscosity (Schechter & Bridson 2012; Macklin & Muller 2013, eq. 17): each velocity moves
/// towards its neighbours' mean. Bounded for any coefficient up to 1, whatever dt is.
#[derive(Debug)]
pub struct Xsph<'a> {
    /// Its variant.
    pub variant: XsphVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Velocity> smoothed_velocities`.
    pub smoothed_velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<ForceParams> forces`.
    pub forces: Uniform<'a, ForceParams>,
}

impl Kernel for Xsph<'_> {
    const STAGE: &'static str = "xsph";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.precision, self.variant.packed) {
            (PrecisionKeyword::Off, false) => &XSPH,
            (PrecisionKeyword::Off, true) => &XSPH_WITH_PACKED,
            (PrecisionKeyword::RelaxedPrecision, false) => &XSPH_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::RelaxedPrecision, true) => &XSPH_WITH_RELAXED_PRECISION_WITH_PACKED,
            (PrecisionKeyword::HalfPrecision, false) => &XSPH_WITH_HALF_PRECISION,
            (PrecisionKeyword::HalfPrecision, true) => &XSPH_WITH_HALF_PRECISION_WITH_PACKED,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("smoothed_velocities", Some(self.smoothed_velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("forces", Some(self.forces.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &XSPH,
    &XSPH_WITH_PACKED,
    &XSPH_WITH_RELAXED_PRECISION,
    &XSPH_WITH_RELAXED_PRECISION_WITH_PACKED,
    &XSPH_WITH_HALF_PRECISION,
    &XSPH_WITH_HALF_PRECISION_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "smoothed_velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "forces", slot: 8, kind: BindingKind::Uniform { bytes: 16 } },
];

static XSPH: Module = Module {
    name: "Xsph",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/xsph.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/xsph.compute",
    hash: "a9b5ec026d0e29901ff2c24f71b4bc86d146bf005e146f3ee6f12e6b70d64bc4",
};

static XSPH_WITH_PACKED: Module = Module {
    name: "Xsph+PACKED",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/xsph+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/xsph.compute",
    hash: "cdd302ca5dc46fd221590527a65592e4e5916206a0a5fb585f6ea857eb5d02ef",
};

static XSPH_WITH_RELAXED_PRECISION: Module = Module {
    name: "Xsph+RELAXED_PRECISION",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/xsph+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/xsph.compute",
    hash: "28bf6154c669909e79b7d2d70bd7392e777d93ccc0ee1cc229988662d5382575",
};

static XSPH_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "Xsph+RELAXED_PRECISION+PACKED",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/xsph+relaxed_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/xsph.compute",
    hash: "03749bfd57b84a5fed1c9a22d2dd752b1414181a13e88597a0519f5838b6bfeb",
};

static XSPH_WITH_HALF_PRECISION: Module = Module {
    name: "Xsph+HALF_PRECISION",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/xsph+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "forces/xsph.compute",
    hash: "32f4d6f23204f42531ebfcbdd1683f84ff7dd3a9c349315563cb28c2aafc89a9",
};

static XSPH_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "Xsph+HALF_PRECISION+PACKED",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/xsph+half_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "forces/xsph.compute",
    hash: "d50176ea99b284667d7c8c33281961bd1a61bb105612be32ffa0bf77575d9631",
};
