//! Meshes that the program wrote, and particles for it to mesh.

use std::path::Path;

use brooklet_reference::surface::marching_cubes::{Mesh, check_closed, volume_m3};
use glam::DVec3;
use rand::RngExt;

use crate::rng;

/// Reads an OBJ file of `v`, `vn` and `f a//a` lines; each edge is walked.
///
/// # Errors
/// What of its edges is open.
///
/// # Panics
/// If it has any other line.
pub fn read_closed_obj(path: &Path) -> Result<Mesh, String> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let (mut vertices_m, mut normals, mut triangles) = (Vec::new(), 0, Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next();
        let words: [&str; 3] = words.collect::<Vec<_>>().try_into().unwrap_or_else(|_| panic!("{line}"));
        match kind {
            Some("v") => vertices_m.push(DVec3::from_array(words.map(|word| word.parse().expect(line)))),
            Some("vn") => normals += 1,
            Some("f") => triangles.push(words.map(|word| {
                let (vertex, normal) = word.split_once("//").expect(line);
                assert_eq!(vertex, normal, "{line}");
                vertex.parse::<u32>().expect(line) - 1
            })),
            _ => panic!("{line}"),
        }
    }
    assert_eq!(vertices_m.len(), normals);
    check_closed(&triangles).map(|()| Mesh { vertices_m, triangles })
}

/// Volume of a mesh, m^3.
pub fn volume(mesh: &Mesh) -> f64 {
    volume_m3(mesh)
}

/// A scene of single drops, 0.8 m apart, drawn as a mesh: each has blocks of its own, more in all than there is room for at
/// first.
pub fn scene_of_drops() -> String {
    let mut scene = "summary = \"Single drops far apart\"\nspacing_m = 0.05\n[domain]\nmin_m = [0, 0, 0]\n\
                     max_m = [4, 4, 4]\n[solver]\nmethod = \"none\"\n[surface]\nmethod = \"marching-cubes\"\n\
                     [outputs]\nimages = 2\nwidth_px = 64\nheight_px = 36\nmeasure_every_steps = 1\n"
        .to_owned();
    for drop in 0..125 {
        let low_m = [1, 5, 25].map(|n| 0.4 + 0.8 * f64::from(drop / n % 5));
        let high_m = low_m.map(|m| m + 0.05);
        scene.push_str(&format!("[[fluid]]\nblock = {{ min_m = {low_m:?}, max_m = {high_m:?} }}\n"));
    }
    scene
}

/// An ASCII PLY file of these particles.
pub fn ply_of(positions_m: &[DVec3]) -> String {
    let mut text = format!("ply\nformat ascii 1.0\nelement vertex {}\n", positions_m.len());
    text.push_str("property double x\nproperty double y\nproperty double z\nproperty uchar phase\nend_header\n");
    for at_m in positions_m {
        text.push_str(&format!("{} {} {} 7\n", at_m.x, at_m.y, at_m.z));
    }
    text
}

/// A ball of particles, off their lattice by a twentieth of the spacing.
pub fn ball(middle_m: DVec3, radius: i32, spacing_m: f64) -> Vec<DVec3> {
    let mut rng = rng(41);
    let side = -radius..=radius;
    let mut positions_m = Vec::new();
    for x in side.clone() {
        for y in side.clone() {
            for z in side.clone() {
                if x * x + y * y + z * z < radius * radius {
                    let jitter = DVec3::from_array([0; 3].map(|_| 0.1 * (rng.random::<f64>() - 0.5)));
                    positions_m.push(middle_m + spacing_m * (DVec3::new(x.into(), y.into(), z.into()) + jitter));
                }
            }
        }
    }
    positions_m
}
