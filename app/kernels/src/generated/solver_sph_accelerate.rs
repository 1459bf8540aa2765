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
    hash: "7fee78badf6eac16e9abd7dccbfe091731826db25b16ea8ce562538b8d1a5606",
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
    hash: "63a268ff53ff57609121af04b73524aeddaea18313b813c0061aa3aab5940f67",
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
    hash: "8e70c434bbab2b3ac222b81f1076c6505b60a819d7fe34f257297530154f5502",
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
    hash: "4d927123d1cbca903e5eb4aa20ef12f471c1577ea1493dd638e77a7d2456f9dc",
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
    hash: "bcfe2a232029ad99140e8611d1559caa48b417df43e04895ccb1dee6fe71e455",
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
    hash: "6d7ceffe5e050a9e05ffdb0b73c144cb2f6aa55689373c8b372e73f0e3ae049a",
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
    hash: "b43aaff53a9179686d507b59da3a08c633cab3b6d83289b72c4cceb1be804221",
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
    hash: "97287b421d625ee9b5b453b03e112d0bb43ea684f9e468ec2d90e54239484273",
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
    hash: "197f04ff6fa4a27e75d15724217f392d8cc1f33d1d4a90d86e5c344db921f93c",
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
    hash: "8c27de3f636e628e824896dd3e70cd63a94028bd817029a24d2fe17065976536",
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
    hash: "a7e0664f5ba7bf6e4f5f6c123c2b259246aaef642c2d4e101d305aa16d881030",
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
    hash: "47cd247aba9bffcf185b4c725c25aeb52461f99719a5a67a702227cb5d57c067",
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
    hash: "384d897989177a55c0a8c85eb99d343775da4bdc49fb99166b6ff0d1ef0987ba",
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
    hash: "d18fdd2c7f608d961ef3ed4ea09fefa39744fcc15da0ad2bccbcd64cf123d850",
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
    hash: "aefebc15d5ef03879215e87820cc0ff8712833be353687f61be3d37a811315c5",
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
    hash: "b94b7948fc0d28377b0a870c01dabd3d8e2844cb11861bfcc9f55f981a3b3672",
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
    hash: "ed555e42347d61e075374b59dbb3d8e7c8d033381878d498d8e4c7d97ac4bf62",
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
    hash: "4c6821c7ec9ca8c322618a3c514856754fa94a05a402d9208ecfd665d89f497c",
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
    hash: "ce09588efb001f671e958b3dc61bc5be1bec9982a41cd88ec287220fee52fb18",
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
    hash: "a7520690acc6c93911ee555b3ca2374c7686ac60944f18396db6e8d5a2ddb551",
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
    hash: "6303628333ce5a7048adc58c549114130f4d67ea35e5190fc4600ee01c88abb6",
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
    hash: "4979a0687cd79d227f0cbca8226b3735bfb25ef39e32cb323e9b7ce187c20c83",
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
    hash: "c0f6e642c94e07dfeb158d6ecfeb28a3e9d8959ea8a94b0a007165533f315384",
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
    hash: "d59240f0bef08932b2d91087cce7e6e50314a810f07972352e81c8fa69d8a94a",
};
