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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 7384 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 4096,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "b791df255c20ddc9bd195e8bd72dea9b5ee08f021995ddf8c5a69ba227deb504",
};

static MEASURE_PARTICLES_WITH_DENSITY: Module = Module {
    name: "MeasureParticles+DENSITY",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 7384, bytes: 12472 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "3831343dff45eedcd69ec6ed63e5b5e2e8788011fd06a588f7f55ef7dc1af2bd",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+DENSITY+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 19856, bytes: 12912 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "93b42182dcf7616d90a0fe50719f9c4794934cf4372c86da0c679a14fe3568b5",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS: Module = Module {
    name: "MeasureParticles+DENSITY+WALLS",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 32768, bytes: 13908 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "34d3a6d5a2748c665f54e6fb1a83cb2849712a9dfbe316cbaa1e3130ebb086d2",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+DENSITY+WALLS+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 46676, bytes: 14332 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "986640ffa0e55713dc0332179da48a458049e8684d7c43b9aa11a049f6a960b4",
};
