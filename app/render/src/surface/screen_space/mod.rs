//! Screen-space fluid rendering (van der Laan, Green & Sainz 2009): the particles' spheres, or ellipsoids, as seen
//! from the eye, smoothed in the picture, shaded as water over what lies behind.
//!
//! [`record`] alone gives a smoothed surface and its normals as textures, of any particles and
//! camera; a picture records the water on top of it.

pub mod anisotropy;
mod options;
mod smoothing;
mod water;

use brooklet_gpu::{Blend, DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DrawFluidDepth, DrawFluidDepthVariant, DrawSunThickness, DrawSurfaceNormals, DrawThickness, Format,
    FrameLight, FrameView, SprayOrEllipsoidsKeyword, SurfaceParams, Texture, Tier,
};

use super::Particles;
pub use options::ScreenSpaceOptions;
pub(crate) use water::{Water, record as record_water};

/// The surface as the eye sees it.
///
/// A *nearness* is 1 / distance along the direction of view, in 1/m, and 0 where no fluid is: planes
/// are linear in it, so filters leave them as they are (shader: `surface/nearness.hlsl`).
#[derive(Debug)]
pub struct SmoothedSurface {
    /// Nearness of the particles' spheres, `R32Float`.
    pub raw: Texture,
    /// The same after smoothing; `raw` itself where nothing smooths.
    pub nearness: Texture,
    /// Unit normals toward the eye in world axes, alpha 1 on the fluid; `Rgba32Float`. Left out of
    /// a plan unless wanted: the water restores them where it shades.
    pub normals: Texture,
    /// The spheres' depth buffer: what later draws over the fluid test against.
    pub(crate) covered: Texture,
    /// The settings on the GPU.
    pub params: Buffer<SurfaceParams>,
}

/// Draws over the fluid's pixels alone: their depth is above 0, where the covering triangle stands.
/// The test runs before the shader, so what no fluid covers costs next to nothing.
pub(crate) const ON_FLUID: DrawState = DrawState {
    depth_test: DepthTest::Less,
    depth_write: false,
    topology: brooklet_gpu::Topology::TriangleList,
    cull: brooklet_gpu::Cull::None,
    blend: Blend::None,
};

/// Records the surface of particles as `view` sees it, in a picture of `size_px`
/// drawn pixels. `init` uploads the settings and runs once before.
pub fn record(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    view: &Buffer<FrameView>,
    particles: &Particles<'_>,
    size_px: [u32; 2],
    tier: Tier,
    options: &ScreenSpaceOptions,
) -> SmoothedSurface {
    let mut params = resources.state("surface_params", 1);
    init.upload(&mut params, &[options.params()]);
    let depth_format = if tier == Tier::Floor { Format::Depth24Plus } else { Format::Depth32Float };
    // R32Float is renderable on every tier; nobody filters or blends it.
    let raw = resources.texture("fluid_nearness", Format::R32Float, size_px);
    let covered = resources.texture("fluid_depth", depth_format, size_px);
    let view = view.uniform();
    let ellipsoids = particles
        .neighbours
        .filter(|_| options.anisotropic && particles.count > 0)
        .map(|neighbours| anisotropy::record(resources, (init, recording), particles, neighbours, options));
    let spray = particles.neighbours.filter(|_| ellipsoids.is_none());
    let spray_or_ellipsoids = match (&ellipsoids, spray) {
        (Some(_), _) => SprayOrEllipsoidsKeyword::Ellipsoids,
        (None, Some(_)) => SprayOrEllipsoidsKeyword::Spray,
        (None, None) => SprayOrEllipsoidsKeyword::Off,
    };
    recording.draw(
        &DrawFluidDepth {
            variant: DrawFluidDepthVariant { spray_or_ellipsoids },
            positions: ellipsoids.is_none().then(|| particles.positions.read()),
            list_heads: spray.map(|neighbours| neighbours.heads.read()),
            ellipsoids: ellipsoids.as_ref().map(Buffer::read),
            view,
            surface: params.uniform(),
        },
        &Targets { color: vec![(&raw, Load::Clear([0.0; 4]))], depth: Some((&covered, Load::Clear(0.0))) },
        DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() },
        3,
        particles.count,
    );
    let nearness = smoothing::record(resources, recording, view, &raw, &covered, params.uniform(), options);
    let normals = resources.texture("surface_normals", Format::Rgba32Float, size_px);
    recording.draw(
        &DrawSurfaceNormals { nearness: nearness.read(), view, surface: params.uniform() },
        &Targets { color: vec![(&normals, Load::Clear([0.0; 4]))], depth: Some((&covered, Load::Keep)) },
        ON_FLUID,
        3,
        1,
    );
    SmoothedSurface { raw, nearness, normals, covered, params }
}

/// Records how much fluid each pixel looks through, in spacings, at `thickness_divisor` drawn
/// pixels a texel, and how much the sun does. `R16Float` blends and filters on every tier.
pub(crate) fn record_thickness(
    resources: &mut Resources,
    recording: &mut Recording,
    (view, light): (&Buffer<FrameView>, &Buffer<FrameLight>),
    particles: &Particles<'_>,
    params: &Buffer<SurfaceParams>,
    (size_px, sun_texels): ([u32; 2], u32),
) -> (Texture, Texture) {
    let add = DrawState { blend: Blend::Additive, ..DrawState::default() };
    let thickness = resources.texture("thickness", Format::R16Float, size_px);
    recording.draw(
        &DrawThickness { positions: particles.positions.read(), view: view.uniform(), surface: params.uniform() },
        &Targets { color: vec![(&thickness, Load::Clear([0.0; 4]))], depth: None },
        add,
        3,
        particles.count,
    );
    let sun_thickness = resources.texture("sun_thickness", Format::R16Float, [sun_texels; 2]);
    recording.draw(
        &DrawSunThickness { positions: particles.positions.read(), light: light.uniform(), surface: params.uniform() },
        &Targets { color: vec![(&sun_thickness, Load::Clear([0.0; 4]))], depth: None },
        add,
        3,
        particles.count,
    );
    (thickness, sun_thickness)
}
