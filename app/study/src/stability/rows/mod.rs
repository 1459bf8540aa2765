//! The extreme cases (rows of a table with fixed numbers) over precisions, tiers, layouts, accelerations, coarse
//! corrections and warm starts.
//!
//! Of every row: states are finite, no particle is lost, all are inside the walls, none is faster than
//! the limit; and what the row itself expects. What fails and is said by the program, of this failure
//! (`said.rs`), is unstable and said; what fails and is not is SILENT, a defect.

mod said;
mod setups;
mod table;

pub use table::ROWS;

use brooklet_fluid::scene::{Acceleration, Precision, body_count};
use brooklet_gpu::{Tier, tier_name};
use glam::DVec3;

use super::{ROWS_PART, covering};
use crate::backend::{GpuRun, run_reference};
use crate::case::own_path;
use crate::energy;
use crate::error::densities;
use crate::method::METHODS;
use crate::session::{Session, StudyError, state_of};
use crate::{Figure, Outcome, Sample, Setup, SetupResult, State, Task, Verdict};

/// One extreme case.
#[derive(Clone, Copy)]
pub struct Row {
    /// Its number in the table of extreme cases.
    pub number: u32,
    /// Its name.
    pub name: &'static str,
    /// What is expected.
    pub expected: &'static str,
    /// What runs.
    pub setup: fn(&[String]) -> SetupResult,
    /// What else it must do.
    pub also: Also,
    /// Particles that are not finite from the start.
    pub injected: usize,
    /// Of solvers whose own table has this setting alone; empty: of all.
    pub needs: &'static str,
}

impl Row {
    /// Whether a solver runs it.
    fn is_of(&self, method: &str) -> bool {
        self.needs.is_empty() || own_path(method, self.needs).is_some()
    }
}

/// What a row is judged by, beside what all rows are.
#[derive(Clone, Copy)]
pub enum Also {
    /// At the end it is slower than falling a spacing makes it, and hardly compressed.
    Rests,
    /// Figures of its own.
    Figures(fn(&Setup, &GpuRun) -> Vec<Figure>),
    /// Particles where another run has them, in spacings, within a limit. The other's setup, and how many
    /// of its lengths one of this is.
    Equals(fn(&[String]) -> SetupResult, f64, f64),
    /// Particles where the f64 twin has them, in spacings, within a limit a step of one substep.
    EqualsTwin(f64),
    /// Refused with a reason.
    Refused,
}

const SWITCHES: [&str; 2] = ["false", "true"];
const TIERS: [Tier; 3] = [Tier::Desktop, Tier::Mobile, Tier::Floor];

/// Rows that a quick look takes.
const QUICK: [u32; 6] = [2, 8, 13, 14, 17, 21];

/// Every pair of row, precision, tier, order, acceleration, whether coarse corrections are left out and whether substeps
/// begin warm. Real f16 is of the desktop tier alone, and without an acceleration there is neither a coarse correction nor
/// a warm start.
fn pbf_tasks(quick: bool) -> Vec<Task> {
    let rows: Vec<&Row> = ROWS.iter().filter(|row| row.is_of(PBF) && (!quick || QUICK.contains(&row.number))).collect();
    let has_bodies = |row: &Row| (row.setup)(&[]).is_ok_and(|setup| body_count(&setup.scene) > 0);
    let has_bodies: Vec<bool> = rows.iter().map(|row| has_bodies(row)).collect();
    let allowed = |row: &[Option<usize>]| {
        // What bodies were given back of a warm start is not begun with.
        if row[6] == Some(1) && row[0].is_some_and(|row| has_bodies[row]) {
            return false;
        }
        let has_f16 = row[1] != Some(2) || row[2].is_none_or(|tier| TIERS[tier] == Tier::Desktop);
        has_f16 && (row[4] != Some(0) || row[5] != Some(0) && row[6] != Some(1))
    };
    let coarse = [None, Some("solver.pbf.coarse_correction=false")];
    let warm = [None, Some("solver.pbf.warm_start=0.3")];
    let sizes = [
        rows.len(),
        Precision::NAMES.len(),
        TIERS.len(),
        SWITCHES.len(),
        Acceleration::NAMES.len(),
        coarse.len(),
        warm.len(),
    ];
    let combinations = if quick {
        rows.iter().enumerate().map(|(i, _)| vec![i, i % 3, 0, i % 2, 1, 0, 0]).collect()
    } else {
        covering(&sizes, allowed)
    };
    let mut tasks: Vec<Task> = combinations
        .into_iter()
        .map(|of| Task {
            part: ROWS_PART.into(),
            case: rows[of[0]].name.into(),
            settings: [
                format!("solver.precision={}", Precision::NAMES[of[1]]),
                format!("solver.deterministic={}", SWITCHES[of[3]]),
                format!("solver.pbf.acceleration={}", Acceleration::NAMES[of[4]]),
            ]
            .into_iter()
            .chain([coarse[of[5]], warm[of[6]]].into_iter().flatten().map(str::to_owned))
            .collect(),
            tier: tier_name(TIERS[of[2]]).into(),
            repeats: 1,
        })
        .collect();
    tasks.sort_by_key(|task| rows.iter().position(|row| row.name == task.case));
    tasks
}

