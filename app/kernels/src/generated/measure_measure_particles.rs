// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/measure_particles.compute.
//! Kernels of `measure/measure_particles.compute`.

use super::{ListHead, MeasureSums, Position, SmoothingKernelParams, StepParams, StepState, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`MeasureParticles`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct MeasureParticlesVariant {
    /// Keyword `DENSITY`.
    pub density: bool,
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Energy and position of every particle, and with DENSITY, where particles have neighbours, density error and
/// compression, summed a group. Percentiles
/// come from histograms whose bins grow with the value: 32 to an octave, so a percentile is known
/// within 3 % of itself. A group fills histograms of its own and adds their bins once: in fluid at rest most
/// particles fall into one bin, and an atomic for each of them in global memory would wait for all others.
#[derive(Debug)]
pub struct MeasureParticles<'a> {
    /// Its variant.
    pub variant: MeasureParticlesVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// `RWStructuredBuffer<MeasureSums> group_measures`.
    pub group_measures: BufMut<'a, MeasureSums>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Option<Buf<'a, [u32; 2]>>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Option<Buf<'a, ListHead>>,
    /// `RWStructuredBuffer<uint> histograms`.
    pub histograms: Option<BufMut<'a, u32>>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Option<Uniform<'a, SmoothingKernelParams>>,
}

impl Kernel for MeasureParticles<'_> {
    const STAGE: &'static str = "measure_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.density, self.variant.walls, self.variant.periodic) {
            (false, false, false) => &MEASURE_PARTICLES,
            (false, false, true) => &MEASURE_PARTICLES,
            (false, true, false) => &MEASURE_PARTICLES,
            (false, true, true) => &MEASURE_PARTICLES,
            (true, false, false) => &MEASURE_PARTICLES_WITH_DENSITY,
            (true, false, true) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_PERIODIC,
            (true, true, false) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS,
            (true, true, true) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("group_measures", Some(self.group_measures.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("neighbours", self.neighbours.as_ref().map(|bound| bound.id)),
                ("list_heads", self.list_heads.as_ref().map(|bound| bound.id)),
                ("histograms", self.histograms.as_ref().map(|bound| bound.id)),
                ("kernel", self.kernel.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &MEASURE_PARTICLES,
    &MEASURE_PARTICLES_WITH_DENSITY,
    &MEASURE_PARTICLES_WITH_DENSITY_WITH_PERIODIC,
    &MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS,
    &MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS_WITH_PERIODIC,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "group_measures",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "group_measures",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo {
        name: "histograms",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/measure_measure_particles.deflate"));

static MEASURE_PARTICLES: Module = Module {
    name: "MeasureParticles",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7380 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 4096,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "71197929804df967ec1f075a175a3fd776d3fedd420d5f01ec278e27456b8faf",
};

static MEASURE_PARTICLES_WITH_DENSITY: Module = Module {
    name: "MeasureParticles+DENSITY",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7380, bytes: 12468 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "c5bb214d3529ec01a70b18ba88d8417cb004de20dbb4a4d29dce2e0008c32701",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+DENSITY+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19848, bytes: 12908 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "7fd064ff67fde9dbc20a8af86d0d1c652da3bb48031487ebe2fc03a6211d1261",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS: Module = Module {
    name: "MeasureParticles+DENSITY+WALLS",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 32756, bytes: 14836 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "e8055f7eab1eaacecb6729affb1d78d586ccb70e0a2f8873baac248295a2a59b",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+DENSITY+WALLS+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47592, bytes: 15008 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "49295764559db0f6471461f2d607fcb07f3c2fc609937450f868441f37a5f20a",
};
