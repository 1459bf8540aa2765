//! Twins of the stages that make a surface in screen space: ellipsoids, depth, smoothing filters, normals and
//! thickness; of those that carry sunlight through it (caustics); and of those that draw solids.
//!
//! A picture is rows from the top of the inverse depth, 1 / distance along the direction of view, in 1/m; 0 where no fluid
//! is.

pub mod anisotropic_field;
pub mod anisotropy;
pub mod caustics;
pub mod count_covered;
pub mod fluid_depth;
pub mod marching_cubes;
pub mod marching_cubes_table;
pub mod mesh_blocks;
pub mod refract_photons;
pub mod sky;
pub mod smooth_bilateral;
pub mod smooth_curvature_flow;
pub mod smooth_gaussian;
pub mod smooth_narrow_range;
pub mod smooth_normals;
pub mod smooth_photons;
pub mod smooth_sun_depth;
pub mod solids;
pub mod subdivide;
pub mod sun_depth;
pub mod sun_map;
pub mod sun_volume;
pub mod surface_field;
pub mod surface_normals;
pub mod thickness;

use brooklet_kernels::{FrameView, SurfaceParams};
use glam::{DVec2, DVec3};

/// A picture of inverse depths, 1/m.
#[derive(Clone, Debug, PartialEq)]
pub struct InverseDepth {
    /// Width and height in pixels.
    pub size_px: [usize; 2],
    /// Rows from the top.
    pub values: Vec<f64>,
}

/// Direction of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// A row.
    X,
    /// A column.
    Y,
    /// Both at once.
    Plane,
}

impl InverseDepth {
    /// The value at a pixel, 0 outside the picture.
    pub fn at(&self, x: i64, y: i64) -> f64 {
        let inside = x >= 0 && y >= 0 && x < self.size_px[0] as i64 && y < self.size_px[1] as i64;
        if inside { self.values[y as usize * self.size_px[0] + x as usize] } else { 0.0 }
    }

    /// `filter` at every pixel of the fluid, 0 elsewhere.
    pub(crate) fn map(&self, filter: impl Fn(i64, i64, f64) -> f64) -> Self {
        let width = self.size_px[0];
        let values = self.values.iter().enumerate().map(|(index, &here)| {
            if here > 0.0 { filter((index % width) as i64, (index / width) as i64, here) } else { 0.0 }
        });
        Self { size_px: self.size_px, values: values.collect() }
    }
}

/// The ray `aside` of a pixel's middle, in pixels, 1 along the direction of view, in world axes.
pub fn ray_of(view: &FrameView, size_px: [usize; 2], index: usize, aside: DVec2) -> DVec3 {
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let x = ((index % size_px[0]) as f64 + 0.5 + aside.x) / size_px[0] as f64 * 2.0 - 1.0;
    let y = 1.0 - ((index / size_px[0]) as f64 + 0.5 + aside.y) / size_px[1] as f64 * 2.0;
    vector(view.forward)
        + vector(view.right) * (x * f64::from(view.tan_half_width))
        + vector(view.up) * (y * f64::from(view.tan_half_height))
}

/// A small difference of distance as one of the inverse depth.
pub(crate) fn inverse_depth_difference(distance_m: f32, inverse_depth: f64) -> f64 {
    (f64::from(distance_m) * inverse_depth * inverse_depth).min(0.5 * inverse_depth)
}

pub(crate) fn reach_px(params: &SurfaceParams, view: &FrameView, inverse_depth: f64) -> f64 {
    let reach = f64::from(params.smoothing_m) * inverse_depth / f64::from(view.pixel_angle);
    reach.min(f64::from(params.most_reach_px))
}

/// A Gaussian of which the reach is two standard deviations, lowered to be zero there.
pub(crate) fn spatial_weight(squared_px: f64, reach: f64) -> f64 {
    ((-2.0 * squared_px / (reach * reach)).exp() - (-2.0f64).exp()).max(0.0)
}

pub(crate) fn middle_weight() -> f64 {
    1.0 - (-2.0f64).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn params() -> (SurfaceParams, FrameView) {
        let params = SurfaceParams {
            wall_min_m: [-1e18; 3],
            radius_m: 0.1,
            wall_max_m: [1e18; 3],
            thickness_radius_m: 0.1,
            spacing_m: 0.1,
            smoothing_m: 0.1,
            most_reach_px: 64.0,
            range_m: 0.3,
            clamp_m: 0.1,
            flow_m2: 1e-5,
            photons: 0.0,
            sun_smoothing_m: 0.1,
        };
        let view = FrameView {
            eye_m: [0.0; 3],
            near_m: 0.01,
            right: [1.0, 0.0, 0.0],
            tan_half_width: 0.16,
            up: [0.0, 1.0, 0.0],
            tan_half_height: 0.12,
            forward: [0.0, 0.0, -1.0],
            pixel_angle: 0.005,
            size_px: [64.0, 48.0],
            supersample: 1.0,
            reserved: 0.0,
        };
        (params, view)
    }

    /// A tilted plane: N . x = c, so w = (N . r) / c.
    fn plane() -> InverseDepth {
        let values = (0..64 * 48).map(|i| {
            let (x, y) = ((i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
            0.5 + 0.004 * x - 0.003 * y
        });
        InverseDepth { size_px: [64, 48], values: values.collect() }
    }

    #[test]
    fn symmetric_filters_leave_a_tilted_plane_as_it_is() {
        let (params, view) = params();
        let plane = plane();
        for smoothed in [
            smooth_gaussian::smooth_gaussian(&plane, &params, &view, Along::X),
            smooth_bilateral::smooth_bilateral(&plane, &params, &view, Along::Plane),
            smooth_narrow_range::smooth_narrow_range(&plane, &params, &view, Along::Y),
            smooth_narrow_range::smooth_narrow_range(&plane, &params, &view, Along::Plane),
        ] {
            // Away from the picture's borders, where half of the taps are missing.
            for (x, y) in [(30, 24), (25, 22), (38, 26)] {
                assert!((smoothed.at(x, y) - plane.at(x, y)).abs() < 1e-12, "{x} {y}");
            }
        }
    }

    #[test]
    fn the_normal_of_a_plane_is_the_planes() {
        let (params, view) = params();
        // w = a + b X + c Y in the ray's coordinates: N is along (b, c, a) in right, up, forward.
        let pixel = 2.0 * 0.16 / 64.0;
        let (b, c) = (0.004 / pixel, 0.003 / pixel);
        let a = 0.5 + 0.004 * 32.0 - 0.003 * 24.0;
        let expected = -glam::DVec3::new(b, c, -a).normalize();
        let normals = surface_normals::surface_normals(&plane(), &params, &view);
        let got = normals[20 * 64 + 30].expect("on the fluid");
        assert!((got - expected).length() < 1e-6, "{got} {expected}");
    }

    #[test]
    fn curvature_flow_flattens_a_bump_and_keeps_a_facing_plane() {
        let (params, view) = params();
        let mut bump = InverseDepth { size_px: [64, 48], values: vec![0.5; 64 * 48] };
        assert_eq!(smooth_curvature_flow::smooth_curvature_flow(&bump, &params, &view), bump);
        bump.values[24 * 64 + 32] = 0.501;
        let after = smooth_curvature_flow::smooth_curvature_flow(&bump, &params, &view);
        assert!(after.at(32, 24) < 0.501 && after.at(33, 24) > 0.5);
    }
}
