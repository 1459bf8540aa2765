//! Spray, foam and bubbles in a picture: splatted as optical depth, then over the water. (Shaders: `diffuse/diffuse.hlsl`,
//! `diffuse/foam.hlsl`.)

use brooklet_fluid::diffuse::DiffuseSlots;
use brooklet_gpu::{Blend, DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DiffuseStyle, DrawDiffuse, DrawDiffuseVariant, DrawFoam, DrawFoamVariant, Texture, WaterStyle,
};

use crate::formats;
use crate::frame::uniforms::FrameUniforms;

pub use crate::diffuse_look::DiffuseLook;

/// The water that they are in.
pub(crate) struct DiffuseWater<'a> {
    pub inverse_depth: &'a Texture,
    pub style: &'a Buffer<WaterStyle>,
    pub solids_shadow_map: Option<&'a Texture>,
}

/// Draws them over `onto`, where nothing that `depth` holds hides them; their light and optical depth.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    uniforms: &FrameUniforms,
    (slots, style): (&DiffuseSlots, &Buffer<DiffuseStyle>),
    (onto, depth): (&Texture, &Texture),
    water: Option<&DiffuseWater<'_>>,
) -> Texture {
    let light = resources.texture_in("diffuse_light", formats::LIGHT, onto.size_px);
    slots.draw(
        recording,
        &DrawDiffuse {
            variant: DrawDiffuseVariant { water: water.is_some() },
            diffuse: slots.particles.read(),
            inverse_depth: water.map(|water| water.inverse_depth.read()),
            water: water.map(|water| water.style.uniform()),
            view: uniforms.view.uniform(),
            diffuse_style: style.uniform(),
        },
        &Targets { color: vec![(&light, Load::Clear([0.0; 4]))], depth: Some((depth, Load::Keep)) },
        DrawState { depth_test: DepthTest::Greater, blend: Blend::Additive, ..DrawState::default() },
    );
    let shaded = water.and_then(|water| Some((water.inverse_depth, water.solids_shadow_map?)));
    recording.draw(
        &DrawFoam {
            variant: DrawFoamVariant { solids_shadow: shaded.is_some() },
            diffuse_light: light.read(),
            inverse_depth: shaded.map(|(inverse_depth, _)| inverse_depth.read()),
            solids_shadow_map: shaded.map(|(_, map)| map.read()),
            view: uniforms.view.uniform(),
            light: uniforms.light.uniform(),
            style: uniforms.style.uniform(),
        },
        &Targets { color: vec![(onto, Load::Keep)], depth: None },
        DrawState { blend: Blend::Alpha, ..DrawState::default() },
        3,
        1,
    );
    light
}
