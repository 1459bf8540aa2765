// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/xsph.compute.
//! Kernels of `forces/xsph.compute`.

use super::{ForceParams, ListHead, PrecisionKeyword, SmoothingKernelParams, StepParams, Velocity};
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
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "forces", slot: 7, kind: BindingKind::Uniform { bytes: 16 } },
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
    hash: "3d3137c7235a784376d362db360e5719f21d0b41bb3ebe357106d7d81035f19c",
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
    hash: "1c2537bf2d7b105edd2527eb35b7c4dbd93e6a1b7b61e5a4715330ac846b221e",
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
    hash: "246727f7cc0b3b93be3dcec2cb608147722557678248ea359995f01de02ab373",
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
    hash: "035ef1837d9175512db1c5cd11c2a6d3bb2e86f4aa02fb80b5628136147f4317",
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
    hash: "eeced6ce57f027db7913a8951759549341d736308d67ca067479f2c5a89409b4",
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
    hash: "5a652bca69678451b899ef612570565e8c012f08883d81456a1f059859744a4c",
};
