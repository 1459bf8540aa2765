// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from measure/sample_particles.compute.
//! Kernels of `measure/sample_particles.compute`.

use super::{Position, SampleParams, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Every stride-th particle by its id, at the index id / stride: a point stays the same particle from
/// frame to frame, whatever order the sort has put them in.
#[derive(Debug)]
pub struct SampleParticles<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Buf<'a, Velocity>,
    /// position, m, and speed, m/s; no number where quarantined
    ///
    /// `RWStructuredBuffer<float4> samples`.
    pub samples: BufMut<'a, [f32; 4]>,
    /// `ConstantBuffer<SampleParams> sample_params`.
    pub sample_params: Uniform<'a, SampleParams>,
}

impl Kernel for SampleParticles<'_> {
    const STAGE: &'static str = "sample_particles";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &SAMPLE_PARTICLES
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", Some(self.velocities.id)),
                ("samples", Some(self.samples.id)),
                ("sample_params", Some(self.sample_params.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SAMPLE_PARTICLES];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "samples",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "sample_params", slot: 3, kind: BindingKind::Uniform { bytes: 16 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/measure_sample_particles.deflate"));

static SAMPLE_PARTICLES: Module = Module {
    name: "SampleParticles",
    entry: "SampleParticles",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2868 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "measure/sample_particles.compute",
    hash: "d04cb32878cea5bd9ad1fc9bbdb3e979a4a1f3c7ee8e74324e1652fbb333c6e1",
};
