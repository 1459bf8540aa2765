//! A pressure solve: iterations until the mean residual is small enough.

use super::apply_pressure::apply_pressure;
use super::correct_pressure::{Correction, PressureSolve, correct_pressure, density_change};
use super::factor_pressure::PressureFactors;
use crate::grid::list_neighbours::Neighbours;
use crate::params::{Smoothing, Step};
use crate::shared::parallel;
use crate::solver::pbf::coarse_correction::{CoarseGrid, coarse_multipliers, prolong_multiplier};
use glam::DVec3;

/// What the particles of a solve are.
pub struct Fluid<'a> {
    /// Where they are.
    pub positions_m: &'a [DVec3],
    /// Whom they know.
    pub neighbours: &'a Neighbours,
    /// What both solves ask of them.
    pub factors: &'a [PressureFactors],
    /// The substep.
    pub step: &'a Step,
    /// The kernel.
    pub smoothing: &'a Smoothing,
}

/// What a solve's first iteration leaves over, out of cells of a grid: added to what it changes pressures by. (Shader:
/// `solver/dfsph/coarse_pressure.compute`, and PBF's between its two ends.)
pub fn add_coarse(
    grid: &CoarseGrid,
    fluid: &Fluid<'_>,
    pressures: &[f64],
    corrections: &mut [Correction],
    solve: &PressureSolve,
) {
    let simulated: Vec<usize> = (0..corrections.len()).filter(|&i| fluid.factors[i].is_simulated).collect();
    let left = simulated
        .iter()
        .map(|&i| (fluid.positions_m[i], corrections[i].change * fluid.factors[i].stiffness / solve.first_step));
    let multipliers = coarse_multipliers(grid, left);
    for i in simulated {
        let added = -prolong_multiplier(grid, &multipliers, fluid.positions_m[i]);
        let change = &mut corrections[i].change;
        *change = (pressures[i] + *change + added).max(0.0) - pressures[i];
    }
}

/// How a solve ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Solved {
    /// Iterations done.
    pub iterations: usize,
    /// Mean residual then; not known where their number was fixed.
    pub residual: Option<f64>,
    /// Whether it was above tolerance.
    pub is_unsolved: bool,
}

impl Fluid<'_> {
    /// Makes velocities, or displacements over dt, what the solve asks for, beginning with `pressures`, which become those
    /// found. With a coarse grid the first iteration is corrected by it.
    pub fn solve(
        &self,
        velocities_m_s: &mut [DVec3],
        pressures: &mut [f64],
        solve: &PressureSolve,
        coarse: Option<&CoarseGrid>,
    ) -> Solved {
        let count = velocities_m_s.len();
        let warm = pressures.to_vec();
        self.apply(velocities_m_s, &warm);
        let mut changes = vec![0.0; count];
        let mut solved = Solved::default();
        loop {
            if solve.is_fixed && solved.iterations == solve.most_iterations {
                return solved;
            }
            let first = solved.iterations == 0;
            let mut corrections = parallel::map(count, |i| {
                let Self { positions_m, neighbours, factors, step, smoothing } = self;
                let (list, own) = (&neighbours[i], &factors[i]);
                let (change, _) = density_change(i, positions_m, velocities_m_s, list, own, step, smoothing);
                correct_pressure(own, change, pressures[i], changes[i], first, solve)
            });
            if !solve.is_fixed {
                let residual = corrections.iter().map(|c| c.residual).sum::<f64>() / count.max(1) as f64;
                let is_last = solved.iterations == solve.most_iterations;
                solved.residual = Some(residual);
                solved.is_unsolved = residual > solve.tolerance && is_last;
                if (residual <= solve.tolerance && solved.iterations >= solve.least_iterations) || is_last {
                    return solved;
                }
            }
            if let (true, Some(grid)) = (first, coarse) {
                add_coarse(grid, self, pressures, &mut corrections, solve);
            }
            changes = corrections.iter().map(|c| c.change).collect();
            self.apply(velocities_m_s, &changes);
            pressures.iter_mut().zip(&changes).for_each(|(pressure, change)| *pressure += change);
            solved.iterations += 1;
        }
    }

    fn apply(&self, velocities_m_s: &mut [DVec3], changes: &[f64]) {
        let Self { positions_m, neighbours, factors, step, smoothing } = self;
        let gains = parallel::map(velocities_m_s.len(), |i| {
            apply_pressure(i, positions_m, changes, &neighbours[i], &factors[i], step, smoothing).gain_m_s
        });
        velocities_m_s.iter_mut().zip(gains).for_each(|(velocity, gain)| *velocity += gain);
    }
}
