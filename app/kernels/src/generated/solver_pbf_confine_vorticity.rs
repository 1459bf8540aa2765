// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/confine_vorticity.compute.
//! Kernels of `solver/pbf/confine_vorticity.compute`.

use super::{ListHead, PbfParams, PrecisionKeyword, StepParams, Velocity, Vorticity};
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
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
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
                ("list_heads", Some(self.list_heads.id)),
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
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
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
    hash: "e39a7700b8ce3d74e48aa1eab7db17d7b63fa4d15d70b95c7646ec11436154b6",
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
    hash: "472028b141ac22496b2523eaf0f13fcffb6b5aeb15c43662844cbb539ebc6dc1",
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
    hash: "3c3ec5ff27c06228a75af936312ae4825ff01502032a6d81679af42fbd42ad04",
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
    hash: "a198687d8e5736bc86db08606a8715bcf858bab1ce67b14cee0aa34a2a0a3c2d",
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
    hash: "f3267aafb232f0352ef002b5ea97025c7a1c2c00149046b4ce15ad1a4e3017b3",
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
    hash: "ad1def7c03c99b2a95fe3849292506391ad7fc128d9703c2c3b37a0e0d153875",
};
