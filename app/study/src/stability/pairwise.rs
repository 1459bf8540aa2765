//! Few runs in which every pair of factors' values meets at least once.

/// A covering of all pairs: rows of one value's index a factor, `sizes` saying how many values each has.
/// Where `allowed` is false a combination cannot be run, and is not asked for. Greedy (as AETG, Cohen et
/// al. 1997): not the fewest rows there could be, and the same ones every time.
pub fn covering(sizes: &[usize], allowed: impl Fn(&[Option<usize>]) -> bool) -> Vec<Vec<usize>> {
    let mut open: Vec<[(usize, usize); 2]> = Vec::new();
    for (a, &size_a) in sizes.iter().enumerate() {
        for (b, &size_b) in sizes.iter().enumerate().skip(a + 1) {
            for pair in (0..size_a).flat_map(|i| (0..size_b).map(move |j| [(a, i), (b, j)])) {
                if allowed(&with(&vec![None; sizes.len()], &pair)) {
                    open.push(pair);
                }
            }
        }
    }
    let mut rows = Vec::new();
    while let Some(&seed) = open.first() {
        let mut row = with(&vec![None; sizes.len()], &seed);
        for (factor, &size) in sizes.iter().enumerate() {
            if row[factor].is_some() {
                continue;
            }
            let gain = |value: usize| {
                let tried = with(&row, &[(factor, value)]);
                let met = open.iter().filter(|pair| pair.iter().all(|&(f, v)| tried[f] == Some(v))).count();
                allowed(&tried).then_some(met)
            };
            // The first of the best, so that the result does not depend on how a maximum is found.
            let best = (0..size)
                .filter_map(|value| Some((gain(value)?, value)))
                .max_by_key(|&(met, value)| (met, size - value));
            row[factor] = best.map(|(_, value)| value);
        }
        open.retain(|pair| !pair.iter().all(|&(f, v)| row[f] == Some(v)));
        // A row that cannot be filled would leave its seed open for good.
        open.retain(|pair| *pair != seed);
        if let Some(full) = row.into_iter().collect() {
            rows.push(full);
        }
    }
    rows
}

fn with(row: &[Option<usize>], values: &[(usize, usize)]) -> Vec<Option<usize>> {
    let mut row = row.to_vec();
    for &(factor, value) in values {
        row[factor] = Some(value);
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_that_is_allowed_is_met_and_none_that_is_not() {
        let sizes = [7, 3, 3, 2, 2];
        // The third value of the second factor goes with the first of the third alone.
        let allowed = |row: &[Option<usize>]| row[1] != Some(2) || row[2].is_none_or(|tier| tier == 0);
        let rows = covering(&sizes, allowed);
        for a in 0..sizes.len() {
            for b in a + 1..sizes.len() {
                for (i, j) in (0..sizes[a]).flat_map(|i| (0..sizes[b]).map(move |j| (i, j))) {
                    let met = rows.iter().any(|row| row[a] == i && row[b] == j);
                    let excluded = (a, b, i) == (1, 2, 2) && j != 0;
                    assert_eq!(met, !excluded, "{:?}", ((a, i), (b, j)));
                }
            }
        }
        assert!(rows.len() <= 30, "{}", rows.len());
    }
}
