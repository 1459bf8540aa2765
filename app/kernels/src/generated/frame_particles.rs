// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from frame/particles.hlsl.
//! Kernels of `frame/particles.hlsl`.

use super::{FrameLight, FrameStyle, FrameView, Position, Velocity};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, Draw, Module, StageKind, Tex, Tier, Uniform, bind_draw,
};

/// Which variant of [`DrawParticles`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawParticlesVariant {
    /// Keyword `COLOR_FLUID`.
    pub color_fluid: bool,
}

/// The particles as shaded spheres: one camera-facing triangle each, on which every pixel meets the
/// exact sphere, in perspective.
#[derive(Debug)]
pub struct DrawParticles<'a> {
    /// Its variant.
    pub variant: DrawParticlesVariant,
    /// `StructuredBuffer<Position> positions`.
    pub positions: Buf<'a, Position>,
    /// `StructuredBuffer<Velocity> velocities`.
    pub velocities: Option<Buf<'a, Velocity>>,
    /// `Texture2D<float> shadow_map`.
    pub shadow_map: Tex<'a>,
    /// `ConstantBuffer<FrameView> view`.
    pub view: Uniform<'a, FrameView>,
    /// `ConstantBuffer<FrameLight> light`.
    pub light: Uniform<'a, FrameLight>,
    /// `ConstantBuffer<FrameStyle> style`.
    pub style: Uniform<'a, FrameStyle>,
}

impl Draw for DrawParticles<'_> {
    const STAGE: &'static str = "draw_particles";

    fn vertex(&self) -> &'static Module {
        if self.variant.color_fluid { &DRAW_PARTICLES_VERTEX_WITH_COLOR_FLUID } else { &DRAW_PARTICLES_VERTEX }
    }
    fn fragment(&self) -> Option<&'static Module> {
        if self.variant.color_fluid {
            Some(&DRAW_PARTICLES_FRAGMENT_WITH_COLOR_FLUID)
        } else {
            Some(&DRAW_PARTICLES_FRAGMENT)
        }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind_draw(
            self.vertex(),
            self.fragment(),
            &[
                ("positions", Some(self.positions.id)),
                ("velocities", self.velocities.as_ref().map(|bound| bound.id)),
                ("shadow_map", Some(self.shadow_map.id)),
                ("view", Some(self.view.id)),
                ("light", Some(self.light.id)),
                ("style", Some(self.style.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[
    &DRAW_PARTICLES_VERTEX,
    &DRAW_PARTICLES_FRAGMENT,
    &DRAW_PARTICLES_VERTEX_WITH_COLOR_FLUID,
    &DRAW_PARTICLES_FRAGMENT_WITH_COLOR_FLUID,
];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "velocities", slot: 1, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 2, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 3, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 4, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 5, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_2: &[BindingInfo] = &[
    BindingInfo { name: "positions", slot: 0, kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 } },
    BindingInfo { name: "shadow_map", slot: 1, kind: BindingKind::Texture { filterable: false } },
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
];

static BINDINGS_3: &[BindingInfo] = &[
    BindingInfo { name: "view", slot: 2, kind: BindingKind::Uniform { bytes: 80 } },
    BindingInfo { name: "light", slot: 3, kind: BindingKind::Uniform { bytes: 112 } },
    BindingInfo { name: "style", slot: 4, kind: BindingKind::Uniform { bytes: 80 } },
];

static DRAW_PARTICLES_VERTEX: Module = Module {
    name: "DrawParticles.vertex",
    entry: "ParticlesVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_particles.vertex.spv"),
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/particles.hlsl",
    hash: "f7bdf883a1776ad64ecc0d6697c3c60a480ce4385b1144f461fbd96e0f362515",
};

static DRAW_PARTICLES_FRAGMENT: Module = Module {
    name: "DrawParticles.fragment",
    entry: "ParticlesFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_particles.fragment.spv"),
    bindings: BINDINGS_1,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/particles.hlsl",
    hash: "03d55047c773c69d50ac5d1f77c5623186e6d999e97cf33661c5acf9d652921f",
};

static DRAW_PARTICLES_VERTEX_WITH_COLOR_FLUID: Module = Module {
    name: "DrawParticles.vertex+COLOR_FLUID",
    entry: "ParticlesVertex",
    stage: StageKind::Vertex,
    spirv: include_bytes!("../../spirv/draw_particles.vertex+color_fluid.spv"),
    bindings: BINDINGS_2,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/particles.hlsl",
    hash: "eea7d1cf7c4b9a23ab1c2703f578cc82757e3cf70324676c750bccbce1dcb0b2",
};

static DRAW_PARTICLES_FRAGMENT_WITH_COLOR_FLUID: Module = Module {
    name: "DrawParticles.fragment+COLOR_FLUID",
    entry: "ParticlesFragment",
    stage: StageKind::Fragment,
    spirv: include_bytes!("../../spirv/draw_particles.fragment+color_fluid.spv"),
    bindings: BINDINGS_3,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "frame/particles.hlsl",
    hash: "83fac2ac6e344abcba640864f7124f50524dbf6ce825b0dece085f41151b9e48",
};
