// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from forces/curl.compute.
//! Kernels of `forces/curl.compute`.

use super::{ListHead, PrecisionKeyword, SmoothingKernelParams, StepParams, StepState, Velocity, Vorticity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`Curl`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CurlVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Curl of the velocity field (Monaghan 1992; Macklin & Muller 2013, eq. 15).
#[derive(Debug)]
pub struct Curl<'a> {
    /// Its variant.
    pub variant: CurlVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Vorticity> vorticities`.
    pub vorticities: BufMut<'a, Vorticity>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for Curl<'_> {
    const STAGE: &'static str = "curl";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match self.variant.precision {
            PrecisionKeyword::Off => &CURL,
            PrecisionKeyword::RelaxedPrecision => &CURL_WITH_RELAXED_PRECISION,
            PrecisionKeyword::HalfPrecision => &CURL_WITH_HALF_PRECISION,
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
                ("vorticities", Some(self.vorticities.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&CURL, &CURL_WITH_RELAXED_PRECISION, &CURL_WITH_HALF_PRECISION];

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
        name: "vorticities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/forces_curl.deflate"));

static CURL: Module = Module {
    name: "Curl",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8204 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/curl.compute",
    hash: "2eb4f1ab1c3ad640d6fa50361b7f4bc05b0fe4c71d32706ffc00946157044c36",
};

static CURL_WITH_RELAXED_PRECISION: Module = Module {
    name: "Curl+RELAXED_PRECISION",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8204, bytes: 8068 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "forces/curl.compute",
    hash: "dadc5a1a3ef7cb151333f7e0a888c70455bc71e1ddaf4361347523cca33264fa",
};

static CURL_WITH_HALF_PRECISION: Module = Module {
    name: "Curl+HALF_PRECISION",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 16272, bytes: 8148 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "forces/curl.compute",
    hash: "a6fa522f6e37ffdded12f8a2aaa54459dd120a354e3b5ede6b5925b5399928c6",
};
