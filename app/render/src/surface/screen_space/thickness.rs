//! How much fluid the eye and the sun look through.

use brooklet_gpu::{Blend, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DrawOpaquePlanes, DrawSunThickness, DrawSunThicknessVariant, DrawThickness, DrawThicknessVariant,
    FrameLight, FrameView, SurfaceParams, Texture,
};

use super::Shapes;
use crate::formats;

/// How much fluid the eye and the sun look through, in spacings.
#[derive(Debug)]
pub struct Thickness {
    /// In the picture before what is opaque, at `thickness_divisor` pixels a texel; `R16Float`.
    pub eye: Texture,
    /// The planes that touch what is opaque, in the same texels; `Rgba32Float` (shader: `surface/opaque_planes.hlsl`).
    pub opaque_planes: Texture,
    /// In the sun's map; `R16Float`.
    pub sun: Texture,
}

/// Records what the eye looks through in `size_px` texels, with the scene's depth in its picture, and the planes that cut
/// it. `R16Float` blends and filters on every tier.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    shapes: &Shapes<'_>,
    params: &Buffer<SurfaceParams>,
    (view, scene_depth, size_px): (&Buffer<FrameView>, &Texture, [u32; 2]),
) -> (Texture, Texture) {
    let (positions, ellipsoids, surface) = (shapes.positions(), shapes.ellipsoids(), params.uniform());
    let planes = resources.texture_in("opaque_planes", formats::PLANES, size_px);
    recording.draw(
        &DrawOpaquePlanes { scene_depth: scene_depth.read(), view: view.uniform(), surface },
        &Targets { color: vec![(&planes, Load::Clear([0.0; 4]))], depth: None },
        DrawState::default(),
        3,
        1,
    );
    let eye = resources.texture_in("thickness", formats::THICKNESS, size_px);
    let variant = DrawThicknessVariant { ellipsoid_centers: ellipsoids.is_some() };
    shapes.slots().draw(
        recording,
        &DrawThickness { variant, positions, ellipsoids, opaque_planes: planes.read(), view: view.uniform(), surface },
        &Targets { color: vec![(&eye, Load::Clear([0.0; 4]))], depth: None },
        add(),
    );
    (eye, planes)
}

/// Records what the sun looks through, in its map of `texels` a side.
pub(crate) fn record_sun(
    resources: &mut Resources,
    recording: &mut Recording,
    shapes: &Shapes<'_>,
    params: &Buffer<SurfaceParams>,
    (light, texels): (&Buffer<FrameLight>, u32),
) -> Texture {
    let (positions, ellipsoids, surface) = (shapes.positions(), shapes.ellipsoids(), params.uniform());
    let sun = resources.texture_in("sun_thickness", formats::THICKNESS, [texels; 2]);
    let variant = DrawSunThicknessVariant { ellipsoid_centers: ellipsoids.is_some() };
    shapes.slots().draw(
        recording,
        &DrawSunThickness { variant, positions, ellipsoids, light: light.uniform(), surface },
        &Targets { color: vec![(&sun, Load::Clear([0.0; 4]))], depth: None },
        add(),
    );
    sun
}

fn add() -> DrawState {
    DrawState { blend: Blend::Additive, ..DrawState::default() }
}
