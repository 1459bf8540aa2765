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
    hash: "fb9f70091ac2a4e8a5ec2911ec84e93102619797c380d2968cb478d17eb7636e",
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
    hash: "9b61373678709bdec3d53d13ca15806a9d0628811db2118e1792389cfb25bd42",
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
    hash: "dc2186f750ae87981a6ed9e7c442ec57f239866fe2289a6d8b2243f6946414a3",
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
    hash: "fcb1a5f98eaed6d4464309219dce398c937ce73d42c3213ec5165933b1623577",
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
    hash: "6ed85768dbed71e5eab9b825cd98e632929034bd555e1593aa3b30ba911557e1",
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
    hash: "69977e6f81be6efbbf5ba4c4e34e3b9f845e99956178e5900f2eb849a1abac82",
};
