//! Triangles cut into smaller ones along curves: PN triangles (Vlachos, Peters, Boyd & Mitchell 2001, sections 3.1 to 3.3),
//! cubic in where they are and quadratic in their normals.
//!
//! What is on an edge depends on its two ends alone, so that the triangles on both of its sides share it, and the mesh
//! stays closed.

use std::collections::BTreeMap;

use super::marching_cubes::Mesh;
use glam::DVec3;

/// A mesh with a unit normal at each vertex.
#[derive(Clone, Debug, Default)]
pub struct NormalMesh {
    /// Where its vertices are, and its triangles.
    pub mesh: Mesh,
    /// As many as there are vertices.
    pub normals: Vec<DVec3>,
}

/// A vertex: where it is, and its normal.
pub type Vertex = (DVec3, DVec3);

/// The tangent control point near `a` on the edge to `b` (section 3.1): a third of the way, in the plane of a's normal.
pub fn tangent_point_m(a: Vertex, b: Vertex) -> DVec3 {
    (2.0 * a.0 + b.0 - (b.0 - a.0).dot(a.1) * a.1) / 3.0
}

/// The normal half-way along an edge (section 3.3): the ends' mean, mirrored at the plane across the edge.
pub fn middle_normal(a: Vertex, b: Vertex) -> DVec3 {
    let (along_m, both) = (b.0 - a.0, a.1 + b.1);
    let squared_m2 = along_m.length_squared();
    let share = if squared_m2 > 0.0 { 2.0 * along_m.dot(both) / squared_m2 } else { 0.0 };
    unit_or(both - share * along_m, a.1)
}

/// `vector` of length 1, or `instead` if it has none.
fn unit_or(vector: DVec3, instead: DVec3) -> DVec3 {
    if vector.length_squared() > 0.0 { vector.normalize() } else { instead }
}

/// The point a share `t` of the way from `a` to `b` along their edge.
pub fn on_edge(a: Vertex, b: Vertex, t: f64) -> Vertex {
    let s = 1.0 - t;
    let near_m = 3.0 * s * (s * tangent_point_m(a, b) + t * tangent_point_m(b, a)) * t;
    let normal = s * s * a.1 + t * t * b.1 + s * t * middle_normal(a, b);
    (s * s * s * a.0 + near_m + t * t * t * b.0, unit_or(normal, a.1))
}

/// The point in the middle of a triangle.
pub fn in_middle([a, b, c]: [Vertex; 3]) -> Vertex {
    let sides = [(a, b), (b, a), (b, c), (c, b), (c, a), (a, c)];
    let tangents_m: DVec3 = sides.into_iter().map(|(from, to)| tangent_point_m(from, to)).sum();
    let corners_m = a.0 + b.0 + c.0;
    // b111 = E + (E - V) / 2, of which there are six in 27; three of each tangent point and one of each corner.
    let middle_m = 1.5 * tangents_m / 6.0 - 0.5 * corners_m / 3.0;
    let at_m = (corners_m + 3.0 * tangents_m + 6.0 * middle_m) / 27.0;
    let normal = a.1 + b.1 + c.1 + middle_normal(a, b) + middle_normal(b, c) + middle_normal(c, a);
    (at_m, unit_or(normal, a.1))
}

