//! A camera that goes round what it looks at.

use brooklet_render::{Camera, View};
use glam::{DVec2, DVec3};

/// How steeply it looks down at most, and up: never through the floor, never straight down, where
/// "up" has no place on the screen.
const PITCH_RAD: std::ops::RangeInclusive<f64> = 0.02..=1.54;
/// How near and far it goes, in diagonals of the domain.
const DISTANCE_RATIO: std::ops::RangeInclusive<f64> = 0.05..=20.0;

/// Where the eye is, seen from what it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// What it looks at, m.
    pub target_m: DVec3,
    /// Angle round the vertical, from +z toward +x, radians.
    pub yaw_rad: f64,
    /// Angle above the horizontal, radians.
    pub pitch_rad: f64,
    /// From the eye to the target, m.
    pub distance_m: f64,
    /// Vertical angle of view, degrees.
    pub fov_deg: f64,
    diagonal_m: f64,
}

impl Orbit {
    /// The orbit on which `view`'s camera is.
    pub fn of(view: &View) -> Self {
        let Camera { eye_m, target_m, fov_deg } = view.camera;
        let offset = eye_m - target_m;
        let distance_m = offset.length().max(1e-9);
        let orbit = Self {
            target_m,
            yaw_rad: offset.x.atan2(offset.z),
            pitch_rad: (offset.y / distance_m).asin(),
            distance_m,
            fov_deg,
            diagonal_m: view.diagonal_m(),
        };
        orbit.limited()
    }

    /// The camera there.
    pub fn camera(&self) -> Camera {
        let (sin_yaw, cos_yaw) = self.yaw_rad.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch_rad.sin_cos();
        let toward_eye = DVec3::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch);
        Camera { eye_m: self.target_m + self.distance_m * toward_eye, target_m: self.target_m, fov_deg: self.fov_deg }
    }

    /// Turns by what was dragged, in parts of the picture's height: half a turn a height.
    pub fn turn(&mut self, dragged: DVec2) {
        self.yaw_rad -= std::f64::consts::PI * dragged.x;
        self.pitch_rad += std::f64::consts::PI * dragged.y;
        *self = self.limited();
    }

    /// Moves sideways by what was dragged, in parts of the picture's height: what was grasped at the
    /// target's distance stays under the pointer.
    pub fn pan(&mut self, dragged: DVec2) {
        let height_m = 2.0 * self.distance_m * (0.5 * self.fov_deg.to_radians()).tan();
        let axes = self.camera().axes();
        self.target_m += height_m * (dragged.y * axes.y_axis - dragged.x * axes.x_axis);
        *self = self.limited();
    }

    /// Comes nearer by a factor.
    pub fn zoom(&mut self, factor: f64) {
        if factor.is_finite() && factor > 0.0 {
            self.distance_m /= factor;
            *self = self.limited();
        }
    }

    fn limited(self) -> Self {
        let (near, far) = (DISTANCE_RATIO.start() * self.diagonal_m, DISTANCE_RATIO.end() * self.diagonal_m);
        let away_m = DVec3::splat(far);
        Self {
            yaw_rad: self.yaw_rad.rem_euclid(std::f64::consts::TAU),
            pitch_rad: self.pitch_rad.clamp(*PITCH_RAD.start(), *PITCH_RAD.end()),
            distance_m: self.distance_m.clamp(near, far),
            target_m: self.target_m.clamp(-away_m, away_m),
            ..self
        }
    }
}

/// A ray of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The eye, m.
    pub origin_m: DVec3,
    /// Where it looks, of length 1.
    pub direction: DVec3,
}

/// The ray through a point of the picture: x from its left and y from its top, in parts of its width
/// and height.
pub fn ray(view: &View, at: DVec2) -> Ray {
    let tan_half = view.tan_half();
    let axes = view.camera.axes();
    let toward = DVec3::new((2.0 * at.x - 1.0) * tan_half.x, (1.0 - 2.0 * at.y) * tan_half.y, -1.0);
    Ray { origin_m: view.camera.eye_m, direction: (axes * toward).normalize() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view() -> View {
        View {
            camera: Camera { eye_m: DVec3::new(1.5, 1.2, 4.0), target_m: DVec3::new(1.0, 0.4, 0.5), fov_deg: 32.0 },
            domain_min_m: DVec3::ZERO,
            domain_max_m: DVec3::new(2.0, 1.0, 1.0),
            size_px: [640, 360],
        }
    }

    #[test]
    fn an_orbit_begins_where_the_camera_is() {
        let camera = Orbit::of(&view()).camera();
        assert!(camera.eye_m.abs_diff_eq(view().camera.eye_m, 1e-12), "{camera:?}");
        assert_eq!(camera.target_m, view().camera.target_m);
    }

    #[test]
    fn turning_keeps_the_distance_and_stays_above_the_floor() {
        let mut orbit = Orbit::of(&view());
        let distance_m = orbit.distance_m;
        for dragged in [DVec2::new(0.3, -0.2), DVec2::new(-7.0, 9.0), DVec2::new(0.0, -90.0)] {
            orbit.turn(dragged);
            let camera = orbit.camera();
            assert!(((camera.eye_m - camera.target_m).length() - distance_m).abs() < 1e-9);
            assert!(camera.eye_m.y > camera.target_m.y);
        }
        let before = Orbit::of(&view()).camera().eye_m;
        let mut right = Orbit::of(&view());
        right.turn(DVec2::new(0.1, 0.0));
        assert!(right.camera().eye_m.x < before.x, "the scene turns with the hand");
    }

    #[test]
    fn what_is_grasped_stays_under_the_pointer() {
        let mut view = view();
        let mut orbit = Orbit::of(&view);
        let grasped = orbit.target_m;
        orbit.pan(DVec2::new(0.25, 0.1));
        view.camera = orbit.camera();
        let seen = view.project(grasped).unwrap().at_px;
        assert!(seen.distance(DVec2::new(320.0 + 0.25 * 360.0, 180.0 + 0.1 * 360.0)) < 1e-6, "{seen}");
    }

    #[test]
    fn zoom_has_ends() {
        let mut orbit = Orbit::of(&view());
        let far_m = orbit.distance_m;
        orbit.zoom(2.0);
        assert!((orbit.distance_m - 0.5 * far_m).abs() < 1e-12);
        for factor in [1e9, 0.0, f64::NAN, 1e-9] {
            orbit.zoom(factor);
            assert!(orbit.distance_m.is_finite() && orbit.distance_m > 0.0);
        }
    }

    #[test]
    fn a_ray_meets_what_is_seen_there() {
        let view = view();
        for point in [DVec3::new(0.3, 0.2, 0.8), DVec3::new(1.9, 0.9, 0.1)] {
            let at = view.project(point).unwrap().at_px / DVec2::new(640.0, 360.0);
            let ray = ray(&view, at);
            let along = (point - ray.origin_m).normalize();
            assert!(ray.direction.abs_diff_eq(along, 1e-12));
        }
    }
}
