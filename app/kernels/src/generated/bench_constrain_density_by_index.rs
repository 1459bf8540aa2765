// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from bench/constrain_density_by_index.compute.
//! Kernels of `bench/constrain_density_by_index.compute`.

use super::{Constrained, KernelParams, PbfParams, StepParams};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// ConstrainDensity where only the index was sorted: neighbours lie wherever they began. What
/// `brooklet bench sorting` holds against it is solver/pbf/constrain\_density.compute.
#[derive(Debug)]
pub struct ConstrainDensityByIndex<'a> {
    /// `StructuredBuffer<uint2> places`.
    pub places: Buf<'a, [u32; 2]>,
    /// `StructuredBuffer<uint4> listed_indices`.
    pub listed_indices: Buf<'a, [u32; 4]>,
    /// `StructuredBuffer<uint> listed_counts`.
    pub listed_counts: Buf<'a, u32>,
    /// `RWStructuredBuffer<Constrained> constrained`.
    pub constrained: BufMut<'a, Constrained>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<KernelParams> kernel`.
    pub kernel: Uniform<'a, KernelParams>,
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
                ("places", Some(self.places.id)),
                ("listed_indices", Some(self.listed_indices.id)),
                ("listed_counts", Some(self.listed_counts.id)),
                ("constrained", Some(self.constrained.id)),
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
    BindingInfo { name: "places", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
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
        name: "constrained",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "kernel", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "pbf", slot: 6, kind: BindingKind::Uniform { bytes: 32 } },
];

static CONSTRAIN_DENSITY_BY_INDEX: Module = Module {
    name: "ConstrainDensityByIndex",
    entry: "ConstrainDensityByIndex",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/constrain_density_by_index.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "bench/constrain_density_by_index.compute",
    hash: "2b6f7b00bfabc8a579c87a08b531af752364315cec8eba0debbd2e51f06b88d5",
};
