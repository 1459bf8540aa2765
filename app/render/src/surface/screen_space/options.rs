//! What makes the surface, as plain numbers.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::Smoothing;
use brooklet_kernels::{SurfaceParams, Tier, WaterStyle};
use glam::DVec3;

use crate::RenderError;

/// How a surface is made of particles and shaded as water. Lengths are metres in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenSpaceOptions {
    /// Particle spacing: a particle's volume is its cube.
    pub spacing_m: f64,
    /// Radius of a particle's sphere.
    pub radius_m: f64,
    /// The fluid is cut off outside this box, relative to the domain's lowest corner: a tank's
    /// walls. Infinite where there are none.
    pub wall_bounds_m: [DVec3; 2],
    /// Whether ellipsoids are drawn where the particles' neighbours are known, else spheres.
    pub anisotropic: bool,
    /// How far the neighbours that make an ellipsoid reach: h.
    pub support_m: f64,
    /// What smooths the surface.
    pub smoothing: Smoothing,
    /// How often.
    pub iterations: u32,
    /// How far smoothing reaches (two standard deviations), the same at any distance and resolution.
    pub smoothing_m: f64,
    /// The reach in drawn pixels is clamped to this.
    pub most_reach_px: u32,
    /// Depths further apart are of different surfaces (narrow range's delta, bilateral's sigma).
    pub range_m: f64,
    /// What lies behind counts as so far behind (narrow range's mu).
    pub clamp_m: f64,
    /// Pixels of the picture a side of a texel of the thickness, 1 to 8.
    pub thickness_divisor: u32,
    /// Absorption of red, green and blue light, 1/m.
    pub absorption_per_m: DVec3,
    /// How much of water's refraction bends what is seen through it: 0 none, 1 all.
    pub refraction: f64,
    /// Of a fluid of metal, the share of red, green and blue light that it reflects at normal incidence. No light passes
    /// it: what is seen through water, and what makes that, is not there.
    pub metal_reflectance: Option<DVec3>,
    /// Photons a side of the grid over the sun's map that make caustics on the floor, up to 1024; 0 casts a
    /// tinted shadow instead, and no pass, buffer or code of caustics is there.
    pub photons: u32,
    /// Whether the water shades itself: sunlight that it meets through other water is the weaker.
    pub self_shadow: bool,
}

/// A particle's volume is spread as thickness over a disc of so many spacings.
const SPREAD_RATIO: f64 = 1.3;
/// Narrow range and bilateral: depths more than so many spheres' radii apart are two surfaces.
const RANGE_RADII: f64 = 3.0;
const CLAMP_RADII: f64 = 1.0;
/// Twice standard deviations of a filter of 64 drawn pixels: more costs much and shows little.
const MOST_REACH_PX: u32 = 64;
/// Clear water in a small tank, for a domain whose diagonal is 1 m; what is taken grows with size.
const ABSORPTION: DVec3 = DVec3::new(7.0, 1.7, 0.75);
/// What a metal takes of light over a spacing: e^-3 is left, in its shadow.
const OPAQUE: f64 = 3.0;
/// What thick water shows of its own, and how soon.
const SCATTER_COLOR: [f32; 3] = [0.006, 0.065, 0.130];
const SCATTER: f64 = 1.8;
const ROUGHNESS: f32 = 0.18;
/// A photon then lights two texels a side of a shadow map of 512.
const PHOTONS: u32 = 256;
/// How often the surface that sunlight meets is smoothed, and over how many spacings in all (two standard deviations): a
/// bump of a particle is a lens, too. Where it ends a pass along one direction leaves the columns or rows uneven among
/// themselves, and the next evens that out.
pub(super) const SUN_SMOOTHINGS: u32 = 3;
const SUN_SMOOTHING_RATIO: f64 = 4.0;

