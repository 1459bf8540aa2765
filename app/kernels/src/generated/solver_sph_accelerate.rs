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
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 15804 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "79322c7ae7c9f6d7c79ef31affce2eb460cf55585c4cff6d0856e93fe1a60b16",
};

static ACCELERATE_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 15804, bytes: 15168 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "03f9b3133c93149bf1f4d75e7820bfd5f638e96c9e55dfb00dd97b9db8dec485",
};

static ACCELERATE_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 30972, bytes: 15248 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "3d82c1e41ba55149a8f474e109c81c9a88821f0273495370bd82e639367b2446",
};

static ACCELERATE_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 46220, bytes: 17984 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e2a9a91d2eec3c7f9edbad1657e3074ccf3b1cffb6e2db8cb6a3e482100bae83",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 64204, bytes: 17348 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e345c935484c95b25ac66c7dbd533cba9533c9a5bb3bcac537d5de366b4eb8e9",
};

static ACCELERATE_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 81552, bytes: 17428 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "a20f4bc226a45f976e24e6c949e63033c55dd19c1746936d38377225c7edd12f",
};

static ACCELERATE_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 98980, bytes: 18636 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "a1a9413e65f4da7e3879e36e372ef0772c82c3e97b8bf59b7f8f6e2c559bcc19",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 117616, bytes: 17904 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "646c156798e84939cf577f603d1c1d44061d710dbb83c7e1ae2b2c604f19e58c",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 135520, bytes: 17904 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "73483ff3b42b9bce506a90d2b29f8a65f18f46b00077bf3476177e18683124ea",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 153424, bytes: 20796 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "3ed5b127af6c130ff61dc75bcc7e3633ea3755154295484ae115525f369b3cf5",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 174220, bytes: 20064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "cd90b86a63a9bfb8a37acb18645d5f0776be5d1ad910101b63b1ce0ed2e17160",
};

static ACCELERATE_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 194284, bytes: 20064 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "fca1abb78118e6ac4c7bc167138128d717bf9ca1f0bfa7035b479472fd11a0dc",
};

static ACCELERATE_WITH_WALLS: Module = Module {
    name: "Accelerate+WALLS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 214348, bytes: 18548 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "45bb3f557ede89275d48cda1865a5c9520a4dd031e523873ee10dc07ee27a6d8",
};

static ACCELERATE_WITH_WALLS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 232896, bytes: 17912 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "f3e3871d1a98494a52ae482e0f48e712093ee23325b103ea9f6a22ee5e177d37",
};

static ACCELERATE_WITH_WALLS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 250808, bytes: 17992 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "0990b6cb70925da091776b388eb580b9060cefb7a2e406ba5167bdb5e4b38121",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 268800, bytes: 20728 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "38de51c88048c8074308b3d39e53029317b93305c9421f65cdb1358548cdf6d0",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 289528, bytes: 20092 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "a8724e93d7c2738668f05b9fd0a947c1f38ab4740de053e35c2cc9028913e1a1",
};

static ACCELERATE_WITH_WALLS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 309620, bytes: 20172 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Desktop,
    source: "solver/sph/accelerate.compute",
    hash: "267b67853660a4cd69d33a8c6765ee150c62ad8bf4e082f25e779676031e38e2",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 329792, bytes: 21332 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "e80e0ecb1353e38467afd5bc1b47b21f0a0a21e34c6108e75884452a44e8148e",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 351124, bytes: 20600 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "de3438ef6ef641f58f62e5cb5d82ed2d74aa98868bdc3994c22261cb4a52b548",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 371724, bytes: 20600 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "cc9835b9e8db80b80d38c51b099c7e3028f1504ef225293c7fc97fd5d96fd63d",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 392324, bytes: 23492 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "4a71798694909fe9ab75a2239d10d8ed0e56aaac9cb4c2016293393a148896b4",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_RELAXED_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+RELAXED_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 415816, bytes: 22760 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "9869fc19582e69286081e89de12b3aaee9c71c54a0c001666f5e574a0f44dd57",
};

static ACCELERATE_WITH_WALLS_WITH_CHOSEN_KERNELS_WITH_SURFACE_TENSION_WITH_HALF_PRECISION: Module = Module {
    name: "Accelerate+WALLS+CHOSEN_KERNELS+SURFACE_TENSION+HALF_PRECISION",
    entry: "Accelerate",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 438576, bytes: 22760 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 8,
    tier: Tier::Floor,
    source: "solver/sph/accelerate.compute",
    hash: "83bc646a808cd0a68b3845b7f8593217235d1a3491f06c99f11895360c7aaad1",
};
