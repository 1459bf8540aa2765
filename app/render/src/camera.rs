//! The camera: from where a scene is seen, and the matrices of that.
//!
//! Depth is reversed with the far plane at infinity: 1 at the near plane, falling to 0 with
//! distance, as near / distance. That spreads f32's steps evenly over the distances, and costs a
//! 24-bit depth buffer nothing.

use brooklet_fluid::Scene;
use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use crate::RenderError;

/// Vertical angle of view of a camera that frames a domain, degrees.
const FRAMING_FOV_DEG: f64 = 32.0;
/// Direction from a framed domain's middle to the eye: a little from the right and above.
const FRAMING_DIRECTION: DVec3 = DVec3::new(0.34, 0.40, 1.0);
/// Share of the picture's half width and height that a framed domain fills.
const FRAMING_FILL: f64 = 0.90;

/// Where pictures are taken from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye, m.
    pub eye_m: DVec3,
    /// What it looks at, m.
    pub target_m: DVec3,
    /// Vertical angle of view, degrees.
    pub fov_deg: f64,
}

/// A domain as a camera sees it, in a picture of a size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// From where.
    pub camera: Camera,
    /// Lowest corner of the domain, m.
    pub domain_min_m: DVec3,
    /// Highest corner of the domain, m.
    pub domain_max_m: DVec3,
    /// Width and height of the picture, pixels.
    pub size_px: [u32; 2],
}

/// Where a point is in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Pixels from the picture's top left corner.
    pub at_px: DVec2,
    /// Metres from the eye along the direction of view.
    pub distance_m: f64,
    /// What the depth buffer holds there.
    pub depth: f64,
}

impl Camera {
    /// A camera that sees the whole box, from a little above and right of its front.
    pub fn framing(min_m: DVec3, max_m: DVec3, size_px: [u32; 2]) -> Self {
        let toward_eye = FRAMING_DIRECTION.normalize();
        let tan_half = tan_half(FRAMING_FOV_DEG, size_px);
        let middle = 0.5 * (min_m + max_m);
        let looking = Self { eye_m: middle + toward_eye, target_m: middle, fov_deg: FRAMING_FOV_DEG };
        let axes = looking.axes();
        let offsets: Vec<DVec3> =
            corners(min_m - middle, max_m - middle).map(|offset| axes.transpose() * offset).collect();
        // The planes through the eye that touch the box, each `FRAMING_FILL` of the half width
        // away from the middle: along one axis a corner at `offset` lies inside when
        // |offset - shift| <= slope (distance - offset.z). Both sides touch at this shift and distance.
        let fit = |axis: usize| {
            let slope = FRAMING_FILL * tan_half[axis];
            let high = offsets.iter().map(|o| o[axis] + slope * o.z).fold(f64::NEG_INFINITY, f64::max);
            let low = offsets.iter().map(|o| o[axis] - slope * o.z).fold(f64::INFINITY, f64::min);
            (0.5 * (high + low), 0.5 * (high - low) / slope)
        };
        let ((right_m, wide_m), (up_m, tall_m)) = (fit(0), fit(1));
        let target_m = middle + axes * DVec3::new(right_m, up_m, 0.0);
        Self { eye_m: target_m + toward_eye * wide_m.max(tall_m), target_m, ..looking }
    }

    /// The axes right, up and backward as columns: `world_from_view` without its translation.
    pub fn axes(&self) -> DMat3 {
        let backward = (self.eye_m - self.target_m).normalize_or(DVec3::Z);
        // Straight down or up there is no "up" on the screen: then x stays to the right.
        let sideways = DVec3::Y.cross(backward);
        let right = if sideways.length() > 1e-9 { sideways.normalize() } else { DVec3::X };
        DMat3::from_cols(right, backward.cross(right), backward)
    }

    /// From view coordinates (x right, y up, z toward the viewer) to the world's, both in metres.
    pub fn world_from_view(&self) -> DMat4 {
        let axes = self.axes();
        DMat4::from_cols(
            axes.x_axis.extend(0.0),
            axes.y_axis.extend(0.0),
            axes.z_axis.extend(0.0),
            self.eye_m.extend(1.0),
        )
    }
}

impl View {
    /// The view that a scene asks for: from its camera, or framing its domain.
    pub fn of_scene(scene: &Scene) -> Self {
        let size_px = [scene.outputs.width_px, scene.outputs.height_px];
        let domain_min_m = DVec3::from(scene.domain.min_m);
        let domain_max_m = DVec3::from(scene.domain.max_m);
        let camera = scene.camera.as_ref().map_or_else(
            || Camera::framing(domain_min_m, domain_max_m, size_px),
            |camera| Camera { eye_m: camera.eye_m.into(), target_m: camera.target_m.into(), fov_deg: camera.fov_deg },
        );
        Self { camera, domain_min_m, domain_max_m, size_px }
    }

