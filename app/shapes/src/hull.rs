//! The convex hull of points, one point at a time: the faces that see it give way to a cone from it to their border.

use std::collections::HashSet;

use glam::DVec3;

use crate::mesh::Mesh;

/// Points that a hull may be made of.
pub const MOST_HULL_POINTS: usize = 4096;
/// Of the points' extent: nearer to a face than this, one is on it.
const ON: f64 = 1.0e-9;

/// The smallest convex solid with these points in it; why there is none otherwise.
///
/// # Errors
/// In words: no points, too many, one that is not finite, all in one plane.
pub fn hull(points_m: &[DVec3]) -> Result<Mesh, String> {
    if points_m.len() > MOST_HULL_POINTS {
        return Err(format!("has {} points, and {MOST_HULL_POINTS} fit", points_m.len()));
    }
    if let Some((index, at_m)) = points_m.iter().enumerate().find(|(_, at_m)| !at_m.is_finite()) {
        return Err(format!("point {index} is at {at_m}, which is no place"));
    }
    let flat = || format!("has {} points that lie in one plane: a hull needs four that do not", points_m.len());
    let low_m = points_m.iter().copied().reduce(DVec3::min).ok_or_else(flat)?;
    let high_m = points_m.iter().copied().reduce(DVec3::max).ok_or_else(flat)?;
    let on_m = ON * (high_m - low_m).max_element();
    let faces = first_faces(points_m, on_m).ok_or_else(flat)?;
    let mut faces: Vec<[u32; 3]> = faces.into();
    let above_m = |[a, b, c]: [u32; 3], at_m: DVec3| {
        let [a, b, c] = [a, b, c].map(|corner| points_m[corner as usize]);
        (b - a).cross(c - a).normalize_or_zero().dot(at_m - a)
    };
    for (point, &at_m) in (0..).zip(points_m) {
        let (seen, kept): (Vec<[u32; 3]>, Vec<[u32; 3]>) = faces.iter().partition(|&&face| above_m(face, at_m) > on_m);
        if seen.is_empty() {
            continue;
        }
        let edges: HashSet<[u32; 2]> = seen.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        let mut border: Vec<[u32; 2]> = edges.iter().copied().filter(|[a, b]| !edges.contains(&[*b, *a])).collect();
        border.sort_unstable();
        faces = kept;
        faces.extend(border.into_iter().map(|[a, b]| [a, b, point]));
    }
    let out_m =
        points_m.iter().flat_map(|&at_m| faces.iter().map(move |&face| above_m(face, at_m))).fold(0.0, f64::max);
    if out_m > 1.0e-3 * (high_m - low_m).max_element() {
        return Err(format!("has points so close to each other that a hull of them leaves one {out_m:.1e} m outside"));
    }
    Ok(Mesh { positions_m: points_m.to_vec(), triangles: faces })
}

/// A tetrahedron of points that are far apart.
fn first_faces(points_m: &[DVec3], on_m: f64) -> Option<[[u32; 3]; 4]> {
    let furthest = |from: &dyn Fn(DVec3) -> f64| {
        let all = (0..).zip(points_m).map(|(index, &at_m)| (index, from(at_m)));
        all.max_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|furthest| furthest.1 > on_m)
            .map(|furthest: (u32, f64)| furthest.0)
    };
    let at_m = |index: u32| points_m[index as usize];
    let a = furthest(&|at| at.distance(points_m[0]))?;
    let b = furthest(&|at| at.distance(at_m(a)))?;
    let along = (at_m(b) - at_m(a)).normalize();
    let c = furthest(&|at| (at - at_m(a)).reject_from_normalized(along).length())?;
    let up = along.cross(at_m(c) - at_m(a)).normalize();
    let d = furthest(&|at| up.dot(at - at_m(a)).abs())?;
    let [b, c] = if up.dot(at_m(d) - at_m(a)) > 0.0 { [c, b] } else { [b, c] };
    Some([[a, b, c], [a, d, b], [b, d, c], [c, d, a]])
}
