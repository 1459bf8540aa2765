//! Neighbours by brute force: every pair is looked at.

use glam::DVec3;

/// Neighbour lists, by particle.
pub type Neighbours = Vec<Vec<usize>>;

/// For each particle the others closer than `support_m`, ascending. Particles for which `alone`
/// is true are outside the grid: nobody's neighbours and without any.
pub fn list_neighbours(positions_m: &[DVec3], alone: impl Fn(usize) -> bool, support_m: f64) -> Neighbours {
    let near = |i: usize, j: usize| (positions_m[i] - positions_m[j]).length_squared() < support_m * support_m;
    (0..positions_m.len())
        .map(|i| {
            let others = 0..positions_m.len();
            if alone(i) { Vec::new() } else { others.filter(|&j| j != i && !alone(j) && near(i, j)).collect() }
        })
        .collect()
}

/// Whether `found`, in any order, is `expected` of particle `i` but for pairs whose distance is
/// within `doubt_m` of the support radius, which rounding may decide either way.
pub fn check_list(
    i: usize,
    found: &[usize],
    expected: &[usize],
    positions_m: &[DVec3],
    support_m: f64,
    doubt_m: f64,
) -> Result<(), String> {
    let mut found = found.to_vec();
    found.sort_unstable();
    if let Some(pair) = found.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(format!("particle {i} lists {} twice", pair[0]));
    }
    let doubtful = |j: usize| {
        let distance_m = (positions_m[i] - positions_m[j]).length();
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
    fn check_finds_what_is_wrong() {
        let points = lattice::points([3, 1, 1], 1.0);
        let check = |found: &[usize]| check_list(1, found, &[0, 2], &points, 1.5, 1e-6);
        assert!(check(&[2, 0]).is_ok());
        assert!(check(&[0]).is_err());
        assert!(check(&[0, 2, 1]).is_err());
        assert!(check(&[0, 0, 2]).is_err());
        assert!(check(&[0, 2, 7]).is_err());
        assert!(check_list(0, &[], &[1], &points, 1.0, 1e-6).is_ok());
    }
}
