//! The triangles of meshes, hulls and ground as they are drawn: smooth where they bend a little, hard at edges; a sheet from
//! both sides, with a rim where it ends; ground in two colors.

use std::collections::HashMap;

use brooklet_fluid::scene::{SolidSettings, Triangles};
use brooklet_shapes::{Mesh, corner_normals, noise};
use glam::DVec3;

use super::triangles::SolidTriangles;

/// Triangles that are turned from each other by less than 40 degrees meet smoothly.
const SMOOTH_COSINE: f64 = 0.766;

impl SolidTriangles {
    /// Adds those of a solid that is a mesh, a hull or ground.
    pub(super) fn add_triangles(&mut self, solid: &SolidSettings, triangles: &Triangles) {
        let mesh = triangles.drawn.as_ref().unwrap_or(&triangles.solid);
        let normals = corner_normals(mesh, SMOOTH_COSINE);
        match (&solid.terrain, solid.thickness_m) {
            (Some(ground), _) => {
                let lowest_m =
                    mesh.positions_m.iter().map(|at_m| at_m.y).filter(|y| *y >= 0.0).fold(f64::INFINITY, f64::min);
                let [x_m, height_m, _] = ground.size_m;
                let feature_m = ground.feature_m.unwrap_or(0.5 * x_m);
                self.add_side(mesh, &normals, 0.0, |at_m, normal| {
                    let fallen_m = ground.fall_m * (0.5 - at_m.x / x_m).clamp(0.0, 1.0);
                    bare(at_m, normal, (at_m.y - lowest_m - fallen_m) / height_m, feature_m)
                });
            }
            (None, Some(thickness_m)) => {
                for side in [1.0, -1.0] {
                    self.add_side(mesh, &normals, 0.5 * side * thickness_m, |_, _| 0.0);
                }
                self.add_rim(mesh, &normals, thickness_m);
            }
            (None, None) => self.add_side(mesh, &normals, 0.0, |_, _| 0.0),
        }
    }

    /// A mesh's triangles, moved along their normals; to its other side turned over.
    fn add_side(&mut self, mesh: &Mesh, normals: &[[DVec3; 3]], along_m: f64, rim: impl Fn(DVec3, DVec3) -> f64) {
        let side = if along_m < 0.0 { -1.0 } else { 1.0 };
        let mut known: HashMap<(u32, [u32; 3]), u32> = HashMap::new();
        for (of, normals) in mesh.triangles.iter().zip(normals) {
            let corners = [0, 1, 2].map(|corner| {
                let normal = side * normals[corner];
                let at_m = mesh.positions_m[of[corner] as usize] + normal * along_m.abs();
                let key = (of[corner], normal.as_vec3().to_array().map(f32::to_bits));
                *known.entry(key).or_insert_with(|| {
                    self.vertex(at_m, normal, rim(at_m, normal) as f32);
                    self.vertices.len() as u32 - 1
                })
            });
            let [a, b, c] = corners;
            self.indices.extend(if side > 0.0 { [a, b, c] } else { [a, c, b] });
        }
    }

    /// What closes a sheet where it ends.
    fn add_rim(&mut self, mesh: &Mesh, normals: &[[DVec3; 3]], thickness_m: f64) {
        let mut edges: HashMap<[u32; 2], u32> = HashMap::new();
        let sides = |[a, b, c]: [u32; 3]| [([a, b], 0), ([b, c], 1), ([c, a], 2)];
        for ([a, b], _) in mesh.triangles.iter().flat_map(|&of| sides(of)) {
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
        for (&of, normals) in mesh.triangles.iter().zip(normals) {
            for ([a, b], corner) in sides(of).into_iter().filter(|([a, b], _)| edges[&[*a.min(b), *a.max(b)]] == 1) {
                let [from_m, to_m] = [a, b].map(|corner| mesh.positions_m[corner as usize]);
                let [from_up_m, to_up_m] =
                    [corner, (corner + 1) % 3].map(|corner: usize| 0.5 * thickness_m * normals[corner]);
                let out = (to_m - from_m).cross(from_up_m + to_up_m).normalize_or_zero();
                self.quad([from_m - from_up_m, to_m - to_up_m, to_m + to_up_m, from_m + from_up_m], out, 1.0);
            }
        }
    }
}

/// How bare ground is: of its slope, of how low it lies, and of chance; from 0 to 1. Its sides are cut through.
fn bare(at_m: DVec3, normal: DVec3, height: f64, feature_m: f64) -> f64 {
    let per_m = 8.0 / feature_m;
    let chance = noise(at_m.x * per_m, at_m.z * per_m, 7) + 0.5 * noise(3.1 * at_m.x * per_m, 3.1 * at_m.z * per_m, 8);
    let smooth = |from: f64, to: f64, x: f64| {
        let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    };
    let steep = smooth(0.25, 0.5, 1.0 - normal.y + 0.25 * chance);
    let low = 1.0 - smooth(0.1, 0.3, height + 0.2 * chance);
    (steep.max(low) + 0.25 * chance).clamp(0.0, 1.0)
}
