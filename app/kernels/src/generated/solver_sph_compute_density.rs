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
    hash: "c4819ffeb5bf7958ba81b63849cfb397faea44e00a988aed9c6e9d027a4f9251",
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
    hash: "597bad6ac9f1ad43c8feacb95695115c7c5f615ef7ea5a070293f6b60569725a",
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
    hash: "46a129fceaf0a3e489693285611b7433ae11bb38fa247695b9ec7caa7b11fe46",
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
    hash: "d6013f3f23c3630764b393f84341fd2d7edba8e37647683541b827b908aaa5cb",
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
    hash: "25fd9f36bbed7a446f74920a01905761929f13bee3ae4bf2e69d3938d7b23a0c",
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
    hash: "ec56085c5d6da8bf2b642398c400c91751a5f719963b9e9fad19dd1f635eaa01",
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
    hash: "687a34bcb730704bbf891928495aa0838b71360fcbabdcb743797fbbfbec218e",
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
    hash: "4493daef8b8bfef7b34bdd8743c01af7964d6b15018da7d21ace62d24234682b",
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
    hash: "7521fde669471331f580ed739f19f284b0388ed483378dc1d48d9be3ae9b65bd",
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
    hash: "0c8e09075ea864818f40b67b92f716208cca571109f4d9768be956745892c3b2",
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
    hash: "f49d835310dabfd82af40bd41669c83540b20d591edc2093ce374205398bb3c2",
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
    hash: "dddfed907ff81af57fc4fd0e084c8955fba0618be8a7b32745a883faffeb9a87",
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
    hash: "24bcdcaf21c7f2ac7fdafb7540d145e694c213b80ab65c43e2e3a25186588fc5",
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
    hash: "464aa9c922a345b7eb64455702c5a746081ff5dda16ecc2a561319643223895c",
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
    hash: "7a45498ab04b6e4b300f6d0c1ae6c99e45b80792615a90f02973bacd865a800b",
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
    hash: "6df16e2f43760cc4f094b4c5e3bbac3adb5af890e37eb941890e1585867aeb9f",
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
    hash: "e0da8ba38819a615b9b81ad1f2f4edde357b77dd63db21791e379b22f081f6e7",
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
    hash: "829c2df70a545f6671213e121fad6aa4412f1390c97af75c2af3408539321f7b",
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
    hash: "45917e08cc82f40fbf4fd3bad71d85dd7d58319aa631d266480698aefc90deca",
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
    hash: "b267c4c36b4136b7cb6888c9c20f95e7f28525c5cd90ee83b192f5c2c8cefe2e",
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
    hash: "b2e5aa07b9132ed598355d257f9162f82965fd5127ce1916b7f628427baf1b56",
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
    hash: "ee82ab31b30d36c999a1d65515fe104e7519fb91fb5661d9e66a554a900ca0c7",
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
    hash: "31ad90c9a0e18432586f0385a4a5eda13f0dd90500d06749b4edea6ae4112f38",
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
    hash: "957e95da8375565627b710aa818c2c5bb44bff4e84955f8247d879fd075f08dd",
};
