// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/particles.hlsl.
//! Kernels of `frame/particles.hlsl`.

use super::{FrameStyle, FrameView, Position};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, Spirv, StageKind, Tier, Uniform,
    bind_draw,
};

/// Which particle is seen in each pixel: one camera-facing triangle a particle, on which every pixel
/// meets the exact sphere, in perspective. Shading follows in draw\_shade, once a pixel: inside a
/// fluid ten spheres cover a pixel and one is seen.
#[derive(Debug)]
pub struct DrawParticles<'a> {
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
}

impl Draw for DrawParticles<'_> {
    const STAGE: &'static str = "draw_particles";

    fn vertex(&self) -> &'static Module {
        &DRAW_PARTICLES_VERTEX
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(&DRAW_PARTICLES_FRAGMENT)
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[("positions", Some(self.positions.id)), ("view", Some(self.view.id)), ("style", Some(self.style.id))],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&DRAW_PARTICLES_VERTEX, &DRAW_PARTICLES_FRAGMENT];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 1, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "style", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/frame_particles.deflate"));

static DRAW_PARTICLES_VERTEX: Module = Module {
    name: "DrawParticles.vertex",
    entry: "ParticlesVertex",
    stage: StageKind::Vertex,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 4276 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/particles.hlsl",
    hash: "d5310c8db062f33a7b532bc93f4f2e030ddc5543ce21b244e3d4261a4361be97",
};

static DRAW_PARTICLES_FRAGMENT: Module = Module {
    name: "DrawParticles.fragment",
    entry: "ParticlesFragment",
    stage: StageKind::Fragment,
    spirv: Spirv::Packed { pack: PACK, first: 4276, bytes: 2588 },
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/particles.hlsl",
    hash: "b686df355b5406695a3d9571716af529b2949f8c6c3cca48fe25249aad1739df",
};
