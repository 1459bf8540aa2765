//! Takes the engine's reports as they come, late by a frame or two: into the capture, into the
//! medians, into the measurements.

use std::fs::File;

use brooklet_capture::{CaptureError, CaptureTotals, CaptureWriter};
use brooklet_fluid::{SessionReport, captured_values};
use brooklet_gpu::{RecordingId, Timings};

use crate::measured::Measured;

/// Where a run's reports go.
pub struct Recorder {
    capture: Option<CaptureWriter<File>>,
    step: RecordingId,
    /// GPU times.
    pub timings: Timings,
    /// Measurements.
    pub measured: Measured,
    /// Why the capture stopped, if it did.
    pub trouble: Option<CaptureError>,
}

impl Recorder {
    /// For a run whose steps are the recording `step`.
    pub fn new(step: RecordingId, timings: Timings, capture: Option<CaptureWriter<File>>) -> Self {
        Self { capture, step, timings, measured: Measured::default(), trouble: None }
    }

    /// Takes finished frames.
    pub fn take(&mut self, reports: &[SessionReport]) {
        for SessionReport { report, steps, simulated_s, stats } in reports {
            self.timings.add(report, self.step);
            self.record(|capture| capture.frame(report));
            if let Some(stats) = stats {
                let values = captured_values(*steps, *simulated_s, stats);
                self.record(|capture| capture.stats(report.frame, report.wall_ns, &values));
                self.measured.add(*steps, *stats);
            }
        }
    }

    /// A capture that cannot be written (a full disk) does not end the run: it says so at the end.
    fn record(&mut self, job: impl FnOnce(&mut CaptureWriter<File>) -> Result<(), CaptureError>) {
        if let Some(capture) = &mut self.capture
            && let Err(error) = job(capture)
        {
            self.trouble.get_or_insert(error);
        }
    }

    /// Ends the capture.
    pub fn finish(&mut self) -> Option<CaptureTotals> {
        match self.capture.take()?.finish() {
            Ok(totals) => Some(totals),
            Err(error) => {
                self.trouble.get_or_insert(error);
                None
            }
        }
    }
}
