// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/density_ratios.compute.
//! Kernels of `measure/density_ratios.compute`.

use super::{KernelParams, ListHead, Position, StepParams};
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
    /// `ConstantBuffer<KernelParams> kernel`.
    pub kernel: Uniform<'a, KernelParams>,
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
    hash: "8b77455ed1f61467a1d16488b06b6ed602dd9fab8d07c8e10a41714d624dc4f6",
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
    hash: "4103a6e1a35ffc3dc7ce89f98aebcdf51607e7dcd76083c753a0844ee462f373",
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
    hash: "1ddbb011f353698189371c49a7c3fe057b343e1d2ce77bf0aaab260d1bb718c4",
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
    hash: "f827294a08051fa05a92ae8e33eabded6345ebdf94c76d14fabceb9f0ad16b94",
};
