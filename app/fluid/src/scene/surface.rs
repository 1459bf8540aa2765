//! How a scene's fluid is drawn.

use serde::{Deserialize, Serialize};

/// What pictures show of the fluid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum SurfaceMethod {
    /// Water: the particles' surface, smoothed in screen space (van der Laan, Green & Sainz 2009).
    #[default]
    ScreenSpace,
    /// Water: the particles' surface as a mesh (Lorensen & Cline 1987).
    MarchingCubes,
    /// Water: whichever of the two costs less for the particles that there are and the pixels that they cover.
    Auto,
    /// The particles themselves, as balls.
    Points,
    /// Nothing. Safe to choose wherever nobody looks at the fluid.
    None,
}

/// What smooths the surface in screen space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Smoothing {
    /// The narrow-range filter (Truong & Yuksel 2018), one direction after the other.
    #[default]
    NarrowRange,
    /// Curvature flow (van der Laan, Green & Sainz 2009); its reach is bounded by its iterations.
    CurvatureFlow,
    /// A bilateral filter, one direction after the other.
    Bilateral,
    /// The bilateral filter itself: its price grows with the square of its reach.
    #[serde(rename = "bilateral-2d")]
    Bilateral2d,
    /// A Gaussian, which runs near surfaces into far ones: the baseline.
    Gaussian,
    /// The particles' spheres as they are.
    None,
}

impl Smoothing {
    /// How often it is applied where the scene does not say.
    pub fn default_iterations(self) -> u32 {
        match self {
            Self::CurvatureFlow => 60,
            Self::Bilateral | Self::Bilateral2d | Self::Gaussian | Self::NarrowRange => 1,
            Self::None => 0,
        }
    }
}

/// What a particle's colour tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum PointColor {
    /// Its speed, from deep blue at rest to white foam.
    #[default]
    Speed,
    /// Its fluid.
    Fluid,
    /// Its density: blue below the rest density, white at it, red above.
    Density,
}

/// How a meshed surface is made (`method = "marching-cubes"`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct MeshSettings {
    /// Least side of a cell, over the spacing. Cells are as many as fit the domain, so that walls stand between them.
    pub cell_ratio: f64,
    /// Cells along the domain's longest side, for a grid that is looked at everywhere: cheaper where it is small, as the
    /// 80 x 40 x 40 of phones. 0: cells by `cell_ratio`, looked at where the surface may be.
    pub dense_cells: u32,
    /// Whether the field is made of the particles' ellipsoids (`surface.anisotropic`, Yu & Turk 2013): flatter, with
    /// smoother normals, at several times the price. Otherwise it is that of Zhu & Bridson 2005.
    pub anisotropic: bool,
    /// How often each normal becomes the mean of those around it, weighted by distance and by how little they differ
    /// (bilateral: Jones, Durand & Zwicker 2004). Edges stay sharp; 0 leaves it out.
    pub smooth_normals: u32,
    /// Into how many parts each side of a triangle is cut, along curves (PN triangles: Vlachos, Peters, Boyd & Mitchell
    /// 2001); 1 leaves it out.
    pub subdivide: u32,
}

impl Default for MeshSettings {
    fn default() -> Self {
        Self { cell_ratio: 0.5, dense_cells: 0, anisotropic: false, smooth_normals: 4, subdivide: 1 }
    }
}

/// When the fluid is meshed (`method = "auto"`): when it covers more drawn pixels than `least_px` and `px_per_particle` for
/// each of its particles. By default that is where both methods took the same time (`app/render/SURFACES.md`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct AutoSettings {
    /// Below so many drawn pixels nothing is meshed.
    pub least_px: f64,
    /// How many more each particle takes. Default: 1.2 at the desktop tier, 30 at the others.
    pub px_per_particle: Option<f64>,
}

impl Default for AutoSettings {
    fn default() -> Self {
        Self { least_px: 60_000.0, px_per_particle: None }
    }
}

/// How the fluid is drawn. What is off has no pass, no buffer and no code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Surface {
    /// What pictures show of the fluid.
    pub method: SurfaceMethod,
    /// What smooths the surface.
    pub smoothing: Smoothing,
    /// How often it is applied; default: 60 times for `curvature-flow`, else once.
    pub iterations: Option<u32>,
    /// How far smoothing reaches, over the spacing: the same in the world at any distance and
    /// resolution, up to 64 drawn pixels.
    pub smoothing_ratio: f64,
    /// Radius of the spheres that the surface is made of, over the spacing. More closes holes and
    /// thickens spray.
    pub radius_ratio: f64,
    /// Whether a particle is drawn as an ellipsoid that its neighbours stretch (Yu & Turk 2013), which
    /// closes flat surfaces and straightens silhouettes; a sphere otherwise.
    pub anisotropic: bool,
    /// What the water takes of red, green and blue light, 1/m (Beer-Lambert). Default: clear blue
    /// water at the domain's size.
    pub absorption_per_m: Option<[f64; 3]>,
    /// Whether sunlight is bent onto the floor photon by photon, into bright lines and webs (caustics);
    /// otherwise the fluid only casts a tinted shadow. Default: on at the desktop tier, off at the others.
    /// Safe to drop anywhere: it changes the floor's light alone.
    pub caustics: Option<bool>,
    /// Whether the water shades itself: where the sun reaches it through other water, below a drop or
    /// behind a column, it and its highlight are darker (Beer-Lambert). Default: on at the desktop tier, off at
    /// the others. Safe to drop anywhere: it changes the water's own light alone.
    pub self_shadow: Option<bool>,
    /// How much of water's refraction bends what is seen through it: 0 none, 1 all.
    pub refraction: f64,
    /// Makes the fluid a metal: the share of red, green and blue light that it reflects, seen straight on (F0; mercury's is
    /// [0.78, 0.78, 0.78]). No light passes it, so nothing is refracted, absorbed or bent onto the floor.
    pub metal_reflectance: Option<[f64; 3]>,
    /// What the colours of `points` tell.
    pub color_by: PointColor,
    /// How a meshed surface is made.
    pub mesh: MeshSettings,
    /// When `auto` meshes it.
    pub auto: AutoSettings,
}

impl Default for Surface {
    fn default() -> Self {
        Self {
            method: SurfaceMethod::default(),
            smoothing: Smoothing::default(),
            iterations: None,
            smoothing_ratio: 2.0,
            radius_ratio: 0.75,
            anisotropic: true,
            absorption_per_m: None,
            caustics: None,
            self_shadow: None,
            refraction: 1.0,
            metal_reflectance: None,
            color_by: PointColor::default(),
            mesh: MeshSettings::default(),
            auto: AutoSettings::default(),
        }
    }
}

impl Surface {
    /// How often smoothing is applied.
    pub fn iterations(&self) -> u32 {
        self.iterations.unwrap_or(self.smoothing.default_iterations())
    }
}
