//! How far a mesh is from a known surface.

use brooklet_kernels::MeshVertex;
use brooklet_render::surface::marching_cubes::export::HostMesh;
use glam::DVec3;
use serde::Serialize;

use super::{
    distance::{distances, points_on},
    seen::Implicit,
    shapes::{DOMAIN_M, SPACING_M, Shape},
};

/// Errors of a mesh, whoever made it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MeshErrors {
    /// From the mesh to the known surface, over the spacing: the mean by area,
    pub mean_spacings: f64,
    /// and the largest either way (Hausdorff).
    pub hausdorff_spacings: f64,
    /// Volume over the known one, less 1.
    pub volume_error: f64,
    /// Angle between a vertex' normal and the known surface's there, degrees: the mean.
    pub normal_mean_deg: f64,
}

/// Compares `mesh` with the surface of `shape`; none if it has no area.
pub fn mesh_errors(shape: Shape, mesh: &HostMesh) -> Option<MeshErrors> {
    let at = |vertex: u32| DVec3::from_array(mesh.vertices[vertex as usize].position_m.map(f64::from));
    let corners_m: Vec<[DVec3; 3]> = mesh.triangles.iter().map(|corners| corners.map(at)).collect();
    let points_m = points_on(&shape, DOMAIN_M, 0.75 * SPACING_M);
    let off = distances(&corners_m, &shape, &points_m, 3.0 * SPACING_M)?;
    let angle_deg = |vertex: &MeshVertex| {
        let [at_m, normal] = [vertex.position_m, vertex.normal].map(|v| DVec3::from_array(v.map(f64::from)));
        (2.0 * (0.5 * (normal - shape.normal(at_m)).length()).min(1.0).asin()).to_degrees()
    };
    Some(MeshErrors {
        mean_spacings: off.mean_m / SPACING_M,
        hausdorff_spacings: off.hausdorff_m / SPACING_M,
        volume_error: mesh.volume_m3() / shape.volume_m3() - 1.0,
        normal_mean_deg: mesh.vertices.iter().map(angle_deg).sum::<f64>() / mesh.vertices.len() as f64,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball around the sphere's middle: a square's rows and columns as latitudes and longitudes.
    fn ball(radius_m: f64, outward: f32) -> HostMesh {
        let (rows, columns) = (64_u32, 128_u32);
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for row in 0..=rows {
            for column in 0..columns {
                let [polar, around] = [f64::from(row) / f64::from(rows), 2.0 * f64::from(column) / f64::from(columns)]
                    .map(|turns| std::f64::consts::PI * turns);
                let normal = DVec3::new(polar.sin() * around.cos(), polar.cos(), -polar.sin() * around.sin());
                vertices.push(MeshVertex {
                    position_m: (Shape::Sphere.middle_m() + radius_m * normal).as_vec3().to_array(),
                    normal: normal.as_vec3().to_array().map(|x| outward * x),
                    ..MeshVertex::default()
                });
                if row < rows {
                    let at = |row: u32, column: u32| row * columns + column % columns;
                    let [a, b] = [at(row, column), at(row, column + 1)];
                    let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
                    triangles.extend([[a, c, d], [a, d, b]]);
                }
            }
        }
        HostMesh { vertices, triangles, ..HostMesh::default() }
    }

    #[test]
    fn what_is_wrong_with_a_mesh_is_found() {
        let right = mesh_errors(Shape::Sphere, &ball(0.25, 1.0)).unwrap();
        assert!(right.mean_spacings < 0.02 && right.hausdorff_spacings < 0.03, "{right:?}");
        assert!(right.volume_error.abs() < 0.005 && right.normal_mean_deg < 0.01, "{right:?}");
        // A spacing too large, its normals into the fluid.
        let wrong = mesh_errors(Shape::Sphere, &ball(0.25 + SPACING_M, -1.0)).unwrap();
        assert!((wrong.mean_spacings - 1.0).abs() < 0.02 && (wrong.hausdorff_spacings - 1.0).abs() < 0.02, "{wrong:?}");
        assert!((wrong.volume_error - (1.08_f64.powi(3) - 1.0)).abs() < 0.01, "{wrong:?}");
        assert!((wrong.normal_mean_deg - 180.0).abs() < 0.1, "{wrong:?}");
        assert!(mesh_errors(Shape::Sphere, &HostMesh::default()).is_none());
    }
}
