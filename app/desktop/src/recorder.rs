//! Takes the engine's reports as they come, late by a frame or two: into the capture, into the
//! medians, into the measurements.

use std::fs::File;
use std::time::Instant;

use brooklet_capture::{CaptureError, CaptureTotals, CaptureWriter};
use brooklet_fluid::{Session, SessionReport, captured_values};
use brooklet_gpu::{RecordingId, Timings};
use brooklet_render::FramePasses;
use brooklet_render::surface::marching_cubes::mesh_values;

use crate::{drawn_meshes::DrawnMeshes, measured::Measured};

/// Where a run's reports go.
pub struct Recorder {
    capture: Option<CaptureWriter<File>>,
    step: RecordingId,
    begun: Instant,
    /// From when on frames are numbered and timed by this, as another session goes on, ns.
    shift_ns: Option<u64>,
    next_frame: u64,
    last_ns: u64,
    /// GPU times.
    pub timings: Timings,
    /// Measurements.
    pub measured: Measured,
    /// Meshes of the pictures.
    pub meshes: DrawnMeshes,
    /// Why the capture stopped, if it did.
    pub trouble: Option<CaptureError>,
}

impl Recorder {
    /// For a run whose steps are the recording `step`.
    pub fn new(step: RecordingId, timings: Timings, capture: Option<CaptureWriter<File>>) -> Self {
        Self {
            capture,
            step,
            begun: Instant::now(),
            shift_ns: None,
            next_frame: 0,
            last_ns: 0,
            timings,
            measured: Measured::default(),
            meshes: DrawnMeshes::default(),
            trouble: None,
        }
    }

    /// Another session goes on from here: its frames come after those that were taken.
    pub fn go_on_in(&mut self, session: &Session) {
        self.step = session.step_id();
        self.shift_ns = Some((self.begun.elapsed().as_nanos() as u64).max(self.last_ns));
        self.record(|capture| capture.plan(session.engine().plan()));
    }

    /// Takes finished frames, whose pictures `passes` drew and learn from.
    pub fn take(&mut self, reports: Vec<SessionReport>, mut passes: Option<&mut FramePasses>) {
        for told in reports {
            let values = captured_values(&told);
            let SessionReport { mut report, steps, stats, .. } = told;
            if let Some(shift_ns) = self.shift_ns {
                report.frame = self.next_frame;
                report.wall_ns += shift_ns;
            }
            (self.next_frame, self.last_ns) = (report.frame + 1, report.wall_ns);
            self.timings.add(&report, self.step);
            if let Some(passes) = &mut passes {
                passes.learn(&report).iter().for_each(|counts| self.meshes.add(counts));
            }
            self.record(|capture| capture.frame(&report));
            if let (Some(stats), Some(mut values)) = (stats, values) {
                if passes.as_ref().is_some_and(|passes| passes.mesh_counts().is_some()) {
                    values.extend(mesh_values(&self.meshes.last().copied().unwrap_or_default()));
                }
                self.record(|capture| capture.stats(report.frame, report.wall_ns, &values));
                self.measured.add(steps, stats);
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
