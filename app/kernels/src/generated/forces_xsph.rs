// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/xsph.compute.
//! Kernels of `forces/xsph.compute`.

use super::{ForceParams, ListHead, PrecisionKeyword, SmoothingKernelParams, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`Xsph`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct XsphVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// XSPH viscosity (Schechter & Bridson 2012; Macklin & Muller 2013, eq. 17): each velocity moves
/// towards its neighbours' mean. Bounded for any coefficient up to 1, whatever dt is.
#[derive(Debug)]
pub struct Xsph<'a> {
    /// Its variant.
    pub variant: XsphVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Velocity> smoothed_velocities`.
    pub smoothed_velocities: BufMut<'a, Velocity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<ForceParams> forces`.
    pub forces: Uniform<'a, ForceParams>,
}

impl Kernel for Xsph<'_> {
    const STAGE: &'static str = "xsph";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.precision {
            PrecisionKeyword::Off => &XSPH,
            PrecisionKeyword::RelaxedPrecision => &XSPH_WITH_RELAXED_PRECISION,
            PrecisionKeyword::HalfPrecision => &XSPH_WITH_HALF_PRECISION,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("smoothed_velocities", Some(self.smoothed_velocities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("forces", Some(self.forces.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&XSPH, &XSPH_WITH_RELAXED_PRECISION, &XSPH_WITH_HALF_PRECISION];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "smoothed_velocities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "forces", slot: 8, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/forces_xsph.deflate"));

static XSPH: Module = Module {
    name: "Xsph",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8524 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/xsph.compute",
    hash: "bbcae845399a83fd87fdab4eb63148119de098dd1d651f3c26c1d87db9a53621",
};

static XSPH_WITH_RELAXED_PRECISION: Module = Module {
    name: "Xsph+RELAXED_PRECISION",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8524, bytes: 8532 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/xsph.compute",
    hash: "735cbb0df92eceea983e7919d3c74bcb08e569d265a3749bfcfbe0399749a212",
};

static XSPH_WITH_HALF_PRECISION: Module = Module {
    name: "Xsph+HALF_PRECISION",
    entry: "Xsph",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 17056, bytes: 8468 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "forces/xsph.compute",
    hash: "e9975928ad24572e60fbf97349df3cb557ae3a68bcdf8f3b219dacdb088dd569",
};
