//! The times of a recording that an engine runs again and again.

use brooklet_gpu::{Engine, FrameReport, Quantiles, RecordingId};

use crate::{BenchError, Observer};

/// Runs `init` once and `timed` so many times, of which the first do not count.
///
/// # Errors
/// If the device is lost, or the observer ends it.
pub fn run(
    engine: &mut Engine,
    (init, timed): (RecordingId, RecordingId),
    (warm_up, repeats): (usize, usize),
    observer: &dyn Observer,
) -> Result<Vec<FrameReport>, BenchError> {
    engine.run(&[init], &[]).map_err(BenchError::stopped)?;
    engine.finish().map_err(BenchError::stopped)?;
    let mut reports = Vec::new();
    for _ in 0..warm_up + repeats {
        observer.check()?;
        engine.run(&[timed], &[]).map_err(BenchError::stopped)?;
        reports.extend(engine.reports());
    }
    reports.extend(engine.finish().map_err(BenchError::stopped)?);
    Ok(reports.into_iter().skip(warm_up).collect())
}

/// Median of the times of the wanted stages, ms of a frame.
pub fn median_ms(reports: &[FrameReport], wanted: impl Fn(&str) -> bool) -> f64 {
    let stages = |report: &FrameReport| -> f64 {
        report.stage_ms().iter().filter(|(stage, ..)| wanted(stage)).fold(0.0, |sum, (_, ms, _)| sum + ms)
    };
    Quantiles::of(reports.iter().map(stages).collect()).map_or(0.0, |quantiles| quantiles.median)
}
