//! How far a mesh and a known surface are from each other.

use std::collections::HashMap;

use glam::{DVec3, IVec3};

use super::seen::Implicit;

/// Triangles by the cells of a grid that they touch.
struct TriangleGrid<'a> {
    triangles: &'a [[DVec3; 3]],
    cells: HashMap<IVec3, Vec<u32>>,
    side_m: f64,
    farthest_m: f64,
}

/// Cells' side over how far is looked: the nearest triangle is in the first shells of them.
const CELL_SHARE: f64 = 0.25;

/// How far a mesh is from a known surface, and that from it, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distances {
    /// From the middles of the mesh's triangles to the surface, weighted by area: the mean.
    pub mean_m: f64,
    /// The largest from a vertex or a middle to the surface, or from a point of the surface to the mesh (Hausdorff).
    pub hausdorff_m: f64,
}

/// Measures both ways. `points_m` lie on the surface; farther than `farthest_m` nothing is looked for.
///
/// `surface` has to be a signed distance near where the mesh is.
pub fn distances(
    triangles: &[[DVec3; 3]],
    surface: &impl Implicit,
    points_m: &[DVec3],
    farthest_m: f64,
) -> Option<Distances> {
    let (mut weighted, mut area, mut largest_m) = (0.0, 0.0, 0.0_f64);
    for corners in triangles {
        let [a, b, c] = *corners;
        let twice_area = (b - a).cross(c - a).length();
        let middle_m = surface.at((a + b + c) / 3.0).abs();
        weighted += twice_area * middle_m;
        area += twice_area;
        largest_m = corners.iter().map(|&corner| surface.at(corner).abs()).fold(largest_m.max(middle_m), f64::max);
    }
    if area <= 0.0 {
        return None;
    }
    let grid = TriangleGrid::new(triangles, farthest_m);
    let back_m = points_m.iter().map(|&at_m| grid.distance_m(at_m)).fold(0.0, f64::max);
    Some(Distances { mean_m: weighted / area, hausdorff_m: largest_m.max(back_m) })
}

/// Points on a surface inside of a box from 0 to `domain_m`: those of a lattice that are near it, moved onto it.
pub fn points_on(surface: &impl Implicit, domain_m: f64, step_m: f64) -> Vec<DVec3> {
    let side = (domain_m / step_m).ceil() as usize;
    (0..side.pow(3))
        .filter_map(|i| {
            let at_m = DVec3::new((i % side) as f64, (i / side % side) as f64, (i / side / side) as f64) * step_m;
            let off_m = surface.at(at_m);
            (off_m.abs() < 0.6 * step_m).then(|| at_m - off_m * surface.normal(at_m))
        })
        .filter(|&at_m| surface.at(at_m).abs() < 1e-6)
        .collect()
}

impl<'a> TriangleGrid<'a> {
    fn new(triangles: &'a [[DVec3; 3]], farthest_m: f64) -> Self {
        let side_m = CELL_SHARE * farthest_m;
        let mut cells: HashMap<IVec3, Vec<u32>> = HashMap::new();
        for (i, [a, b, c]) in triangles.iter().enumerate() {
            let low = cell(a.min(*b).min(*c), side_m);
            let high = cell(a.max(*b).max(*c), side_m);
            for z in low.z..=high.z {
                for y in low.y..=high.y {
                    (low.x..=high.x).for_each(|x| cells.entry(IVec3::new(x, y, z)).or_default().push(i as u32));
                }
            }
        }
        Self { triangles, cells, side_m, farthest_m }
    }

    /// To the nearest triangle; `farthest_m` where none is nearer.
    fn distance_m(&self, at_m: DVec3) -> f64 {
        let mut least_m = self.farthest_m;
        let middle = cell(at_m, self.side_m);
        for shell in 0_i32.. {
            for offset in offsets(shell) {
                for &triangle in self.cells.get(&(middle + offset)).into_iter().flatten() {
                    least_m = least_m.min(to_triangle_m(at_m, &self.triangles[triangle as usize]));
                }
            }
            // What touches no cell so far is a cell's side for each shell away.
            if least_m <= f64::from(shell) * self.side_m {
                break;
            }
        }
        least_m
    }
}

/// To the cells that are `shell` away along one axis and no more along the others.
fn offsets(shell: i32) -> impl Iterator<Item = IVec3> {
    let side = 2 * shell + 1;
    let all = (0..side.pow(3)).map(move |i| IVec3::new(i % side, i / side % side, i / side / side) - shell);
    all.filter(move |offset| offset.abs().max_element() == shell)
}

fn cell(at_m: DVec3, side_m: f64) -> IVec3 {
    (at_m / side_m).floor().as_ivec3()
}

