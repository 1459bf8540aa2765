// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/compute_density.compute.
//! Kernels of `solver/sph/compute_density.compute`.

use super::{
    ListHead, Position, PrecisionKeyword, SmoothingKernelParams, SphKernels, SphParams, StepParams, StepState,
    Velocity, VelocityPressure, VelocityPressureNormal,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ComputeDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ComputeDensityVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `CHOSEN_KERNELS`.
    pub chosen_kernels: bool,
    /// Keyword `SURFACE_TENSION`.
    pub surface_tension: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Density and pressure of each particle (Muller, Charypar & Gross 2003, eq. 3 and 12; Becker & Teschner 2007, eq. 7), and
/// with SURFACE\_TENSION the gradient of the colour field (Muller et al., eq. 15) with the rest volume of each neighbour.
#[derive(Debug)]
pub struct ComputeDensity<'a> {
    /// Its variant.
    pub variant: ComputeDensityVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> sorted_velocities`.
    pub sorted_velocities: Buf<'a, Velocity>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Position> positions`.
    pub positions: BufMut<'a, Position>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<VelocityPressure> velocity_pressures`.
    pub velocity_pressures: Option<BufMut<'a, VelocityPressure>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SphKernels> kernels`.
    pub kernels: Uniform<'a, SphKernels>,
    /// `ConstantBuffer<SphParams> sph`.
    pub sph: Uniform<'a, SphParams>,
    /// `RWStructuredBuffer<VelocityPressureNormal> velocity_pressure_normals`.
    pub velocity_pressure_normals: Option<BufMut<'a, VelocityPressureNormal>>,
    /// `ConstantBuffer<SmoothingKernelParams> density_walls`.
    pub density_walls: Option<Uniform<'a, SmoothingKernelParams>>,
}

