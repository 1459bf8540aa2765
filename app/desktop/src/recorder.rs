//! Takes the engine's reports as they come, late by a frame or two: into the capture, into the
//! medians, into the measurements.

use std::{collections::VecDeque, fs::File};

use brooklet_capture::{CaptureError, CaptureTotals, CaptureWriter};
use brooklet_fluid::{Scene, Stats, captured_values};
use brooklet_gpu::{FrameReport, RecordingId, ResourceId};

use crate::{measured::Measured, timings::Timings};

/// Where a run's reports go.
pub struct Recorder {
    capture: Option<CaptureWriter<File>>,
    scene: Scene,
    step: RecordingId,
    measure: Option<ResourceId>,
    /// Frames that are not reported yet, with the number of steps done at their end.
    pending: VecDeque<(u64, u64)>,
    /// GPU times.
    pub timings: Timings,
    /// Measurements.
    pub measured: Measured,
    /// Why the capture stopped, if it did.
    pub trouble: Option<CaptureError>,
}

impl Recorder {
    /// For a run of `scene`; `step` is a step's recording, `measure` what measurements are read back from.
    pub fn new(
        scene: &Scene,
        step: RecordingId,
        measure: Option<ResourceId>,
        timings: Timings,
        capture: Option<CaptureWriter<File>>,
    ) -> Self {
        Self {
            capture,
            scene: scene.clone(),
            step,
            measure,
            pending: VecDeque::new(),
            timings,
            measured: Measured::default(),
            trouble: None,
        }
    }

    /// Announces frame `frame`, at whose end `step` steps are done.
    pub fn expect(&mut self, frame: u64, step: u64) {
        self.pending.push_back((frame, step));
    }

    /// Takes finished frames; those that nobody announced (set-up) are not the run's.
    pub fn take(&mut self, reports: &[FrameReport]) {
        for report in reports {
            while self.pending.front().is_some_and(|(frame, _)| *frame < report.frame) {
                self.pending.pop_front();
            }
            if let Some(&(frame, step)) = self.pending.front()
                && frame == report.frame
            {
                self.pending.pop_front();
                self.frame(report, step);
            }
        }
    }

    fn frame(&mut self, report: &FrameReport, step: u64) {
        self.timings.add(report, self.step);
        self.record(|capture| capture.frame(report));
        for (id, bytes) in &report.readbacks {
            if Some(*id) == self.measure {
                let stats = Stats::new(bytes, &self.scene);
                let simulated_s = step as f64 * self.scene.solver.dt_s;
                let values = captured_values(step, simulated_s, &stats);
                self.record(|capture| capture.stats(report.frame, report.wall_ns, &values));
                self.measured.add(step, stats);
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
