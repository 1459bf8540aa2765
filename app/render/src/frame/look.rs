//! The look of a frame: where the sun stands, colours, sizes.

use brooklet_kernels::{FrameLight, FrameStyle, FrameView};
use glam::{DMat3, DVec3, DVec4};

use super::options::{Coloring, FrameOptions};
use crate::View;
use crate::camera::corners;

/// Toward the sun: from the left and a little behind, so that the fluid's rim is lit and its
/// shadow falls to where it is seen.
const TO_SUN: DVec3 = DVec3::new(-0.55, 0.75, -0.25);
/// Colours in linear light.
const SUN_COLOR: [f32; 3] = [3.0, 2.75, 2.4];
const SKY_ZENITH: [f32; 3] = [0.075, 0.165, 0.34];
const SKY_HORIZON: [f32; 3] = [0.33, 0.40, 0.47];
const FLOOR_COLOR: [f32; 3] = [0.27, 0.243, 0.205];
const EDGE_COLOR: [f32; 3] = [0.05, 0.09, 0.13];
const EDGE_OPACITY: f32 = 0.45;
const EDGE_WIDTH_PX: f32 = 1.3;
const EXPOSURE: f32 = 0.88;
/// How deep the sun reaches into the fluid, in radii of a particle.
const LIGHT_DEPTH_RADII: f64 = 9.0;
/// Reach of the ambient occlusion, in radii of a particle.
const OCCLUSION_RADII: f64 = 7.0;
const OCCLUSION_STRENGTH: f32 = 0.7;
/// About so many floor tiles go along the domain's longest horizontal side.
const TILES: f64 = 20.0;

/// The camera, relative to the domain's lowest corner.
pub(super) fn frame_view(view: &View, options: &FrameOptions) -> FrameView {
    let axes = view.camera.axes();
    let tan_half = view.tan_half();
    let drawn_px = view.size_px.map(|side| (side * options.supersample) as f32);
    FrameView {
        eye_m: (view.camera.eye_m - view.domain_min_m).as_vec3().into(),
        near_m: view.near_m() as f32,
        right: axes.x_axis.as_vec3().into(),
        tan_half_width: tan_half.x as f32,
        up: axes.y_axis.as_vec3().into(),
        tan_half_height: tan_half.y as f32,
        forward: (-axes.z_axis).as_vec3().into(),
        pixel_angle: 2.0 * tan_half.y as f32 / drawn_px[1],
        size_px: drawn_px,
        supersample: options.supersample as f32,
        reserved: 0.0,
    }
}

/// The sun and a shadow map that just holds the domain and the floor under it.
pub(super) fn frame_light(view: &View, options: &FrameOptions) -> FrameLight {
    let to_sun = TO_SUN.normalize();
    let right = to_sun.cross(DVec3::Y).normalize();
    let down = right.cross(to_sun);
    let light_from_world = DMat3::from_cols(right, down, to_sun).transpose();
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for corner in corners(DVec3::ZERO, view.domain_max_m - view.domain_min_m) {
        let seen = light_from_world * corner;
        low = low.min(seen);
        high = high.max(seen);
    }
    // A margin for particles on the faces, and for the taps around a point.
    let side_m = 1.06 * (high - low).truncate().max_element() + 2.0 * options.radius_m;
    let range_m = 1.1 * (high.z - low.z) + 2.0 * options.radius_m;
    let middle = 0.5 * (low + high);
    let row = |axis: DVec3, scale_m: f64, middle_m: f64| -> [f32; 4] {
        let row: DVec4 = (axis / scale_m).extend(0.5 - middle_m / scale_m);
        row.as_vec4().into()
    };
    FrameLight {
        to_sun: to_sun.as_vec3().into(),
        shadow_range_m: range_m as f32,
        sun_color: SUN_COLOR,
        shadow_texels: options.shadow_texels as f32,
        shadow_u: row(right, side_m, middle.x),
        shadow_v: row(down, side_m, middle.y),
        shadow_depth: row(to_sun, range_m, middle.z),
        sky_zenith: SKY_ZENITH,
        shadow_texel_m: (side_m / f64::from(options.shadow_texels)) as f32,
        sky_horizon: SKY_HORIZON,
        exposure: EXPOSURE,
    }
}

