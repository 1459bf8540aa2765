//! Jacobi against Gauss-Seidel, in f64: how fast sweeps take the density error out of the inside of a block.
//!
//! The GPU's solver is Jacobi: all particles move by what all saw before. Gauss-Seidel projects one
//! constraint after the other and sees what the last one did; it converges faster a sweep and does not run
//! side by side. Both take the same lambdas from the same twins.

use brooklet_reference::grid::list_neighbours::{Neighbours, list_neighbours};
use brooklet_reference::params::{Pbf, Smoothing};
use brooklet_reference::shared::{lattice, wendland};
use brooklet_reference::solver::pbf::constrain_density::{DensityConstraint, constrain_density};
use glam::DVec3;

use super::JACOBI_PART;
use crate::session::Session;
use crate::{Figure, Outcome, State, Task};

/// A scheme's name, whether it is Gauss-Seidel, and its relaxation.
const SCHEMES: [(&str, bool, f64); 6] = [
    ("jacobi 0.3", false, 0.3),
    ("jacobi 0.5", false, 0.5),
    ("jacobi 0.7", false, 0.7),
    ("jacobi 1", false, 1.0),
    ("gauss-seidel 1", true, 1.0),
    ("gauss-seidel 1.5", true, 1.5),
];
const SIDE: usize = 12;
const SUPPORT_RATIO: f64 = 2.0;
/// Of each length: the density ratio rises by three times as much.
const SQUEEZE: f64 = 0.02;
/// Sweeps after which the error is told.
const SWEEPS: [u32; 8] = [0, 1, 2, 4, 8, 16, 32, 64];

/// Root mean square density error inside of the block after so many sweeps.
#[derive(Clone, Debug, PartialEq)]
pub struct Convergence {
    /// The scheme.
    pub scheme: String,
    /// Sweeps, and what is left.
    pub left: Vec<(u32, f64)>,
}

/// A task a scheme.
pub fn jacobi_tasks() -> Vec<Task> {
    let task = |(name, ..): &(&str, bool, f64)| Task {
        part: JACOBI_PART.into(),
        case: (*name).into(),
        settings: Vec::new(),
        tier: "desktop".into(),
        repeats: 1,
    };
    SCHEMES.iter().map(task).collect()
}

/// Runs a scheme; none if it was stopped.
pub fn run_jacobi(session: &Session<'_>, task: &Task) -> Option<Outcome> {
    let Some(&(_, sweeps_in_turn, relaxation)) = SCHEMES.iter().find(|(name, ..)| *name == task.case) else {
        return Some(Outcome::empty(State::Refused, format!("there is no scheme '{}'", task.case)));
    };
    let mut block = Block::squeezed();
    let mut figures = Vec::new();
    let mut done = 0;
    for until in SWEEPS {
        while done < until {
            if session.stops() {
                return None;
            }
            if sweeps_in_turn {
                block.gauss_seidel(relaxation)
            } else {
                block.jacobi(relaxation)
            }
            done += 1;
        }
        figures.push(Figure::told(&format!("after {until}"), block.density_error(), "", "root mean square, inside"));
    }
    let mut outcome = Outcome::empty(State::Stable, "");
    outcome.figures = figures;
    outcome.particles = block.positions.len() as u64;
    outcome.device = "the processor, in f64".into();
    Some(outcome)
}

impl Convergence {
    /// What a task's outcome says.
    pub fn of(task: &Task, outcome: &Outcome) -> Self {
        let left = SWEEPS.iter().zip(&outcome.figures).filter_map(|(n, figure)| Some((*n, figure.value?)));
        Self { scheme: task.case.clone(), left: left.collect() }
    }
}

/// A block of fluid in units of its spacing.
struct Block {
    positions: Vec<DVec3>,
    neighbours: Neighbours,
    smoothing: Smoothing,
    pbf: Pbf,
}

