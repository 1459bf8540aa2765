//! Exclusive prefix sums, in the wrapping arithmetic of u32.

/// The sum of each run of `group` values; the last run may be shorter.
pub fn reduce_groups(values: &[u32], group: usize) -> Vec<u32> {
    values.chunks(group).map(|run| run.iter().fold(0, |sum: u32, &v| sum.wrapping_add(v))).collect()
}

/// Exclusive sums inside each run of `group` values, plus the run's offset, or none.
pub fn scan_groups(values: &[u32], group: usize, offsets: Option<&[u32]>) -> Vec<u32> {
    let mut out = Vec::with_capacity(values.len());
    for (run, values) in values.chunks(group).enumerate() {
        let mut sum: u32 = offsets.map_or(0, |offsets| offsets[run]);
        for &value in values {
            out.push(sum);
            sum = sum.wrapping_add(value);
        }
    }
    out
}

/// The sum of everything before each value: what the levels of the two kernels amount to.
pub fn scan(values: &[u32]) -> Vec<u32> {
    scan_groups(values, values.len().max(1), None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_make_the_whole() {
        let values: Vec<u32> = (0..1000).map(|i| i * i % 97).collect();
        let offsets = scan(&reduce_groups(&values, 64));
        assert_eq!(scan_groups(&values, 64, Some(&offsets)), scan(&values));
        assert_eq!(scan(&[5, 7, 11]), [0, 5, 12]);
        assert!(scan(&[]).is_empty());
    }
}
