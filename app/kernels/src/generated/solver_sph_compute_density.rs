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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10476 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "cef1b13a0d5ec4a1cf51d7087b228f2a0551eef6a27f2f438a4b3e1598ac5a02",
};

static COMPUTE_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10476, bytes: 10484 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "f6948bc898fe0f03f0df2b5b7609fe6badc3048b5e3c9f6b673c1b88d0f3a9ca",
};

static COMPUTE_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20960, bytes: 10420 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "7829c33ee433f648c4d7f3ca40e30ed82566ebd7a86fe68e03c0939c313ae14c",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31380, bytes: 11172 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "dcdf5e3746a00fd1bb868bf948884c935a4d5007fb166eb7f2d03f17d74dc90c",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 42552, bytes: 11228 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "3d3c7eaa97204bd4f9de590d9b8b5ee91d95a3f7cc44994faed061cd05fbe0f6",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 53780, bytes: 11180 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "d6f885d01e88a695220a9626ab5bc00aa0c8a9ba4fbbb7484df2e97289bc9957",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 64960, bytes: 11536 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "ac8162c110a386f0b2df913c44647838874aec5c4448138010969d5331bfe1e4",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 76496, bytes: 11304 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "e8b2ee7e6cb4cc52363a43d58a17583a0f19496d9ab42a46949288f9ea64d66f",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 87800, bytes: 11304 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "9aeabe37c12749ef78e0335770d997c8b171d0d893b4d210afccd51bc4c2b691",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 99104, bytes: 13560 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "68d4be1a75dbc01b5bd12e100e464dc29de1575333edfd69c47b3dae10c5c616",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 112664, bytes: 13328 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "3987ea4a398f7a102c847140d68804f66a28685d320a77b6288a3b62d9db49b0",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 125992, bytes: 13328 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "e3abdae9d0e4ad73d132a84c4d758180d6af7a0f5fbc4269092da5c0c71c5e02",
};

static COMPUTE_DENSITY_WITH_WALLS: Module = Module {
    name: "ComputeDensity+WALLS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 139320, bytes: 12580 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "92c205c9ec36a72ada1962a389ec3586bf86ce931ab062329d74ede959134ae6",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 151900, bytes: 12588 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "6c6cd5781864861f5e1c7edf8ccb85d1b00a88e119913f728dc407a14a64cfe5",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 164488, bytes: 12524 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "3ecffd2a7e1d979e85bb3132414dd4b9d6dcf6aa355d28b0030a5d2dcc42d3c2",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 177012, bytes: 14048 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "248195f7dac5929d3c74d5aa03c1d7649e6b70b36a2d7df5844ec3faf9f058f4",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 191060, bytes: 14104 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "fed06ff4b324b331f4e1c32d1c20531d39b62c5fc37b951041c7b8e5a4275242",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 205164, bytes: 14072 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "e7af37125c1d839fdf46e14909d95f3373306a0509030f948cdbc597f6274a3c",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 219236, bytes: 13624 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "efed696040e239150cb12cd4ab27dd654c3a9e624f1f6ea32d9d7fab2f8b27fc",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 232860, bytes: 13392 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "604dedd7f0d03dc0e641dcf5cdf0ab51ac88e27727c5a76172b8d796dc176867",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 246252, bytes: 13392 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "b720bf9ba9be33ffdb33d6fcf9aa77416dbf6b0c114105f39f36f07f4d90dcd9",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 259644, bytes: 16404 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "67a73a071c967c74a6f97989f2aa774553008044ad552c06c48a6cc0750bd4d8",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 276048, bytes: 16172 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "4ef8b7b1954277fcd8171e54ddc881217a8a2ddf0cac3759f2fcbdd43b17f385",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 292220, bytes: 16172 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "a2e34d69b84c69d50672b7c0a884b590846ab5b7473a82690f2c1eff62106f63",
};
