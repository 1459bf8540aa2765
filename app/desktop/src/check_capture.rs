//! The verdicts of `brooklet doctor --check --capture FILE`.

use std::fs::File;
use std::path::Path;

use brooklet_capture::{CaptureClock, CaptureError, CaptureOptions, CaptureWriter, CheckRow};
use brooklet_check::{Outcome, Report, Verdict};
use brooklet_gpu::{Gpu, tier_name};

use crate::check_words::{title, verdict_name};
use crate::commit::{COMMIT, VERSION};
use crate::failure::Failure;

/// A capture of verdicts. The first error is kept until its end: the check itself goes on.
pub struct Verdicts {
    capture: CaptureWriter<File>,
    clock: CaptureClock,
    failed: Option<CaptureError>,
}

impl Verdicts {
    /// Begins the file.
    pub fn create(path: &Path, gpu: &Gpu) -> Result<Self, Failure> {
        let clock = CaptureClock::new();
        let options = CaptureOptions { start: clock.start(), ..CaptureOptions::default() };
        let mut capture = CaptureWriter::create(path, options).map_err(Failure::input)?;
        let build = [("program", "brooklet"), ("version", VERSION), ("commit", COMMIT)];
        capture
            .device(gpu.info(), tier_name(gpu.tier()))
            .and_then(|()| capture.metadata("build", build.map(|(key, value)| (key, value.to_string()))))
            .map_err(Failure::input)?;
        Ok(Self { capture, clock, failed: None })
    }

    fn write(&mut self, row: &CheckRow) {
        // In the file at once: a driver may end the program in the next case.
        let written = self.capture.check(self.clock.ns(), row).and_then(|()| self.capture.flush());
        self.failed = self.failed.take().or(written.err());
    }

    /// Writes how a case ended.
    pub fn case(&mut self, outcome: &Outcome) {
        let (verdict, said) = match &outcome.verdict {
            Verdict::Right => ("right", outcome.notes.join("; ")),
            Verdict::Wrong(wrong) => ("wrong", wrong.to_string()),
            Verdict::Skipped(reason) => ("skipped", reason.clone()),
        };
        let compared = outcome.modules.iter().map(|run| run.compared + run.exact).sum::<usize>() as u64;
        let (of, name) = ("case".to_owned(), title(outcome.known));
        self.write(&CheckRow { of, name, verdict: verdict.to_owned(), compared, said, ..CheckRow::default() });
    }

    /// Writes what is known of every variant, and ends the file.
    pub fn finish(mut self, report: &Report) -> Result<(), Failure> {
        for module in &report.modules {
            let [difference, tolerance] = [0, 1].map(|number| module.run.worst.map(|worst| worst[number]));
            self.write(&CheckRow {
                of: "module".to_owned(),
                name: module.run.module.to_owned(),
                verdict: verdict_name(module.verdict).to_lowercase(),
                compared: (module.run.compared + module.run.exact) as u64,
                difference: difference.filter(|number| number.is_finite()),
                tolerance,
                ..CheckRow::default()
            });
        }
        match self.failed {
            Some(error) => Err(Failure::stopped(error)),
            None => self.capture.finish().map(|_| ()).map_err(Failure::stopped),
        }
    }
}