    /// Checks that there is something to be seen and a picture to see it in.
    ///
    /// # Errors
    /// When a value is not finite or out of range; the error names it.
    pub fn check(&self) -> Result<(), RenderError> {
        let Self { camera, domain_min_m, domain_max_m, size_px } = self;
        if !camera.eye_m.is_finite() || !camera.target_m.is_finite() {
            let value = [camera.eye_m.to_array(), camera.target_m.to_array()];
            return Err(RenderError::not_allowed("camera eye_m and target_m", value, "must be finite"));
        }
        if (camera.eye_m - camera.target_m).length() < 1e-6 {
            let value = camera.eye_m.to_array();
            return Err(RenderError::not_allowed("camera.eye_m", value, "must be away from camera.target_m"));
        }
        if !(1.0..=170.0).contains(&camera.fov_deg) {
            return Err(RenderError::not_allowed("camera.fov_deg", camera.fov_deg, "1 to 170 are allowed"));
        }
        let extent_m = *domain_max_m - *domain_min_m;
        if !extent_m.is_finite() || extent_m.min_element() <= 0.0 {
            let value = extent_m.to_array();
            return Err(RenderError::not_allowed("domain's size in m", value, "must be above 0 and finite"));
        }
        if size_px.contains(&0) || size_px.iter().any(|side| *side > 16_384) {
            return Err(RenderError::not_allowed("picture's size in pixels", size_px, "1 to 16384 a side are allowed"));
        }
        Ok(())
    }

    /// Half the picture's width and height at distance 1.
    pub fn tan_half(&self) -> DVec2 {
        tan_half(self.camera.fov_deg, self.size_px)
    }

    /// Length of the domain's diagonal, m.
    pub fn diagonal_m(&self) -> f64 {
        (self.domain_max_m - self.domain_min_m).length()
    }

    /// Distance of the near plane, m: far enough for a 24-bit depth buffer, nearer than anything
    /// worth seeing.
    pub fn near_m(&self) -> f64 {
        let nearest = self.camera.eye_m.clamp(self.domain_min_m, self.domain_max_m);
        let outside_m = (self.camera.eye_m - nearest).length();
        0.005 * self.diagonal_m() + 0.02 * outside_m
    }

    /// From view coordinates to clip coordinates: x and y as in the picture with y up, depth
    /// reversed.
    pub fn clip_from_view(&self) -> DMat4 {
        let tan_half = self.tan_half();
        DMat4::from_cols(
            DVec4::new(1.0 / tan_half.x, 0.0, 0.0, 0.0),
            DVec4::new(0.0, 1.0 / tan_half.y, 0.0, 0.0),
            DVec4::new(0.0, 0.0, 0.0, -1.0),
            DVec4::new(0.0, 0.0, self.near_m(), 0.0),
        )
    }

    /// From the world's coordinates to clip coordinates.
    pub fn clip_from_world(&self) -> DMat4 {
        self.clip_from_view() * self.camera.world_from_view().inverse()
    }

    /// Where `world_m` is in the picture; `None` behind the near plane.
    pub fn project(&self, world_m: DVec3) -> Option<Projected> {
        let clip = self.clip_from_world() * world_m.extend(1.0);
        if clip.w < self.near_m() {
            return None;
        }
        let [width_px, height_px] = self.size_px.map(f64::from);
        let ndc = clip.truncate() / clip.w;
        Some(Projected {
            at_px: DVec2::new(0.5 * (1.0 + ndc.x) * width_px, 0.5 * (1.0 - ndc.y) * height_px),
            distance_m: clip.w,
            depth: ndc.z,
        })
    }
}

fn tan_half(fov_deg: f64, size_px: [u32; 2]) -> DVec2 {
    let y = (0.5 * fov_deg.to_radians()).tan();
    DVec2::new(y * f64::from(size_px[0]) / f64::from(size_px[1].max(1)), y)
}