impl Block {
    /// A lattice with a little noise, so that no symmetry helps, squeezed evenly.
    fn squeezed() -> Self {
        let noise = |i: usize| {
            // Low discrepancy instead of chance: the same everywhere (Roberts 2018, R3).
            let part = |a: f64| (i as f64 * a).fract() - 0.5;
            0.1 * DVec3::new(part(0.819_172_513_4), part(0.671_043_606_7), part(0.549_700_477_9))
        };
        let points = lattice::points([SIDE; 3], 1.0);
        let positions: Vec<DVec3> =
            points.iter().enumerate().map(|(i, at)| (*at + noise(i)) * (1.0 - SQUEEZE)).collect();
        let neighbours = list_neighbours(&positions, |_| false, SUPPORT_RATIO);
        let pbf = Pbf {
            relaxation: 1.0,
            cfm: 1e-4,
            s_corr_k: 0.0,
            s_corr_inverse_w: 0.0,
            max_correction_m: f64::INFINITY,
            separation: 0.0,
            separation_lambda: 0.0,
            warm_start: 0.0,
        };
        let smoothing = Smoothing::new(SUPPORT_RATIO, lattice::weight(3, SUPPORT_RATIO));
        Self { positions, neighbours, smoothing, pbf }
    }

    fn constraint(&self, i: usize) -> DensityConstraint {
        constrain_density(i, &self.positions, &self.neighbours[i], &self.smoothing, &self.pbf, None)
    }

    /// How C_i changes with particle i's place, past j.
    fn gradient(&self, i: usize, j: usize) -> DVec3 {
        let offset = (self.positions[i] - self.positions[j]) / self.smoothing.support_m;
        wendland::gradient(offset) * self.smoothing.weight
    }

    fn jacobi(&mut self, relaxation: f64) {
        let lambdas: Vec<f64> = (0..self.positions.len()).map(|i| self.constraint(i).lambda).collect();
        let moved = |i: usize| {
            let push: DVec3 = self.neighbours[i].iter().map(|&j| (lambdas[i] + lambdas[j]) * self.gradient(i, j)).sum();
            self.positions[i] + relaxation * self.smoothing.support_m * push
        };
        self.positions = (0..self.positions.len()).map(moved).collect();
    }

    fn gauss_seidel(&mut self, relaxation: f64) {
        for i in 0..self.positions.len() {
            let lambda = relaxation * self.constraint(i).lambda * self.smoothing.support_m;
            let pushes: Vec<(usize, DVec3)> =
                self.neighbours[i].iter().map(|&j| (j, lambda * self.gradient(i, j))).collect();
            for (j, push) in pushes {
                self.positions[i] += push;
                self.positions[j] -= push;
            }
        }
    }

    /// Root mean square of |rho / rho0 - 1| where no surface takes neighbours away: a sweep that overshoots leaves a
    /// block too thin, which is an error as well.
    fn density_error(&self) -> f64 {
        let inner = SUPPORT_RATIO as usize..SIDE - SUPPORT_RATIO as usize;
        let is_inner = |i: &usize| [i % SIDE, i / SIDE % SIDE, i / SIDE / SIDE].iter().all(|k| inner.contains(k));
        let squares: Vec<f64> =
            (0..self.positions.len()).filter(is_inner).map(|i| self.constraint(i).excess.powi(2)).collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_seidel_converges_faster_a_sweep_and_a_wrong_sign_not_at_all() {
        let after = |sweeps: u32, step: &dyn Fn(&mut Block)| {
            let mut block = Block::squeezed();
            (0..sweeps).for_each(|_| step(&mut block));
            block.density_error()
        };
        let start = after(0, &|_| {});
        let jacobi = after(4, &|block| block.jacobi(0.5));
        let in_turn = after(4, &|block| block.gauss_seidel(1.0));
        assert!(in_turn < jacobi && jacobi < 0.7 * start, "{start} {jacobi} {in_turn}");
        assert!(after(4, &|block| block.jacobi(-0.5)) > start);
    }

    #[test]
    fn pairs_push_each_other_equally() {
        for step in [|block: &mut Block| block.jacobi(0.5), |block: &mut Block| block.gauss_seidel(1.0)] {
            let mut block = Block::squeezed();
            let before: DVec3 = block.positions.iter().sum();
            step(&mut block);
            let after: DVec3 = block.positions.iter().sum();
            assert!((after - before).length() < 1e-9);
        }
    }
}