/// Every row of every solver: PBF's over what it can be run with, another's as it is. A quick look leaves costly ones out.
pub fn row_tasks(quick: bool) -> Vec<Task> {
    let others = METHODS.iter().filter(|method| method.name != PBF && (!quick || method.few.is_empty()));
    let mut tasks = pbf_tasks(quick);
    tasks.extend(others.flat_map(|method| {
        let rows = ROWS.iter().filter(|row| row.is_of(method.name) && (!quick || QUICK.contains(&row.number)));
        rows.map(|row| Task {
            part: ROWS_PART.into(),
            case: row.name.into(),
            settings: vec![method.setting()],
            tier: tier_name(Tier::Desktop).into(),
            repeats: 1,
        })
    }));
    tasks
}

/// The solver whose settings are varied.
const PBF: &str = "pbf";

fn row(name: &str) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.name == name)
}

/// Particle iterations of a row.
pub fn row_cost(task: &Task) -> Option<f64> {
    Some((row(&task.case)?.setup)(&task.settings).ok()?.particle_iterations())
}

/// Runs a row.
///
/// # Errors
/// If there is no such row, or no such device.
pub fn run_row(session: &Session<'_>, task: &Task) -> Result<Option<Outcome>, StudyError> {
    let row = row(&task.case).ok_or_else(|| StudyError::Unknown(format!("there is no row '{}'", task.case)))?;
    let setup = match (row.setup)(&task.settings) {
        Ok(setup) => setup,
        Err(error) => return Ok(Some(refused(row, error.to_string()))),
    };
    let gpu = session.gpu(&task.tier)?;
    if tier_name(gpu.tier()) != task.tier {
        let reason = format!("{} is of tier {}", gpu.info().name, tier_name(gpu.tier()));
        return Ok(Some(Outcome::empty(State::NotRun, reason)));
    }
    let run = match session.run_setup(&gpu, &setup) {
        Ok(run) if run.stopped => return Ok(None),
        Ok(run) => run,
        Err(reason) => return Ok(Some(refused(row, reason))),
    };
    let mut figures = every_row(&setup, &run, row.injected);
    figures.extend(energy::figures(&setup, &run, energy::RISE));
    match row.also {
        Also::Refused => {}
        Also::Rests => figures.extend(rests(&setup, &run)),
        Also::Figures(of) => figures.extend(of(&setup, &run)),
        Also::Equals(make, scale, limit) => {
            let other = make(&task.settings).map_err(|error| StudyError::Unknown(error.to_string()))?;
            let reference = match session.run_setup(&gpu, &other) {
                Ok(run) if run.stopped => return Ok(None),
                Ok(run) => run,
                Err(reason) => return Ok(Some(refused(row, reason))),
            };
            figures.push(difference(&setup, &run.samples, &reference.samples, scale, limit));
        }
        Also::EqualsTwin(limit) => {
            let Some(twin) = run_reference(&setup, &|| session.stops()) else { return Ok(None) };
            // Roundings of substeps add up as a random walk.
            let limit = limit * f64::from(setup.scene.substeps()).sqrt();
            figures.push(difference(&setup, &run.samples, &twin, 1.0, limit));
        }
    }
    let (state, reason) = judge(row, &run, &figures);
    let mut outcome = Outcome::empty(state, reason);
    outcome.figures = figures;
    outcome.figures.extend(densities(&run));
    outcome.particles = setup.count() as u64;
    outcome.device = gpu.info().name.clone();
    outcome.cost = GpuRun::cost(&[run], 10, setup.scene.solver.dt_s);
    Ok(Some(outcome))
}

