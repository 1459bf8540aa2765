// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/mesh/gather_field.compute.
//! Kernels of `surface/mesh/gather_field.compute`.

use super::{FieldPoint, MeshCounts, MeshParams, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, StageKind, Tier, Uniform, bind,
};

/// The field at the points of the listed blocks: that of Zhu & Bridson 2005, cut where few particles are, and at walls,
/// behind which the particles are mirrored (twin and reasons: reference/src/surface/surface\_field.rs). A group makes a
/// block: all of its threads look at the same particles at the same time, which is one load for a wave.
#[derive(Debug)]
pub struct GatherField<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<uint> bin_starts`.
    pub bin_starts: Buf<'a, u32>,
    /// `StructuredBuffer<uint> bin_members`.
    pub bin_members: Buf<'a, u32>,
    /// `StructuredBuffer<uint> listed_blocks`.
    pub listed_blocks: Buf<'a, u32>,
    /// `StructuredBuffer<MeshCounts> mesh_counts`.
    pub mesh_counts: Buf<'a, MeshCounts>,
    /// `RWStructuredBuffer<FieldPoint> field_points`.
    pub field_points: BufMut<'a, FieldPoint>,
    /// `ConstantBuffer<MeshParams> mesh`.
    pub mesh: Uniform<'a, MeshParams>,
}

impl Kernel for GatherField<'_> {
    const STAGE: &'static str = "gather_field";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &GATHER_FIELD
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("positions", Some(self.positions.id)),
                ("bin_starts", Some(self.bin_starts.id)),
                ("bin_members", Some(self.bin_members.id)),
                ("listed_blocks", Some(self.listed_blocks.id)),
                ("mesh_counts", Some(self.mesh_counts.id)),
                ("field_points", Some(self.field_points.id)),
                ("mesh", Some(self.mesh.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&GATHER_FIELD];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "bin_starts", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo { name: "bin_members", slot: 2, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 } },
    BindingInfo {
        name: "listed_blocks",
        slot: 3,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo { name: "mesh_counts", slot: 4, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 48 } },
    BindingInfo {
        name: "field_points",
        slot: 5,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "mesh", slot: 6, kind: BindingKind::Uniform { bytes: 96 } },
];

static GATHER_FIELD: Module = Module {
    name: "GatherField",
    entry: "GatherField",
    stage: StageKind::Compute,
    spirv: include_bytes!("../../spirv/gather_field.spv"),
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "surface/mesh/gather_field.compute",
    hash: "714416fa7f428d54ab547c7280617805ed427382ee2757baa65a6b4ef035ac2c",
};
