//! How spray, foam and bubbles look.

use brooklet_fluid::Scene;
use brooklet_kernels::DiffuseStyle;

/// How diffuse particles look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiffuseLook {
    /// Radius of one that is drawn, m.
    pub radius_m: f64,
    /// Optical depth at the middle of one.
    pub opacity: f64,
    /// The fluid's spacing, m.
    pub spacing_m: f64,
    /// For how long it fades before its end, s.
    pub fade_s: f64,
}

impl DiffuseLook {
    /// That of a scene's, if it has any.
    pub fn for_scene(scene: &Scene) -> Option<Self> {
        let diffuse = scene.diffuse_particles()?;
        let spacing_m = scene.fitted_spacing_m();
        Some(Self { radius_m: 0.14 * spacing_m, opacity: 1.1, spacing_m, fade_s: 0.35 * diffuse.lifetime_s })
    }

    /// What the shaders are told.
    pub fn style(&self) -> DiffuseStyle {
        DiffuseStyle {
            radius_m: self.radius_m as f32,
            opacity: self.opacity as f32,
            spacing_m: self.spacing_m as f32,
            fade_s: self.fade_s as f32,
        }
    }
}
