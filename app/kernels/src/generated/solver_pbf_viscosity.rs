// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/viscosity.compute.
//! Kernels of `solver/pbf/viscosity.compute`.

use super::{KernelParams, ListHead, PbfParams, PrecisionKeyword, StepParams, Velocity};
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
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
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
    /// `ConstantBuffer<KernelParams> kernel`.
    pub kernel: Uniform<'a, KernelParams>,
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
                ("places", Some(self.places.id)),
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
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
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
    hash: "2cc9ac242480b09123c66dab36222fdf8cf93e715dd31048c54ee615927a0872",
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
    hash: "677f4929d833cb8969d476a38cfafa56a75140bc3cb183cdc30020b75982e50a",
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
    hash: "f5ced068638c5d49a36ea6d84e10a5ef6926c1e28ee08989a81c64f15e820d02",
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
    hash: "ccd4850187642c90602210b5a8bac757fd4ec0bf9b49765874e1ddd0ddfa1692",
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
    hash: "2be95680d63a01825f4803248c216123ea322365d13863ab0c43f123030b2fa5",
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
    hash: "0e7d9819c1d8b36b1810677c1ef0078f7ccc5dbf9985fd9ffc982ab0520dab1d",
};
