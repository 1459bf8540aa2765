// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/mesh_normals.compute.
//! Kernels of `surface/mesh/mesh_normals.compute`.

use super::{MeshCounts, MeshKernel, MeshParams, MeshVertex, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`MeshNormals`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct MeshNormalsVariant {
    /// Keyword `ANISOTROPIC`.
    pub anisotropic: bool,
}

/// The normal of each vertex that no wall gave one: the field's gradient where the vertex is, turned outward. There are an
/// eighth as many vertices as points of the field, so it is asked here and not there.
#[derive(Debug)]
pub struct MeshNormals<'a> {
    /// Its variant.
    pub variant: MeshNormalsVariant,
    /// `StructuredBuffer<Position> bin_particles`.
    pub bin_particles: Option<Buf<'a, Position>>,
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `RWStructuredBuffer<MeshVertex> mesh_vertices`.
    pub mesh_vertices: BufMut<'a, MeshVertex>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
    /// `StructuredBuffer<MeshKernel> bin_kernels`.
    pub bin_kernels: Option<Buf<'a, MeshKernel>>,
}

impl Kernel for MeshNormals<'_> {
    const STAGE: &'static str = "mesh_normals";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.anisotropic { &MESH_NORMALS_WITH_ANISOTROPIC } else { &MESH_NORMALS }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("bin_particles", self.bin_particles.as_ref().map(|bound| bound.id)),
                ("bin_starts", Some(self.bin_starts.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("mesh_vertices", Some(self.mesh_vertices.id)),
                ("mesh", Some(self.mesh.id)),
                ("bin_kernels", self.bin_kernels.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&MESH_NORMALS, &MESH_NORMALS_WITH_ANISOTROPIC];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "bin_particles",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_counts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "mesh", slot: 4, kind: BindingKind::Uniform { bytes: 160 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "bin_kernels", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 48 } },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "mesh_counts", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 80 } },
    BindingInfo {
        name: "mesh_vertices",
        slot: 3,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "mesh", slot: 4, kind: BindingKind::Uniform { bytes: 160 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_mesh_mesh_normals.deflate"));

static MESH_NORMALS: Module = Module {
    name: "MeshNormals",
    entry: "MeshNormals",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 10612 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_normals.compute",
    hash: "52cf148eb45f58cd0174858f9adec8230a30759c7bce3624501225dd7242736f",
};

static MESH_NORMALS_WITH_ANISOTROPIC: Module = Module {
    name: "MeshNormals+ANISOTROPIC",
    entry: "MeshNormals",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 10612, bytes: 9000 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/mesh_normals.compute",
    hash: "29821e398f114f021569e5c8cade82dc7167a5ce841f7e251d36aae00618eec6",
};
