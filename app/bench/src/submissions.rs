//! What a submission costs, and what timestamps do: the same steps in submissions of 1, 4 and 16, with and without GPU
//! times, by the host's clock.

use std::time::Instant;

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_gpu::{Gpu, quantile, tier_name};
use serde::Serialize;

use crate::{BenchError, Observer, scene_options};

/// Steps of a turn: a whole number of the largest submission.
const STEPS: u32 = 32;
/// Steps in one submission.
const BATCHES: [u32; 3] = [1, 4, 16];

/// What is timed.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Turns of each way.
    pub rounds: u32,
}

/// What each way took.
#[derive(Clone, Debug, Serialize)]
pub struct Submissions {
    /// The scene.
    pub scene: String,
    /// Its particles.
    pub particles: u32,
    /// What it ran on.
    pub device: String,
    /// What the device was used as.
    pub tier: &'static str,
    /// Turns of each way.
    pub rounds: u32,
    /// The first is what the others are held against.
    pub ways: Vec<Way>,
}

/// One way to run the same steps.
#[derive(Clone, Debug, Serialize)]
pub struct Way {
    /// Steps in one submission.
    pub steps_a_submission: u32,
    /// Whether the GPU takes times of each pass.
    pub timestamps: bool,
    /// A step by the host's clock, from the first submission to the end of the last, ms: the median of all turns.
    pub wall_ms: f64,
    /// The same over the first way's of the same round: the median, and what 10 and 90 of 100 rounds stay below.
    pub ratio: [f64; 3],
}

/// Runs `scene`, as it is but for its outputs, every way in turn; `untimed` is the same device, opened without times.
///
/// # Errors
/// Every [`BenchError`].
pub fn run(
    timed: &Gpu,
    untimed: &Gpu,
    scene: &Scene,
    options: Options,
    observer: &dyn Observer,
) -> Result<Submissions, BenchError> {
    let mut scene = scene.clone();
    scene.outputs.images = 0;
    scene.outputs.measure_every_steps = 0;
    let start = |gpu: &Gpu| -> Result<Session, BenchError> {
        let planned = scene_options::plan(gpu, &scene)?;
        let mut session = brooklet_render::start(gpu, planned.session).map_err(BenchError::input)?;
        session.finish().map_err(BenchError::stopped)?;
        Ok(session)
    };
    let mut sessions = [start(timed)?, start(untimed)?];
    let particles = sessions[0].slot_count();
    let ways: Vec<(u32, bool)> = BATCHES.iter().flat_map(|&batch| [(batch, true), (batch, false)]).collect();
    observer.begin(u64::from(options.rounds + 1));
    let mut walls = vec![Vec::new(); ways.len()];
    // A first round builds pipelines and is not counted.
    for round in 0..=options.rounds {
        for (way, &(batch, timestamps)) in ways.iter().enumerate() {
            let session = &mut sessions[usize::from(!timestamps)];
            let wall_s = turn(session, batch, observer)?;
            if round > 0 {
                walls[way].push(1e3 * wall_s / f64::from(STEPS));
            }
        }
        observer.advance();
    }
    let info = timed.info();
    Ok(Submissions {
        scene: scene.name,
        particles,
        device: info.name.clone(),
        tier: tier_name(timed.tier()),
        rounds: options.rounds,
        ways: ways
            .iter()
            .zip(&walls)
            .map(|(&(steps_a_submission, timestamps), wall)| Way {
                steps_a_submission,
                timestamps,
                wall_ms: quantiles(wall.clone())[0],
                ratio: ratios(wall, &walls[0]),
            })
            .collect(),
    })
}

/// Seconds that [`STEPS`] steps took.
fn turn(session: &mut Session, batch: u32, observer: &dyn Observer) -> Result<f64, BenchError> {
    let request = FrameRequest { steps: batch, ..FrameRequest::default() };
    let begun = Instant::now();
    for _ in 0..STEPS / batch {
        observer.check()?;
        session.submit(&request).map_err(BenchError::stopped)?;
        session.reports();
    }
    session.finish().map_err(BenchError::stopped)?;
    Ok(begun.elapsed().as_secs_f64())
}

fn ratios(wall: &[f64], first: &[f64]) -> [f64; 3] {
    quantiles(wall.iter().zip(first).map(|(a, b)| a / b).collect())
}

/// The median, and what 10 and 90 of 100 stay below.
fn quantiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [0.5, 0.1, 0.9].map(|share| quantile(&values, share).unwrap_or(f64::NAN))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_of_the_same_round() {
        assert_eq!(ratios(&[2.0, 6.0, 20.0], &[1.0, 2.0, 5.0]), [3.0, 2.2, 3.8]);
        assert!(ratios(&[], &[])[0].is_nan());
        assert!(STEPS.is_multiple_of(BATCHES[2]));
    }
}
