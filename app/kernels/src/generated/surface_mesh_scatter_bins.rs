// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/scatter_bins.compute.
//! Kernels of `surface/mesh/scatter_bins.compute`.

use super::{CellSlot, Ellipsoid, MeshKernel, MeshParams, Position, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`ScatterBins`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ScatterBinsVariant {
    /// Keyword `ANISOTROPIC`.
    pub anisotropic: bool,
}

/// The particles side by side, bin after bin: what looks at a bin reads from end to end. With ANISOTROPIC their ellipsoids
/// as kernels of a density (Yu & Turk 2013; twin: reference/src/surface/anisotropic\_field.rs).
#[derive(Debug)]
pub struct ScatterBins<'a> {
    /// Its variant.
    pub variant: ScatterBinsVariant,
    /// `StructuredBuffer<CellSlot> bin_slots`.
    pub bin_slots: Buf<'a, CellSlot>,
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Option<Buf<'a, Position>>,
    /// `RWStructuredBuffer<Position> bin_particles`.
    pub bin_particles: Option<BufMut<'a, Position>>,
    /// `StructuredBuffer<Ellipsoid> ellipsoids`.
    pub ellipsoids: Option<Buf<'a, Ellipsoid>>,
    /// `RWStructuredBuffer<MeshKernel> bin_kernels`.
    pub bin_kernels: Option<BufMut<'a, MeshKernel>>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Option<Uniform<'a, MeshParams>>,
}

impl Kernel for ScatterBins<'_> {
    const STAGE: &'static str = "scatter_bins";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.anisotropic { &SCATTER_BINS_WITH_ANISOTROPIC } else { &SCATTER_BINS }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bin_slots", Some(self.bin_slots.id)),
                ("bin_starts", Some(self.bin_starts.id)),
                ("step_state", Some(self.step_state.id)),
                ("positions", self.positions.as_ref().map(|bound| bound.id)),
                ("bin_particles", self.bin_particles.as_ref().map(|bound| bound.id)),
                ("ellipsoids", self.ellipsoids.as_ref().map(|bound| bound.id)),
                ("bin_kernels", self.bin_kernels.as_ref().map(|bound| bound.id)),
                ("mesh", self.mesh.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&SCATTER_BINS, &SCATTER_BINS_WITH_ANISOTROPIC];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "bin_slots", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "positions", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo {
        name: "bin_particles",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "bin_slots", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 8 } },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "step_state", slot: 2, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "ellipsoids", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 32 } },
    BindingInfo {
        name: "bin_kernels",
        slot: 4,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 48 },
    },
    BindingInfo { name: "mesh", slot: 5, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_scatter_bins.deflate"));

static SCATTER_BINS: Module = Module {
    name: "ScatterBins",
    entry: "ScatterBins",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2676 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/scatter_bins.compute",
    hash: "8a53b408961655617e9d557b5def77bb197dac47b6ac377453f1bdb191ee8592",
};

static SCATTER_BINS_WITH_ANISOTROPIC: Module = Module {
    name: "ScatterBins+ANISOTROPIC",
    entry: "ScatterBins",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 2676, bytes: 8096 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/scatter_bins.compute",
    hash: "8ee71d4b5048a0f31acbfa349e9b94dd519fcbb8f93f5848310d7521e1c9ca3e",
};
