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
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
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
    hash: "9fac20e652fde076ff1c8ae23a35ff945891b2083156f7d8e77a64a904d0693a",
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
    hash: "198fdb161b28d662cd0e0bb5d057a6510b4e4f56065af2596c6b46adc3d5856b",
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
    hash: "9846bb94cd92ae06e4165a832d9c868b4eab4f2a774bac408f1855b808c6fd39",
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
    hash: "43374b43c96d67ff3fd36c2451f93e2c13762544585cded4a48022ce04612b32",
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
    hash: "07d3840f24ab5317eeead2452d0be45dfe88c4b3a97d57636f753022acce421f",
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
    hash: "44d7944ab9e3715f78b606ba1ab82de41a7892e830c75b1874e0a078e126ed9b",
};
