// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/viscosity.compute.
//! Kernels of `solver/pbf/viscosity.compute`.

use super::{KernelParams, PbfParams, PrecisionKeyword, StepParams, Velocity};
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
    /// `StructuredBuffer<uint4> neighbours`.
    pub neighbours: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> neighbour_counts`.
    pub neighbour_counts: Buf<'a, u32>,
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
                ("neighbour_counts", Some(self.neighbour_counts.id)),
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
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "smoothed_velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
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
    hash: "008bfba9899f83e7b2a970b3727938098e2a1d60c0ef9f762c3ada6081f82809",
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
    hash: "988d82b0ef3880abd25b9879821fe2ae2a6c67e91b977dbbf479f0a803586a1b",
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
    hash: "5903a240e52cd23998fc5cc264df10df734e40571cbabc99d84cda0948c5125f",
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
    hash: "8cb58116c3166266741fbcfe36e6b337871d62a1dae22e763251ffe01963093f",
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
    hash: "7757a3495132b09bff15a09101674115743fb67a9bfd07477aa7ac1d65f87838",
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
    hash: "2158c1cfaa906eb482bcc4cfe6b8e1ad6985babcb951190ce197f0660607049c",
};
