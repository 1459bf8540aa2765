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
    hash: "89e722d540324286430589c4687d2c1c6b1f7d04c2eaf100e7663783b2ad33b3",
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
    hash: "ea976b3ada7033446da6466c1bfe9b06ae19d9bd799812276a813e90d5146e8e",
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
    hash: "eaa25882a7b60612dc09eccbbbc5f7cb0580b1f1d538ca6c621e589393882b6e",
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
    hash: "5400f4a492186ea0631eb0231b8c7fedca8890d6fed1d06de6a65bcfa9e7a126",
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
    hash: "a9be60bd2aca3069b54f2f60afb8e950ce37190ba22ca8d2b006b0bbfb267673",
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
    hash: "b12bdc3418944b646280c265c89f72c56b28d3d0c7179894af4be3fb4d7d0a10",
};
