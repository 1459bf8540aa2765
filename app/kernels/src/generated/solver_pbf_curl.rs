// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/pbf/curl.compute.
//! Kernels of `solver/pbf/curl.compute`.

use super::{KernelParams, PrecisionKeyword, StepParams, Velocity, Vorticity};
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
    /// `StructuredBuffer<uint4> neighbours`.
    pub neighbours: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> neighbour_counts`.
    pub neighbour_counts: Buf<'a, u32>,
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
                ("neighbour_counts", Some(self.neighbour_counts.id)),
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
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "neighbour_counts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "vorticities",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 16 } },
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
    hash: "1eeaa88289f19b39f877bb2c1c689c258151cdc5e86414a312180ff3a12402de",
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
    hash: "96ef35d0bb2e24beafafcf802bd1ed7f129ac09ac765ba86c134e6b343fa9a29",
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
    hash: "da9aea174f8ea9a5a0a6906902929c20ecf14bb4039a31a589e917ebfa1d93f0",
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
    hash: "a1984a8631abd13ca0e60450a7ce99c7620229f1be513ab1970fb71d51ce765e",
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
    hash: "4b6545bd76db88c73141468bd6f3dee899630d838e618292e960d1ca1c0a7a6b",
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
    hash: "d9d3e8186a5170b258a54896e9c0119bcaa77e4668e8810d76bb452110f9c39c",
};