fn refused(row: &Row, reason: String) -> Outcome {
    // Where it should have run, a refusal is still said; the table shows it beside what is expected.
    let expected = matches!(row.also, Also::Refused);
    Outcome::empty(State::Refused, if expected { reason } else { format!("not expected: {reason}") })
}

/// How a run ended: what failed, and whether the program's own counts and measurements say so.
fn judge(row: &Row, run: &GpuRun, figures: &[Figure]) -> (State, String) {
    let failed: Vec<&str> = figures
        .iter()
        .filter(|figure| figure.verdict() == Verdict::FallsShort)
        .map(|figure| figure.name.as_str())
        .collect();
    let (plain, counts) = state_of(run);
    if matches!(row.also, Also::Refused) {
        return (State::Silent, "was not refused".into());
    }
    // Injected particles are out, and that is told: nothing is wrong.
    let quarantined = run.measured.last().map_or(0, |measured| measured.stats.quarantined as usize);
    let as_injected = row.injected > 0 && quarantined == row.injected;
    let state = if as_injected { State::Stable } else { plain };
    if failed.is_empty() {
        return (state, if as_injected { format!("{quarantined} quarantined") } else { counts });
    }
    let silent: Vec<&str> = failed.iter().copied().filter(|name| !said::is_said(name, run, row.injected)).collect();
    match silent.is_empty() {
        true => (State::Unstable, format!("{} beyond limits, and said; {counts}", failed.join(", "))),
        false => {
            (State::Silent, format!("{} beyond limits, {} not said; {counts}", failed.join(", "), silent.join(", ")))
        }
    }
}

/// What every row keeps.
fn every_row(setup: &Setup, run: &GpuRun, injected: usize) -> Vec<Figure> {
    let limit_m_s = setup.scene.max_speed_m_s();
    let unsound = run.samples.iter().map(|sample| sample.unsound).max().unwrap_or(0);
    let finite = |sample: &Sample| -> Vec<(DVec3, DVec3)> {
        let all = sample.positions_m.iter().copied().zip(sample.velocities_m_s.iter().copied());
        all.filter(|(at, v)| at.is_finite() && v.is_finite()).collect()
    };
    let fastest = run.samples.iter().flat_map(finite).map(|(_, v)| v.length()).fold(0.0, f64::max);
    let mut figures = vec![
        Figure::judged("lost or not finite", unsound as f64, "", injected as f64, "particles, beyond those put in so"),
        // A clamped speed is rounded three times.
        Figure::judged("fastest over the limit", fastest / limit_m_s, "", 1.0 + 1e-6, "speed limit of the scene"),
    ];
    if setup.scene.domain.has_walls() {
        let [low_m, high_m] = setup.scene.domain.wall_bounds_m().map(DVec3::from_array);
        let beyond = |at: DVec3| (low_m - at).max(at - high_m).max_element().max(0.0);
        let out_m = run.samples.iter().flat_map(finite).map(|(at, _)| beyond(at)).fold(0.0, f64::max);
        figures.push(Figure::judged(
            "outside",
            out_m / setup.scene.spacing_m,
            "d",
            1e-4,
            "furthest particle beyond a wall",
        ));
    }
    figures
}

/// A fluid at rest at the end.
fn rests(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let Some(last) = run.measured.last() else { return Vec::new() };
    let limit_m_s = (2.0 * 9.81 * setup.scene.spacing_m).sqrt();
    vec![
        Figure::judged("speed at the end", last.stats.max_speed_m_s, "m/s", limit_m_s, "what falling a spacing gives"),
        Figure::judged("compression at the end", last.stats.compression.p99, "", 0.1, "p99"),
    ]
}

