// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from boundary/solids/confine_displacements.compute.
//! Kernels of `boundary/solids/confine_displacements.compute`.

use super::{
    BodyState, Position, PrecisionKeyword, SmoothingKernelParams, Solid, SolidPose, SolidsParams, StepParams, StepState,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ConfineDisplacements`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConfineDisplacementsVariant {
    /// Keyword `BODIES`.
    pub bodies: bool,
    /// Keyword `RELAXED_PRECISION` or `HALF_PRECISION`.
    pub precision: PrecisionKeyword,
}

/// Holds what a substep's iterations displaced particles by to what solids let through: the iterations themselves know no
/// more of a solid than the plane of its nearest part.
#[derive(Debug)]
pub struct ConfineDisplacements<'a> {
    /// Its variant.
    pub variant: ConfineDisplacementsVariant,
    /// `StructuredBuffer<Solid> solids`.
    pub solids: Buf<'a, Solid>,
    /// `StructuredBuffer<SolidPose> solid_poses`.
    pub solid_poses: Buf<'a, SolidPose>,
    /// `StructuredBuffer<float2> solid_fields`.
    pub solid_fields: Buf<'a, [f32; 2]>,
    /// `StructuredBuffer<uint4> solid_blocks`.
    pub solid_blocks: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `RWStructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: BufMut<'a, [u32; 2]>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SolidsParams> solids_params`.
    pub solids_params: Uniform<'a, SolidsParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `StructuredBuffer<BodyState> body_states`.
    pub body_states: Option<Buf<'a, BodyState>>,
    /// `RWStructuredBuffer<uint> reactions`.
    pub reactions: Option<BufMut<'a, u32>>,
}

impl Kernel for ConfineDisplacements<'_> {
    const STAGE: &'static str = "confine_displacements";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.bodies, self.variant.precision) {
            (false, PrecisionKeyword::Off) => &CONFINE_DISPLACEMENTS,
            (false, PrecisionKeyword::RelaxedPrecision) => &CONFINE_DISPLACEMENTS_WITH_RELAXED_PRECISION,
            (false, PrecisionKeyword::HalfPrecision) => &CONFINE_DISPLACEMENTS_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::Off) => &CONFINE_DISPLACEMENTS_WITH_BODIES,
            (true, PrecisionKeyword::RelaxedPrecision) => &CONFINE_DISPLACEMENTS_WITH_BODIES_WITH_RELAXED_PRECISION,
            (true, PrecisionKeyword::HalfPrecision) => &CONFINE_DISPLACEMENTS_WITH_BODIES_WITH_RELAXED_PRECISION,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("solids", Some(self.solids.id)),
                ("solid_poses", Some(self.solid_poses.id)),
                ("solid_fields", Some(self.solid_fields.id)),
                ("solid_blocks", Some(self.solid_blocks.id)),
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("solids_params", Some(self.solids_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("body_states", self.body_states.as_ref().map(|bound| bound.id)),
                ("reactions", self.reactions.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &CONFINE_DISPLACEMENTS,
    &CONFINE_DISPLACEMENTS_WITH_RELAXED_PRECISION,
    &CONFINE_DISPLACEMENTS_WITH_BODIES,
    &CONFINE_DISPLACEMENTS_WITH_BODIES_WITH_RELAXED_PRECISION,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "solids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 4,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 7, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 8, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "kernel", slot: 9, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "solids", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 112 } },
    BindingInfo { name: "solid_poses", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo { name: "solid_fields", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "body_states", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 96 } },
    BindingInfo {
        name: "reactions",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo {
        name: "sorted_positions",
        slot: 6,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "quantized_positions",
        slot: 7,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "step_state", slot: 8, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 9, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "solids_params", slot: 10, kind: BindingKind::Uniform { bytes: 64 } },
    BindingInfo { name: "kernel", slot: 11, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/boundary_solids_confine_displacements.deflate"));

static CONFINE_DISPLACEMENTS: Module = Module {
    name: "ConfineDisplacements",
    entry: "ConfineDisplacements",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 21964 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/confine_displacements.compute",
    hash: "91478972b514e6b31174efc9244d8f6b992ce62bd2ec7ff62819d7bb7da4cd2d",
};

static CONFINE_DISPLACEMENTS_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConfineDisplacements+RELAXED_PRECISION",
    entry: "ConfineDisplacements",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 21964, bytes: 22684 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/confine_displacements.compute",
    hash: "d320651c099be1ad17a10a99c2284c1fc01cfb6865af9a93a611ab1fcd4c273f",
};

static CONFINE_DISPLACEMENTS_WITH_BODIES: Module = Module {
    name: "ConfineDisplacements+BODIES",
    entry: "ConfineDisplacements",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 44648, bytes: 26168 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/confine_displacements.compute",
    hash: "1dbd56a2574c558845a7228e2c1f5002738b18ce25399cef48b7609899695c63",
};

static CONFINE_DISPLACEMENTS_WITH_BODIES_WITH_RELAXED_PRECISION: Module = Module {
    name: "ConfineDisplacements+BODIES+RELAXED_PRECISION",
    entry: "ConfineDisplacements",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 70816, bytes: 26888 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "boundary/solids/confine_displacements.compute",
    hash: "3652a91c9f1af1c009fb46af88c6b96ce4ee33d6a58e1252f5398de9492a7240",
};
