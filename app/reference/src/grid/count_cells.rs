//! Which cell each particle is in, and how many a cell holds.

use crate::params::Grid;
use glam::DVec3;

/// The cell of a position, x fastest; `cell_count` for what is outside the grid.
pub fn cell_of(position_m: DVec3, grid: &Grid) -> u32 {
    let cell = (position_m / grid.cell_size_m).floor();
    let mut index = 0;
    for axis in [2, 1, 0] {
        if cell[axis] < 0.0 || cell[axis] >= f64::from(grid.domain_cells[axis]) {
            return grid.cell_count();
        }
        index = index * grid.cells[axis] + cell[axis] as u32 % grid.cells[axis];
    }
    index
}

/// The cell that a slot is sorted into: `cell_count` for what is quarantined, one more for an inactive slot.
pub fn cell_of_slot(position_m: DVec3, state: SlotState, grid: &Grid) -> u32 {
    match state {
        SlotState::Simulated => cell_of(position_m, grid),
        SlotState::Quarantined => grid.cell_count(),
        SlotState::Inactive => grid.cell_count() + 1,
    }
}

/// What a slot holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlotState {
    /// A particle that takes part.
    Simulated,
    /// One whose state was not finite.
    Quarantined,
    /// Nothing.
    Inactive,
}

/// How many of `cells` name each of the `cell_count + 2` cells: the last but one is outside, the last has inactive slots.
pub fn count_cells(cells: &[u32], cell_count: u32) -> Vec<u32> {
    let mut counts = vec![0; cell_count as usize + 2];
    for &cell in cells {
        counts[cell as usize] += 1;
    }
    counts
}

/// Whether `ranks` number the particles of each cell 0, 1, 2, ... in any order, which is all that
/// an atomic counting sort promises. Names the first particle where they do not.
pub fn check_ranks(cells: &[u32], ranks: &[u32], cell_count: u32) -> Result<(), String> {
    if cells.len() != ranks.len() {
        return Err(format!("{} cells but {} ranks", cells.len(), ranks.len()));
    }
    let counts = count_cells(cells, cell_count);
    let mut taken: Vec<Vec<bool>> = counts.iter().map(|&n| vec![false; n as usize]).collect();
    for (i, (&cell, &rank)) in cells.iter().zip(ranks).enumerate() {
        match taken[cell as usize].get_mut(rank as usize) {
            None => {
                return Err(format!("particle {i}: rank {rank} past the end of cell {cell}"));
            }
            Some(true) => return Err(format!("particle {i}: rank {rank} of cell {cell} twice")),
            Some(free) => *free = true,
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRID: Grid = Grid { cells: [4, 3, 2], domain_cells: [4, 3, 2], cell_size_m: 0.5, support_m: 1.0 };

    #[test]
    fn x_is_fastest_and_outside_is_last() {
        assert_eq!(cell_of(DVec3::ZERO, &GRID), 0);
        assert_eq!(cell_of(DVec3::new(0.6, 0.0, 0.0), &GRID), 1);
        assert_eq!(cell_of(DVec3::new(0.0, 0.6, 0.0), &GRID), 4);
        assert_eq!(cell_of(DVec3::new(0.0, 0.0, 0.6), &GRID), 12);
        assert_eq!(cell_of(DVec3::new(1.9, 1.4, 0.9), &GRID), 23);
        for outside in [DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, -1e-9, 0.0)] {
            assert_eq!(cell_of(outside, &GRID), 24);
        }
    }

    #[test]
    fn counts_and_ranks() {
        let cells = [3, 1, 3, 4, 3];
        assert_eq!(count_cells(&cells, 4), [0, 1, 0, 3, 1, 0]);
        assert_eq!(count_cells(&[5, 4, 5], 4), [0, 0, 0, 0, 1, 2]);
        assert!(check_ranks(&cells, &[2, 0, 0, 0, 1], 4).is_ok());
        assert!(check_ranks(&cells, &[2, 0, 0, 0, 0], 4).is_err());
        assert!(check_ranks(&cells, &[3, 0, 0, 0, 1], 4).is_err());
        assert!(check_ranks(&cells, &[0], 4).is_err());
    }
}
