//! Runs the tasks that have no outcome yet, and keeps each as it comes.

use std::time::Instant;

use crate::session::{Event, Session, StudyError};
use crate::{Outcome, Store, Task, error, precision, stability, validation};

/// Runs tasks of every part of a study.
pub struct Runner<'a> {
    session: Session<'a>,
}

impl<'a> Runner<'a> {
    /// Runs with what `session` has.
    pub fn new(session: Session<'a>) -> Self {
        Self { session }
    }

    /// Runs those of `tasks` that `store` has no outcome of; false if it was stopped.
    ///
    /// # Errors
    /// If an outcome cannot be kept, or a task names what there is not.
    pub fn run(&self, tasks: &[Task], store: &mut Store) -> Result<bool, StudyError> {
        let weights: Vec<f64> = tasks.iter().map(weight).collect();
        let total = weights.iter().sum();
        let mut done: f64 =
            tasks.iter().zip(&weights).filter(|(task, _)| store.get(task).is_some()).map(|(_, w)| w).sum();
        self.session.tell(Event::Begin { total, done });
        for (task, weight) in tasks.iter().zip(&weights) {
            if store.get(task).is_some() {
                continue;
            }
            if self.session.stops() {
                return Ok(false);
            }
            self.session.begin(task, done, *weight);
            let begun = Instant::now();
            let Some(mut outcome) = self.outcome(task)? else { return Ok(false) };
            outcome.wall_s = begun.elapsed().as_secs_f64();
            store.put(task, outcome)?;
            done += weight;
            self.session.tell(Event::Done(done));
        }
        Ok(true)
    }

    /// Runs one task; none if it was stopped.
    ///
    /// # Errors
    /// If it names what there is not.
    pub fn outcome(&self, task: &Task) -> Result<Option<Outcome>, StudyError> {
        let session = &self.session;
        match task.part.as_str() {
            error::PART | validation::PART => error::run_case(session, task),
            error::ORDER_PART => error::run_order(session, task),
            error::JACOBI_PART => Ok(error::run_jacobi(session, task)),
            error::OVERHEAD_PART => error::run_overhead(session, task),
            error::EQUAL_WORK_PART => error::run_equal_work(session, task),
            precision::PART => precision::run(session, task),
            stability::ROWS_PART => stability::run_row(session, task),
            stability::MAP_PART => stability::run_cell(session, task),
            part => Err(StudyError::Unknown(format!("there is no part '{part}' of a study"))),
        }
    }
}

/// Particle iterations that a task costs.
fn weight(task: &Task) -> f64 {
    let setup = match task.part.as_str() {
        precision::PART => precision::cost(task),
        stability::ROWS_PART => stability::row_cost(task),
        stability::MAP_PART => stability::cell_cost(task),
        error::EQUAL_WORK_PART => error::equal_work_cost(task),
        error::JACOBI_PART => Some(1e6),
        // Four ways, 24 steps a block, some 4,000 particles.
        error::OVERHEAD_PART => Some(2.4e6 * f64::from(task.repeats)),
        _ => crate::case::case(&task.case)
            .and_then(|case| case.setup(&task.settings).ok())
            .map(|setup| setup.particle_iterations() * f64::from(task.repeats.max(1))),
    };
    // Whatever it is, it takes a moment: pipelines are built.
    setup.unwrap_or(0.0) + 1e5
}
