//! Which method the next picture's surface is drawn by: a mesh, whose price grows with the particles, or screen space,
//! whose price grows with the pixels that the fluid covers.
//!
//! The measured prices (`app/render/SURFACES.md`) cross where the covered pixels are a number of their own and so many more a
//! particle. Coming nearer covers more pixels, so that this tells the distance and the picture's size as well.

use brooklet_fluid::Scene;
use brooklet_kernels::Tier;

use crate::{RenderError, View};

/// Drawn pixels a particle at which both methods cost the same, less those that a mesh of nothing costs: measured on a
/// desktop's driver,
const DESKTOP_PX_PER_PARTICLE: f64 = 1.2;
/// and of phones, whose GPUs shade a pixel faster than they sort particles, from figures of others: a mesh below 5,000
/// particles, screen space above 10,000, with some 300,000 pixels of fluid.
const MOBILE_PX_PER_PARTICLE: f64 = 30.0;
/// The method changes at so many times the pixels, or as much fewer: a fluid that sloshes at the limit changes nothing.
const HYSTERESIS: f64 = 1.25;
/// Pictures over which one method's fades into the other's.
const FADED_PICTURES: f64 = 12.0;

/// How the method is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AutoOptions {
    /// Drawn pixels of fluid above which it is meshed: so many,
    pub least_px: f64,
    /// and so many more for each particle.
    pub px_per_particle: f64,
}

impl AutoOptions {
    /// What a scene asks for, on a device of `tier`.
    pub fn for_scene(scene: &Scene, tier: Tier) -> Self {
        let px_per_particle = scene.surface.auto.px_per_particle.unwrap_or(match tier {
            Tier::Desktop => DESKTOP_PX_PER_PARTICLE,
            Tier::Mobile | Tier::Floor => MOBILE_PX_PER_PARTICLE,
        });
        Self { least_px: scene.surface.auto.least_px, px_per_particle }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// When an option is not allowed; the error names it.
    pub fn check(&self) -> Result<(), RenderError> {
        let allowed = "must be 0 or more, and finite";
        let not_negative = |field, value: f64| {
            let is_allowed = value.is_finite() && value >= 0.0;
            is_allowed.then_some(()).ok_or(RenderError::not_allowed(field, value, allowed))
        };
        not_negative("least_px", self.least_px)?;
        not_negative("px_per_particle", self.px_per_particle)
    }
}

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shown {
    /// The surface in screen space.
    ScreenSpace,
    /// The mesh.
    Mesh,
    /// Both, the mesh's picture over the other with this opacity, above 0 and below 1.
    Both(f64),
}

impl Shown {
    /// As scenes call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::ScreenSpace => "screen-space",
            Self::Mesh => "marching-cubes",
            Self::Both(_) => "both",
        }
    }
}

/// The choice from picture to picture.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceChoice {
    options: AutoOptions,
    /// What it goes to; none before the first picture.
    meshes: Option<bool>,
    /// How far the mesh's picture is faded in.
    opacity: f64,
}

impl SurfaceChoice {
    /// Before the first picture.
    pub fn new(options: AutoOptions) -> Self {
        Self { options, meshes: None, opacity: 0.0 }
    }

    /// The same with other options.
    pub fn with(self, options: AutoOptions) -> Self {
        Self { options, ..self }
    }

    /// How it chooses.
    pub fn options(&self) -> AutoOptions {
        self.options
    }

    /// What the next picture shows of `particles` that cover so many drawn pixels. `fades`: it follows the last one closely
    /// enough for a change to be seen; otherwise it changes at once, as the first one does.
    pub fn next(&mut self, covered_px: f64, particles: u32, fades: bool) -> Shown {
        let AutoOptions { least_px, px_per_particle } = self.options;
        // No fluid has no limit to be above.
        let ratio = covered_px / (least_px + px_per_particle * f64::from(particles)).max(1.0);
        let meshes = match self.meshes {
            None => ratio >= 1.0,
            Some(true) => ratio >= 1.0 / HYSTERESIS,
            Some(false) => ratio > HYSTERESIS,
        };
        let (goal, step) = if meshes { (1.0, 1.0) } else { (0.0, -1.0) };
        let moves = fades && self.meshes.is_some();
        self.opacity = if moves { (self.opacity + step / FADED_PICTURES).clamp(0.0, 1.0) } else { goal };
        self.meshes = Some(meshes);
        // A step of rounding is no step.
        if (self.opacity - goal).abs() < 0.5 / FADED_PICTURES {
            self.opacity = goal;
        }
        match self.opacity {
            0.0 => Shown::ScreenSpace,
            1.0 => Shown::Mesh,
            opacity => Shown::Both(opacity),
        }
    }
}

