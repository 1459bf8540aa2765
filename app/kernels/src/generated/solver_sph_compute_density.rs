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
    hash: "69069fb9b0c1506e7d39661121aeaac530c34d3e55acbad6b04029af8242c5bc",
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
    hash: "269736f2738fc240b9b8de28a54986285012f7f1dc3caac2e2cfc0473f666d81",
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
    hash: "b580208b713df2be90ff77a118b98f8a86d695e7300af0fd0b4f15e78c03b9b9",
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
    hash: "b0ffc5f045e74729479fa1025b51e94606b6ea2027b6cd86ccf3df14e7e1d872",
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
    hash: "eb2b3a1533e63256c39003217e02334e9c6e3d00f41f9948801e13722f29b22d",
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
    hash: "b9fa0d12c4d5281e0736ebf897526e0f6644cfbc88c32b11d4d4d5bf8b601919",
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
    hash: "c117c08d6628899d592fc911f1d68a63b5632344928b47d91394a1119873f68a",
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
    hash: "59bc242f9b0d36f795a2536fcf37a80254121ee65e36748757ec1c77cf0ee7aa",
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
    hash: "6190696fe64268c5bc5733faee171a29a452379160150c04e6a6717343d0e84d",
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
    hash: "156e0c66d280c049b9752394c1b63270363c1c7eecb2915c58f281c75b30cd15",
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
    hash: "d43c7a2d3c29d80811dd679f0eab5211a5605658c4c78b15c61d2b76dd919b6b",
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
    hash: "05f37f6a07c8c35d2fd9f8afdc9e342cd90e5ebc6912155e0755329f55248622",
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
    hash: "cfe4410d31d34b01354e37cec064e0640b1cf2f8c779b8aed234c49851052cc3",
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
    hash: "7c07a6443eda26f2ede6fce29dfcf5509c0a695fff9bd1d10a3d3c54759a7f89",
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
    hash: "10047b6e8e077ff5924fde960c2d3aed12ed512ee2b7768f4c66ee7914057d5b",
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
    hash: "87a427902d9e0a83c7fc5ae2f5719e8e8664b02ce86fe8624c43c22fa21a269d",
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
    hash: "d967570aea892ed31320cb1f45e059b2a6b30efbb55e1e9f03e58ef72824291c",
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
    hash: "c69d8afcb712a8595e7cf6d975e96b92db4fff277e12b163d8ac91febb045664",
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
    hash: "ed5e4be4d4a691fd62f1cecf2dfeb943f6eb33712df2dc9822c35b15cd573b80",
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
    hash: "4d36bbdc4ab4193f02ddf7d6d3fe145a92b1cc3c23d81e139df10ae81b4fa448",
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
    hash: "4b1bc073c0fdd568a1d8e9f27f5993f6a6e984f493601e1552e385036b5c1e60",
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
    hash: "3acc72832d6c08711ad7534f6affe518fef4d15a3926c105b3bf80b746e2e90b",
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
    hash: "a99685050ae60aaacf35d811afdd8147b524def9b7bfaec30784b3a4a726315b",
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
    hash: "d853ecba77f65b2bfd136ba5f08bb5c99c9758701d34fd863c6c5be1e5daa686",
};
