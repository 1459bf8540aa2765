//! Sky, sun and floor as what mirrors or scatters their light sees them. (Shaders: `frame/environment.hlsli`,
//! `surface/water_shading.hlsli`.)

use brooklet_kernels::{FrameLight, FrameStyle};
use glam::DVec3;

/// The sky without the sun.
pub fn sky_gradient(light: &FrameLight, direction: DVec3) -> DVec3 {
    let below = (1.0 - direction.y.clamp(0.0, 1.0)).powi(4);
    vector(light.sky_zenith).lerp(vector(light.sky_horizon), below)
}

/// The sky with the sun's glow.
pub fn sky_radiance(light: &FrameLight, direction: DVec3) -> DVec3 {
    let toward_sun = direction.dot(vector(light.to_sun)).clamp(0.0, 1.0);
    let glow = 0.08 * toward_sun.powi(6) + 0.25 * toward_sun.powi(48) + 2.0 * toward_sun.powi(900);
    sky_gradient(light, direction) + glow * vector(light.sun_color)
}

/// Diffuse light of sky and floor on what faces `normal`.
pub fn ambient_light(light: &FrameLight, floor_color: DVec3, normal: DVec3) -> DVec3 {
    let (horizon, zenith) = (vector(light.sky_horizon), vector(light.sky_zenith));
    let bounce = floor_color * (0.35 * vector(light.sun_color) + 0.3 * horizon);
    bounce.lerp(1.5 * horizon.lerp(zenith, 0.5), 0.5 + 0.5 * normal.y)
}

/// Schlick 1994.
pub fn fresnel(f0: f64, cosine: f64) -> f64 {
    f0 + (1.0 - f0) * (1.0 - cosine.clamp(0.0, 1.0)).powi(5)
}

/// What a mirrored ray meets: sky and windows, or the floor.
pub fn surroundings(light: &FrameLight, style: &FrameStyle, position_m: DVec3, direction: DVec3) -> DVec3 {
    let horizon = vector(light.sky_horizon);
    let sky = sky_radiance(light, direction) + windows(light, direction);
    let ambient = 1.5 * horizon.lerp(vector(light.sky_zenith), 0.4);
    let sun = 0.75 * f64::from(light.to_sun[1]) * vector(light.sun_color);
    let floor = vector(style.floor_color) * (sun + 0.75 * ambient);
    let away_m = position_m.y / (-direction.y).max(1e-4);
    let fade = (-(away_m / f64::from(style.floor_fade_m)).powi(2)).exp();
    sky.lerp(floor, smooth_step(0.0, 0.04, -direction.y) * fade)
}

fn windows(light: &FrameLight, direction: DVec3) -> DVec3 {
    let height = smooth_step(0.10, 0.22, direction.y) * (1.0 - smooth_step(0.50, 0.75, direction.y));
    let around = direction.x / (direction.x * direction.x + direction.z * direction.z).max(1e-6).sqrt();
    let open = 0.35 + 0.65 * smooth_step(-0.35, 0.25, around * (4.0 * around * around - 3.0));
    height * open * (1.1 * vector(light.sky_horizon) + 0.12 * vector(light.sun_color))
}

fn smooth_step(from: f64, to: f64, at: f64) -> f64 {
    let share = ((at - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

fn vector(of: [f32; 3]) -> DVec3 {
    DVec3::from_array(of.map(f64::from))
}