/// Drawn pixels that so many particles cover which lie together, as seen from the view's eye: as the face of a cube of
/// them, at most the whole picture. For the first picture, before anything was counted.
pub fn expected_cover_px(view: &View, supersample: u32, spacing_m: f64, particles: u32) -> f64 {
    let [width_px, height_px] = view.size_px.map(|side| f64::from(side * supersample));
    let distance_m = (view.camera.target_m - view.camera.eye_m).length();
    let spacing_px = 0.5 * height_px * spacing_m / (distance_m * view.tan_half().y);
    (f64::from(particles).powf(2.0 / 3.0) * spacing_px * spacing_px).min(width_px * height_px)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Camera;
    use glam::DVec3;

    fn choice() -> SurfaceChoice {
        SurfaceChoice::new(AutoOptions { least_px: 1000.0, px_per_particle: 3.0 })
    }

    #[test]
    fn many_pixels_a_particle_are_meshed() {
        assert_eq!(choice().next(4000.0, 1000, true), Shown::Mesh);
        assert_eq!(choice().next(3999.0, 1000, true), Shown::ScreenSpace);
        assert_eq!(choice().next(0.0, 0, true), Shown::ScreenSpace);
    }

    #[test]
    fn a_change_takes_more_than_the_limit_and_fades() {
        let mut choice = choice();
        assert_eq!(choice.next(3000.0, 1000, true), Shown::ScreenSpace);
        for covered_px in [4100.0, 3900.0, 4900.0] {
            assert_eq!(choice.next(covered_px, 1000, true), Shown::ScreenSpace);
        }
        let mut last = 0.0;
        for _ in 1..12 {
            let Shown::Both(opacity) = choice.next(5100.0, 1000, true) else { panic!("no fade") };
            assert!(opacity > last && opacity - last < 0.1, "{opacity} after {last}");
            last = opacity;
        }
        for covered_px in [5100.0, 4100.0, 3900.0, 3300.0] {
            assert_eq!(choice.next(covered_px, 1000, true), Shown::Mesh);
        }
        assert!(matches!(choice.next(3100.0, 1000, true), Shown::Both(opacity) if opacity > 0.9));
        // It turns back where it is.
        assert!(matches!(choice.next(3100.0, 1000, true), Shown::Both(_)));
        assert!(matches!(choice.next(6000.0, 1000, true), Shown::Both(_)));
        assert_eq!(choice.next(6000.0, 1000, true), Shown::Mesh);
    }

    #[test]
    fn pictures_far_apart_change_at_once() {
        let mut choice = choice();
        assert_eq!(choice.next(3000.0, 1000, false), Shown::ScreenSpace);
        assert_eq!(choice.next(5100.0, 1000, false), Shown::Mesh);
        assert_eq!(choice.next(3100.0, 1000, false), Shown::ScreenSpace);
    }

    #[test]
    fn a_cube_of_particles_is_expected_to_show_a_face() {
        let camera = Camera {
            eye_m: DVec3::new(0.0, 0.0, 4.0),
            target_m: DVec3::ZERO,
            fov_deg: 2.0 * 0.5_f64.atan().to_degrees(),
        };
        let view = View { camera, domain_min_m: -DVec3::ONE, domain_max_m: DVec3::ONE, size_px: [300, 200] };
        // 400 drawn pixels span 4 m: 1000 particles of 0.1 m show a square of 1 m.
        let px = expected_cover_px(&view, 2, 0.1, 1000);
        assert!((px - 10_000.0).abs() < 1e-6, "{px}");
        assert_eq!(expected_cover_px(&view, 2, 10.0, 1000), 600.0 * 400.0);
    }
}
