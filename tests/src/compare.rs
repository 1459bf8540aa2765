//! Comparators of a kernel's output with its twin's, each fed a wrong input once in
//! `tests/tests/fluid/comparators.rs`.

use brooklet_fluid::particles::{is_inactive, is_quarantined};
use brooklet_kernels::{CellSlot, GridParams, Position};
use brooklet_reference::grid::count_cells::{SlotState, cell_of, cell_of_slot, check_ranks, count_cells};
use brooklet_reference::params::Grid;
use glam::DVec3;

/// What sums of some 30 terms of pairs may be off by, relative to the sum of the terms' lengths. In f32 each term has
/// a handful of roundings: 64. In f16 (`rounding` larger than f32's), where the sums are f32 all the same, terms'
/// roundings cancel: so many `half_roundings`, within four times of what is measured.
pub fn tolerance_of_pairs(rounding: f64, half_roundings: f64) -> f64 {
    if rounding > ROUNDING { half_roundings * rounding } else { 64.0 * rounding }
}

/// Half the distance of 1 to the next f32: the largest relative error of one rounding.
pub const ROUNDING: f64 = 5.960_464_477_539_063e-8;

/// The same of f16.
pub const HALF_ROUNDING: f64 = 4.882_812_5e-4;

/// Compares floats against a stated tolerance and keeps the largest difference seen.
#[derive(Debug)]
pub struct Worst {
    kernel: String,
    tolerance: f64,
    largest: f64,
    cases: usize,
}

impl Worst {
    /// A comparator for `kernel`. Differences are relative to the scale that each comparison names.
    pub fn new(kernel: impl Into<String>, tolerance: f64) -> Self {
        Self { kernel: kernel.into(), tolerance, largest: 0.0, cases: 0 }
    }

    /// Compares one number.
    ///
    /// # Errors
    /// If |got - expected| is not within tolerance x scale, as NaN never is.
    pub fn check(&mut self, got: f32, expected: f64, scale: f64) -> Result<(), String> {
        let difference = (f64::from(got) - expected).abs() / scale;
        self.cases += 1;
        // Written so that a NaN, which compares with nothing, is a failure.
        if difference <= self.tolerance {
            self.largest = self.largest.max(difference);
            return Ok(());
        }
        Err(format!(
            "{}: got {got}, expected {expected}: {difference:e} of {scale:e}, tolerance {:e}",
            self.kernel, self.tolerance
        ))
    }

    /// Compares three numbers by the length of their difference.
    ///
    /// # Errors
    /// As [`Worst::check`].
    pub fn check3(&mut self, got: [f32; 3], expected: DVec3, scale: f64) -> Result<(), String> {
        let difference = (vector(got) - expected).length() / scale;
        self.cases += 1;
        if difference <= self.tolerance {
            self.largest = self.largest.max(difference);
            return Ok(());
        }
        Err(format!(
            "{}: got {got:?}, expected {expected}: {difference:e} of {scale:e}, tolerance {:e}",
            self.kernel, self.tolerance
        ))
    }

    /// Prints the line that the project's reports quote.
    ///
    /// # Panics
    /// If nothing was compared: a test that compared nothing has not passed.
    pub fn report(&self) {
        assert!(self.cases > 0, "{}: nothing was compared", self.kernel);
        println!(
            "kernel {}: tolerance {:.1e}, largest difference {:.1e} over {} cases",
            self.kernel, self.tolerance, self.largest, self.cases
        );
    }
}

/// Prints the line of a kernel whose output is integers.
///
/// # Panics
/// If nothing was compared.
pub fn report_exact(kernel: &str, cases: usize) {
    assert!(cases > 0, "{kernel}: nothing was compared");
    println!("kernel {kernel}: exact over {cases} cases");
}

/// Compares integers.
///
/// # Errors
/// Names the first that differs, or the lengths.
pub fn check_exact(got: &[u32], expected: &[u32]) -> Result<(), String> {
    if got.len() != expected.len() {
        return Err(format!("{} values, expected {}", got.len(), expected.len()));
    }
    match got.iter().zip(expected).position(|(a, b)| a != b) {
        None => Ok(()),
        Some(i) => Err(format!("value {i}: got {}, expected {}", got[i], expected[i])),
    }
}

/// Whether `cell` is that of `position` / cell size, where coordinates within `doubt` of a face may
/// have been rounded across it. `cell_position` is the position in units of cells.
///
/// # Errors
/// Names the cell that was expected.
pub fn check_cell(cell: u32, cell_position: DVec3, grid: &Grid, doubt: f64) -> Result<(), String> {
    let index = |cell_position: DVec3| match cell_position.is_nan() {
        true => grid.cell_count(),
        false => cell_of(cell_position * grid.cell_size_m, grid),
    };
    let nudges = [-doubt, 0.0, doubt];
    let allowed = nudges
        .iter()
        .any(|&x| nudges.iter().any(|&y| nudges.iter().any(|&z| index(cell_position + DVec3::new(x, y, z)) == cell)));
    match allowed {
        true => Ok(()),
        false => Err(format!("cell {cell} at {cell_position}, expected {}", index(cell_position))),
    }
}

/// Whether `counts` and `slots` are those of `positions`: each in its cell (as [`check_cell`], with
/// its `doubt`) or, quarantined or inactive, behind the last; each rank of a cell once.
///
/// # Errors
/// Names the first that is not.
pub fn check_counted(
    positions: &[Position],
    counts: &[u32],
    slots: &[CellSlot],
    grid: &GridParams,
    doubt: f64,
) -> Result<(), String> {
    let cells: Vec<u32> = slots.iter().map(|slot| slot.cell).collect();
    let ranks: Vec<u32> = slots.iter().map(|slot| slot.rank).collect();
    let geometry = Grid {
        cells: grid.cells,
        domain_cells: grid.domain_cells,
        cell_size_m: f64::from(grid.cell_size_m),
        support_m: f64::from(grid.support_m),
    };
    for (position, &cell) in positions.iter().zip(&cells) {
        match slot_state(position.tag) {
            SlotState::Simulated => {
                let cell_position = vector(position.position_m) * f64::from(grid.inverse_cell_size_per_m);
                check_cell(cell, cell_position, &geometry, doubt)?;
            }
            state => check_exact(&[cell], &[cell_of_slot(DVec3::ZERO, state, &geometry)])?,
        }
    }
    check_exact(counts, &count_cells(&cells, grid.cell_count))?;
    check_ranks(&cells, &ranks, grid.cell_count)
}

/// What the slot of a tag holds.
pub fn slot_state(tag: u32) -> SlotState {
    match (is_inactive(tag), is_quarantined(tag)) {
        (true, _) => SlotState::Inactive,
        (_, true) => SlotState::Quarantined,
        _ => SlotState::Simulated,
    }
}

/// A GPU vector in f64.
pub fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}
