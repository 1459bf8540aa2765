//! Sunlight on the floor, bent by the water's surface and carried there photon by photon: photon geometry without noise.
//!
//! A grid over the sun's map meets the water as the sun sees it (`surface/sun_depth.hlsl`, `smooth_sun_depth.hlsl`), Snell
//! bends each photon to the floor (`refract_photons.compute`, evened out by `smooth_photons.compute`), and its light is a
//! tent there (`caustics.hlsl`). Photons that met no water are not drawn: the floor adds their bilinear mean
//! (`frame/floor.hlsl`).

use brooklet_gpu::{Blend, DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    AlongKeyword, Buffer, DrawCaustics, DrawSmoothSunDepth, DrawSmoothSunDepthVariant, DrawSunDepth,
    DrawSunDepthVariant, FrameLight, Photon, RefractPhotons, SmoothPhotons, SmoothPhotonsVariant, SurfaceParams,
    Texture, Tier, WaterStyle,
};

use super::options::SUN_SMOOTHINGS;
use super::{ON_FLUID, Shapes};
use crate::formats;

/// The light that the sun's map brings to the floor, and what it was made from.
#[derive(Debug)]
pub struct Caustics {
    /// Shadow depth of the particles' shapes that sunlight meets at each cell of the photons' grid; 0 where no
    /// fluid is. `R32Float`.
    pub raw: Texture,
    /// The same after smoothing.
    pub sun_depth: Texture,
    /// A photon for each cell of the grid, rows from the top, as its own place bends it,
    pub bent: Buffer<Photon>,
    /// and as those around it are bent.
    pub photons: Buffer<Photon>,
    /// Light that photons brought, over the sun's own, in the sun's map; `Rgba16Float`. Where no water stands
    /// before the sun its light is to be added.
    pub light: Texture,
}

/// What a picture has already of the sun and the water.
pub(crate) struct Sunlit<'a> {
    pub light: &'a Buffer<FrameLight>,
    pub params: &'a Buffer<SurfaceParams>,
    pub water: &'a Buffer<WaterStyle>,
    pub sun_thickness: &'a Texture,
}

/// Records the caustics of particles from `photons` photons a side.
pub(crate) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    shapes: &Shapes<'_>,
    sunlit: &Sunlit<'_>,
    (photons, tier): (u32, Tier),
) -> Caustics {
    let (light, surface) = (sunlit.light.uniform(), sunlit.params.uniform());
    // R32Float is renderable on every tier, and what follows only loads it.
    let map = |resources: &mut Resources, label| resources.texture_in(label, formats::DEPTH, [photons; 2]);
    let raw = map(resources, "sun_depth");
    let half_smoothed = map(resources, "half_smoothed_sun_depth");
    let smoothed = map(resources, "smoothed_sun_depth");
    let covered = resources.texture_in("sun_covered", formats::depth_buffer(tier), [photons; 2]);
    shapes.slots().draw(
        recording,
        &DrawSunDepth {
            variant: DrawSunDepthVariant { shape: shapes.keyword() },
            positions: shapes.positions(),
            list_heads: shapes.list_heads(),
            ellipsoids: shapes.ellipsoids(),
            light,
            surface,
        },
        &Targets { color: vec![(&raw, Load::Clear([0.0; 4]))], depth: Some((&covered, Load::Clear(0.0))) },
        DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() },
    );
    let mut from = &raw;
    for _ in 0..SUN_SMOOTHINGS {
        for (along, to) in [(AlongKeyword::AlongX, &half_smoothed), (AlongKeyword::AlongY, &smoothed)] {
            let variant = DrawSmoothSunDepthVariant { along };
            recording.draw(
                &DrawSmoothSunDepth { variant, sun_depth: from.read(), light, surface },
                &Targets { color: vec![(to, Load::Clear([0.0; 4]))], depth: Some((&covered, Load::Keep)) },
                ON_FLUID,
                3,
                1,
            );
            from = to;
        }
    }
    let count = photons * photons;
    let [mut bent, mut half_smoothed, mut photons] =
        ["bent_photons", "half_smoothed_photons", "photons"].map(|label| resources.buffer(label, count));
    recording.dispatch(
        &RefractPhotons {
            sun_depth: smoothed.read(),
            sun_thickness: sunlit.sun_thickness.read(),
            photons: bent.write(),
            light,
            surface,
        },
        count,
    );
    let mut smooth = |along, from: &Buffer<Photon>, to: &mut Buffer<Photon>| {
        let variant = SmoothPhotonsVariant { along };
        let (sun_depth, photons) = (smoothed.read(), from.read());
        let kernel = SmoothPhotons { variant, sun_depth, photons, smoothed_photons: to.write(), light, surface };
        recording.dispatch(&kernel, count);
    };
    smooth(AlongKeyword::AlongX, &bent, &mut half_smoothed);
    smooth(AlongKeyword::AlongY, &half_smoothed, &mut photons);
    // Rgba16Float blends and filters on every tier.
    let map = resources.texture_in("caustics", formats::LIGHT, sunlit.sun_thickness.size_px);
    recording.draw(
        &DrawCaustics { photons: photons.read(), light, surface, water: sunlit.water.uniform() },
        &Targets { color: vec![(&map, Load::Clear([0.0; 4]))], depth: None },
        DrawState { blend: Blend::Additive, ..DrawState::default() },
        6 * count,
        1,
    );
    Caustics { raw, sun_depth: smoothed, bent, photons, light: map }
}
