//! Triangles with shared corners.

use glam::DVec3;

/// Triangles that a mesh may have: their tree then has some hundred megabytes.
pub const MOST_TRIANGLES: usize = 2_000_000;
/// How far from its origin a mesh may reach, m.
pub const MOST_SIZE_M: f64 = 1.0e6;

/// Triangles, counter-clockwise as seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners, m.
    pub positions_m: Vec<DVec3>,
    /// Three corners a triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The places of a triangle's corners.
    pub fn corners_m(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|corner| self.positions_m[corner as usize])
    }

    /// Lowest and highest corner of the box around it.
    pub fn bounds_m(&self) -> [DVec3; 2] {
        let used = self.triangles.iter().flatten().map(|&corner| self.positions_m[corner as usize]);
        used.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low_m, high_m], at_m| [low_m.min(at_m), high_m.max(at_m)])
    }

    /// What a closed one holds, m³; below 0 where its triangles face inward.
    pub fn volume_m3(&self) -> f64 {
        let middle_m = self.bounds_m().into_iter().sum::<DVec3>() / 2.0;
        let of = |triangle: usize| {
            let [a, b, c] = self.corners_m(triangle).map(|corner_m| corner_m - middle_m);
            a.dot(b.cross(c)) / 6.0
        };
        (0..self.triangles.len()).map(of).sum()
    }

    /// The sum of its triangles' areas, m².
    pub fn area_m2(&self) -> f64 {
        (0..self.triangles.len()).map(|triangle| self.area_normal_m2(triangle).length()).sum()
    }

    /// A triangle's normal, as long as its area.
    pub fn area_normal_m2(&self, triangle: usize) -> DVec3 {
        let [a, b, c] = self.corners_m(triangle);
        0.5 * (b - a).cross(c - a)
    }

    /// The same, `by` times as large.
    pub fn scaled(mut self, by: f64) -> Self {
        self.positions_m.iter_mut().for_each(|at_m| *at_m *= by);
        self
    }

    /// Turns all triangles over.
    pub fn flip(&mut self) {
        self.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
}
