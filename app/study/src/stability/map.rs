//! Maps over two settings of a column at rest: what is left of its compression over iterations and
//! substeps, and whether it is at rest at all over relaxation and support.

use brooklet_fluid::spectrum::lambda_max;

use super::MAP_PART;
use crate::case::{Case, HYDROSTATIC, SHALLOW, case};
use crate::error::{run_case, task};
use crate::session::{Session, StudyError};
use crate::{Outcome, State, Store, Task};

/// Kinetic energy over g H from which a column does not rest: half as much again as columns that still settle
/// after their second have (7e-4 at most, at the smallest support).
const RESTLESS: f64 = 1.0e-3;

/// Which map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Map {
    /// Compression over PBF's iterations (x) and substeps (y).
    Compression,
    /// Compression over the stiffness of SPH's equation of state, m²/s² (x), and substeps (y).
    Stiffness,
    /// Compression over DFSPH's divergence tolerance (x) and substeps (y).
    Tolerance,
    /// Rest over support ratio (x) and relaxation (y) of PBF.
    Relaxation,
}

/// A cell, and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Along x.
    pub x: f64,
    /// Along y.
    pub y: f64,
    /// How it ended.
    pub state: State,
    /// The map's figure: compression p99, or kinetic energy over g H.
    pub value: Option<f64>,
    /// What its energy rose by beyond what its compression holds, and the most that it may.
    pub energy: Option<(f64, f64)>,
    /// What theory says there: the compression of the column law or of the equation of state, the tolerance, or the largest
    /// relaxation.
    pub theory: f64,
}

impl Map {
    /// Each.
    pub const ALL: [Self; 4] = [Self::Compression, Self::Stiffness, Self::Tolerance, Self::Relaxation];

    /// Its plot's.
    pub fn name(self) -> &'static str {
        match self {
            Self::Compression => "map-compression",
            Self::Stiffness => "map-stiffness",
            Self::Tolerance => "map-tolerance",
            Self::Relaxation => "map-relaxation",
        }
    }

    /// The settings along x and y.
    pub fn paths(self) -> (&'static str, &'static str) {
        match self {
            Self::Compression => ("solver.pbf.iterations", "solver.substeps"),
            Self::Stiffness => ("solver.sph.stiffness_m2_s2", "solver.substeps"),
            Self::Tolerance => ("solver.dfsph.divergence_tolerance", "solver.substeps"),
            Self::Relaxation => ("solver.support_ratio", "solver.pbf.relaxation"),
        }
    }

    fn values(self, quick: bool) -> (&'static [f64], &'static [f64]) {
        match (self, quick) {
            (Self::Compression, false) => (&[1.0, 2.0, 4.0, 8.0, 16.0], &[1.0, 2.0, 4.0, 8.0]),
            (Self::Compression, true) => (&[2.0, 8.0], &[1.0, 2.0]),
            (Self::Stiffness, false) => (&[200.0, 400.0, 800.0, 1600.0, 3200.0], &[4.0, 8.0, 16.0, 32.0]),
            (Self::Tolerance, false) => (&[3.0e-5, 1.0e-4, 3.0e-4, 1.0e-3, 3.0e-3], &[1.0, 2.0, 4.0, 8.0]),
            // Solvers that cost several times as much are in no quick look.
            (Self::Stiffness | Self::Tolerance, true) => (&[], &[]),
            (Self::Relaxation, false) => (&[1.6, 2.0, 2.5, 3.0], &[0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1.0]),
            (Self::Relaxation, true) => (&[2.0, 3.0], &[0.5, 1.0]),
        }
    }

    /// What all of its cells have.
    fn with(self) -> &'static [&'static str] {
        match self {
            Self::Compression => &[],
            Self::Stiffness => &["solver.method=sph", "solver.sph.adaptive_substeps=false"],
            Self::Tolerance => &["solver.method=dfsph"],
            // What is not stable is refused with an acceleration.
            Self::Relaxation => &["solver.pbf.acceleration=none"],
        }
    }

    /// A task a cell.
    pub fn tasks(self, quick: bool) -> Vec<((f64, f64), Task)> {
        let (path_x, path_y) = self.paths();
        let (xs, ys) = self.values(quick);
        let one = |x: f64, y: f64| {
            let mut settings: Vec<String> = self.with().iter().map(|&setting| setting.into()).collect();
            settings.extend([format!("{path_x}={x}"), format!("{path_y}={y}")]);
            let case: &dyn Case = if self == Self::Relaxation { &SHALLOW } else { &HYDROSTATIC };
            ((x, y), task(MAP_PART, case, settings, 1))
        };
        ys.iter().flat_map(|&y| xs.iter().map(move |&x| one(x, y))).collect()
    }

    /// Its cells, as far as they have run.
    pub fn cells(self, quick: bool, store: &Store) -> Vec<Cell> {
        let cell = |((x, y), task): ((f64, f64), Task)| {
            let outcome = store.get(&task)?;
            let name = if self == Self::Relaxation { "kinetic energy" } else { "compression p99" };
            let theory = match self {
                Self::Compression | Self::Stiffness => outcome.figure("law's compression")?.value?,
                Self::Tolerance => x,
                Self::Relaxation => 2.0 / lambda_max(3, x, 0.01),
            };
            let value = |name: &str| outcome.figure(name)?.value;
            let energy = || {
                let rise = outcome.figure("energy rise")?;
                Some((rise.value?, rise.limit?))
            };
            Some(Cell { x, y, state: outcome.state, value: value(name), energy: energy(), theory })
        };
        self.tasks(quick).into_iter().filter_map(cell).collect()
    }
}

/// The cells of all maps.
pub fn map_tasks(quick: bool) -> Vec<Task> {
    Map::ALL.iter().flat_map(|map| map.tasks(quick)).map(|(_, task)| task).collect()
}

/// Particle iterations of a cell.
pub fn cell_cost(task: &Task) -> Option<f64> {
    Some(case(&task.case)?.setup(&task.settings).ok()?.particle_iterations())
}

/// Runs a cell. A column that does not come to rest is unstable: its kinetic energy, which the program
/// measures, says so.
///
/// # Errors
/// If the device is not there.
pub fn run_cell(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let Some(mut outcome) = run_case(session, task)? else { return Ok(None) };
    let restless =
        outcome.figure("kinetic energy").and_then(|figure| figure.value).is_none_or(|value| value > RESTLESS);
    if restless && matches!(outcome.state, State::Stable | State::Clamped) {
        outcome.state = State::Unstable;
        outcome.reason = "does not come to rest; measured kinetic energy".into();
    }
    Ok(Some(outcome))
}
