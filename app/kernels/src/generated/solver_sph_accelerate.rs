// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/accelerate.compute.
//! Kernels of `solver/sph/accelerate.compute`.

use super::{
    ListHead, Position, PrecisionKeyword, SmoothingKernelParams, SphKernels, SphParams, StepParams, StepState,
    Velocity, VelocityPressure, VelocityPressureNormal,
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
/// that would grow by under gravity across it (Adami, Hu & Adams 2012), in closed form; along it pressure pushes as much more as
/// the fluid's images beyond would (AlongWalls).
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
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "pressure_walls", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
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
    BindingInfo { name: "step_state", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 8, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "pressure_walls", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "kernels", slot: 10, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "sph", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_accelerate.deflate"));

static ACCELERATE: Module = Module {
    name: "Accelerate",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 14756 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "68ac91b3331a64a576aa6f6c701d15d8ce5f46af161057e3a8ca9de5232bd2e9",
};

static ACCELERATE_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 14756, bytes: 14616 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "a26799a82b5fe47f7f72a644e29c48def5a8bb7147ca19fa650f26a8c2505dcd",
};

static ACCELERATE_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 29372, bytes: 14696 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "4250c51d75361ceb85e33389b215a925c9d89e68b74dfe02e4722c5dfc2f137b",
};

static ACCELERATE_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 44068, bytes: 16936 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "1fa06541991edd511bf46ab8539bbf0f433db4f4148687270dbc665dc6fb5564",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 61004, bytes: 16796 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "0b2f31c377f5ad50d4b4428572c43570422779244c257997e88b1360df4fb7ea",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 77800, bytes: 16876 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "80bbb3cefd1973d098b4b0851373bbbced4fb69e2f5bc25ef553ab63c908509a",
};

static ACCELERATE_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 94676, bytes: 17604 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e46667eb8319edb74e57c30c8d8dbacbdc269cc49cea3595c62b17b7a8bb9930",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 112280, bytes: 17368 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "89459113f237cec85510975e38ecdff9b1a45b2821bbeaca967cbd70f5002ed9",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 129648, bytes: 17368 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "7f95a40c6ae96ee7232ed649dbe5f93df855a81903de6c08437c6b4a8a9232fe",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 147016, bytes: 19764 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "5f5b8f51976c419c9d828c3db6a5d6282afc903da99bb8dba87f6e7901987a00",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 166780, bytes: 19528 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e5ee12c2d0b57c32414fe78f18f89e92481c3e280747ea635e89f7a090d5cd59",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 186308, bytes: 19528 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "59a31d732d9652d444ee6b577b083c6e4cff8af83b4b6d6cebfaf00e11749b6f",
};

static ACCELERATE_WITH_WALLS: Module = Module {
    name: "Accelerate+WALLS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 205836, bytes: 17388 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "f7566bc0dbbda35272379e71029514c9a895693752f5ec6a1dd5f96f5521ecdf",
};

static ACCELERATE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 223224, bytes: 17248 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "4b8e5aeb3ddc82c811b76c69c13cfe5cfaf33871d3ed782415f4ef03ac80b94c",
};

static ACCELERATE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 240472, bytes: 17328 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "156491b4cc3f027011b31fa3ecbf1e15e848f715f89b8ece2fb94131ade65faf",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 257800, bytes: 19568 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "882d94ddb8b7f4c92d01f098c5cf04cbbde7fed732b681a93276a9ab40d38362",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 277368, bytes: 19428 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "4c268d0677dd2135bb0bb5f0721aef0560b7581b723d2d3ea2d0d352a03765a7",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 296796, bytes: 19508 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "f1cdba59e3cc803aa69ce589bb9c0b460fa5d7d7144a83411d9a425d87ddfd69",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 316304, bytes: 20188 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "ea3ab50e8ec6a933c5b53ccf3cbbba330f699905ee9ae67bb536d48fa1245a6e",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 336492, bytes: 19952 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "83d3542206fa1502a3cbbe97862dc407b911e1b89f5f34534b1f24b1094c98bc",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 356444, bytes: 19952 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "80a8ec210a2474f65bf677752a048dcf2c78ae1fba13be73171ee12de85da555",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 376396, bytes: 22348 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "8d0df6339c5c3cab1b1af198afa903bccbf52bf7d5529779b51e6523b60911f8",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 398744, bytes: 22112 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "bfb74120c42bba37c29b394b3771cea51f2db6dc2e81f4242472129414338053",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 420856, bytes: 22112 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "955e58b0ea1ed85e9a09f233dc086adb25e963721ef86924eb767e6a09c3ae19",
};
