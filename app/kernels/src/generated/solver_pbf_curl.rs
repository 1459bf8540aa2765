// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/curl.compute.
//! Kernels of `solver/pbf/curl.compute`.

use super::{KernelParams, ListHead, PrecisionKeyword, StepParams, Velocity, Vorticity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`Curl`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CurlVariant {
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
    /// Keyword `PACKED`.
    pub packed: bool,
}

/// Curl of the velocity field (Monaghan 1992; Macklin & Muller 2013, eq. 15).
#[derive(Debug)]
pub struct Curl<'a> {
    /// Its variant.
    pub variant: CurlVariant,
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Vorticity> vorticities`.
    pub vorticities: BufMut<'a, Vorticity>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<KernelParams> kernel`.
    pub kernel: Uniform<'a, KernelParams>,
}

impl Kernel for Curl<'_> {
    const STAGE: &'static str = "curl";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.precision, self.variant.packed) {
            (PrecisionKeyword::Off, false) => &CURL,
            (PrecisionKeyword::Off, true) => &CURL_WITH_PACKED,
            (PrecisionKeyword::RelaxedPrecision, false) => &CURL_WITH_RELAXED_PRECISION,
            (PrecisionKeyword::RelaxedPrecision, true) => &CURL_WITH_RELAXED_PRECISION_WITH_PACKED,
            (PrecisionKeyword::HalfPrecision, false) => &CURL_WITH_HALF_PRECISION,
            (PrecisionKeyword::HalfPrecision, true) => &CURL_WITH_HALF_PRECISION_WITH_PACKED,
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
                ("vorticities", Some(self.vorticities.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CURL,
    &CURL_WITH_PACKED,
    &CURL_WITH_RELAXED_PRECISION,
    &CURL_WITH_RELAXED_PRECISION_WITH_PACKED,
    &CURL_WITH_HALF_PRECISION,
    &CURL_WITH_HALF_PRECISION_WITH_PACKED,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "vorticities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
];

static CURL: Module = Module {
    name: "Curl",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/curl.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/curl.compute",
    hash: "e0f406bfa53b9579fb1821c96a590b8328e11f9e95a7c602c29db3b457e1a460",
};

static CURL_WITH_PACKED: Module = Module {
    name: "Curl+PACKED",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/curl+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/curl.compute",
    hash: "ffbbd1b6328478869a8f8bdada886bc3809f9ae9151b18171c066aaaf69108e9",
};

static CURL_WITH_RELAXED_PRECISION: Module = Module {
    name: "Curl+RELAXED_PRECISION",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/curl+relaxed_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/curl.compute",
    hash: "f9defc90f4363b441b17cbee9b85633e780932116f0d3b585ea2146c24218bf0",
};

static CURL_WITH_RELAXED_PRECISION_WITH_PACKED: Module = Module {
    name: "Curl+RELAXED_PRECISION+PACKED",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/curl+relaxed_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/pbf/curl.compute",
    hash: "3f738657dd9972a78cc2b407cc0e5fa732a42937442211fd9bf45f3949ab9234",
};

static CURL_WITH_HALF_PRECISION: Module = Module {
    name: "Curl+HALF_PRECISION",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/curl+half_precision.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/curl.compute",
    hash: "2bf1da91134dbc1e08d0620d73543ea65308d88de6f017b23657ebe98da07df0",
};

static CURL_WITH_HALF_PRECISION_WITH_PACKED: Module = Module {
    name: "Curl+HALF_PRECISION+PACKED",
    entry: "Curl",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/curl+half_precision+packed.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/pbf/curl.compute",
    hash: "091199fe4306b4539b45be96d62fcff1444277852832c5d5f343bda3aaf1f692",
};
