// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/constrain_density_by_index.compute.
//! Kernels of `bench/constrain_density_by_index.compute`.

use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, PbfParams, PositionLambda,
    SmoothingKernelParams, Spirv, StageKind, StepParams, StepState, Tier, Uniform, bind,
};

/// ConstrainDensity where only the index was sorted: neighbours lie wherever they began. What
/// `brooklet bench sorting` holds against it is solver/pbf/constrain\_density.compute.
#[derive(Debug)]
pub struct ConstrainDensityByIndex<'a> {
    /// `StructuredBuffer<uint2> quantized_positions`.
    pub quantized_positions: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint4> listed_indices`.
    pub listed_indices: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> listed_counts`.
    pub listed_counts: Buf<'a, u32>,
    /// `RWStructuredBuffer<PositionLambda> position_lambdas`.
    pub position_lambdas: BufMut<'a, PositionLambda>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> kernel`.
    pub kernel: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<PbfParams> pbf`.
    pub pbf: Uniform<'a, PbfParams>,
}

impl Kernel for ConstrainDensityByIndex<'_> {
    const STAGE: &'static str = "constrain_density_by_index";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &CONSTRAIN_DENSITY_BY_INDEX
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("quantized_positions", Some(self.quantized_positions.id)),
                ("listed_indices", Some(self.listed_indices.id)),
                ("listed_counts", Some(self.listed_counts.id)),
                ("position_lambdas", Some(self.position_lambdas.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("kernel", Some(self.kernel.id)),
                ("pbf", Some(self.pbf.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&CONSTRAIN_DENSITY_BY_INDEX];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "quantized_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 },
    },
    BindingInfo {
        name: "listed_indices",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "listed_counts",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "position_lambdas",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 5, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 7, kind: BindingKind::Uniform { bytes: 32 } },
];

static CONSTRAIN_DENSITY_BY_INDEX: Module = Module {
    name: "ConstrainDensityByIndex",
    entry: "ConstrainDensityByIndex",
    stage: StageKind::Compute,
    spirv: Spirv::Plain(include_bytes!("../../spirv/constrain_density_by_index.spv")),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/constrain_density_by_index.compute",
    hash: "97fb94f11d29bccd77932bf678def92b6b2d20cbda6f1e3dc36eb477875c02c0",
};
