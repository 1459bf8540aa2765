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
    hash: "f8196ef339092728cd082b6ec46295de8c717a0edeba07256270fe2618565676",
};

static ACCELERATE_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15940, bytes: 15800 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "f3c4788ac43801a8a8053ea80ed2e4bc8b68f361659e3c6554ff73f2fbf27ce3",
};

static ACCELERATE_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 31740, bytes: 15880 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "20b4e73f93cc0371488b1989db69f51a6b1fc79b395f5d32523fd39cad340892",
};

static ACCELERATE_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 47620, bytes: 18120 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "cf1a45c414adc923491d9b93f5b2ecd9dba19bcc16892f3a18da5ec6c04106bb",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 65740, bytes: 17980 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "f23bf18c2b7cebc6578302cabd6091e3c36aa6fdfdf2a7aa3ed96642145b0152",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 83720, bytes: 18060 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "1cf0a7a7649a03b35a7c247e081d1c55ed53e251f25e4103e9d2255bba84c19e",
};

static ACCELERATE_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 101780, bytes: 18772 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "639f6b3d1261f0b568a6b23054665c6f1e940837cbb130a422d6a2e39d47fd9f",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 120552, bytes: 18536 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "d2b8728084b0148638d8c4c4a7cfe03ce51c2c586e3d0884a2eae3466ae60ab3",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 139088, bytes: 18536 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "077e82c87e438545334f03d1f5bdc5b12d44ec07811048e8dc25f8608e6e06d8",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 157624, bytes: 20932 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e06ed03e849eb2ea3ec15be0ef6a96736ecc6d2993776a7faa6fded3c1b819ca",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 178556, bytes: 20696 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "3e62dd56f1973c8fcd4e7138dcd7811f022412aff6d5bf1286545f8b7baf72d1",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 199252, bytes: 20696 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "da55ff8336370040e454229a16aff4615253670901786088356353879b912f78",
};

static ACCELERATE_WITH_WALLS: Module = Module {
    name: "Accelerate+WALLS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 219948, bytes: 18684 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "ba991f05969e082455c8505e72323f3d21e60e1a0c8c11ef2b0ce2297e542f36",
};

static ACCELERATE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 238632, bytes: 18544 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "4d306d6190e190442847932a3fa26c1223d459354a6133967c6d129fde2f2f91",
};

static ACCELERATE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 257176, bytes: 18624 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "4e1c0064430dcfa13dfe8eea5682e8d893169e0b45631ea96917c6384a6bdbaf",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 275800, bytes: 20864 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "bce084a78441c3b5f81223bf42727eb6a1e143f99337d2ec248e343ed093c45a",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 296664, bytes: 20724 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "3f6d70e1a437f962a1254bdda36bb266b4e7036a61de5780bf4c83d95fe69ec7",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 317388, bytes: 20804 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "017e7755ad55c013562db5da7c5f451bbbb29b52e521c7caece9c6f76173b167",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 338192, bytes: 21468 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "2c7fa4146a9349fea2ba8d2d652deb11ae406780cb894dfb1da007590410a771",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 359660, bytes: 21232 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "1398f98c8fd4cbf6285dd6a99af65f8228b5bcead88f571d23673223bbff6bf2",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 380892, bytes: 21232 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "2062bf50d9a8b509161c699118edc762dd7550c6bcaab0ecffb812f4bb59b873",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 402124, bytes: 23628 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "c3215a7a25163fb7621178a43c1b2f830765cf33801a97a4d628d9e30d54c26c",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 425752, bytes: 23392 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "709fba4b7b187c825a4e6a5d8d09c77f6edbc15e8d40aeee3a2d79fe0d7e636b",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 449144, bytes: 23392 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "f3943f3bc0f69eba32b11c8d07cbc917d0e970e43d0ac517b240b3eb50b1f57a",
};