impl ScreenSpaceOptions {
    /// What a scene asks for, on a device of `tier`.
    pub fn for_scene(scene: &Scene, tier: Tier) -> Self {
        let (surface, spacing_m) = (&scene.surface, scene.fitted_spacing_m());
        let size_m = DVec3::from(scene.domain.size_m());
        let radius_m = surface.radius_ratio * spacing_m;
        let is_metal = surface.metal_reflectance.is_some();
        let clear = if is_metal { DVec3::splat(OPAQUE / spacing_m) } else { ABSORPTION / size_m.length() };
        let light_of_its_own = tier == Tier::Desktop && !is_metal;
        Self {
            spacing_m,
            radius_m,
            wall_bounds_m: scene.domain.wall_bounds_m().map(DVec3::from),
            anisotropic: surface.anisotropic,
            support_m: scene.solver.support_ratio * spacing_m,
            smoothing: surface.smoothing,
            iterations: surface.iterations(),
            smoothing_m: surface.smoothing_ratio * spacing_m,
            most_reach_px: MOST_REACH_PX,
            range_m: RANGE_RADII * radius_m,
            clamp_m: CLAMP_RADII * radius_m,
            thickness_divisor: 2,
            absorption_per_m: surface.absorption_per_m.map_or(clear, DVec3::from),
            refraction: surface.refraction,
            metal_reflectance: surface.metal_reflectance.map(DVec3::from),
            photons: if surface.caustics.unwrap_or(light_of_its_own) { PHOTONS } else { 0 },
            self_shadow: surface.self_shadow.unwrap_or(light_of_its_own),
        }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// When an option is not allowed; the error names it.
    pub fn check(&self) -> Result<(), RenderError> {
        let positive = |field, value: f64| {
            let allowed = "must be above 0 and finite";
            (value.is_finite() && value > 0.0).then_some(()).ok_or(RenderError::not_allowed(field, value, allowed))
        };
        positive("spacing_m", self.spacing_m)?;
        positive("radius_m", self.radius_m)?;
        positive("support_m", self.support_m)?;
        positive("range_m", self.range_m)?;
        positive("clamp_m", self.clamp_m)?;
        if !(self.smoothing_m.is_finite() && self.smoothing_m >= 0.0) {
            return Err(RenderError::not_allowed("smoothing_m", self.smoothing_m, "must be 0 or more, and finite"));
        }
        if !(1..=256).contains(&self.most_reach_px) {
            return Err(RenderError::not_allowed("most_reach_px", self.most_reach_px, "1 to 256 are allowed"));
        }
        if !(1..=8).contains(&self.thickness_divisor) {
            return Err(RenderError::not_allowed("thickness_divisor", self.thickness_divisor, "1 to 8 are allowed"));
        }
        if !(self.absorption_per_m.is_finite() && self.absorption_per_m.min_element() >= 0.0) {
            let value = self.absorption_per_m.to_array();
            return Err(RenderError::not_allowed("absorption_per_m", value, "must be 0 or more, and finite"));
        }
        if !(0.0..=2.0).contains(&self.refraction) {
            return Err(RenderError::not_allowed("refraction", self.refraction, "0 to 2 are allowed"));
        }
        let shares = self.metal_reflectance.unwrap_or_default();
        if !(shares.is_finite() && shares.min_element() >= 0.0 && shares.max_element() <= 1.0) {
            return Err(RenderError::not_allowed("metal_reflectance", shares.to_array(), "0 to 1 are allowed"));
        }
        if self.photons > 1024 {
            return Err(RenderError::not_allowed("photons", self.photons, "0 to 1024 are allowed"));
        }
        let [min, max] = self.wall_bounds_m;
        if min.is_nan() || max.is_nan() || !min.cmplt(max).all() {
            let value = [min.to_array(), max.to_array()];
            return Err(RenderError::not_allowed("wall_bounds_m", value, "must be a lowest and a highest corner"));
        }
        Ok(())
    }

    /// What the shaders are given.
    pub fn params(&self) -> SurfaceParams {
        // Infinities would make NaNs of rays along an axis: what is far enough is as good.
        let corner = |corner: DVec3| corner.clamp(DVec3::splat(-1e18), DVec3::splat(1e18)).as_vec3().into();
        SurfaceParams {
            wall_min_m: corner(self.wall_bounds_m[0]),
            radius_m: self.radius_m as f32,
            wall_max_m: corner(self.wall_bounds_m[1]),
            thickness_radius_m: (SPREAD_RATIO * self.spacing_m) as f32,
            spacing_m: self.spacing_m as f32,
            smoothing_m: self.smoothing_m as f32,
            most_reach_px: self.most_reach_px as f32,
            range_m: self.range_m as f32,
            clamp_m: self.clamp_m as f32,
            flow_m2: (self.smoothing_m * self.smoothing_m / (8.0 * f64::from(self.iterations.max(1)))) as f32,
            photons: self.photons as f32,
            sun_smoothing_m: (SUN_SMOOTHING_RATIO / f64::from(SUN_SMOOTHINGS).sqrt() * self.spacing_m) as f32,
        }
    }

    /// How the water looks, as the shaders are told.
    pub fn water(&self) -> WaterStyle {
        WaterStyle {
            absorption_per_m: self.absorption_per_m.as_vec3().into(),
            refraction: self.refraction as f32,
            scatter_color: SCATTER_COLOR,
            scatter_per_m: (SCATTER / ABSORPTION.x * self.absorption_per_m.x) as f32,
            roughness: ROUGHNESS,
            reflectance: self.metal_reflectance.unwrap_or_default().as_vec3().into(),
        }
    }
}
