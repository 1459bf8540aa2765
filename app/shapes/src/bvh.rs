//! A tree of boxes over triangles: the nearest point on them, and how often they wind around a place.
//!
//! Far branches count in the winding number as one dipole each (Barill et al. 2018, first order).

use glam::DVec3;

use crate::mesh::Mesh;

const LEAF: usize = 4;
/// Radii of a branch beyond which it counts as a dipole: off by less than a hundredth.
const FAR: f64 = 3.0;

struct Node {
    low_m: DVec3,
    high_m: DVec3,
    /// Of a leaf its first triangle, of a branch its second child; the first is the next node.
    first: u32,
    /// Triangles of a leaf; 0: a branch.
    count: u32,
    /// Sum of the normals, as long as the areas.
    dipole_m2: DVec3,
    /// Where that acts, and how far triangles reach from there.
    centre_m: DVec3,
    radius_m: f64,
}

/// The tree.
pub struct Bvh {
    nodes: Vec<Node>,
    /// Corners in the order of leaves.
    triangles_m: Vec<[DVec3; 3]>,
}

/// The point of a triangle that is nearest to a place (Ericson 2005, with edges alone of one without an area).
pub fn nearest_on_triangle(place_m: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac, ap) = (b - a, c - a, place_m - a);
    let across = ab.cross(ac);
    if across.length_squared() <= 1.0e-24 * ab.length_squared().max(ac.length_squared()).powi(2) {
        let on = |from: DVec3, to: DVec3| {
            let along = to - from;
            let share = (place_m - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
            from + along * share.clamp(0.0, 1.0)
        };
        let nearer = |p: DVec3, q: DVec3| {
            if p.distance_squared(place_m) <= q.distance_squared(place_m) { p } else { q }
        };
        return nearer(nearer(on(a, b), on(b, c)), on(c, a));
    }
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = place_m - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = place_m - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    a + (ab * vb + ac * vc) / (va + vb + vc)
}

/// A triangle's solid angle over 4 pi (van Oosterom & Strackee 1983).
fn winding_of(place_m: DVec3, triangle_m: [DVec3; 3]) -> f64 {
    let [a, b, c] = triangle_m.map(|corner_m| corner_m - place_m);
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let above = a.dot(b.cross(c));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    above.atan2(below) / (2.0 * std::f64::consts::PI)
}

fn box_distance_squared(place_m: DVec3, node: &Node) -> f64 {
    (node.low_m - place_m).max(place_m - node.high_m).max(DVec3::ZERO).length_squared()
}

impl Bvh {
    /// Of a mesh with at least one triangle.
    pub fn new(mesh: &Mesh) -> Self {
        let mut triangles_m: Vec<[DVec3; 3]> = (0..mesh.triangles.len()).map(|number| mesh.corners_m(number)).collect();
        let mut nodes = Vec::with_capacity(triangles_m.len());
        let count = triangles_m.len();
        build(&mut nodes, &mut triangles_m, 0, count);
        Self { nodes, triangles_m }
    }

    /// The nearest point on a triangle, if one is within a distance.
    pub fn nearest_m(&self, place_m: DVec3, within_m: f64) -> Option<DVec3> {
        let (mut best, mut nearest_m) = (within_m * within_m, None);
        let mut stack = [(0_u32, 0.0_f64); 64];
        let mut depth = 1;
        stack[0] = (0, box_distance_squared(place_m, &self.nodes[0]));
        while depth > 0 {
            depth -= 1;
            let (index, away) = stack[depth];
            if away > best {
                continue;
            }
            let node = &self.nodes[index as usize];
            if node.count > 0 {
                for &triangle_m in &self.triangles_m[node.first as usize..(node.first + node.count) as usize] {
                    let on_m = nearest_on_triangle(place_m, triangle_m);
                    let away = on_m.distance_squared(place_m);
                    if away <= best {
                        (best, nearest_m) = (away, Some(on_m));
                    }
                }
                continue;
            }
            let children = [index + 1, node.first]
                .map(|child| (child, box_distance_squared(place_m, &self.nodes[child as usize])));
            let nearer_last = if children[0].1 < children[1].1 { [children[1], children[0]] } else { children };
            for child in nearer_last.into_iter().filter(|child| child.1 <= best) {
                stack[depth] = child;
                depth += 1;
            }
        }
        nearest_m
    }

    /// How often triangles wind around a place: 1 inside a closed mesh that faces outward, 0 outside of it, off by less than
    /// a hundredth.
    pub fn winding(&self, place_m: DVec3) -> f64 {
        let mut sum = 0.0;
        let mut stack = vec![0_u32];
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index as usize];
            let to_m = node.centre_m - place_m;
            let away_m = to_m.length();
            if away_m > FAR * node.radius_m {
                sum += node.dipole_m2.dot(to_m) / (4.0 * std::f64::consts::PI * away_m.powi(3));
            } else if node.count > 0 {
                let own = &self.triangles_m[node.first as usize..(node.first + node.count) as usize];
                sum += own.iter().map(|&triangle_m| winding_of(place_m, triangle_m)).sum::<f64>();
            } else {
                stack.extend([index + 1, node.first]);
            }
        }
        sum
    }
}

/// Adds the tree of some triangles: split in two halves along their longest side, so that it is 22 deep at most.
fn build(nodes: &mut Vec<Node>, triangles_m: &mut [[DVec3; 3]], from: usize, to: usize) {
    let index = nodes.len();
    let own = &mut triangles_m[from..to];
    let around = own
        .iter()
        .flatten()
        .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low_m, high_m], &at_m| [low_m.min(at_m), high_m.max(at_m)]);
    let (mut dipole_m2, mut weighted, mut area_m2) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    for [a, b, c] in own.iter() {
        let normal_m2 = 0.5 * (b - a).cross(c - a);
        let own_m2 = normal_m2.length();
        dipole_m2 += normal_m2;
        weighted += (a + b + c) / 3.0 * own_m2;
        area_m2 += own_m2;
    }
    let middle_m = 0.5 * (around[0] + around[1]);
    let centre_m = if area_m2 > 0.0 { weighted / area_m2 } else { middle_m };
    let radius_m = own.iter().flatten().map(|at_m| at_m.distance(centre_m)).fold(0.0, f64::max);
    let [low_m, high_m] = around;
    nodes.push(Node { low_m, high_m, first: from as u32, count: 0, dipole_m2, centre_m, radius_m });
    if to - from <= LEAF {
        nodes[index].count = (to - from) as u32;
        return;
    }
    let middles = |[a, b, c]: &[DVec3; 3], axis: usize| a[axis] + b[axis] + c[axis];
    let size_m = high_m - low_m;
    let axis = (0..3).fold(0, |longest, axis| if size_m[axis] > size_m[longest] { axis } else { longest });
    let half = (to - from) / 2;
    own.select_nth_unstable_by(half, |a, b| middles(a, axis).total_cmp(&middles(b, axis)));
    build(nodes, triangles_m, from, from + half);
    nodes[index].first = nodes.len() as u32;
    build(nodes, triangles_m, from + half, to);
}
