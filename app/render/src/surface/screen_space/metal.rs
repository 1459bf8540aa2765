//! A fluid of metal before the scene.

use brooklet_gpu::{Load, Recording, Resources, Targets};
use brooklet_kernels::{Buffer, DrawMetal, DrawMetalVariant, Texture, WaterStyle};

use super::{ON_FLUID, SmoothedSurface};
use crate::formats;
use crate::frame::uniforms::FrameUniforms;

/// Records the metal before a scene whose depth is `scene_depth`: a texture whose alpha is 1 where metal is seen. `sun_thickness`
/// is its shadow on the floor that it mirrors.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    uniforms: &FrameUniforms,
    (surface, style, sun_thickness): (&SmoothedSurface, &Buffer<WaterStyle>, &Texture),
    (scene_depth, solids_shadow_map): (&Texture, Option<&Texture>),
) -> Texture {
    let seen = resources.texture_in("metal", formats::LIGHT, scene_depth.size_px);
    recording.draw(
        &DrawMetal {
            variant: DrawMetalVariant { mesh_normals: surface.has_normals, solids_shadow: solids_shadow_map.is_some() },
            mesh_normals: surface.has_normals.then(|| surface.normals.read()),
            solids_shadow_map: solids_shadow_map.map(Texture::read),
            view: uniforms.view.uniform(),
            inverse_depth: surface.inverse_depth.read(),
            scene_depth: scene_depth.read(),
            sun_thickness: sun_thickness.read(),
            light: uniforms.light.uniform(),
            style: uniforms.style.uniform(),
            surface: surface.params.uniform(),
            water: style.uniform(),
        },
        &Targets { color: vec![(&seen, Load::Clear([0.0; 4]))], depth: Some((&surface.covered, Load::Keep)) },
        ON_FLUID,
        3,
        1,
    );
    seen
}