/// A closed mesh with each side of its triangles cut into `parts`, 2 or 3: first its own vertices, then those of its edges,
/// ordered by their lower and their higher end, each from the lower on; then those within triangles.
pub fn subdivide(coarse: &NormalMesh, parts: u32) -> NormalMesh {
    let vertex = |index: u32| (coarse.mesh.vertices_m[index as usize], coarse.normals[index as usize]);
    let mut edges: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for &[a, b, c] in &coarse.mesh.triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            edges.insert([from.min(to), from.max(to)], 0);
        }
    }
    let mut fine = coarse.clone();
    fine.mesh.triangles.clear();
    let mut add = |(at_m, normal): Vertex| {
        fine.mesh.vertices_m.push(at_m);
        fine.normals.push(normal);
        fine.mesh.vertices_m.len() as u32 - 1
    };
    for ([low, high], first) in &mut edges {
        let steps = (1..parts).map(|step| on_edge(vertex(*low), vertex(*high), f64::from(step) / f64::from(parts)));
        *first = steps.map(&mut add).min().unwrap_or_default();
    }
    let middles: Vec<u32> = match parts {
        3 => coarse.mesh.triangles.iter().map(|corners| add(in_middle(corners.map(vertex)))).collect(),
        _ => vec![0; coarse.mesh.triangles.len()],
    };
    for (&[a, b, c], middle) in coarse.mesh.triangles.iter().zip(middles) {
        let on = |from: u32, to: u32, step: u32| {
            let first = edges[&[from.min(to), from.max(to)]];
            first + if from < to { step - 1 } else { parts - 1 - step }
        };
        // i steps from a to b, and j from a to c.
        let at = |i: u32, j: u32| match (i, j) {
            (0, 0) => a,
            (i, 0) if i == parts => b,
            (0, j) if j == parts => c,
            (i, 0) => on(a, b, i),
            (0, j) => on(a, c, j),
            (i, j) if i + j == parts => on(b, c, j),
            _ => middle,
        };
        for j in 0..parts {
            for i in 0..parts - j {
                fine.mesh.triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < parts {
                    fine.mesh.triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    fine
}

#[cfg(test)]
mod tests {
    use super::super::marching_cubes::{FieldGrid, check_closed, marching_cubes};
    use super::*;

    /// A ball of radius 1 in cells of this size, with its normals.
    fn ball(cell_m: f64) -> NormalMesh {
        let count = (2.6 / cell_m).ceil() as usize;
        let min_m = DVec3::splat(-1.27);
        let at_m = |i: usize| {
            let at = [i % count, i / count % count, i / count / count];
            min_m + cell_m * DVec3::from_array(at.map(|k| k as f64))
        };
        let values: Vec<f64> = (0..count.pow(3)).map(|i| 1.0 - at_m(i).length()).collect();
        let mut mesh =
            marching_cubes(&FieldGrid { points: [count; 3], min_m, cell_m: DVec3::splat(cell_m), values: &values });
        // On the ball exactly: what is off is then subdivision's.
        mesh.vertices_m.iter_mut().for_each(|at_m| *at_m = at_m.normalize());
        let normals = mesh.vertices_m.iter().map(|at_m| at_m.normalize()).collect();
        NormalMesh { mesh, normals }
    }

    #[test]
    fn a_ball_is_rounder_and_as_closed() {
        let coarse = ball(0.2);
        let count = coarse.mesh.triangles.len();
        let off = |at_m: DVec3| (at_m.length() - 1.0).abs();
        let corners = |mesh: &NormalMesh, triangle: [u32; 3]| triangle.map(|v| mesh.mesh.vertices_m[v as usize]);
        // How far the triangles' middles are off the ball.
        let middles = |mesh: &NormalMesh| {
            let of = |triangle: &[u32; 3]| off(corners(mesh, *triangle).iter().sum::<DVec3>() / 3.0);
            mesh.mesh.triangles.iter().map(of).sum::<f64>() / mesh.mesh.triangles.len() as f64
        };
        for parts in [2, 3] {
            let fine = subdivide(&coarse, parts);
            check_closed(&fine.mesh.triangles).unwrap();
            assert_eq!(fine.mesh.triangles.len(), count * parts.pow(2) as usize);
            let fine_middles = middles(&fine);
            assert!(fine_middles < 0.5 * middles(&coarse), "{parts}: {fine_middles} of {}", middles(&coarse));
            let new = &fine.mesh.vertices_m[coarse.mesh.vertices_m.len()..];
            let turned = |i: usize| fine.normals[i].angle_between(fine.mesh.vertices_m[i]).to_degrees();
            let mean = (0..fine.normals.len()).map(turned).sum::<f64>() / fine.normals.len() as f64;
            assert!(mean < 0.5, "{parts}: normals are {mean:.2} degrees off");
            // Of chords as long as these the middles are 0.005 inside.
            assert!(new.iter().map(|at_m| off(*at_m)).fold(0.0, f64::max) < 0.005);
            assert!(check_closed(&fine.mesh.triangles[1..]).is_err(), "a missing triangle is seen");
        }
        let at_ends = on_edge((DVec3::X, DVec3::X), (DVec3::Y, DVec3::Y), 0.5);
        assert!(
            (at_ends.1 - DVec3::new(1.0, 1.0, 0.0).normalize()).length() < 1e-12 && at_ends.0.length() > 0.88,
            "the chord is 0.71 away"
        );
        let same = on_edge((DVec3::X, DVec3::X), (DVec3::X, DVec3::X), 0.5);
        assert_eq!(same, (DVec3::X, DVec3::X), "an edge without length is a point");
    }
}