pub(super) fn frame_style(view: &View, options: &FrameOptions) -> FrameStyle {
    let size_m = view.domain_max_m - view.domain_min_m;
    let foam_m_s = match options.coloring {
        Coloring::Speed { foam_m_s } => foam_m_s,
        Coloring::Fluid | Coloring::Density => 1.0,
    };
    // Far enough to reach beyond the domain from wherever it is seen.
    let seen_m = (view.camera.eye_m - 0.5 * (view.domain_min_m + view.domain_max_m)).length() + view.diagonal_m();
    FrameStyle {
        domain_size_m: size_m.as_vec3().into(),
        tile_m: nice_length(size_m.x.max(size_m.z) / TILES) as f32,
        floor_color: FLOOR_COLOR,
        floor_fade_m: (1.3 * seen_m) as f32,
        radius_m: options.radius_m as f32,
        inverse_speed_scale_s_m: (1.0 / foam_m_s) as f32,
        light_depth_m: (LIGHT_DEPTH_RADII * options.radius_m) as f32,
        edge_width_px: EDGE_WIDTH_PX,
        edge_color: EDGE_COLOR,
        edge_opacity: EDGE_OPACITY,
        occlusion_m: (OCCLUSION_RADII * options.radius_m) as f32,
        occlusion_strength: OCCLUSION_STRENGTH,
        reserved: [0.0; 2],
    }
}

/// The nearest of 1, 2, 5 times a power of ten: tiles then tell lengths.
fn nice_length(length_m: f64) -> f64 {
    let power = 10f64.powf(length_m.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    let nearest = |a: &&f64, b: &&f64| {
        let off = |step: f64| (step * power / length_m).ln().abs();
        off(**a).total_cmp(&off(**b))
    };
    steps.iter().min_by(nearest).copied().unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Camera;
    use brooklet_kernels::Tier;
    use glam::DVec2;

    fn view_and_options() -> (View, FrameOptions) {
        let (domain_min_m, domain_max_m) = (DVec3::new(-3.0, 10.0, 0.5), DVec3::new(-1.0, 11.0, 1.5));
        let size_px = [640, 360];
        let view =
            View { camera: Camera::framing(domain_min_m, domain_max_m, size_px), domain_min_m, domain_max_m, size_px };
        let options = FrameOptions {
            tier: Tier::Desktop,
            surface: crate::SurfaceOptions::Points,
            radius_m: 0.01,
            coloring: Coloring::Fluid,
            supersample: 2,
            shadow_texels: 512,
            edges: true,
            diffuse: None,
        };
        (view, options)
    }

    /// As camera.hlsli computes it, in f64.
    fn clip_from_offset(frame: &FrameView, offset_m: DVec3) -> DVec4 {
        let dot = |axis: [f32; 3]| offset_m.dot(glam::Vec3::from(axis).as_dvec3());
        DVec4::new(
            dot(frame.right) / f64::from(frame.tan_half_width),
            dot(frame.up) / f64::from(frame.tan_half_height),
            f64::from(frame.near_m),
            dot(frame.forward),
        )
    }

    #[test]
    fn the_shaders_axes_project_as_the_matrices_do() {
        let (view, options) = view_and_options();
        let frame = frame_view(&view, &options);
        for corner in corners(view.domain_min_m, view.domain_max_m) {
            let by_matrix = view.clip_from_world() * corner.extend(1.0);
            let by_axes = clip_from_offset(&frame, corner - view.camera.eye_m);
            assert!(by_matrix.abs_diff_eq(by_axes, 1e-6), "{by_matrix} {by_axes}");
        }
        let pixels = 2.0 * f64::from(frame.tan_half_height) / f64::from(frame.pixel_angle);
        assert!((pixels - 720.0).abs() < 1e-3);
    }

    #[test]
    fn the_shadow_map_holds_the_domain() {
        let (view, options) = view_and_options();
        let light = frame_light(&view, &options);
        let size_m = view.domain_max_m - view.domain_min_m;
        let row = |row: [f32; 4], at: DVec3| glam::Vec4::from(row).as_dvec4().dot(at.extend(1.0));
        let mut extent = DVec2::ZERO;
        for corner in corners(DVec3::ZERO, size_m) {
            let at =
                DVec3::new(row(light.shadow_u, corner), row(light.shadow_v, corner), row(light.shadow_depth, corner));
            assert!(at.min_element() > 0.0 && at.max_element() < 1.0, "{at}");
            extent = extent.max((at.truncate() - 0.5).abs());
        }
        assert!(extent.max_element() > 0.4, "most of the map is used: {extent}");
        // Toward the sun is nearer; along the rays the point in the map stays.
        let sun = glam::Vec3::from(light.to_sun).as_dvec3();
        let (a, b) = (0.5 * size_m, 0.5 * size_m + 0.1 * sun);
        assert!((row(light.shadow_u, a) - row(light.shadow_u, b)).abs() < 1e-6);
        assert!((row(light.shadow_v, a) - row(light.shadow_v, b)).abs() < 1e-6);
        let nearer_m = (row(light.shadow_depth, b) - row(light.shadow_depth, a)) * f64::from(light.shadow_range_m);
        assert!((nearer_m - 0.1).abs() < 1e-6);
    }

    #[test]
    fn tiles_have_round_sizes() {
        for (length_m, wanted_m) in [(0.1, 0.1), (0.12, 0.1), (0.017, 0.02), (0.4, 0.5), (8.0, 10.0)] {
            assert!((nice_length(length_m) / wanted_m - 1.0).abs() < 1e-9, "{length_m}");
        }
    }
}
