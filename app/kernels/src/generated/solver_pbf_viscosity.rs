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
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
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
    hash: "7133c678d92e68ef8efa4bd9b9c42a638bb12f3b6be34802cbdd625333c67d70",
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
    hash: "f17c97d650469e843fcfc4503c5dc53b2a278fb809661d71c13d1bbcf66153f0",
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
    hash: "0885f5bd2feba900618ed0dc4fa9a116bc9e6a864facb01322a52690c8423b09",
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
    hash: "69865a9a9a964e1b1915e3e94fc33174cd726fd2163e634505195b8469a0c020",
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
    hash: "f32c4e436aaf1a080a681b4b8887916ffae85d5f08d67f9042bc41d5fb44c142",
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
    hash: "976f2e490646861730f1449de6447362c560a69b458c123cd8c85fedead4996b",
};
