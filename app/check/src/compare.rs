//! Comparators of a kernel's output with its twin's, each fed a wrong input once in
//! `tests/tests/fluid/comparators.rs`.

use std::fmt::Debug;
use std::rc::Rc;

use crate::device::{Device, Record};
use crate::wrong::{Found, Wrong, ensure, note, raise, shown};
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
pub struct Worst {
    of: String,
    tolerance: f64,
    largest: f64,
    cases: usize,
    /// Where it gathers what is wrong until it tells.
    record: Option<Rc<Record>>,
    gathered: Gathered,
}

/// What a comparator gathered.
#[derive(Default)]
struct Gathered {
    /// The furthest off, and how far.
    wrong: Option<(f64, Wrong)>,
    beyond: usize,
    /// The plan that was run last, and the modules in question of it.
    plan: u64,
    modules: Vec<&'static str>,
    /// Numbers of that plan so far, and the largest difference of them.
    numbers: usize,
    largest: f64,
}

impl Worst {
    /// A comparator that fails at the first number that is wrong. Differences are relative to the scale that each
    /// comparison names.
    pub fn new(of: impl Into<String>, tolerance: f64) -> Self {
        let gathered = Gathered::default();
        Self { of: of.into(), tolerance, largest: 0.0, cases: 0, record: None, gathered }
    }

    /// Its tolerance.
    pub(crate) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Compares one number.
    ///
    /// # Errors
    /// If |got - expected| is not within tolerance x scale, as NaN never is; one that gathers tells so in
    /// [`Worst::report`].
    pub fn check(&mut self, got: f32, expected: f64, scale: f64) -> Result<(), Wrong> {
        let difference = (f64::from(got) - expected).abs() / scale;
        self.take(difference, || (got.to_string(), expected.to_string()))
    }

    /// Compares three numbers by the length of their difference.
    ///
    /// # Errors
    /// As [`Worst::check`].
    pub fn check3(&mut self, got: [f32; 3], expected: DVec3, scale: f64) -> Result<(), Wrong> {
        let difference = (vector(got) - expected).length() / scale;
        self.take(difference, || (format!("{got:?}"), expected.to_string()))
    }

    fn take(&mut self, difference: f64, values: impl FnOnce() -> (String, String)) -> Result<(), Wrong> {
        self.cases += 1;
        let element = self.follow(difference);
        // Written so that a NaN, which compares with nothing, is a failure.
        if difference <= self.tolerance {
            self.largest = self.largest.max(difference);
            return Ok(());
        }
        let off = if difference.is_nan() { f64::INFINITY } else { difference };
        let wrong = || -> Wrong {
            let (got, expected) = values();
            let modules = self.gathered.modules.clone();
            let difference = Some([difference, self.tolerance]);
            Found { of: self.of.clone(), modules, element, got, expected, difference, ..Found::default() }.into()
        };
        if self.record.is_none() {
            return Err(wrong());
        }
        self.gathered.beyond += 1;
        if self.gathered.wrong.as_ref().is_none_or(|(furthest, _)| off > *furthest) {
            self.gathered.wrong = Some((off, wrong()));
        }
        Ok(())
    }

    /// Which number of the last plan's this is.
    fn follow(&mut self, difference: f64) -> Option<usize> {
        let record = self.record.as_ref()?;
        if record.plan.get() != self.gathered.plan {
            let (plan, modules) = (record.plan.get(), record.modules_of(&self.of));
            self.tell_modules();
            (self.gathered.plan, self.gathered.modules) = (plan, modules);
        }
        self.gathered.numbers += 1;
        self.gathered.largest = self.gathered.largest.max(difference);
        Some(self.gathered.numbers - 1)
    }

    /// Gives what was seen of a plan's modules to the record.
    fn tell_modules(&mut self) {
        if let Some(record) = &self.record
            && self.gathered.numbers > 0
        {
            let Gathered { modules, numbers, largest, .. } = &self.gathered;
            record.compared(modules, *numbers, [*largest, self.tolerance]);
        }
        (self.gathered.numbers, self.gathered.largest) = (0, 0.0);
    }

