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
    hash: "e6a7f4cf09cfd7fc0e147a821b4638e0bb62f67966232d27b238d0f557228cfe",
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
    hash: "c806fac3c296f55d5b0c027c0af9034e1275945458c61e79d86552a7ddd2700c",
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
    hash: "990591369f533c37c3385c1f6bd72964f4866e74c49a70a9967091f05e4c354d",
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
    hash: "be119bd1c35aa6008e3f99dce74d149365e84a314ef6afe0b4529af1cf27a9c3",
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
    hash: "3e0216b0854978dab042556a6196e89991f6685872ceec1024cf8832f30931a2",
};
