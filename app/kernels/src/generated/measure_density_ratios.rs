// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/density_ratios.compute.
//! Kernels of `measure/density_ratios.compute`.

use super::{ListHead, Position, SmoothingKernelParams, StepParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// Which variant of [`DensityRatios`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DensityRatiosVariant {
    /// Keyword `WALLS`.
    pub walls: bool,
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
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
}

impl Kernel for DensityRatios<'_> {
    const STAGE: &'static str = "density_ratios";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        match (self.variant.walls, self.variant.periodic) {
            (false, false) => &DENSITY_RATIOS,
            (false, true) => &DENSITY_RATIOS_WITH_PERIODIC,
            (true, false) => &DENSITY_RATIOS_WITH_WALLS,
            (true, true) => &DENSITY_RATIOS_WITH_WALLS_WITH_PERIODIC,
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
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
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
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
];

static DENSITY_RATIOS: Module = Module {
    name: "DensityRatios",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/density_ratios.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "9cdef81e9e09cc30759b641627b83ea799a719db7e4ed74b5ccde68f32e39481",
};

static DENSITY_RATIOS_WITH_PERIODIC: Module = Module {
    name: "DensityRatios+PERIODIC",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/density_ratios+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "a5ab0ac37466b232b2a072f1175f93524dd90551b6de63cdc50f3d74930e5968",
};

static DENSITY_RATIOS_WITH_WALLS: Module = Module {
    name: "DensityRatios+WALLS",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/density_ratios+walls.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "234808cfab233c2d59372d2ee5507a48fd02e13c29ccb9f06cc434edbfa9bd50",
};

static DENSITY_RATIOS_WITH_WALLS_WITH_PERIODIC: Module = Module {
    name: "DensityRatios+WALLS+PERIODIC",
    entry: "DensityRatios",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/density_ratios+walls+periodic.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/density_ratios.compute",
    hash: "b82e87369cca2040f95864a267198ed12564cccf659d024aa1eedc575eca8d29",
};
