//! Bilateral smoothing of a mesh's normals: a vertex takes the mean of its own normal and those of its ring, weighted by
//! distance and by how little they differ (Tomasi & Manduchi 1998, on normals as Jones, Durand & Zwicker 2004).
//!
//! The ring are the vertices that share an edge with it. On a closed mesh whose triangles are oriented alike each of them
//! is the end of exactly one side that starts at the vertex.

use glam::DVec3;

/// The ends of the sides that start at each of `vertices` vertices, ascending.
pub fn rings(vertices: usize, triangles: &[[u32; 3]]) -> Vec<Vec<u32>> {
    let mut rings = vec![Vec::new(); vertices];
    for &[a, b, c] in triangles.iter().filter(|[a, b, _]| a != b) {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            rings[from as usize].push(to);
        }
    }
    rings.iter_mut().for_each(|ring| ring.sort_unstable());
    rings
}

/// The normals of a mesh, smoothed once, with the weight's standard deviations over the distance of two vertices, m, and
/// over the difference of their normals.
pub fn smooth_normals(
    vertices_m: &[DVec3],
    normals: &[DVec3],
    rings: &[Vec<u32>],
    [distance_m, difference]: [f64; 2],
) -> Vec<DVec3> {
    let smoothed = |vertex: usize| {
        let mut sum = normals[vertex];
        for &other in &rings[vertex] {
            let apart = (vertices_m[other as usize] - vertices_m[vertex]) / distance_m;
            let turned = (normals[other as usize] - normals[vertex]) / difference;
            sum += (-0.5 * (apart.length_squared() + turned.length_squared())).exp() * normals[other as usize];
        }
        if sum.length() > 0.0 { sum.normalize() } else { normals[vertex] }
    };
    (0..normals.len()).map(smoothed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bumps_are_smoothed_and_edges_are_not() {
        // A strip of triangles along x, bent by 90 degrees at its middle, of which one side's normals waver.
        const COUNT: u32 = 40;
        let at = |i: u32| DVec3::new(f64::from(i / 2), f64::from(i % 2), 0.0);
        let vertices_m: Vec<DVec3> = (0..COUNT).map(at).collect();
        let waver = |i: u32| if (i / 2).is_multiple_of(2) { 0.1 } else { -0.1 };
        let normal = |i: u32| if i < COUNT / 2 { DVec3::new(waver(i), 0.0, 1.0).normalize() } else { DVec3::X };
        let normals: Vec<DVec3> = (0..COUNT).map(normal).collect();
        let triangles: Vec<[u32; 3]> =
            (0..COUNT - 2).map(|i| if i % 2 == 0 { [i, i + 2, i + 1] } else { [i, i + 1, i + 2] }).collect();
        let rings = rings(vertices_m.len(), &triangles);
        assert_eq!(rings[5], [3, 4, 6], "the ends of the sides that start there, ascending");
        let smoothed = smooth_normals(&vertices_m, &normals, &rings, [2.0, 0.25]);
        let off = |normals: &[DVec3]| normals[8..12].iter().map(|n| n.x.abs()).fold(0.0, f64::max);
        assert!(off(&smoothed) < 0.5 * off(&normals), "{} of {}", off(&smoothed), off(&normals));
        let edge = COUNT as usize / 2;
        assert!((smoothed[edge] - DVec3::X).length() < 1e-4, "{}", smoothed[edge]);
        assert!(smoothed[edge - 1].x < 0.1, "{}", smoothed[edge - 1]);
        let plain = smooth_normals(&vertices_m, &normals, &rings, [2.0, 10.0]);
        assert!(plain[edge].z > 0.2, "without regard to differences edges are smoothed too: {}", plain[edge]);
    }
}
