// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from surface/count_covered.compute.
//! Kernels of `surface/count_covered.compute`.

use super::FrameView;
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, BufMut, Kernel, Module, Spirv, StageKind, Tex, Tier,
    Uniform, bind,
};

/// How many drawn pixels show the fluid, by one in COVERED\_STRIDE x COVERED\_STRIDE of them: what the choice between a mesh and
/// screen space goes by.
#[derive(Debug)]
pub struct CountCovered<'a> {
    /// `Texture2D<float> inverse_depth`.
    pub inverse_depth: Tex<'a>,
    /// `RWStructuredBuffer<uint> covered_px`.
    pub covered_px: BufMut<'a, u32>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
}

impl Kernel for CountCovered<'_> {
    const STAGE: &'static str = "count_covered";
    const GROUP_SIZE: [u32; 3] = [8, 8, 1];

    fn module(&self) -> &'static Module {
        &COUNT_COVERED
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("inverse_depth", Some(self.inverse_depth.id)),
                ("covered_px", Some(self.covered_px.id)),
                ("view", Some(self.view.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&COUNT_COVERED];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "inverse_depth", slot: 0, kind: BindingKind::Texture { filterable: false } },
    BindingInfo {
        name: "covered_px",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 4 },
    },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/surface_count_covered.deflate"));

static COUNT_COVERED: Module = Module {
    name: "CountCovered",
    entry: "CountCovered",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 2520 },
    bindings: BINDINGS_0,
    group_size: [8, 8, 1],
    shared_bytes: 4,
    tier: Tier::Floor,
    source: "surface/count_covered.compute",
    hash: "92bb259a6728b1c446cc3a7dd1a1a392fe002e19bdeac9a8da8cd3bada42a14f",
};
