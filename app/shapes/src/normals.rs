//! Normals of a mesh's corners as it is drawn: smooth where it bends a little, hard at edges.

use glam::DVec3;

use crate::mesh::Mesh;

/// Of each triangle's three corners the normal: the mean of the triangles around that are turned from it by no more than an
/// angle with this cosine, by their angles there (Thürmer & Wüthrich 1998).
pub fn corner_normals(mesh: &Mesh, cosine: f64) -> Vec<[DVec3; 3]> {
    let faces: Vec<DVec3> =
        (0..mesh.triangles.len()).map(|triangle| mesh.area_normal_m2(triangle).normalize_or_zero()).collect();
    let mut around: Vec<Vec<(u32, f64)>> = vec![Vec::new(); mesh.positions_m.len()];
    for (triangle, of) in (0..).zip(&mesh.triangles) {
        let corners_m = mesh.corners_m(triangle as usize);
        for corner in 0..3 {
            let [to_next, to_last] = [1, 2].map(|step| corners_m[(corner + step) % 3] - corners_m[corner]);
            let angle = if to_next.length() * to_last.length() > 0.0 { to_next.angle_between(to_last) } else { 0.0 };
            around[of[corner] as usize].push((triangle, angle));
        }
    }
    let normal = |triangle: usize, corner: u32| {
        let own = faces[triangle];
        let near = around[corner as usize].iter().filter(|(other, _)| faces[*other as usize].dot(own) >= cosine);
        let sum: DVec3 = near.map(|&(other, angle)| faces[other as usize] * angle).sum();
        sum.try_normalize().unwrap_or(if own == DVec3::ZERO { DVec3::Y } else { own })
    };
    mesh.triangles.iter().enumerate().map(|(triangle, of)| of.map(|corner| normal(triangle, corner))).collect()
}
