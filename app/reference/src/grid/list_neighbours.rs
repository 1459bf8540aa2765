//! Neighbours by brute force: every pair is looked at. And by cells, for those who have many.

use crate::params::{nearest_image, next_image};
use glam::DVec3;
use std::collections::HashMap;

/// Neighbour lists, by particle.
pub type Neighbours = Vec<Vec<usize>>;

/// For each particle the others closer than `support_m`, ascending. Particles for which `alone`
/// is true are outside the grid: nobody's neighbours and without any.
pub fn list_neighbours(positions_m: &[DVec3], alone: impl Fn(usize) -> bool, support_m: f64) -> Neighbours {
    list_images(positions_m, alone, support_m, DVec3::ZERO)
}

/// As [`list_neighbours`], where the others' images count too: along each axis a whole number of
/// `period_m` away, which is 0 where an axis has none, and elsewhere at least 2 supports.
pub fn list_images(
    positions_m: &[DVec3],
    alone: impl Fn(usize) -> bool,
    support_m: f64,
    period_m: DVec3,
) -> Neighbours {
    let offset = |i: usize, j: usize| nearest_image(positions_m[i] - positions_m[j], period_m);
    let near = |i: usize, j: usize| offset(i, j).length_squared() < support_m * support_m;
    (0..positions_m.len())
        .map(|i| {
            let others = 0..positions_m.len();
            if alone(i) { Vec::new() } else { others.filter(|&j| j != i && !alone(j) && near(i, j)).collect() }
        })
        .collect()
}

/// The same lists, from cells as wide as the support or wider; a period is at least 3 supports.
pub fn list_by_cells(
    positions_m: &[DVec3],
    alone: impl Fn(usize) -> bool,
    support_m: f64,
    period_m: DVec3,
) -> Neighbours {
    let offset = |i: usize, j: usize| next_image(positions_m[i] - positions_m[j], period_m);
    let near = |i: usize, j: usize| offset(i, j).length_squared() < support_m * support_m;
    // Cells along a period, none along other axes.
    let turns = (period_m / support_m).floor();
    let size_m = DVec3::select(turns.cmpgt(DVec3::ZERO), period_m / turns, DVec3::splat(support_m));
    let onto = |mut cell: [i64; 3]| {
        for axis in 0..3 {
            if turns[axis] > 0.0 {
                cell[axis] = cell[axis].rem_euclid(turns[axis] as i64);
            }
        }
        cell
    };
    let cell_of = |i: usize| (positions_m[i] / size_m).floor().to_array().map(|c| c as i64);
    let mut members: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for i in (0..positions_m.len()).filter(|&i| !alone(i)) {
        members.entry(onto(cell_of(i))).or_default().push(i);
    }
    // A cell's particles look into the same cells.
    let mut lists = vec![Vec::new(); positions_m.len()];
    for of_cell in members.values() {
        let cell = cell_of(of_cell[0]);
        let around = (0..27).map(|k| [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1]);
        let cells = around.map(|step| onto(std::array::from_fn(|axis| cell[axis] + step[axis])));
        let mut held: Vec<usize> = cells.filter_map(|cell| members.get(&cell)).flatten().copied().collect();
        held.sort_unstable();
        for &i in of_cell {
            lists[i] = held.iter().copied().filter(|&j| j != i && near(i, j)).collect();
        }
    }
    lists
}

/// Whether `found`, in any order, is `expected` of particle `i` but for pairs whose distance is
/// within `doubt_m` of the support radius, which rounding may decide either way.
pub fn check_list(
    i: usize,
    found: &[usize],
    expected: &[usize],
    positions_m: &[DVec3],
    support_m: f64,
    period_m: DVec3,
    doubt_m: f64,
) -> Result<(), String> {
    let mut found = found.to_vec();
    found.sort_unstable();
    if let Some(pair) = found.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(format!("particle {i} lists {} twice", pair[0]));
    }
    let doubtful = |j: usize| {
        let distance_m = nearest_image(positions_m[i] - positions_m[j], period_m).length();
        (distance_m - support_m).abs() <= doubt_m
    };
    for &j in &found {
        if j >= positions_m.len() {
            return Err(format!("particle {i} lists {j}, which does not exist"));
        }
        if expected.binary_search(&j).is_err() && (j == i || !doubtful(j)) {
            return Err(format!("particle {i} lists {j}, which is no neighbour"));
        }
    }
    for &j in expected {
        if found.binary_search(&j).is_err() && !doubtful(j) {
            return Err(format!("particle {i} misses its neighbour {j}"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::lattice;

    #[test]
    fn lattice_has_its_shells() {
        // Within 2 d, exclusive: 6 + 12 + 8 at 1, sqrt 2 and sqrt 3.
        let points = lattice::points([5, 5, 5], 1.0);
        let lists = list_neighbours(&points, |_| false, 2.0);
        assert_eq!(lists[62].len(), 26);
        assert_eq!(lists[0].len(), 7);
        let lists = list_neighbours(&points, |i| i == 62, 2.0);
        assert!(lists[62].is_empty());
        assert!(lists.iter().all(|list| !list.contains(&62)));
    }

    #[test]
    fn cells_and_brute_force_list_the_same() {
        // Scattered, beyond the domain too, on its corners, and across the seams of some axes.
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(1_u32 << 31)
        };
        for period_m in [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(4.0, 8.0, 3.3)] {
            let mut points: Vec<DVec3> =
                (0..500).map(|_| DVec3::new(random(), random(), random()) * DVec3::new(4.0, 8.0, 3.3)).collect();
            points.extend([DVec3::ZERO, DVec3::new(4.0, 8.0, 3.3), DVec3::new(-0.5, -0.5, -0.5)]);
            let alone = |i: usize| i % 17 == 3;
            let all = list_images(&points, alone, 1.0, period_m);
            assert_eq!(list_by_cells(&points, alone, 1.0, period_m), all);
            assert_ne!(list_by_cells(&points, alone, 1.001, period_m), all);
            let across = all != list_neighbours(&points, alone, 1.0);
            assert_eq!(across, period_m != DVec3::ZERO, "a seam has neighbours on both sides");
        }
    }

    #[test]
    fn a_periodic_lattice_has_its_shells_everywhere() {
        let points = lattice::points([4, 4, 4], 1.0);
        let lists = list_images(&points, |_| false, 1.9, DVec3::splat(4.0));
        assert!(lists.iter().all(|list| list.len() == 26));
    }

    #[test]
    fn check_finds_what_is_wrong() {
        let points = lattice::points([3, 1, 1], 1.0);
        let check = |found: &[usize]| check_list(1, found, &[0, 2], &points, 1.5, DVec3::ZERO, 1e-6);
        assert!(check(&[2, 0]).is_ok());
        assert!(check(&[0]).is_err());
        assert!(check(&[0, 2, 1]).is_err());
        assert!(check(&[0, 0, 2]).is_err());
        assert!(check(&[0, 2, 7]).is_err());
        assert!(check_list(0, &[], &[1], &points, 1.0, DVec3::ZERO, 1e-6).is_ok());
    }
}
