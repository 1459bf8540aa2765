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
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
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
                ("quantized_positions", Some(self.quantized_positions.id)),
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
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
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
    hash: "a77356a83701c8693671205c9cfa34eed3b3f0765ec3f04fb935e03793054e70",
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
    hash: "58549c580cb1504990bf400b71ceab5f16722f3430018a4c79b7854e1d53c6ce",
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
    hash: "de28e245e917a3777bed6c902c4fc5920a0aaa0b33e03ae7c34b118bfc31b1b6",
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
    hash: "9354ddc28aed46750aac6bcd32da079ed62f9e2c311bf16e4bd15f923b680c1a",
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
    hash: "bdd8084df0fcbcbb42e353c0be86eca36d885f828993eb9bee1a35896c54687d",
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
    hash: "d6e7fd3d12f0aa8d5bfa13240f4f21699b3532264a6535a1973e0773458abbdf",
};
