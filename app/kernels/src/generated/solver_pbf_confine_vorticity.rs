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
    hash: "50172e891808389f992a24c245585aec2efec96aafc8e5968624a31cde5b537d",
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
    hash: "ecde5e7a2fa6c0451515f675bcd73ed8db824bcfebf6dd05885bf29880a08342",
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
    hash: "2f4d7ad64033c91e52542b9e910e8268754cc78db190a4e61b11e3dc3f9d582c",
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
    hash: "181d9c52d9fb3c32ecde29c1ec7ab4ffaa33cf4fd84725740647c449e2dce29b",
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
    hash: "361423f84dcf73f747bb90673414b2ba45afebf9ba0c66af6dac16079e420fe0",
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
    hash: "a7c23a98e0bf9234d264632bcd7908e9d4ff985215caed9c92c8e6719132ab55",
};
