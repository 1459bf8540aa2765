// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/confine_vorticity.compute.
//! Kernels of `forces/confine_vorticity.compute`.

use super::{ForceParams, ListHead, PrecisionKeyword, StepParams, StepState, Velocity, Vorticity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ConfineVorticity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConfineVorticityVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
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
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<ForceParams> forces`.
    pub forces: Uniform<'a, ForceParams>,
}

impl Kernel for ConfineVorticity<'_> {
    const STAGE: &'static str = "confine_vorticity";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.precision {
            PrecisionKeyword::Off => &CONFINE_VORTICITY,
            PrecisionKeyword::RelaxedPrecision => &CONFINE_VORTICITY_WITH_RELAXED_PRECISION,
            PrecisionKeyword::HalfPrecision => &CONFINE_VORTICITY_WITH_HALF_PRECISION,
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
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("forces", Some(self.forces.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] =
    &[&CONFINE_VORTICITY, &CONFINE_VORTICITY_WITH_RELAXED_PRECISION, &CONFINE_VORTICITY_WITH_HALF_PRECISION];

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
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "forces", slot: 7, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/forces_confine_vorticity.deflate"));

static CONFINE_VORTICITY: Module = Module {
    name: "ConfineVorticity",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8188 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/confine_vorticity.compute",
    hash: "66e5d95d99338a00801705cc4e0b3950f54c73a470e24618f47ab75482cbc155",
};

static CONFINE_VORTICITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConfineVorticity+RELAXED_PRECISION",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8188, bytes: 8052 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/confine_vorticity.compute",
    hash: "3cd618a3644a70be1980fee381a795d354363764267355efe16603b8c084a8c0",
};

static CONFINE_VORTICITY_WITH_HALF_PRECISION: Module = Module {
    name: "ConfineVorticity+HALF_PRECISION",
    entry: "ConfineVorticity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 16240, bytes: 8132 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "forces/confine_vorticity.compute",
    hash: "a84fdbfec289ad608789ebea9251a5bf632e6508f3137e48771f0c678c1bf2bb",
};
