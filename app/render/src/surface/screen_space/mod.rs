//! Screen-space fluid rendering (van der Laan, Green & Sainz 2009): the particles' spheres, or ellipsoids, as seen
//! from the eye, smoothed in the picture, shaded as water over what lies behind.
//!
//! [`record`] alone gives a smoothed surface and its normals as textures, of any particles and
//! camera; a picture records the water on top of it.

pub mod anisotropy;
mod caustics;
mod metal;
mod options;
mod shapes;
mod smoothing;
pub mod sun_volume;
mod thickness;
mod water;

use brooklet_gpu::{Blend, DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DrawFluidDepth, DrawFluidDepthVariant, DrawSurfaceNormals, Ellipsoid, FrameView, MeshCounts, SurfaceParams,
    Texture, Tier,
};

use super::Particles;
use super::marching_cubes::{self, MarchingCubesOptions};
use crate::formats;
pub use caustics::Caustics;
pub(crate) use caustics::{Sunlit, record as record_caustics};
pub(crate) use metal::record as record_metal;
pub use options::ScreenSpaceOptions;
pub(crate) use shapes::Shapes;
pub use sun_volume::SunVolume;
pub use thickness::Thickness;
pub(crate) use thickness::{record as record_thickness, record_sun as record_sun_thickness};
pub(crate) use water::{Water, record as record_water};

/// The surface as the eye sees it.
///
/// The inverse depth is 1 / distance along the direction of view, in 1/m, and 0 where no fluid is: planes
/// are linear in it, so filters leave them as they are (shader: `surface/inverse_depth.hlsli`).
#[derive(Debug)]
pub struct SmoothedSurface {
    /// Inverse depth of the particles' spheres, `R32Float`.
    pub raw: Texture,
    /// The same after smoothing; `raw` itself where nothing smooths.
    pub inverse_depth: Texture,
    /// Unit normals toward the eye in world axes, alpha 1 on the fluid; `Rgba32Float`. Left out of
    /// a plan unless wanted: the water restores them where it shades.
    pub normals: Texture,
    /// The spheres' depth buffer: what later draws over the fluid test against.
    pub(crate) covered: Texture,
    /// What the particles are drawn as, where they are stretched.
    pub(crate) ellipsoids: Option<Buffer<Ellipsoid>>,
    /// Whether `normals` were drawn with the surface and are to be shaded with: a mesh's.
    pub(crate) has_normals: bool,
    /// The settings on the GPU.
    pub params: Buffer<SurfaceParams>,
    /// What a mesh came to, and what of it found no room, if it is one.
    pub mesh_counts: Option<Buffer<MeshCounts>>,
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
    let (params, ellipsoids) = settings(resources, (&mut *init, &mut *recording), particles, options);
    // R32Float is renderable on every tier; nobody filters or blends it.
    let raw = resources.texture_in("fluid_inverse_depth", formats::DEPTH, size_px);
    let covered = resources.texture_in("fluid_depth", formats::depth_buffer(tier), size_px);
    let view = view.uniform();
    let shapes = Shapes::new(particles, ellipsoids.as_ref());
    particles.slots.draw(
        recording,
        &DrawFluidDepth {
            variant: DrawFluidDepthVariant { shape: shapes.keyword() },
            positions: shapes.positions(),
            list_heads: shapes.list_heads(),
            ellipsoids: shapes.ellipsoids(),
            view,
            surface: params.uniform(),
        },
        &Targets { color: vec![(&raw, Load::Clear([0.0; 4]))], depth: Some((&covered, Load::Clear(0.0))) },
        DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() },
    );
    let inverse_depth = smoothing::record(resources, recording, view, &raw, &covered, params.uniform(), options);
    let normals = resources.texture_in("surface_normals", formats::PLANES, size_px);
    recording.draw(
        &DrawSurfaceNormals { inverse_depth: inverse_depth.read(), view, surface: params.uniform() },
        &Targets { color: vec![(&normals, Load::Clear([0.0; 4]))], depth: Some((&covered, Load::Keep)) },
        ON_FLUID,
        3,
        1,
    );
    SmoothedSurface { raw, inverse_depth, normals, covered, ellipsoids, has_normals: false, params, mesh_counts: None }
}

/// Uploads the settings, and records the ellipsoids that particles with neighbours are stretched to.
fn settings(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    particles: &Particles<'_>,
    options: &ScreenSpaceOptions,
) -> (Buffer<SurfaceParams>, Option<Buffer<Ellipsoid>>) {
    let mut params = resources.persistent("surface_params", 1);
    init.upload(&mut params, &[options.params()]);
    let ellipsoids = particles
        .neighbours
        .filter(|_| options.anisotropic && particles.slots.capacity > 0)
        .map(|neighbours| anisotropy::record(resources, (init, recording), particles, neighbours, &params, options));
    (params, ellipsoids)
}

/// Records the ellipsoids that particles with neighbours are stretched to, where the options want them.
pub fn record_ellipsoids(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    particles: &Particles<'_>,
    options: &ScreenSpaceOptions,
) -> Option<Buffer<Ellipsoid>> {
    settings(resources, (init, recording), particles, options).1
}

/// Records the surface of a mesh likewise, where `mesh` is wanted instead of smoothed depths; its normals are
/// `Rgba16Float`.
pub fn record_meshed(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    view: &Buffer<FrameView>,
    particles: &Particles<'_>,
    (size_px, tier): ([u32; 2], Tier),
    (options, mesh): (&ScreenSpaceOptions, &MarchingCubesOptions),
) -> SmoothedSurface {
    // A mesh may want ellipsoids where nothing else does.
    let options = &ScreenSpaceOptions { anisotropic: options.anisotropic || mesh.anisotropic, ..*options };
    let (params, ellipsoids) = settings(resources, (&mut *init, &mut *recording), particles, options);
    let mesh = marching_cubes::record(resources, (init, recording), (particles, ellipsoids.as_ref()), mesh);
    let drawn = marching_cubes::record_drawn(resources, recording, view, &mesh, (size_px, tier));
    SmoothedSurface {
        raw: drawn.inverse_depth.alias(),
        inverse_depth: drawn.inverse_depth,
        normals: drawn.normals,
        covered: drawn.covered,
        ellipsoids,
        has_normals: true,
        params,
        mesh_counts: Some(mesh.counts),
    }
}
