//! The spacing of particles that nobody says the spacing of.

/// Particles that are looked at.
const LOOKED_AT: usize = 1000;
/// Neighbours that a particle of a lattice has one spacing away.
const NEAREST: usize = 6;

/// Half of (at most a thousand of) the particles have their six nearest no further away on average: a lattice's spacing,
/// and that of a fluid, where some are nearer and some further, within a few hundredths. None of fewer than two
/// particles, nor where most are in one place.
pub fn estimate_spacing(positions_m: &[[f64; 3]]) -> Option<f64> {
    let count = positions_m.len();
    let nearest = NEAREST.min(count.saturating_sub(1));
    if nearest == 0 {
        return None;
    }
    // Sorted along the axis where they are furthest apart, those nearby are in a slice around.
    let extent_m = |axis: usize| {
        let along = || positions_m.iter().map(|position_m| position_m[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let axis = (0..3).max_by(|&a, &b| extent_m(a).total_cmp(&extent_m(b)))?;
    let mut sorted = positions_m.to_vec();
    sorted.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
    let looked_at = count.min(LOOKED_AT);
    let mut means_m: Vec<f64> = (0..looked_at)
        .map(|number| {
            let own = number * count / looked_at;
            mean_distance_m(&sorted, own, axis, nearest)
        })
        .collect();
    means_m.sort_unstable_by(f64::total_cmp);
    Some(means_m[looked_at / 2]).filter(|spacing_m| *spacing_m > 0.0)
}

/// Mean distance of the particle at `own` to its `nearest` nearest. `sorted` is sorted along `axis`.
fn mean_distance_m(sorted: &[[f64; 3]], own: usize, axis: usize, nearest: usize) -> f64 {
    let at_m = sorted[own];
    // The nearest so far, squared, in ascending order.
    let mut squares_m2 = [f64::INFINITY; NEAREST];
    let mut look = |other_m: &[f64; 3]| {
        let along_m = other_m[axis] - at_m[axis];
        if along_m * along_m >= squares_m2[nearest - 1] {
            return false;
        }
        let square_m2 = (0..3).map(|axis| (other_m[axis] - at_m[axis]).powi(2)).sum::<f64>();
        let place = squares_m2[..nearest].partition_point(|other| *other <= square_m2);
        if place < nearest {
            squares_m2[place..nearest].rotate_right(1);
            squares_m2[place] = square_m2;
        }
        true
    };
    // Both ways at once: the nearest are found early, and end both.
    let (mut above, mut below) = (sorted[own + 1..].iter(), sorted[..own].iter().rev());
    let (mut is_above, mut is_below) = (true, true);
    while is_above || is_below {
        is_above = is_above && above.next().is_some_and(&mut look);
        is_below = is_below && below.next().is_some_and(&mut look);
    }
    squares_m2[..nearest].iter().map(|square_m2| square_m2.sqrt()).sum::<f64>() / nearest as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(counts: [u32; 3], spacing_m: f64, jitter: f64) -> Vec<[f64; 3]> {
        let mut random = numbers(7);
        let mut positions_m = Vec::new();
        for x in 0..counts[0] {
            for y in 0..counts[1] {
                for z in 0..counts[2] {
                    let at = [x, y, z].map(|n| spacing_m * (f64::from(n) + jitter * (random() - 0.5)));
                    positions_m.push(at);
                }
            }
        }
        positions_m
    }

    /// Numbers from 0 to 1, the same every time.
    fn numbers(mut state: u64) -> impl FnMut() -> f64 {
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    #[test]
    fn a_lattice_has_its_spacing() {
        for (jitter, within) in [(0.0, 1e-12), (0.2, 0.03), (0.5, 0.06)] {
            let estimated_m = estimate_spacing(&lattice([9, 20, 14], 0.02, jitter)).unwrap();
            assert!((estimated_m / 0.02 - 1.0).abs() <= within, "{jitter}: {estimated_m}");
        }
        assert!((estimate_spacing(&lattice([2, 1, 1], 0.5, 0.0)).unwrap() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn some_have_none() {
        for none in [vec![], vec![[1.0; 3]], vec![[1.0; 3]; 500]] {
            assert_eq!(estimate_spacing(&none), None);
        }
    }
}
