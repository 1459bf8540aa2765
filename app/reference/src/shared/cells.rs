//! Points sorted into cells, to look at near ones only.

use glam::DVec3;
use std::collections::HashMap;

/// Points by cell.
pub struct Cells<'a> {
    points: &'a [DVec3],
    size: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> Cells<'a> {
    /// Sorts `points` into cubes of edge `size`.
    pub fn new(points: &'a [DVec3], size: f64) -> Self {
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        for (i, &point) in points.iter().enumerate() {
            cells.entry(cell(point, size)).or_default().push(i);
        }
        Self { points, size, cells }
    }

    /// Indices of the points in the cells that touch the cube of half-edge `reach` around `at`:
    /// every point within `reach`, and some beyond.
    pub fn near(&self, at: DVec3, reach: f64) -> impl Iterator<Item = usize> + '_ {
        let low = cell(at - reach, self.size);
        let high = cell(at + reach, self.size);
        (low[2]..=high[2])
            .flat_map(move |z| (low[1]..=high[1]).flat_map(move |y| (low[0]..=high[0]).map(move |x| [x, y, z])))
            .filter_map(|key| self.cells.get(&key))
            .flatten()
            .copied()
    }

    /// Distance from `at` to the nearest point; infinite when there is none.
    pub fn nearest(&self, at: DVec3) -> f64 {
        if self.points.is_empty() {
            return f64::INFINITY;
        }
        let mut reach = self.size;
        loop {
            let nearest = self.near(at, reach).map(|i| (self.points[i] - at).length()).fold(f64::INFINITY, f64::min);
            // Only what is within reach is known to have been looked at.
            if nearest <= reach {
                return nearest;
            }
            reach *= 2.0;
            if reach > 64.0 * self.size {
                let all = self.points.iter().map(|p| (*p - at).length());
                return all.fold(f64::INFINITY, f64::min);
            }
        }
    }
}

fn cell(point: DVec3, size: f64) -> [i64; 3] {
    (point / size).floor().to_array().map(|c| c as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::lattice;

    #[test]
    fn finds_what_brute_force_finds() {
        let points = lattice::points([6, 5, 4], 0.3);
        let cells = Cells::new(&points, 0.4);
        for at in [DVec3::splat(0.5), DVec3::new(-3.0, 0.1, 9.0), DVec3::splat(99.0)] {
            let all = points.iter().map(|p| (*p - at).length());
            assert_eq!(cells.nearest(at), all.fold(f64::INFINITY, f64::min));
            let within = |i: &usize| (points[*i] - at).length() <= 0.7;
            let mut near: Vec<usize> = cells.near(at, 0.7).filter(within).collect();
            near.sort_unstable();
            let all: Vec<usize> = (0..points.len()).filter(within).collect();
            assert_eq!(near, all);
        }
    }
}