/// The eight corners of a box.
pub(crate) fn corners(min: DVec3, max: DVec3) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |corner| {
        let high = |axis: u32| corner >> axis & 1 == 1;
        DVec3::new(
            if high(0) { max.x } else { min.x },
            if high(1) { max.y } else { min.y },
            if high(2) { max.z } else { min.z },
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(eye_m: DVec3, target_m: DVec3) -> View {
        View {
            camera: Camera { eye_m, target_m, fov_deg: 40.0 },
            domain_min_m: DVec3::ZERO,
            domain_max_m: DVec3::new(2.0, 1.0, 1.0),
            size_px: [640, 360],
        }
    }

    #[test]
    fn the_target_is_in_the_middle_and_axes_point_as_named() {
        let view = view(DVec3::new(1.0, 0.5, 4.0), DVec3::new(1.0, 0.5, 0.5));
        let middle = view.project(view.camera.target_m).expect("in front");
        assert!(middle.at_px.distance(DVec2::new(320.0, 180.0)) < 1e-9);
        assert!((middle.distance_m - 3.5).abs() < 1e-12);
        assert!((middle.depth - view.near_m() / 3.5).abs() < 1e-12);
        let right = view.project(DVec3::new(1.1, 0.5, 0.5)).expect("in front");
        let above = view.project(DVec3::new(1.0, 0.6, 0.5)).expect("in front");
        assert!(right.at_px.x > 320.0 && above.at_px.y < 180.0);
        assert!(view.project(DVec3::new(1.0, 0.5, 4.5)).is_none(), "behind the eye");
        // The top of the picture is half the angle of view above the target.
        let top = 3.5 * 20f64.to_radians().tan();
        let top = view.project(DVec3::new(1.0, 0.5 + top, 0.5)).expect("in front");
        assert!(top.at_px.y.abs() < 1e-9);
    }

    #[test]
    fn axes_are_orthonormal_and_right_handed_even_straight_down() {
        for eye in [DVec3::new(3.0, 2.0, 5.0), DVec3::new(0.0, 5.0, 0.0), DVec3::new(0.0, -5.0, 0.0)] {
            let axes = view(eye, DVec3::ZERO).camera.axes();
            assert!((axes * axes.transpose()).abs_diff_eq(DMat3::IDENTITY, 1e-12));
            assert!((axes.determinant() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn framing_shows_every_corner_and_fills_the_picture() {
        for (max_m, size_px) in
            [([2.0, 1.0, 1.0], [960, 540]), ([0.3, 5.0, 0.2], [640, 360]), ([9.0, 0.1, 9.0], [300, 900])]
        {
            let (min_m, max_m) = (DVec3::new(-1.0, 2.0, 0.5), DVec3::new(-1.0, 2.0, 0.5) + DVec3::from(max_m));
            let camera = Camera::framing(min_m, max_m, size_px);
            let view = View { camera, domain_min_m: min_m, domain_max_m: max_m, size_px };
            let [width_px, height_px] = size_px.map(f64::from);
            let extent = corners(min_m, max_m)
                .map(|corner| view.project(corner).expect("in front").at_px)
                .map(|at| (2.0 * at.x / width_px - 1.0).abs().max((2.0 * at.y / height_px - 1.0).abs()))
                .fold(0.0, f64::max);
            assert!((extent - FRAMING_FILL).abs() < 1e-9, "{extent}");
            // Along the direction that is filled, both sides are.
            let seen: Vec<DVec2> =
                corners(min_m, max_m).map(|corner| view.project(corner).expect("in front").at_px).collect();
            let sides = |at: fn(&DVec2) -> f64, side_px: f64| {
                let low = seen.iter().map(at).fold(f64::INFINITY, f64::min);
                let high = seen.iter().map(at).fold(f64::NEG_INFINITY, f64::max);
                (low / side_px, 1.0 - high / side_px)
            };
            let (left, right) = sides(|at| at.x, width_px);
            let (top, bottom) = sides(|at| at.y, height_px);
            let filled = if left < top { (left, right) } else { (top, bottom) };
            assert!((filled.0 - filled.1).abs() < 1e-9, "{left} {right} {top} {bottom}");
        }
    }

    #[test]
    fn bad_views_are_refused_by_name() {
        let good = view(DVec3::new(1.0, 0.5, 4.0), DVec3::ZERO);
        assert!(good.check().is_ok());
        let eye = DVec3::splat(f64::NAN);
        let cases = [
            (View { camera: Camera { eye_m: eye, ..good.camera }, ..good }, "eye_m"),
            (View { camera: Camera { eye_m: DVec3::ZERO, ..good.camera }, ..good }, "eye_m"),
            (View { camera: Camera { fov_deg: 180.0, ..good.camera }, ..good }, "fov_deg"),
            (View { domain_max_m: DVec3::ZERO, ..good }, "domain"),
            (View { size_px: [0, 360], ..good }, "pixels"),
        ];
        for (bad, field) in cases {
            let error = bad.check().expect_err(field).to_string();
            assert!(error.contains(field), "{error}");
        }
    }
}
