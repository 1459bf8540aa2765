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
    hash: "4a2b9c97e67ad49d779c1dd7804907a8ca8f20eb75cc50d3dbd38d441dcd7641",
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
    hash: "7e0e934feac6aca1dd6b9a60f7b40da6f773b2671407128f8e14d0560a5fef5b",
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
    hash: "d32ae7b03adb0e27569e439ff5bdcec40f96ae8cb409fc466a9851b3bb181b64",
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
    hash: "7e1b75e7ac1891dc30d13680ee9ffee7fa7a8efee7759a1c53ab2a727f99d304",
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
    hash: "0916d1efdaa30a687d37168faafa30d55e49b3ab214290933e4a08e597ffcd1f",
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
    hash: "93e8b778f016d6e114be45b63e74f3d6ff3232f41b5e6288202d8f052da14c5e",
};
