//! Moving attributes to cell order.

/// Sorted index of each particle: its cell's start plus its rank in the cell.
pub fn sorted_indices(cells: &[u32], ranks: &[u32], starts: &[u32]) -> Vec<usize> {
    cells.iter().zip(ranks).map(|(&cell, &rank)| (starts[cell as usize] + rank) as usize).collect()
}

/// `values[i]` at `sorted_indices[i]`.
pub fn reorder<T: Copy>(values: &[T], sorted_indices: &[usize]) -> Vec<T> {
    let mut out = values.to_vec();
    for (value, &index) in values.iter().zip(sorted_indices) {
        out[index] = *value;
    }
    out
}

/// Sorted indices of a stable sort by cell, one of the orders that the atomic sort may give.
pub fn stable_sorted_indices(cells: &[u32]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by_key(|&i| cells[i]);
    let mut sorted_indices = vec![0; cells.len()];
    for (index, &i) in order.iter().enumerate() {
        sorted_indices[i] = index;
    }
    sorted_indices
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{count_cells::count_cells, scan::scan};

    #[test]
    fn starts_and_ranks_are_the_stable_sort() {
        let cells = [3, 1, 3, 0, 1, 3];
        let ranks = [0, 0, 1, 0, 1, 2];
        let starts = scan(&count_cells(&cells, 4));
        let sorted_indices = sorted_indices(&cells, &ranks, &starts);
        assert_eq!(sorted_indices, stable_sorted_indices(&cells));
        assert_eq!(reorder(&cells, &sorted_indices), [0, 1, 1, 3, 3, 3]);
    }
}