impl Kernel for ComputeDensity<'_> {
    const STAGE: &'static str = "compute_density";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.chosen_kernels, self.variant.surface_tension, self.variant.precision) {
            (false, false, false, PrecisionKeyword::Off) => &COMPUTE_DENSITY,
            (false, false, false, PrecisionKeyword::RelaxedPrecision) => &COMPUTE_DENSITY_WITH_RELAXED_PRECISION,
            (false, false, false, PrecisionKeyword::HalfPrecision) => &COMPUTE_DENSITY_WITH_HALF_PRECISION,
            (false, false, true, PrecisionKeyword::Off) => &COMPUTE_DENSITY_WITH_SURFACE_TENSION,
            (false, false, true, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (false, false, true, PrecisionKeyword::HalfPrecision) => {
                &COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
            (false, true, false, PrecisionKeyword::Off) => &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS,
            (false, true, false, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION
            }
            (false, true, false, PrecisionKeyword::HalfPrecision) => {
                &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION
            }
            (false, true, true, PrecisionKeyword::Off) => &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION,
            (false, true, true, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (false, true, true, PrecisionKeyword::HalfPrecision) => {
                &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
            (true, false, false, PrecisionKeyword::Off) => &COMPUTE_DENSITY_WITH_WALLS,
            (true, false, false, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION
            }
            (true, false, false, PrecisionKeyword::HalfPrecision) => &COMPUTE_DENSITY_WITH_WALLS_WITH_HALF_PRECISION,
            (true, false, true, PrecisionKeyword::Off) => &COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION,
            (true, false, true, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (true, false, true, PrecisionKeyword::HalfPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
            (true, true, false, PrecisionKeyword::Off) => &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS,
            (true, true, false, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION
            }
            (true, true, false, PrecisionKeyword::HalfPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION
            }
            (true, true, true, PrecisionKeyword::Off) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION
            }
            (true, true, true, PrecisionKeyword::RelaxedPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (true, true, true, PrecisionKeyword::HalfPrecision) => {
                &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("sorted_velocities", Some(self.sorted_velocities.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("velocity_pressures", self.velocity_pressures.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernels", Some(self.kernels.id)),
                ("sph", Some(self.sph.id)),
                ("velocity_pressure_normals", self.velocity_pressure_normals.as_ref().map(|bound| bound.id)),
                ("density_walls", self.density_walls.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &COMPUTE_DENSITY,
    &COMPUTE_DENSITY_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_SURFACE_TENSION,
    &COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS,
    &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION,
    &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocity_pressures",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernels", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocity_pressure_normals",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernels", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocity_pressures",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "density_walls", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernels", slot: 11, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_velocities",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocities",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "velocity_pressure_normals",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "density_walls", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernels", slot: 11, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_compute_density.deflate"));

static COMPUTE_DENSITY: Module = Module {
    name: "ComputeDensity",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10376 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "69fec3e9e63873f21c0f15d7488394b292fc2b45c17b767ad7a948775dbeb38b",
};

static COMPUTE_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10376, bytes: 9968 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "69451fa2619e87ef7c2ea5d23c2adf2ae8f08d8b20db241d9403020623796013",
};

static COMPUTE_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20344, bytes: 9904 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "eaa14b772e55442c14ace07c3a9b6642f86bbe71c150ef44597346aa3f726ce1",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30248, bytes: 11072 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "0edc31a2555488ae08ef1acb1b59bfbcc5655150732dcd5d06575921a4deeb00",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 41320, bytes: 10712 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "ba5c7536df9cc7b3c81c9ae8de7aaefe3ffeb38d891757f0e85d9fd1692821a8",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 52032, bytes: 10664 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "d408e6cf8a3059148a022c5a72cbd7312cdf0b4370e6be50086f1d40cb05050d",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 62696, bytes: 11436 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "fe7a5af8ab3fb7dc2b9aa94fba580da9c61981ca416ace6d5b106efe6d77d4c2",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 74132, bytes: 10788 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "23fd8d5ffff72170c6ff92c85807f2af3cdb6dadbf12cd135ad6052318fb5248",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 84920, bytes: 10788 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "1ebcec1b3477879d04115a32e930e809a65598e5d8941116733c1aa034caecc1",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 95708, bytes: 13460 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "188b82369594d78af3154664394a0c5ed8f0e844438c63cc7705cbffcd1a1e11",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 109168, bytes: 12812 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "83061279d526935dbc39034d705fccc2569de6d6655f5079cd4cb326b556bf8d",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 121980, bytes: 12812 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "c544d980ecc231e84a4a4690fce6fcb60d799afcd073eeb80e2f0881500b5bc2",
};

static COMPUTE_DENSITY_WITH_WALLS: Module = Module {
    name: "ComputeDensity+WALLS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 134792, bytes: 12480 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "ca409ccbf09965559343353d2539815f2aad9d257d4eeab99ad92c1b190df3c5",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 147272, bytes: 12072 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "01b3de69d6a61e52741f15a430660d6ac15bb8933c068651f121302c7b0024be",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 159344, bytes: 12008 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "b3e75a679f57357bc87204244f7a5f065daedfbefdf30bedde5cf608a165cc0e",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 171352, bytes: 13948 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "b86bc599b1c9219fc6f4a22525c4acff9f13fd9e032de328b01c67fcffd126b1",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 185300, bytes: 13588 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "58878796968cb39f9f553f0162c88805624a1f12a29fd1f8c9ab057960b2aab5",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 198888, bytes: 13556 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "899c4c4695a3df8a58d94b6c66b319c4437df2da978d3e8e2e098fd7fe1045a9",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 212444, bytes: 13524 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "c3c416be367ebe433de6321b5cba006f834065ecb6aa6ec3e8831687ff3993e5",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 225968, bytes: 12876 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "fcfb8c19539202b44504b5923155bf799714488bbace111004143c9758546f6b",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 238844, bytes: 12876 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "58ad78e29824da66c03c02bca60095cb1e44036109d3093e9b184a0b65c5bb36",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 251720, bytes: 16304 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "5f6fb979950e3e36f69a5ee73322226813e3c2f7a790283074732d2fcd259af1",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 268024, bytes: 15656 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "a282545c870f050d6a6e79c52add57492675330270778b876cfb3f372a57e4ab",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 283680, bytes: 15656 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "779570fdc1fd892c3364d25d37b794221ea77b413bb81d42d51ebf91103eae08",
};
