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
    hash: "649470fca41d7c2e4755973978e0fdbf437e7b48cb07377b7414fe1ca5f50f32",
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
    hash: "53452f6d197dfc6315327f26c7850c74347ce55ad66d9cf3d63bba34ffceea98",
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
    hash: "39730415c249088cdd8a9a70bdc1022a3c520474bd6183a2fec7bbd348c4d00f",
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
    hash: "e9e01edd0b3d085ffdf3ac137e737f477b74b697761a4bed50d4b98314aa70a8",
};
