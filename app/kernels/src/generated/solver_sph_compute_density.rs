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
    hash: "3e5035cb99b5d4f589f96ab52627f8f218202212c60967515085ce6fdb29bebd",
};

static COMPUTE_DENSITY_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10476, bytes: 10068 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "989206f2b1c9532c699d03ed140c74719dcaf17a87311912b106e43a8eea863d",
};

static COMPUTE_DENSITY_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 20544, bytes: 10004 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "065803523f99c6c180d6460f77e447ecbf0ec9aee072cfb60927cff3524a3f44",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30548, bytes: 11172 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "1b3a06558998ea2efcedcea415da7cc2a2285b01d13a829f87ab1962d457aba6",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 41720, bytes: 10812 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "1ab9f49a35e3455d92dfb3664a24e1f96891ada8588cc24934a2233de6310e6d",
};

static COMPUTE_DENSITY_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 52532, bytes: 10764 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "8265890e41c0e7afe5b2b07e8169b629fd5aafebc79615a335206fa6c99797c1",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 63296, bytes: 11536 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "1e51074d86ebe729a4ed76db9db71299262736243576af98fcce413c490773f1",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 74832, bytes: 10888 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "03da14c381a6bc44f85b8761d44f7d19f2f288a2887153e3678b598708bc0ce9",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 85720, bytes: 10888 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "7c621928630eb15fa382703835da88199d497ee87651839b489db439fd63638e",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 96608, bytes: 13560 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "51a5e6219b63450ed9528d5ef243f45db1b7849680cc6b4037a6aa1c5971e53b",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 110168, bytes: 12912 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "5745a9c724ce49dca543a7d6e9a4b1ad93f557b565c7415a5d28247596190485",
};

static COMPUTE_DENSITY_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 123080, bytes: 12912 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "04630298c301754ba310408a6f36bbcdfbebc00fd96eca2e34358f1c744b1556",
};

static COMPUTE_DENSITY_WITH_WALLS: Module = Module {
    name: "ComputeDensity+WALLS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 135992, bytes: 12580 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "57898ee235c0b92d346a3da91f5bd4488d1c0668bbee5ec4161e9468463bf0c8",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 148572, bytes: 12172 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "7612680a855636c4cf99a6d7bdb13af785e4a4fd5b73e0103cc2b6434a4d75a9",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 160744, bytes: 12108 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "598b57046c6eb33d992d4b3f2726cc73ab283300bd0c697ab0a45ae9367b71ae",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 172852, bytes: 14048 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "0dd870ab12458e493a11218b2ae8a0c9ae1657392c753e973278ccafb22fd935",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 186900, bytes: 13688 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "8fe32c3f61dcc87a42e5ad0b74374a0e9c4aba10dd68595daa6f416b55ba7af4",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 200588, bytes: 13656 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/compute_density.compute",
    hash: "43222cff039fe474273c87508edf2fd7241bbb148add0717b0372bb924fd9c2c",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 214244, bytes: 13624 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "5fae687a630bd776d392c590793d9ae1a7f357d1bc439cc37fc641f7691f7ab7",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 227868, bytes: 12976 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "2e47ff4a9088671b105b50d666f7ef7db0a9409e27d3267cba4d0ffc1b31f9a0",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 240844, bytes: 12976 },
    bindings: BINDINGS_2,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "2c289b7e25ef47d419913acfa4e6c7370ecccc9ee81b700398b595b217473bd8",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 253820, bytes: 16404 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "55c65ed5b5dec585e5c805ff25c1755dfb779eea241e5372bcb56ce4d8f752cd",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 270224, bytes: 15756 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "7ee980a6cfa164c6967909f3d9958bfa1be31dec751b9e9046190dbde8f2a0fa",
};

static COMPUTE_DENSITY_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "ComputeDensity+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "ComputeDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 285980, bytes: 15756 },
    bindings: BINDINGS_3,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/compute_density.compute",
    hash: "7f9cfff7b2c8ce782273408300ccef064cc633e62b781827a9ec6e692a9078af",
};
