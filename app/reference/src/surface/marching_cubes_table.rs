//! Which triangles the surface has in a cell, for each of the 256 ways in which its corners are inside or outside
//! (Lorensen & Cline 1987), made from two rules instead of copied:
//!
//! - On a face with two opposite corners inside, each is cut off by itself. A face is cut alike from both of its cells, so
//!   no hole is left (Nielson & Hamann 1991 name the fault of the first table).
//! - No diagonal joins two points of one face. The cell beyond the face may have that very segment, and an edge would
//!   have four triangles.
//!
//! Every case has a triangulation that keeps both rules, of five triangles at most.

/// Triangles of a cell at most.
pub const MOST_TRIANGLES: usize = 5;

/// The ends of the twelve edges: edge 4 a + k is along axis a, from the k-th of the corners that have 0 along it. Corner c
/// is at (c & 1, c >> 1 & 1, c >> 2 & 1).
pub const EDGES: [[u8; 2]; 12] = edges();

/// A triangle's corners, as edges of the cell; counter-clockwise as seen from outside of the fluid.
pub type Triangle = [u8; 3];

const fn edges() -> [[u8; 2]; 12] {
    let mut edges = [[0; 2]; 12];
    let (mut axis, mut next) = (0, 0);
    while axis < 3 {
        let mut corner = 0;
        while corner < 8 {
            if corner >> axis & 1 == 0 {
                edges[next] = [corner, corner | 1 << axis];
                next += 1;
            }
            corner += 1;
        }
        axis += 1;
    }
    edges
}

/// The triangles of a cell whose corners of `inside`, a bit each, are in the fluid.
pub fn triangles(inside: u8) -> Vec<Triangle> {
    loops(inside).iter().flat_map(|polygon| triangulated(polygon)).collect()
}

/// The corners of each face, counter-clockwise as seen from outside of the cell.
fn faces() -> [[u8; 4]; 6] {
    std::array::from_fn(|face| {
        let (axis, side) = (face / 2, face % 2);
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut around = [[0, 0], [1, 0], [1, 1], [0, 1]];
        if side == 0 {
            around.reverse();
        }
        around.map(|[a, b]| (side << axis | a << u | b << v) as u8)
    })
}

fn edge_between(a: u8, b: u8) -> u8 {
    EDGES.iter().position(|&[low, high]| (low, high) == (a.min(b), a.max(b))).unwrap_or_default() as u8
}

/// Whether two edges are of one face.
fn share_a_face(one: u8, other: u8) -> bool {
    let has = |face: &[u8; 4], edge: u8| EDGES[edge as usize].iter().all(|corner| face.contains(corner));
    faces().iter().any(|face| has(face, one) && has(face, other))
}

/// The closed polygons in which the surface meets the cell's faces.
fn loops(inside: u8) -> Vec<Vec<u8>> {
    let is_inside = |corner: u8| inside >> corner & 1 == 1;
    let mut next = [None; 12];
    for face in faces() {
        for k in 0..4 {
            let at = |step: usize| face[(k + step) % 4];
            if is_inside(at(0)) || !is_inside(at(1)) {
                continue;
            }
            // A run of corners that are inside, along the face's edge, is cut off by one segment.
            let end = (1..4).find(|&step| !is_inside(at(step + 1))).unwrap_or(3);
            next[edge_between(at(0), at(1)) as usize] = Some(edge_between(at(end), at(end + 1)));
        }
    }
    let mut polygons = Vec::new();
    for start in 0..12 {
        let mut polygon = Vec::new();
        let mut edge = start;
        while let Some(following) = next[edge as usize].take() {
            polygon.push(edge);
            edge = following;
        }
        if !polygon.is_empty() {
            polygons.push(polygon);
        }
    }
    polygons
}

/// The first triangulation of a polygon that has no diagonal in a face.
fn triangulated(polygon: &[u8]) -> Vec<Triangle> {
    let n = polygon.len();
    let are_next = |i: usize, j: usize| j == i + 1 || (i == 0 && j == n - 1);
    let allowed = |i: usize, j: usize| are_next(i, j) || !share_a_face(polygon[i], polygon[j]);
    split(0, n - 1, &allowed).unwrap_or_default().into_iter().map(|corners| corners.map(|i| polygon[i])).collect()
}

/// Triangles between the points `first` to `last` of a polygon.
fn split(first: usize, last: usize, allowed: &dyn Fn(usize, usize) -> bool) -> Option<Vec<[usize; 3]>> {
    if last - first < 2 {
        return Some(Vec::new());
    }
    (first + 1..last).filter(|&middle| allowed(first, middle) && allowed(middle, last)).find_map(|middle| {
        let mut triangles = split(first, middle, allowed)?;
        triangles.extend(split(middle, last, allowed)?);
        triangles.push([first, middle, last]);
        Some(triangles)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    fn cut_edges(inside: u8) -> Vec<u8> {
        let bit = |corner: u8| inside >> corner & 1;
        (0..12).filter(|&edge| bit(EDGES[edge as usize][0]) != bit(EDGES[edge as usize][1])).collect()
    }

    #[test]
    fn every_cut_edge_has_one_point_and_no_triangulation_is_missing() {
        let mut most = 0;
        for inside in 0..=255 {
            let polygons = loops(inside);
            let mut points: Vec<u8> = polygons.concat();
            points.sort_unstable();
            assert_eq!(points, cut_edges(inside), "case {inside}");
            let expected: usize = polygons.iter().map(|polygon| polygon.len() - 2).sum();
            assert_eq!(triangles(inside).len(), expected, "case {inside} has no triangulation");
            most = most.max(expected);
        }
        assert_eq!(most, MOST_TRIANGLES);
    }

    #[test]
    fn within_a_cell_an_edge_has_two_triangles_and_on_a_face_one() {
        for inside in 0..=255 {
            let mut sides: HashMap<[u8; 2], i32> = HashMap::new();
            for [a, b, c] in triangles(inside) {
                for side in [[a, b], [b, c], [c, a]] {
                    assert!(sides.insert(side, 1).is_none(), "case {inside}: {side:?} twice in one direction");
                }
            }
            for &[a, b] in sides.keys() {
                assert_eq!(sides.contains_key(&[b, a]), !share_a_face(a, b), "case {inside}: {a} to {b}");
            }
        }
    }

    #[test]
    fn triangles_face_out_of_the_fluid() {
        // A plane through the edges at one corner: the normal points away from it.
        let middle = |edge: u8| {
            let [a, b] = EDGES[edge as usize].map(|c| [c & 1, c >> 1 & 1, c >> 2 & 1].map(f64::from));
            glam::DVec3::from_array(std::array::from_fn(|axis| 0.5 * (a[axis] + b[axis])))
        };
        for corner in 0..8_u8 {
            let at = glam::DVec3::from_array([corner & 1, corner >> 1 & 1, corner >> 2 & 1].map(f64::from));
            let [a, b, c] = triangles(1 << corner)[0].map(middle);
            assert!((b - a).cross(c - a).dot(a - at) > 0.0, "corner {corner}");
            let [a, b, c] = triangles(!(1 << corner))[0].map(middle);
            assert!((b - a).cross(c - a).dot(a - at) < 0.0, "all but corner {corner}");
        }
    }
}
