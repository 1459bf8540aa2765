//! The water over the scene behind it.

use brooklet_gpu::{Load, Recording, Resources, Targets};
use brooklet_kernels::{Buffer, DrawWater, DrawWaterVariant, Texture, WaterStyle};

use super::{ON_FLUID, SmoothedSurface, SunVolume};
use crate::formats;
use crate::frame::uniforms::FrameUniforms;

/// What the water is drawn from.
pub(crate) struct Water<'a> {
    pub surface: &'a SmoothedSurface,
    pub thickness: &'a Texture,
    pub style: &'a Buffer<WaterStyle>,
    /// What shades it, where it shades itself.
    pub sun_volume: Option<&'a SunVolume>,
    /// What shades it of solids, where there are any.
    pub solids_shadow_map: Option<&'a Texture>,
}

/// Records the water over `scene`, whose depth is `scene_depth`: a texture whose alpha is 1 where
/// water is seen. The scene stays as it is, since it is what the water refracts.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    uniforms: &FrameUniforms,
    water: &Water<'_>,
    (scene, scene_depth): (&Texture, &Texture),
) -> Texture {
    let seen = resources.texture_in("water", formats::LIGHT, scene.size_px);
    recording.draw(
        &DrawWater {
            variant: DrawWaterVariant {
                mesh_normals: water.surface.has_normals,
                self_shadow: water.sun_volume.is_some(),
                solids_shadow: water.solids_shadow_map.is_some(),
            },
            mesh_normals: water.surface.has_normals.then(|| water.surface.normals.read()),
            sun_volume: water.sun_volume.map(|volume| volume.above_m.read()),
            volume: water.sun_volume.map(|volume| volume.params.uniform()),
            solids_shadow_map: water.solids_shadow_map.map(Texture::read),
            view: uniforms.view.uniform(),
            inverse_depth: water.surface.inverse_depth.read(),
            thickness: water.thickness.read(),
            scene: scene.read(),
            scene_depth: scene_depth.read(),
            light: uniforms.light.uniform(),
            style: uniforms.style.uniform(),
            surface: water.surface.params.uniform(),
            water: water.style.uniform(),
        },
        &Targets { color: vec![(&seen, Load::Clear([0.0; 4]))], depth: Some((&water.surface.covered, Load::Keep)) },
        ON_FLUID,
        3,
        1,
    );
    seen
}
