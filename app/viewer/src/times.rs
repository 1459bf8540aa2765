//! What frames took, over the last seconds.

use brooklet_gpu::{FrameReport, RecordingId};

use crate::history::{History, Quantiles};

/// A pass's last times.
pub struct PassTimes {
    /// Its stage.
    pub stage: &'static str,
    /// All its dispatches of a frame together, ms.
    pub ms: History,
    /// Where they lie, as of the last look.
    pub quantiles: Option<Quantiles>,
}

/// Times of the last frames.
#[derive(Default)]
pub struct Times {
    /// Between two frames of the window, ms.
    pub frame_ms: History,
    /// On the GPU, from a frame's first pass to its last, ms.
    pub gpu_ms: History,
    /// Of one step, ms.
    pub step_ms: History,
    /// Of what is not simulation, ms.
    pub draw_ms: History,
    /// Mean density error, %.
    pub density_error: History,
    /// Kinetic energy and that with the potential energy from the domain's lowest corner, J. The sum falls by what walls
    /// and damping take; nothing but a hand or new settings may raise it.
    pub energy_j: [History; 2],
    /// Simulated seconds a second.
    pub speed: History,
    /// Passes in the order of their first run.
    pub passes: Vec<PassTimes>,
    /// Spans that cannot be right.
    pub flagged_spans: u64,
    looked_s: f64,
}

/// Percentiles are looked at so often: faster is not read, and costs time itself.
const LOOK_EVERY_S: f64 = 0.25;

impl Times {
    /// Takes a frame that has come back at `time_s`, of `steps` runs of the recording `step`. A device that tells no times
    /// is taken at `wall_ms`, half of it for the steps: enough to choose a rung by.
    pub fn take(&mut self, report: &FrameReport, (step, steps): (RecordingId, u32), time_s: f64, wall_ms: f64) {
        self.flagged_spans += report.flagged() as u64;
        let Some(gpu_ms) = report.gpu_ms() else {
            let steps_ms = if steps > 0 { 0.5 * wall_ms } else { 0.0 };
            if steps > 0 {
                self.step_ms.push(time_s, steps_ms / f64::from(steps));
            }
            self.draw_ms.push(time_s, wall_ms - steps_ms);
            return;
        };
        self.gpu_ms.push(time_s, gpu_ms);
        let mut simulation_ms = 0.0;
        for span in report.spans.iter().filter(|span| span.recording == step) {
            simulation_ms += span.end_ticks.saturating_sub(span.begin_ticks) as f64 * report.timestamp_period_ns * 1e-6;
        }
        if steps > 0 {
            self.step_ms.push(time_s, simulation_ms / f64::from(steps));
        }
        self.draw_ms.push(time_s, (gpu_ms - simulation_ms).max(0.0));
        for (stage, ms, _) in report.stage_ms() {
            let known = self.passes.iter().position(|pass| pass.stage == stage);
            let index = known.unwrap_or_else(|| {
                self.passes.push(PassTimes { stage, ms: History::default(), quantiles: None });
                self.passes.len() - 1
            });
            self.passes[index].ms.push(time_s, ms);
        }
        if time_s - self.looked_s >= LOOK_EVERY_S {
            self.looked_s = time_s;
            for pass in &mut self.passes {
                pass.quantiles = pass.ms.quantiles();
            }
        }
    }

    /// What one step and the rest of a frame take, ms; nothing before there are times.
    pub fn cost_ms(&self) -> Option<(f64, f64)> {
        Some((self.step_ms.quantiles()?.p50, self.draw_ms.quantiles()?.p50))
    }

    /// Forgets all: another plan has other passes, these, in this order.
    pub fn restart(&mut self, stages: impl IntoIterator<Item = &'static str>) {
        let mut passes: Vec<PassTimes> = Vec::new();
        for stage in stages {
            if !passes.iter().any(|pass| pass.stage == stage) {
                passes.push(PassTimes { stage, ms: History::default(), quantiles: None });
            }
        }
        *self = Self { passes, ..Self::default() };
    }
}
