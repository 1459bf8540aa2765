//! Implicit surfaces as a camera sees them, by marching along the pixels' rays in f64.

use brooklet_render::View;
use glam::{DVec2, DVec3};

/// A surface: where a function of space changes sign, from outside (above 0) to inside.
pub trait Implicit: Sync {
    /// The function.
    fn at(&self, point_m: DVec3) -> f64;
    /// How far a ray may go on where the function has `value` above 0, m.
    fn safe_step_m(&self, value: f64) -> f64;
    /// The normal where a ray met the surface, if not the function's slope.
    fn normal(&self, point_m: DVec3) -> DVec3 {
        // Central differences: exact to the square of a step that f64 still resolves well.
        let step_m = 1e-5;
        let along = |e: DVec3| self.at(point_m + step_m * e) - self.at(point_m - step_m * e);
        DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z)).normalize_or_zero()
    }
}

/// A picture of normals toward the eye, in world axes; none where nothing is.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Width and height, pixels.
    pub size_px: [u32; 2],
    /// Rows from the top.
    pub normals: Vec<Option<DVec3>>,
}

impl Seen {
    /// The surface as `view` sees it, inside the box [0, domain]³ only.
    pub fn of(surface: &impl Implicit, view: &View, domain_m: f64) -> Self {
        let [width, height] = view.size_px.map(|side| side as usize);
        let mut normals = vec![None; width * height];
        let workers = std::thread::available_parallelism().map_or(1, usize::from);
        std::thread::scope(|scope| {
            for (band, rows) in normals.chunks_mut(width * height.div_ceil(workers)).enumerate() {
                scope.spawn(move || {
                    for (i, normal) in rows.iter_mut().enumerate() {
                        let index = band * height.div_ceil(workers) * width + i;
                        let at_px = DVec2::new((index % width) as f64, (index / width) as f64) + 0.5;
                        *normal = met(surface, view, at_px, domain_m);
                    }
                });
            }
        });
        Self { size_px: view.size_px, normals }
    }

    /// Pixels' sides between something and nothing: times the mean of |cos| + |sin|'s inverse, pi/4,
    /// the length of all outlines in pixels (Crofton).
    pub fn outline_px(&self) -> f64 {
        let [width, height] = self.size_px.map(|side| side as usize);
        let there = |x: usize, y: usize| self.normals[y * width + x].is_some();
        let mut sides = 0_usize;
        for y in 0..height {
            for x in 0..width {
                sides += usize::from(x + 1 < width && there(x, y) != there(x + 1, y));
                sides += usize::from(y + 1 < height && there(x, y) != there(x, y + 1));
            }
        }
        std::f64::consts::FRAC_PI_4 * sides as f64
    }
}

/// The normal where the ray through a pixel meets the surface.
fn met(surface: &impl Implicit, view: &View, at_px: DVec2, domain_m: f64) -> Option<DVec3> {
    let camera = &view.camera;
    let axes = camera.axes();
    let size = DVec2::new(f64::from(view.size_px[0]), f64::from(view.size_px[1]));
    let ndc = at_px / size * DVec2::new(2.0, -2.0) + DVec2::new(-1.0, 1.0);
    let ray = ndc * view.tan_half();
    let direction = (axes * DVec3::new(ray.x, ray.y, -1.0)).normalize();
    let (mut along_m, end_m) = inside_box(camera.eye_m, direction, domain_m)?;
    let mut before_m = along_m;
    while along_m <= end_m {
        let value = surface.at(camera.eye_m + along_m * direction);
        if value <= 1e-7 {
            // Between the last point outside and this one.
            let (mut low, mut high) = (before_m, along_m);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                match surface.at(camera.eye_m + middle * direction) > 0.0 {
                    true => low = middle,
                    false => high = middle,
                }
            }
            return Some(surface.normal(camera.eye_m + high * direction));
        }
        before_m = along_m;
        along_m += surface.safe_step_m(value).max(1e-6);
    }
    None
}

/// Where a ray enters and leaves the box [0, side]³.
fn inside_box(from: DVec3, direction: DVec3, side: f64) -> Option<(f64, f64)> {
    let low = (DVec3::ZERO - from) / direction;
    let high = (DVec3::splat(side) - from) / direction;
    let enters = low.min(high).max_element().max(0.0);
    let leaves = low.max(high).min_element();
    (enters < leaves).then_some((enters, leaves))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surfaces::shapes::Shape;
    use brooklet_render::Camera;

    #[test]
    fn a_sphere_is_a_disc_with_the_sphere_s_normals() {
        let view = View {
            camera: Camera { eye_m: DVec3::new(0.5, 0.5, 2.5), target_m: DVec3::splat(0.5), fov_deg: 30.0 },
            domain_min_m: DVec3::ZERO,
            domain_max_m: DVec3::ONE,
            size_px: [160, 90],
        };
        let seen = Seen::of(&Shape::Sphere, &view, 1.0);
        // A sphere of radius r at distance D is a disc of half-angle asin(r / D).
        let radius_px = (0.25_f64 / 2.0).asin().tan() / 15.0_f64.to_radians().tan() * 45.0;
        let covered = seen.normals.iter().flatten().count() as f64;
        let disc = std::f64::consts::PI * radius_px * radius_px;
        assert!((covered / disc - 1.0).abs() < 0.02, "{covered} {disc}");
        let outline = seen.outline_px() / (2.0 * std::f64::consts::PI * radius_px);
        assert!((outline - 1.0).abs() < 0.05, "{outline}");
        let middle = seen.normals[45 * 160 + 80].unwrap();
        assert!((middle - DVec3::Z).length() < 0.05, "{middle}");
    }
}
