// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/accelerate.compute.
//! Kernels of `solver/sph/accelerate.compute`.

use super::{
    ListHead, Position, PrecisionKeyword, SmoothingKernelParams, SphKernels, SphParams, SphTimeStep, StepParams,
    StepState, Velocity, VelocityPressure, VelocityPressureNormal,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`Accelerate`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct AccelerateVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
    /// Keyword `CHOSEN_KERNELS`.
    pub chosen_kernels: bool,
    /// Keyword `SURFACE_TENSION`.
    pub surface_tension: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// The acceleration of each particle and what its velocity takes of it at once: pressure in the form that keeps momentum
/// (Monaghan 1992), viscosity of differences of velocities (Muller, Charypar & Gross 2003, eq. 14; Morris, Fox & Zhu 1997),
/// gravity, walls, and with SURFACE\_TENSION the divergence of the colour field's stress (Lafaurie et al. 1994; Hu & Adams
/// 2006), which needs no curvature and keeps momentum too. A wall answers with its particle's own pressure, and with what
/// that would grow by under gravity beyond it (Adami, Hu & Adams 2012), in closed form.
#[derive(Debug)]
pub struct Accelerate<'a> {
    /// Its variant.
    pub variant: AccelerateVariant,
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<VelocityPressure> velocity_pressures`.
    pub velocity_pressures: Option<Buf<'a, VelocityPressure>>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<Velocity> velocities`.
    pub velocities: BufMut<'a, Velocity>,
    /// `RWStructuredBuffer<float4> accelerations`.
    pub accelerations: BufMut<'a, [f32; 4]>,
    /// `RWStructuredBuffer<SphTimeStep> time_step`.
    pub time_step: BufMut<'a, SphTimeStep>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> pressure_walls`.
    pub pressure_walls: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<SphKernels> kernels`.
    pub kernels: Uniform<'a, SphKernels>,
    /// `ConstantBuffer<SphParams> sph`.
    pub sph: Uniform<'a, SphParams>,
    /// `StructuredBuffer<VelocityPressureNormal> velocity_pressure_normals`.
    pub velocity_pressure_normals: Option<Buf<'a, VelocityPressureNormal>>,
}

impl Kernel for Accelerate<'_> {
    const STAGE: &'static str = "accelerate";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.chosen_kernels, self.variant.surface_tension, self.variant.precision) {
            (false, false, false, PrecisionKeyword::Off) => &ACCELERATE,
            (false, false, false, PrecisionKeyword::RelaxedPrecision) => &ACCELERATE_WITH_RELAXED_PRECISION,
            (false, false, false, PrecisionKeyword::HalfPrecision) => &ACCELERATE_WITH_HALF_PRECISION,
            (false, false, true, PrecisionKeyword::Off) => &ACCELERATE_WITH_SURFACE_TENSION,
            (false, false, true, PrecisionKeyword::RelaxedPrecision) => {
                &ACCELERATE_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (false, false, true, PrecisionKeyword::HalfPrecision) => {
                &ACCELERATE_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
            (false, true, false, PrecisionKeyword::Off) => &ACCELERATE_WITH_CHOSEN_KERNELS,
            (false, true, false, PrecisionKeyword::RelaxedPrecision) => {
                &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION
            }
            (false, true, false, PrecisionKeyword::HalfPrecision) => {
                &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION
            }
            (false, true, true, PrecisionKeyword::Off) => &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION,
            (false, true, true, PrecisionKeyword::RelaxedPrecision) => {
                &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (false, true, true, PrecisionKeyword::HalfPrecision) => {
                &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
            (true, false, false, PrecisionKeyword::Off) => &ACCELERATE_WITH_WALLS,
            (true, false, false, PrecisionKeyword::RelaxedPrecision) => &ACCELERATE_WITH_WALLS_WITH_RELAXED_PRECISION,
            (true, false, false, PrecisionKeyword::HalfPrecision) => &ACCELERATE_WITH_WALLS_WITH_HALF_PRECISION,
            (true, false, true, PrecisionKeyword::Off) => &ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION,
            (true, false, true, PrecisionKeyword::RelaxedPrecision) => {
                &ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (true, false, true, PrecisionKeyword::HalfPrecision) => {
                &ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
            (true, true, false, PrecisionKeyword::Off) => &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS,
            (true, true, false, PrecisionKeyword::RelaxedPrecision) => {
                &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION
            }
            (true, true, false, PrecisionKeyword::HalfPrecision) => {
                &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION
            }
            (true, true, true, PrecisionKeyword::Off) => {
                &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION
            }
            (true, true, true, PrecisionKeyword::RelaxedPrecision) => {
                &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION
            }
            (true, true, true, PrecisionKeyword::HalfPrecision) => {
                &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION
            }
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("velocity_pressures", self.velocity_pressures.as_ref().map(|bound| bound.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("velocities", Some(self.velocities.id)),
                ("accelerations", Some(self.accelerations.id)),
                ("time_step", Some(self.time_step.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("pressure_walls", Some(self.pressure_walls.id)),
                ("kernels", Some(self.kernels.id)),
                ("sph", Some(self.sph.id)),
                ("velocity_pressure_normals", self.velocity_pressure_normals.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &ACCELERATE,
    &ACCELERATE_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_SURFACE_TENSION,
    &ACCELERATE_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_CHOSEN_KERNELS,
    &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION,
    &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_WALLS,
    &ACCELERATE_WITH_WALLS_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION,
    &ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS,
    &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION,
    &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION,
    &ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION,
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
        name: "velocity_pressures",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "neighbours", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "velocities",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "accelerations",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "time_step",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "pressure_walls", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernels", slot: 11, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
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
        name: "velocity_pressure_normals",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 },
    },
    BindingInfo { name: "neighbours", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "velocities",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "accelerations",
        slot: 6,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo {
        name: "time_step",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "pressure_walls", slot: 10, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernels", slot: 11, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 12, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_accelerate.deflate"));

static ACCELERATE: Module = Module {
    name: "Accelerate",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15940 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "b6dd6dec0b79b836449dc15a9aba8aac66b355911ef86fa8c8e2952d0ce79aa1",
};

static ACCELERATE_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15940, bytes: 15304 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "52f4b3d0ef188126928bf381c125d13b5ece5e81ab32ebfc19f56aaeb85b97b7",
};

static ACCELERATE_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31244, bytes: 15384 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "1af2f07d8e80deabe038c58d4074054fe6d0357e20cf74638b9a82aebf2adfa9",
};

static ACCELERATE_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 46628, bytes: 18120 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "ea0e986073ed1519bd271c1550077a7f8af80b49f68c3aa832d4c6bc32f9f4e6",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 64748, bytes: 17484 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e557baf86a5ae824e52e250aeb59fc80f8b822382aa1e7cab2b2043f1cb60a20",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 82232, bytes: 17564 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "05e90d3ba3ff6d604ae65d5784692782c27d6a355d35fb66fb1aa19d1ebce1ef",
};

static ACCELERATE_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 99796, bytes: 18772 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "607f44e4f2ce536d49646848c204ae627ed960c6a2a01e3590b4517cd7104d3a",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 118568, bytes: 18040 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "15d5585cdbc00af9466f6da3c398ab5498f6be07a1fda69e70dc4d0a8de5e866",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 136608, bytes: 18040 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "30ef1b20ff4567b2c47998351583b5866f5920032b8d2160d50b927c1d93b847",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 154648, bytes: 20932 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "594ce5edff6a6ae760b7042f54e2895c101322df4dddf6e7b48fecb846e0266a",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 175580, bytes: 20200 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "2dae1f68b5fc34d629b15d84053d4d0c8ad9c2d5fca74b849263468961a0d67b",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 195780, bytes: 20200 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "6af9ba3281e1b7714b6857c4cb44dcb0964f4fd57b3e1cdb81868ed0d4fb86af",
};

static ACCELERATE_WITH_WALLS: Module = Module {
    name: "Accelerate+WALLS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 215980, bytes: 18684 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "d49848168472e41bc517212606ab994ae594cf871a68859282bc8ba49835dd3c",
};

static ACCELERATE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 234664, bytes: 18048 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "8bd8ae4f84c5d77ddf50774b206a91edcffc95503af3d6c871cf7a7dca252857",
};

static ACCELERATE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 252712, bytes: 18128 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "292901edb7cf355901fde72950a4b1aca89a91d02e487eba9d393b3fceecac47",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 270840, bytes: 20864 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "7be22167be517ddf98ff7a99af74e79462c4a4331201417d7b084e4c52f194ca",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 291704, bytes: 20228 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "ef49bc09c359ea0db607d21c97c5aadb24ee2e8d50b1827af5a0e031254047a0",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 311932, bytes: 20308 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "5ca86be7c37c9aac2a8926f93be4b950d308c668f6fc79109ee12f0ee7d7f038",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 332240, bytes: 21468 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "b77db8ee08fe847da9cf8e67fdc637cc28ac70fde0adc6d97e9f38099a50e881",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 353708, bytes: 20736 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "cedc7243284431103fdb7285ba5dc85c2cfbca473b98650bae90e49fd7bd5729",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 374444, bytes: 20736 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "92a16f3555ecc54c92db9a8f6b40a583e76ca2bed34210ca87ffdf3a62fe562d",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 395180, bytes: 23628 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "05ffc1178b55b5a4dc22bdbb94f15da47d49c165794f994739281ea6f90c25b8",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 418808, bytes: 22896 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "2e02e5db38fb341d57cd649e1635b60d073f638abd1ae80beaa29b759f9b949a",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 441704, bytes: 22896 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "32b80213fb87c59be272873f47e11f566188a26473fcae6815b1f113fa37f028",
};
