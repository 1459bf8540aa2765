//! How much fluid the eye and the sun look through.

use brooklet_gpu::{Blend, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DrawSunThickness, DrawSunThicknessVariant, DrawThickness, DrawThicknessVariant, Format, FrameLight,
    FrameView, SurfaceParams, Texture,
};

use super::Shapes;

/// How much fluid the eye and the sun look through, in spacings.
#[derive(Debug)]
pub struct Thickness {
    /// In the picture, at `thickness_divisor` pixels a texel; `R16Float`.
    pub eye: Texture,
    /// In the sun's map; `R16Float`.
    pub sun: Texture,
}

/// From where thickness is looked at, and how finely.
pub(crate) struct SeenBy<'a> {
    pub view: &'a Buffer<FrameView>,
    pub size_px: [u32; 2],
    pub light: &'a Buffer<FrameLight>,
    pub sun_texels: u32,
}

/// Records both. `R16Float` blends and filters on every tier.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    shapes: &Shapes<'_>,
    params: &Buffer<SurfaceParams>,
    seen_by: &SeenBy<'_>,
) -> Thickness {
    let (positions, ellipsoids, surface) = (shapes.positions(), shapes.ellipsoids(), params.uniform());
    let add = DrawState { blend: Blend::Additive, ..DrawState::default() };
    let ellipsoid_centers = ellipsoids.is_some();
    let eye = resources.texture("thickness", Format::R16Float, seen_by.size_px);
    let variant = DrawThicknessVariant { ellipsoid_centers };
    shapes.slots().draw(
        recording,
        &DrawThickness { variant, positions, ellipsoids, view: seen_by.view.uniform(), surface },
        &Targets { color: vec![(&eye, Load::Clear([0.0; 4]))], depth: None },
        add,
    );
    let sun = resources.texture("sun_thickness", Format::R16Float, [seen_by.sun_texels; 2]);
    let variant = DrawSunThicknessVariant { ellipsoid_centers };
    shapes.slots().draw(
        recording,
        &DrawSunThickness { variant, positions, ellipsoids, light: seen_by.light.uniform(), surface },
        &Targets { color: vec![(&sun, Load::Clear([0.0; 4]))], depth: None },
        add,
    );
    Thickness { eye, sun }
}
