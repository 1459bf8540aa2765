// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/density_ratios.compute.
//! Kernels of `measure/density_ratios.compute`.

use super::{ListHead, Position, SmoothingKernelParams, StepParams, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
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
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
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
                ("step_state", Some(self.step_state.id)),
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
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
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
    hash: "ee44564cf1a86e871aedc3ef1c735006dce57e2eb09156cee687beb5844bfb82",
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
    hash: "b074f1b6e5bd714a1c305d5bb8ce5163783ec18970d0a79d196d3abb67225209",
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
    hash: "01d3e37d2ab67921c9b3e7111c837ffe34cc43bc1a87f3db1fa297912e7a1659",
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
    hash: "21c78c20719289c0b89e3dd91b92b70e49910c77ac1b44953f8926e94d4f204a",
};
