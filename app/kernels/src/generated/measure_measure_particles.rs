// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/measure_particles.compute.
//! Kernels of `measure/measure_particles.compute`.

use super::{
    ListHead, MeasureSums, Position, SmoothingKernelParams, SolidContact, StepParams, StepState, Velocity, WallsKeyword,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`MeasureParticles`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct MeasureParticlesVariant {
    /// Keyword `DENSITY`.
    pub density: bool,
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
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
    /// `StructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Option<Buf<'a, SolidContact>>,
}

impl Kernel for MeasureParticles<'_> {
    const STAGE: &'static str = "measure_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.density, self.variant.walls, self.variant.periodic) {
            (false, WallsKeyword::Off, false) => &MEASURE_PARTICLES,
            (false, WallsKeyword::Off, true) => &MEASURE_PARTICLES,
            (false, WallsKeyword::Walls, false) => &MEASURE_PARTICLES,
            (false, WallsKeyword::Walls, true) => &MEASURE_PARTICLES,
            (false, WallsKeyword::SolidWalls, false) => &MEASURE_PARTICLES,
            (false, WallsKeyword::SolidWalls, true) => &MEASURE_PARTICLES,
            (true, WallsKeyword::Off, false) => &MEASURE_PARTICLES_WITH_DENSITY,
            (true, WallsKeyword::Off, true) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_PERIODIC,
            (true, WallsKeyword::Walls, false) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS,
            (true, WallsKeyword::Walls, true) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_WALLS_WITH_PERIODIC,
            (true, WallsKeyword::SolidWalls, false) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_SOLID_WALLS,
            (true, WallsKeyword::SolidWalls, true) => &MEASURE_PARTICLES_WITH_DENSITY_WITH_SOLID_WALLS_WITH_PERIODIC,
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
                ("solid_contacts", self.solid_contacts.as_ref().map(|bound| bound.id)),
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
    &MEASURE_PARTICLES_WITH_DENSITY_WITH_SOLID_WALLS,
    &MEASURE_PARTICLES_WITH_DENSITY_WITH_SOLID_WALLS_WITH_PERIODIC,
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

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_contacts",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "group_measures",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo {
        name: "histograms",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
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
    hash: "20017cc55e201327bb4468a320ff5c04518a347fcdbd183f723c2c17142f29e5",
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
    hash: "56cd3359ce3ee45ed2328f3a12234a2e17a175ab619240142af101c798a04981",
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
    hash: "bbb9b4d0992c13bff49e0734b72c6f3db93443ec0046f79513e742e2e73b34bc",
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
    hash: "d3edda08eace06097c5dd34e2978829062a4e9a5b5c3008294941b3c4abbabdf",
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
    hash: "46a88704042ae9455b91ba7ca5a72a8a1811b3374b2e50e3e0308e4e1c698e28",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_SOLID_WALLS: Module = Module {
    name: "MeasureParticles+DENSITY+SOLID_WALLS",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 62600, bytes: 16944 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "b3e6c815e494fd28b35bb9577b92a515d5f3bd83f76afe4fbee68f287da16996",
};

static MEASURE_PARTICLES_WITH_DENSITY_WITH_SOLID_WALLS_WITH_PERIODIC: Module = Module {
    name: "MeasureParticles+DENSITY+SOLID_WALLS+PERIODIC",
    entry: "MeasureParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 79544, bytes: 17116 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 8192,
    tier: Tier::Floor,
    source: "measure/measure_particles.compute",
    hash: "bb29235441aadfd7e1b5ea7c11d99eebf974fa8d2589e72e0ff9310b660d4dda",
};
