// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/gather_field.compute.
//! Kernels of `surface/mesh/gather_field.compute`.

use super::{MeshCounts, MeshKernel, MeshParams, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`GatherField`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct GatherFieldVariant {
    /// Keyword `ANISOTROPIC`.
    pub anisotropic: bool,
}

/// The field at the points of the listed blocks: that of Zhu & Bridson 2005, cut where few particles are, and at walls,
/// behind which the particles are mirrored (twin and reasons: reference/src/surface/surface\_field.rs).
#[derive(Debug)]
pub struct GatherField<'a> {
    /// Its variant.
    pub variant: GatherFieldVariant,
    /// `StructuredBuffer<Position> bin_particles`.
    pub bin_particles: Option<Buf<'a, Position>>,
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> listed_blocks`.
    pub listed_blocks: Buf<'a, u32>,
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `RWStructuredBuffer<float> field_m`.
    pub field_m: BufMut<'a, f32>,
    /// `RWStructuredBuffer<uint2> block_inside`.
    pub block_inside: BufMut<'a, [u32; 2]>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
    /// `StructuredBuffer<MeshKernel> bin_kernels`.
    pub bin_kernels: Option<Buf<'a, MeshKernel>>,
}

impl Kernel for GatherField<'_> {
    const STAGE: &'static str = "gather_field";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.anisotropic { &GATHER_FIELD_WITH_ANISOTROPIC } else { &GATHER_FIELD }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bin_particles", self.bin_particles.as_ref().map(|bound| bound.id)),
                ("bin_starts", Some(self.bin_starts.id)),
                ("listed_blocks", Some(self.listed_blocks.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("field_m", Some(self.field_m.id)),
                ("block_inside", Some(self.block_inside.id)),
                ("mesh", Some(self.mesh.id)),
                ("bin_kernels", self.bin_kernels.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&GATHER_FIELD, &GATHER_FIELD_WITH_ANISOTROPIC];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "bin_particles",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "listed_blocks",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "mesh_counts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo { name: "field_m", slot: 4, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
    BindingInfo {
        name: "block_inside",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "mesh", slot: 6, kind: BindingKind::Uniform { bytes: 160 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "bin_kernels", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 48 } },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "listed_blocks",
        slot: 2,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "mesh_counts", slot: 3, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo { name: "field_m", slot: 4, kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 } },
    BindingInfo {
        name: "block_inside",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 8 },
    },
    BindingInfo { name: "mesh", slot: 6, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_gather_field.deflate"));

static GATHER_FIELD: Module = Module {
    name: "GatherField",
    entry: "GatherField",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 24528 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 64,
    tier: Tier::Floor,
    source: "surface/mesh/gather_field.compute",
    hash: "99e006e28a682f2cb6c7023e7425af90a9865a3a26abbb5d215a2b7bb1e050be",
};

static GATHER_FIELD_WITH_ANISOTROPIC: Module = Module {
    name: "GatherField+ANISOTROPIC",
    entry: "GatherField",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 24528, bytes: 19728 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 64,
    tier: Tier::Floor,
    source: "surface/mesh/gather_field.compute",
    hash: "ce26d34c6fa67a73e83f80f1c77bfa38ae2e61724255ccece9dbecc82b40926b",
};
