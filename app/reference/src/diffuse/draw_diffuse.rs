//! Diffuse particles as optical depth. (Shader: `diffuse/diffuse.hlsl`.)

use brooklet_kernels::{BUBBLE_ABOVE, DiffuseStyle, FrameView, SPRAY_BELOW, WaterStyle};
use glam::{DVec2, DVec3, DVec4};

use super::Particle;

const SPRAY_SIZE: f64 = 0.6;
const LEAST_PX: f64 = 0.7;
const BUBBLE_OPACITY: f64 = 0.35;

/// What they are drawn in: inverse depth along the view of each pixel's water, 0 where there is none, and of what is opaque.
#[derive(Clone, Copy, Debug)]
pub struct Behind<'a> {
    /// The water's, 1/m.
    pub water: &'a [f64],
    /// The opaque scene's, 1/m.
    pub scene: &'a [f64],
    /// Pixels along each side.
    pub size_px: [usize; 2],
}

/// Colour times optical depth, and optical depth, of each pixel.
pub fn draw_diffuse(
    particles: &[Particle],
    behind: &Behind<'_>,
    view: &FrameView,
    style: &DiffuseStyle,
    water: &WaterStyle,
) -> Vec<DVec4> {
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let [width, height] = behind.size_px;
    let size = DVec2::new(width as f64, height as f64);
    let mut light = vec![DVec4::ZERO; width * height];
    for particle in particles.iter().filter(|particle| particle.lifetime_s > 0.0) {
        let offset_m = particle.position_m - vector(view.eye_m);
        let away_m = offset_m.dot(vector(view.forward));
        if away_m <= 1.5 * f64::from(view.near_m) {
            continue;
        }
        let tangents = DVec2::new(view.tan_half_width.into(), view.tan_half_height.into());
        let ndc = DVec2::new(offset_m.dot(vector(view.right)), offset_m.dot(vector(view.up))) / away_m / tangents;
        let middle_px = (ndc * DVec2::new(0.5, -0.5) + 0.5) * size;

        let t = (particle.crowd / f64::from(SPRAY_BELOW)).clamp(0.0, 1.0);
        let bigger = SPRAY_SIZE + (1.0 - SPRAY_SIZE) * t * t * (3.0 - 2.0 * t);
        let radius_px = f64::from(style.radius_m) * bigger / (away_m * f64::from(view.pixel_angle));
        let drawn_px = radius_px.max(LEAST_PX);
        let is_bubble = particle.crowd > f64::from(BUBBLE_ABOVE);
        let depth = f64::from(style.opacity)
            * if is_bubble { BUBBLE_OPACITY } else { 1.0 }
            * (particle.lifetime_s / f64::from(style.fade_s)).min(1.0)
            * (radius_px / drawn_px).powi(2);
        let range = |at: f64, most: usize| {
            ((at - drawn_px - 1.0).max(0.0) as usize).min(most)..((at + drawn_px + 1.0).max(0.0) as usize).min(most)
        };
        for y in range(middle_px.y, height) {
            for x in range(middle_px.x, width) {
                let off = (DVec2::new(x as f64 + 0.5, y as f64 + 0.5) - middle_px) / drawn_px;
                let inside = (1.0 - off.length_squared()).max(0.0).powi(2);
                let pixel = y * width + x;
                if inside == 0.0 || 1.0 / away_m <= behind.scene[pixel] {
                    continue;
                }
                let under_m = match behind.water[pixel] {
                    0.0 => 0.0,
                    surface => (away_m - 1.0 / surface - f64::from(style.spacing_m)).max(0.0),
                };
                let tint = (-2.0 * under_m * vector(water.absorption_per_m)).exp();
                let seen = depth * inside * (-f64::from(water.scatter_per_m) * under_m).exp();
                light[pixel] += (tint * seen).extend(seen);
            }
        }
    }
    light
}