    fn gathered_wrong(&mut self) -> Option<Wrong> {
        self.tell_modules();
        self.record = None;
        let beyond = Some([self.gathered.beyond, self.cases]);
        let (_, mut wrong) = self.gathered.wrong.take()?;
        wrong.beyond = beyond;
        Some(wrong)
    }

    /// Ends the case if something that was gathered is wrong, or nothing was compared: a case that compared nothing has
    /// not passed. Keeps the line that the project's reports quote. From then on the first number that is wrong fails.
    pub fn report(&mut self, device: &Device) {
        if self.record.is_none() {
            device.record.compared(&device.record.modules_of(&self.of), self.cases, [self.largest, self.tolerance]);
        }
        if let Some(wrong) = self.gathered_wrong() {
            raise(wrong);
        }
        ensure!(self.cases > 0, "{}: nothing was compared", self.of);
        note!(
            device,
            "kernel {}: tolerance {:.1e}, largest difference {:.1e} over {} cases",
            self.of,
            self.tolerance,
            self.largest,
            self.cases
        );
    }
}

impl Drop for Worst {
    fn drop(&mut self) {
        if let Some(record) = self.record.clone()
            && let Some(wrong) = self.gathered_wrong()
        {
            record.untold.borrow_mut().push(wrong);
        }
    }
}

impl Device {
    /// A comparator that goes on after a number that is wrong, so that the furthest off is told.
    pub(crate) fn worst(&self, of: impl Into<String>, tolerance: f64) -> Worst {
        let mut worst = Worst::new(of, tolerance);
        worst.record = Some(Rc::clone(&self.record));
        worst
    }
}

/// Keeps the line of a stage whose output is integers; ends the case if nothing was compared.
pub fn report_exact(device: &Device, of: &str, cases: usize) {
    ensure!(cases > 0, "{of}: nothing was compared");
    device.record.exact(of, cases);
    note!(device, "kernel {of}: exact over {cases} cases");
}

/// For each number what is nearest to it of the range that several answers span: what is expected where a device has
/// some freedom, and the answers are its bounds.
pub(crate) fn nearest_of(got: &[f64], answers: &[Vec<f64>]) -> Vec<f64> {
    let nearest = |(index, &got): (usize, &f64)| {
        let bounds = answers.iter().map(|answer| answer[index]);
        let (low, high) = bounds.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), a| (a.min(l), a.max(h)));
        if got.is_nan() { low } else { got.clamp(low, high) }
    };
    got.iter().enumerate().map(nearest).collect()
}

/// Compares integers.
///
/// # Errors
/// Names the first that differs, or the lengths.
pub fn check_exact(got: &[u32], expected: &[u32]) -> Result<(), Wrong> {
    check_same(got, expected)
}

/// Compares what has to be the same to the bit.
///
/// # Errors
/// Names the first that differs and how many do, or the lengths.
pub(crate) fn check_same<T: PartialEq + Debug>(got: &[T], expected: &[T]) -> Result<(), Wrong> {
    if got.len() != expected.len() {
        return Err(Wrong::new(format!("{} values, expected {}", got.len(), expected.len())));
    }
    let Some(element) = got.iter().zip(expected).position(|(a, b)| a != b) else {
        return Ok(());
    };
    let beyond = got.iter().zip(expected).filter(|(a, b)| a != b).count();
    let [got_text, expected_text] = [&got[element], &expected[element]].map(|value| shown(value));
    Err(Found {
        element: Some(element),
        beyond: Some([beyond, got.len()]),
        got: got_text,
        expected: expected_text,
        ..Found::default()
    }
    .into())
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
) -> Result<(), Wrong> {
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
    Ok(check_ranks(&cells, &ranks, grid.cell_count)?)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_beyond_a_range_is_held_against_its_nearer_end() {
        let bounds = [vec![1.0, 1.0, 1.0, 1.0], vec![2.0, 2.0, 2.0, 2.0]];
        assert_eq!(nearest_of(&[1.5, 0.0, 9.0, f64::NAN], &bounds), [1.5, 1.0, 2.0, 1.0]);
    }
}
