//! The particles as balls: which one each pixel sees, then its colour, once a pixel.

use brooklet_gpu::{DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{Buffer, ColorKeyword, DrawParticles, DrawShade, DrawShadeVariant, DrawShadow, Texture};

use super::Particles;
use crate::formats;
use crate::frame::options::{Coloring, FrameOptions};
use crate::frame::uniforms::FrameUniforms;

/// Draws the particles' shadow map, then the particles to `radiance` and `depth`, both cleared. Solids shade them.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    (uniforms, options, solids_shadow_map): (&FrameUniforms, &FrameOptions, Option<&Texture>),
    particles: &Particles<'_>,
    (radiance, depth): (&Texture, &Texture),
) -> Texture {
    let Particles { positions, velocities, slots, .. } = *particles;
    let (view, light, style) = (uniforms.view.uniform(), uniforms.light.uniform(), uniforms.style.uniform());
    let shadow_map =
        resources.texture_in("shadow_map", formats::depth_buffer(options.tier), [options.shadow_texels; 2]);
    // R32Float holds every index below 2^24 exactly, and every tier can draw to it.
    let seen = resources.texture_in("seen", formats::DEPTH, radiance.size_px);
    let nearer = DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() };
    slots.draw(
        recording,
        &DrawShadow { positions: positions.read(), light, style },
        &Targets { color: vec![], depth: Some((&shadow_map, Load::Clear(0.0))) },
        nearer,
    );
    slots.draw(
        recording,
        &DrawParticles { positions: positions.read(), view, style },
        &Targets { color: vec![(&seen, Load::Clear([0.0; 4]))], depth: Some((depth, Load::Clear(0.0))) },
        nearer,
    );
    let color = match options.coloring {
        Coloring::Speed { .. } => ColorKeyword::Off,
        Coloring::Fluid => ColorKeyword::ColorFluid,
        Coloring::Density => ColorKeyword::ColorDensity,
    };
    let density_ratios = match (color, particles.densities, particles.neighbours) {
        (ColorKeyword::ColorDensity, Some(densities), Some(neighbours)) => {
            Some(densities.record(resources, recording, positions, neighbours))
        }
        _ => None,
    };
    recording.draw(
        &DrawShade {
            variant: DrawShadeVariant { color, solids_shadow: solids_shadow_map.is_some() },
            solids_shadow_map: solids_shadow_map.map(Texture::read),
            seen: seen.read(),
            positions: positions.read(),
            velocities: (color == ColorKeyword::Off).then(|| velocities.read()),
            density_ratios: density_ratios.as_ref().map(Buffer::read),
            shadow_map: shadow_map.read(),
            view,
            light,
            style,
        },
        &Targets { color: vec![(radiance, Load::Clear([0.0; 4]))], depth: None },
        DrawState::default(),
        3,
        1,
    );
    shadow_map
}
