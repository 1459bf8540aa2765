// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/density_ratios.compute.
//! Kernels of `measure/density_ratios.compute`.

use super::{ListHead, Position, SmoothingKernelParams, SolidContact, StepParams, StepState, WallsKeyword};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`DensityRatios`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DensityRatiosVariant {
    /// Keyword `WALLS` or `SOLID_WALLS`.
    pub walls: WallsKeyword,
    /// Keyword `PERIODIC`.
    pub periodic: bool,
}

/// Every particle's density ratio, for colours that tell it.
#[derive(Debug)]
pub struct DensityRatios<'a> {
    /// Its variant.
    pub variant: DensityRatiosVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint2> neighbours`.
    pub neighbours: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<ListHead> list_heads`.
    pub list_heads: Buf<'a, ListHead>,
    /// `RWStructuredBuffer<float> density_ratios`.
    pub density_ratios: BufMut<'a, f32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `StructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Option<Buf<'a, SolidContact>>,
}

impl Kernel for DensityRatios<'_> {
    const STAGE: &'static str = "density_ratios";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (WallsKeyword::Off, false) => &DENSITY_RATIOS,
            (WallsKeyword::Off, true) => &DENSITY_RATIOS_WITH_PERIODIC,
            (WallsKeyword::Walls, false) => &DENSITY_RATIOS_WITH_WALLS,
            (WallsKeyword::Walls, true) => &DENSITY_RATIOS_WITH_WALLS_WITH_PERIODIC,
            (WallsKeyword::SolidWalls, false) => &DENSITY_RATIOS_WITH_SOLID_WALLS,
            (WallsKeyword::SolidWalls, true) => &DENSITY_RATIOS_WITH_SOLID_WALLS_WITH_PERIODIC,
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("neighbours", Some(self.neighbours.id)),
                ("list_heads", Some(self.list_heads.id)),
                ("density_ratios", Some(self.density_ratios.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("solid_contacts", self.solid_contacts.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DENSITY_RATIOS,
    &DENSITY_RATIOS_WITH_PERIODIC,
    &DENSITY_RATIOS_WITH_WALLS,
    &DENSITY_RATIOS_WITH_WALLS_WITH_PERIODIC,
    &DENSITY_RATIOS_WITH_SOLID_WALLS,
    &DENSITY_RATIOS_WITH_SOLID_WALLS_WITH_PERIODIC,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "density_ratios",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "neighbours", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "list_heads", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo {
        name: "solid_contacts",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "density_ratios",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "step_state", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 7, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/measure_density_ratios.deflate"));

static DENSITY_RATIOS: Module = Module {
    name: "DensityRatios",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 6916 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "0073a8b6703b2fa8fffd4b2552815a28091bea8d66b0dec0272eb09aeaf09cdb",
};

static DENSITY_RATIOS_WITH_PERIODIC: Module = Module {
    name: "DensityRatios+PERIODIC",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 6916, bytes: 7356 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "aaacbf57a68e03d3fab0ea42bca73af23c84faa57127271e5e4aa45de877812c",
};

static DENSITY_RATIOS_WITH_WALLS: Module = Module {
    name: "DensityRatios+WALLS",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 14272, bytes: 9324 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "14cf40c03ce82b755fd5bba43c5ba38b6cfc859d14571864b118a2774d0d286b",
};

static DENSITY_RATIOS_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "DensityRatios+WALLS+PERIODIC",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 23596, bytes: 9496 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "e92e4711c1916cbaf1044fee07b648d88b2014d38bfb53f06df1c416cc26334b",
};

static DENSITY_RATIOS_WITH_SOLID_WALLS: Module = Module {
    name: "DensityRatios+SOLID_WALLS",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 33092, bytes: 11432 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "3c6b08eac67de93020c48fcf4cfe827e5956183344320dd51c8900b4d4e52500",
};

static DENSITY_RATIOS_WITH_SOLID_WALLS_WITH_PERIODIC: Module = Module {
    name: "DensityRatios+SOLID_WALLS+PERIODIC",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 44524, bytes: 11604 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "2dddb64f7f3508bf6f3e9c415e648c01664cb7f4b489d3a7133654e18cdc9a7e",
};
