// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/confine_vorticity.compute.
//! Kernels of `forces/confine_vorticity.compute`.

use super::{ForceParams, ListHead, PrecisionKeyword, StepParams, Velocity, Vorticity};
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
    /// `ConstantBuffer<ForceParams> forces`.
    pub forces: Uniform<'a, ForceParams>,
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
                ("forces", Some(self.forces.id)),
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
    BindingInfo { name: "forces", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
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
    source: "forces/confine_vorticity.compute",
    hash: "bdc96c8a17473d146b4d08d339109c0a8dd553f2be6a4676ae7698d6a6d98389",
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
    source: "forces/confine_vorticity.compute",
    hash: "fb62dffc01b8bd40b2895f3da9d74e0a819b113b174d2aabae1eb190e369cdbb",
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
    source: "forces/confine_vorticity.compute",
    hash: "f2a2825e413b6f8d8178691c35715b781fbe98dbf73c6e116fe5783e9aa609af",
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
    source: "forces/confine_vorticity.compute",
    hash: "cd7f2107816b73a44204cad85460233cd86506be50003b7a3a09307233b6c5bb",
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
    source: "forces/confine_vorticity.compute",
    hash: "2b7aeec01ea9543cfcb92d9b202c7050be739fbcf229b86efbcff96073fd6542",
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
    source: "forces/confine_vorticity.compute",
    hash: "6db20bfb165def1cdbccccf6bbce50b9263f2d9f1e74a6ff5007f6e82b9f553b",
};
