// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/confine_vorticity.compute.
//! Kernels of `solver/pbf/confine_vorticity.compute`.

use super::{PbfParams, PrecisionKeyword, StepParams, Velocity, Vorticity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`ConfineVorticity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConfineVorticityVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// Vorticity confinement (Fedkiw, Stam & Jensen 2001; Macklin & Muller 2013, eq. 16): gives back
/// the swirl that the solver damps, pushing along N x omega, N towards larger |omega|.
#[derive(Debug)]
pub struct ConfineVorticity<'a> {
    /// Its variant.
    pub variant: ConfineVorticityVariant,
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Vorticity> vorticities`.
    pub vorticities: Buf<'a, Vorticity>,
    /// `StructuredBuffer<uint4> neighbours`.
    pub neighbours: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> neighbour_counts`.
    pub neighbour_counts: Buf<'a, u32>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
}

impl Kernel for ConfineVorticity<'_> {
    const STAGE: &'static str = "confine_vorticity";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.precision, self.variant.packed) {
            (PrecisionKeyword::Off, false) => &CONFINE_VORTICITY,
            (PrecisionKeyword::Off, true) => &CONFINE_VORTICITY_WITH_PACKED,
            (PrecisionKeyword::RelaxedPrecision, false) => &CONFINE_VORTICITY_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::RelaxedPrecision, true) => &CONFINE_VORTICITY_WITH_RELAXED_PRECISION_WITH_PACKED,
            (PrecisionKeyword::HalfPrecision, false) => &CONFINE_VORTICITY_WITH_HALF_PRECISION,
            (PrecisionKeyword::HalfPrecision, true) => &CONFINE_VORTICITY_WITH_HALF_PRECISION_WITH_PACKED,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("places", Some(self.places.id)),
                ("vorticities", Some(self.vorticities.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("neighbour_counts", Some(self.neighbour_counts.id)),
                ("velocities", Some(self.velocities.id)),
                ("step_params", Some(self.step_params.id)),
                ("pbf", Some(self.pbf.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CONFINE_VORTICITY,
    &CONFINE_VORTICITY_WITH_PACKED,
    &CONFINE_VORTICITY_WITH_RELAXED_PRECISION,
    &CONFINE_VORTICITY_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CONFINE_VORTICITY_WITH_HALF_PRECISION,
    &CONFINE_VORTICITY_WITH_HALF_PRECISION_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "vorticities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
];

static CONFINE_VORTICITY: Module = Module {
    name: "ConfineVorticity",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/confine_vorticity.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/confine_vorticity.compute",
    hash: "760821c2d88d864b4227896bf999965869201dc059b8cd9275249513e2abd367",
};

static CONFINE_VORTICITY_WITH_PACKED: Module = Module {
    name: "ConfineVorticity+PACKED",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/confine_vorticity+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/confine_vorticity.compute",
    hash: "0da7c16d04521238c286fc49f20723550c2e780eebc6b3a9380dad51e1ed95b2",
};

static CONFINE_VORTICITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConfineVorticity+RELAXED_PRECISION",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/confine_vorticity+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/confine_vorticity.compute",
    hash: "2e9cf2a5b962639cacbd0fff1bc704a43b50c627916ca610f4c3ec19c6b218b0",
};

static CONFINE_VORTICITY_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "ConfineVorticity+RELAXED_PRECISION+PACKED",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/confine_vorticity+relaxed_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/confine_vorticity.compute",
    hash: "f9077bbed84705f56ea810229165e192f0bde871350e64f344592a771f856d41",
};

static CONFINE_VORTICITY_WITH_HALF_PRECISION: Module = Module {
    name: "ConfineVorticity+HALF_PRECISION",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/confine_vorticity+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/confine_vorticity.compute",
    hash: "4a534e9c5160ab7641b97158841bf318585ba61807dc85c52dd2ebb4922bc12e",
};

static CONFINE_VORTICITY_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "ConfineVorticity+HALF_PRECISION+PACKED",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/confine_vorticity+half_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/confine_vorticity.compute",
    hash: "15b7380d33f2fbc4cd599b4c22db19da237e67de79a98888649a7bd3f078e3c7",
};
