// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/viscosity.compute.
//! Kernels of `solver/pbf/viscosity.compute`.

use super::{ListHead, PbfParams, PrecisionKeyword, SmoothingKernelParams, StepParams, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`Viscosity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ViscosityVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// XSPH viscosity (Schechter & Bridson 2012; Macklin & Muller 2013, eq. 17): each velocity moves
/// towards its neighbours' mean. Bounded for any coefficient up to 1, whatever dt is.
#[derive(Debug)]
pub struct Viscosity<'a> {
    /// Its variant.
    pub variant: ViscosityVariant,
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
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
}

impl Kernel for Viscosity<'_> {
    const STAGE: &'static str = "viscosity";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.precision, self.variant.packed) {
            (PrecisionKeyword::Off, false) => &VISCOSITY,
            (PrecisionKeyword::Off, true) => &VISCOSITY_WITH_PACKED,
            (PrecisionKeyword::RelaxedPrecision, false) => &VISCOSITY_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::RelaxedPrecision, true) => &VISCOSITY_WITH_RELAXED_PRECISION_WITH_PACKED,
            (PrecisionKeyword::HalfPrecision, false) => &VISCOSITY_WITH_HALF_PRECISION,
            (PrecisionKeyword::HalfPrecision, true) => &VISCOSITY_WITH_HALF_PRECISION_WITH_PACKED,
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
                ("pbf", Some(self.pbf.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &VISCOSITY,
    &VISCOSITY_WITH_PACKED,
    &VISCOSITY_WITH_RELAXED_PRECISION,
    &VISCOSITY_WITH_RELAXED_PRECISION_WITH_PACKED,
    &VISCOSITY_WITH_HALF_PRECISION,
    &VISCOSITY_WITH_HALF_PRECISION_WITH_PACKED,
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
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static VISCOSITY: Module = Module {
    name: "Viscosity",
    entry: "Viscosity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/viscosity.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/viscosity.compute",
    hash: "2643921dcb5b881f89e031931b0bbb6bedae2a22ab8e889cf1148b23029e059f",
};

static VISCOSITY_WITH_PACKED: Module = Module {
    name: "Viscosity+PACKED",
    entry: "Viscosity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/viscosity+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/viscosity.compute",
    hash: "3e85e76d9e46ffb17cc44bf7304f6c93a231e91b441abbd3a78915c165ba3c64",
};

static VISCOSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "Viscosity+RELAXED_PRECISION",
    entry: "Viscosity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/viscosity+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/viscosity.compute",
    hash: "cc9ec613369fc4e0675472d1648a7e373d3abf25992fb105a9b71d69e097e59b",
};

static VISCOSITY_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "Viscosity+RELAXED_PRECISION+PACKED",
    entry: "Viscosity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/viscosity+relaxed_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/viscosity.compute",
    hash: "0e97111d6df107f14816b4d13fb36a0f18181c1992cd6054e1007b67479b6e30",
};

static VISCOSITY_WITH_HALF_PRECISION: Module = Module {
    name: "Viscosity+HALF_PRECISION",
    entry: "Viscosity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/viscosity+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/viscosity.compute",
    hash: "dec38cb628ac399f7021d952af067314d50a680e93d129da92402ae2bb81b858",
};

static VISCOSITY_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "Viscosity+HALF_PRECISION+PACKED",
    entry: "Viscosity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/viscosity+half_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/viscosity.compute",
    hash: "b7110e60d9a7acc0aaabc71d3fc7b3fbfdba13e2427411b587931824d72eb8d6",
};