/// From a point to the nearest of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
fn to_triangle_m(at_m: DVec3, [a, b, c]: &[DVec3; 3]) -> f64 {
    let (ab, ac, ap) = (*b - *a, *c - *a, at_m - *a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return ap.length();
    }
    let bp = at_m - *b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return bp.length();
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (ap - ab * (d1 / (d1 - d3))).length();
    }
    let cp = at_m - *c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return cp.length();
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (ap - ac * (d2 / (d2 - d6))).length();
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return (bp - (*c - *b) * ((d4 - d3) / (d4 - d3 + d5 - d6))).length();
    }
    let normal = ab.cross(ac).normalize_or_zero();
    ap.dot(normal).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surfaces::shapes::Shape;

    #[test]
    fn a_point_is_as_far_from_a_triangle_as_from_the_nearest_of_many_of_its_points() {
        let triangle = [DVec3::new(0.1, 0.2, 0.3), DVec3::new(1.1, 0.4, 0.2), DVec3::new(0.3, 1.3, 0.6)];
        let [a, b, c] = triangle;
        let mut random = fastrand::Rng::with_seed(5);
        for _ in 0..200 {
            let at_m = DVec3::new(random.f64(), random.f64(), random.f64()) * 3.0 - 1.0;
            let many = (0..=100).flat_map(|i| (0..=100 - i).map(move |j| (f64::from(i) / 100.0, f64::from(j) / 100.0)));
            let least =
                many.map(|(u, v)| (a + u * (b - a) + v * (c - a) - at_m).length()).fold(f64::INFINITY, f64::min);
            let got = to_triangle_m(at_m, &triangle);
            assert!(got <= least + 1e-12 && got > least - 0.02, "{at_m}: {got}, {least}");
        }
    }

    #[test]
    fn the_nearest_triangle_is_found_in_whatever_cell() {
        let mut random = fastrand::Rng::with_seed(6);
        let mut within = |side: f64| DVec3::new(random.f64(), random.f64(), random.f64()) * side;
        let triangles: Vec<[DVec3; 3]> = (0..60)
            .map(|_| within(1.0))
            .collect::<Vec<_>>()
            .into_iter()
            .map(|at| [at, at + within(0.2), at + within(0.2)])
            .collect();
        let grid = TriangleGrid::new(&triangles, 0.3);
        let (mut far, mut near) = (0, 0);
        for _ in 0..300 {
            let at_m = within(1.6) - 0.3;
            let least_m = triangles.iter().map(|triangle| to_triangle_m(at_m, triangle)).fold(0.3, f64::min);
            assert_eq!(grid.distance_m(at_m), least_m, "{at_m}");
            *if least_m < 0.3 { &mut near } else { &mut far } += 1;
        }
        assert!(near > 50 && far > 50, "{near} near, {far} far");
    }

    /// The sphere's own octahedron, cut six times and moved onto a sphere of another radius.
    fn ball(radius_m: f64) -> Vec<[DVec3; 3]> {
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z];
        let mut triangles: Vec<[DVec3; 3]> = Vec::new();
        for i in 0..8 {
            let sign = |bit: i32| if i >> bit & 1 == 0 { 1.0 } else { -1.0 };
            triangles.push([sign(0) * x, sign(1) * y, sign(2) * z]);
        }
        for _ in 0..5 {
            triangles = triangles
                .into_iter()
                .flat_map(|[a, b, c]| {
                    let [ab, bc, ca] = [(a + b).normalize(), (b + c).normalize(), (c + a).normalize()];
                    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
                })
                .collect();
        }
        let place = |v: DVec3| Shape::Sphere.middle_m() + radius_m * v;
        triangles.into_iter().map(|corners| corners.map(place)).collect()
    }

    #[test]
    fn a_larger_ball_is_as_far_off_as_it_is_larger_and_a_hole_is_seen() {
        let points_m = points_on(&Shape::Sphere, 1.0, 0.02);
        assert!(points_m.len() > 1000);
        let off = distances(&ball(0.26), &Shape::Sphere, &points_m, 0.05).unwrap();
        assert!((off.mean_m - 0.01).abs() < 2e-4 && (off.hausdorff_m - 0.01).abs() < 2e-4, "{off:?}");
        let holed = ball(0.25).split_off(1024);
        let off = distances(&holed, &Shape::Sphere, &points_m, 0.05).unwrap();
        assert!(off.mean_m < 2e-4 && off.hausdorff_m > 0.04, "{off:?}");
        assert!(distances(&[], &Shape::Sphere, &points_m, 0.05).is_none());
    }
}
