//! The deterministic order of a cell's particles.

/// The rank of each particle in its cell: how many of the cell's have a lower id. Those of cell
/// `outside` have none that is fixed.
pub fn rank_by_id(cells: &[u32], ids: &[u32], outside: u32) -> Vec<Option<u32>> {
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by_key(|&i| (cells[i], ids[i]));
    let mut ranks = vec![None; cells.len()];
    let mut first = 0;
    for (slot, &i) in order.iter().enumerate() {
        if cells[order[first]] != cells[i] {
            first = slot;
        }
        if cells[i] != outside {
            ranks[i] = Some((slot - first) as u32);
        }
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_follow_ids() {
        let ranks = rank_by_id(&[1, 0, 1, 9, 1, 9], &[7, 3, 2, 1, 5, 0], 9);
        assert_eq!(ranks, [Some(2), Some(0), Some(0), None, Some(1), None]);
        assert!(rank_by_id(&[], &[], 0).is_empty());
    }
}
