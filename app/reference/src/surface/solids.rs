//! Solids' triangles as they are moved, seen and lit: rays are cast where the GPU fills triangles.
//! (Shaders: `frame/solids.hlsl`, `frame/glass.hlsl`.)

use super::sky::{ambient_light, fresnel, sky_gradient, surroundings};
use brooklet_kernels::{FrameLight, FrameStyle, SolidPaint, SolidPose, SolidVertex};
use glam::{DQuat, DVec3};

/// Of [`glass_film`]: reflectance at normal incidence, and what a face and a rim keep.
const GLASS_F0: f64 = 0.04;
const FACE_DEPTH: f64 = 0.012;
const RIM_DEPTH: f64 = 0.3;

/// A corner where its solid's pose puts it, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidCorner {
    /// Where it is, m.
    pub position_m: DVec3,
    /// Its normal.
    pub normal: DVec3,
    /// Its solid's color there.
    pub color: DVec3,
    /// Share of what smooth paint mirrors.
    pub gloss: f64,
    /// Whether it is of a rim, 0 or 1.
    pub rim: f64,
}

/// The corner of a solid at `pose`. (Shader: `frame/solid_geometry.hlsli`.)
pub fn moved(vertex: &SolidVertex, pose: &SolidPose, paint: &SolidPaint) -> SolidCorner {
    let rotation = DQuat::from_array(pose.rotation.map(f64::from));
    SolidCorner {
        position_m: vector(pose.position_m) + rotation * vector(vertex.position_m),
        normal: rotation * vector(vertex.normal),
        color: vector(paint.color).lerp(vector(paint.other), f64::from(vertex.rim)),
        gloss: f64::from(paint.gloss),
        rim: f64::from(vertex.rim),
    }
}

/// What a ray meets of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidHit {
    /// How far along the ray, in lengths of its direction.
    pub along: f64,
    /// What of the corners is there; the normal has length 1.
    pub at: SolidCorner,
    /// Whether the triangle's own front is met.
    pub is_front: bool,
}

/// Triangles of solids.
#[derive(Clone, Debug)]
pub struct SolidScene {
    /// Three corners each.
    pub triangles: Vec<[SolidCorner; 3]>,
}

impl SolidScene {
    /// Triangles at their solids' `poses`.
    pub fn new(vertices: &[SolidVertex], indices: &[u32], poses: &[SolidPose], paints: &[SolidPaint]) -> Self {
        let corner = |index: u32| {
            let vertex = &vertices[index as usize];
            moved(vertex, &poses[vertex.solid as usize], &paints[vertex.solid as usize])
        };
        let triangles = indices.chunks_exact(3).map(|of| [corner(of[0]), corner(of[1]), corner(of[2])]).collect();
        Self { triangles }
    }

    /// Everything that a ray meets, in the order of the triangles.
    pub fn hits(&self, from_m: DVec3, direction: DVec3) -> impl Iterator<Item = SolidHit> {
        self.triangles.iter().filter_map(move |triangle| meet(triangle, from_m, direction))
    }

    /// What it meets first of triangles that face it.
    pub fn first(&self, from_m: DVec3, direction: DVec3) -> Option<SolidHit> {
        self.hits(from_m, direction).filter(|hit| hit.is_front).min_by(|a, b| a.along.total_cmp(&b.along))
    }

    /// Whether something stands between a place and the sun.
    pub fn is_shaded(&self, at_m: DVec3, light: &FrameLight) -> bool {
        self.hits(at_m, vector(light.to_sun)).next().is_some()
    }
}

/// Möller & Trumbore 1997.
fn meet(triangle: &[SolidCorner; 3], from_m: DVec3, direction: DVec3) -> Option<SolidHit> {
    let [a, b, c] = triangle;
    let (to_b_m, to_c_m) = (b.position_m - a.position_m, c.position_m - a.position_m);
    let across = direction.cross(to_c_m);
    let determinant = to_b_m.dot(across);
    let from_a_m = from_m - a.position_m;
    let share_b = from_a_m.dot(across) / determinant;
    let aside = from_a_m.cross(to_b_m);
    let share_c = direction.dot(aside) / determinant;
    let along = to_c_m.dot(aside) / determinant;
    // Written so that a triangle seen from its edge, which has NaNs, is not met.
    if !(share_b >= 0.0 && share_c >= 0.0 && share_b + share_c <= 1.0 && along > 0.0) {
        return None;
    }
    let share_a = 1.0 - share_b - share_c;
    let mean = |of: fn(&SolidCorner) -> DVec3| share_a * of(a) + share_b * of(b) + share_c * of(c);
    let at = SolidCorner {
        position_m: mean(|corner| corner.position_m),
        normal: mean(|corner| corner.normal).normalize(),
        color: mean(|corner| corner.color),
        gloss: a.gloss,
        rim: share_a * a.rim + share_b * b.rim + share_c * c.rim,
    };
    Some(SolidHit { along, at, is_front: to_b_m.cross(to_c_m).dot(direction) < 0.0 })
}

/// Light from a place of an opaque solid toward the eye, where a share `sun` of the sun's arrives.
pub fn solid_light(at: &SolidCorner, eye_m: DVec3, sun: f64, (light, style): (&FrameLight, &FrameStyle)) -> DVec3 {
    let (normal, to_sun) = (at.normal, vector(light.to_sun));
    let to_eye = (eye_m - at.position_m).normalize();
    let n_dot_l = normal.dot(to_sun);
    let n_dot_v = normal.dot(to_eye).clamp(0.0, 1.0);
    let sun = if n_dot_l > 0.0 { sun * vector(light.sun_color) } else { DVec3::ZERO };
    let diffuse = 0.75 * n_dot_l * sun
        + 0.85 * ambient_light(light, vector(style.floor_color), normal)
        + 0.25 * n_dot_v * n_dot_v * vector(light.sky_horizon);
    let mirrored = fresnel(0.04, n_dot_v) * 0.6 * sky_gradient(light, (-to_eye).reflect(normal));
    let halfway = (to_sun + to_eye).normalize().dot(normal).clamp(0.0, 1.0);
    at.color * diffuse + at.gloss * (mirrored + 0.16 * halfway.powi(64) * sun)
}

/// What a face of glass adds toward the eye, and the share that it takes of what is behind it.
pub fn glass_film(at: &SolidCorner, eye_m: DVec3, (light, style): (&FrameLight, &FrameStyle)) -> (DVec3, f64) {
    let to_eye = (eye_m - at.position_m).normalize();
    let normal = if at.normal.dot(to_eye) < 0.0 { -at.normal } else { at.normal };
    let cosine = normal.dot(to_eye);
    let mirrored = fresnel(GLASS_F0, cosine);
    let kept = 1.0 - (-(FACE_DEPTH + at.rim * (RIM_DEPTH - FACE_DEPTH)) / cosine.max(0.12)).exp();
    let glow = at.color * ambient_light(light, vector(style.floor_color), normal);
    let halfway = (vector(light.to_sun) + to_eye).normalize().dot(normal).clamp(0.0, 1.0);
    let color = mirrored * surroundings(light, style, at.position_m, (-to_eye).reflect(normal))
        + (1.0 - mirrored) * kept * glow
        + 0.5 * halfway.powi(64) * vector(light.sun_color);
    (color, mirrored + (1.0 - mirrored) * kept)
}

fn vector(of: [f32; 3]) -> DVec3 {
    DVec3::from_array(of.map(f64::from))
}