/// Largest distance between particles of two runs, over the spacing.
fn difference(setup: &Setup, ours: &[Sample], theirs: &[Sample], scale: f64, limit: f64) -> Figure {
    let mut largest = if ours.len() == theirs.len() && !ours.is_empty() { 0.0_f64 } else { f64::NAN };
    for (a, b) in ours.iter().zip(theirs) {
        for (here, there) in a.positions_m.iter().zip(&b.positions_m) {
            let off = (*here - *there * scale).length() / setup.scene.spacing_m;
            // f64::max would drop a NaN.
            largest = if off > largest || off.is_nan() { off } else { largest };
        }
    }
    Figure::judged("difference", largest, "d", limit, "largest, from where the other run has the same particle")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_those_of_the_table_and_each_meets_every_tier_and_precision() {
        let numbers: Vec<u32> = ROWS.iter().map(|row| row.number).collect();
        assert_eq!(numbers, (1..=21).collect::<Vec<_>>());
        let tasks = row_tasks(false);
        for row in ROWS.iter().filter(|row| row.is_of(PBF)) {
            let of = || tasks.iter().filter(|task| task.case == row.name);
            for tier in TIERS {
                assert!(of().any(|task| task.tier == tier_name(tier)), "{} on {tier:?}", row.name);
            }
            for precision in Precision::NAMES {
                assert!(of().any(|task| task.settings[0].ends_with(precision)), "{} at {precision}", row.name);
            }
        }
        assert!(row_tasks(true).len() == QUICK.len());
        // Other solvers run all of them, and what is theirs.
        for method in METHODS.iter().filter(|method| method.name != PBF) {
            let of = |row: &Row| tasks.iter().any(|task| task.case == row.name && task.settings[0] == method.setting());
            assert!(ROWS.iter().all(|row| of(row) == row.is_of(method.name)), "{}", method.name);
        }
        let stiff = tasks.iter().filter(|task| task.case == "stiffness-times-1000");
        assert!(stiff.clone().count() > 0 && stiff.into_iter().all(|task| task.settings[0] != "solver.method=pbf"));
    }

    #[test]
    fn every_row_that_should_run_has_a_sound_setup() {
        for (row, method) in ROWS.iter().flat_map(|row| METHODS.iter().map(move |method| (row, method))) {
            if !row.is_of(method.name) {
                continue;
            }
            match (row.setup)(&[method.setting()]) {
                Ok(setup) => assert!(setup.count() > 0 && setup.count() <= 6_000, "{}: {}", row.name, setup.count()),
                Err(error) => assert!(matches!(row.also, Also::Refused), "{}, {}: {error}", row.name, method.name),
            }
        }
    }

    #[test]
    fn what_fails_without_a_word_is_silent() {
        let row = ROWS.iter().find(|row| matches!(row.also, Also::Rests)).unwrap();
        let wrong = [Figure::judged("momentum drift", 2.0, "", 1.0, "")];
        let mut run = GpuRun::default();
        run.measured.push(crate::backend::Measured { time_s: 1.0, stats: brooklet_fluid::Stats::default() });
        assert_eq!(judge(row, &run, &wrong).0, State::Silent);
        assert_eq!(judge(row, &run, &[]).0, State::Stable);
        // A count of something else is no word of it.
        run.measured[0].stats.counters.speed_clamps = 1;
        assert_eq!(judge(row, &run, &wrong).0, State::Silent);
        assert_eq!(judge(row, &run, &[]).0, State::Clamped);
        run.measured[0].stats.counters.neighbour_overflow = 1;
        assert_eq!(judge(row, &run, &wrong).0, State::Unstable);
        // Of two failures both have to be said.
        let [drift] = wrong;
        assert_eq!(judge(row, &run, &[drift, Figure::judged("passed", 1.0, "", 0.0, "")]).0, State::Silent);
        let fast = [Figure::judged("speed at the end", 1.0, "", 0.5, "")];
        assert_eq!(judge(row, &run, &fast).0, State::Unstable, "measured, so said");
        run.measured[0].stats.quarantined = 2;
        let lost = [Figure::judged("lost or not finite", 2.0, "", 0.0, "")];
        assert_eq!(judge(row, &run, &lost).0, State::Unstable);
        assert_eq!(judge(&Row { injected: 2, ..*row }, &run, &lost).0, State::Silent, "those put in are no word");
    }
}
