// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/measure_particles.compute.
//! Kernels of `measure/measure_particles.compute`.

use super::{ListHead, MeasureSums, Position, SmoothingKernelParams, StepParams, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`MeasureParticles`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct MeasureParticlesVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Density error, compression, energy and place of every particle, summed a group. Percentiles
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
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<MeasureSums> group_measures`.
    pub group_measures: BufMut<'a, MeasureSums>,
    /// `RWStructuredBuffer<uint> histograms`.
    pub histograms: BufMut<'a, u32>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for MeasureParticles<'_> {
    const STAGE: &'static str = "measure_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (false, false) => &MEASURE_PARTICLES,
            (false, true) => &MEASURE_PARTICLES_WITH_PERIODIC,
            (true, false) => &MEASURE_PARTICLES_WITH_WALLS,
            (true, true) => &MEASURE_PARTICLES_WITH_WALLS_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("group_measures", Some(self.group_measures.id)),
                ("histograms", Some(self.histograms.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &MEASURE_PARTICLES,
    &MEASURE_PARTICLES_WITH_PERIODIC,
    &MEASURE_PARTICLES_WITH_WALLS,
    &MEASURE_PARTICLES_WITH_WALLS_WITH_PERIODIC,
];

static BINDINGS_0: &[BindingInfo] = &[
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
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
];

static MEASURE_PARTICLES: Module = Module {
    name: "MeasureParticles",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/measure_particles.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "63b1363fc4efa0c244b4763668a2440fd7d438fe9c03075fa8bf2da8782ca4bc",
};

static MEASURE_PARTICLES_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/measure_particles+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "63966af78a24d09a4bd3c20403b654ad16d25f7d0ae5d12ed63fec5d68fcb2a0",
};

static MEASURE_PARTICLES_WITH_WALLS: Module = Module {
    name: "MeasureParticles+WALLS",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/measure_particles+walls.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "87204ade48595b53f8bcb5bac529e3537e0f927dd19eed05ec1c4a5ea588a05f",
};

static MEASURE_PARTICLES_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+WALLS+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/measure_particles+walls+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "0bfe5a939e424137dbbf2147ca931c3603af816ede52dab3c5b46d7dc6d91784",
};
