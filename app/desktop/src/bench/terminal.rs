//! A benchmark at the terminal: its progress bar, Ctrl-C, and how it fails.

use brooklet_bench::{BenchError, Observer};
use indicatif::ProgressBar;

use crate::{failure::Failure, interrupt::Interrupt, progress};

/// A person who watches a benchmark.
pub struct Terminal {
    bar: ProgressBar,
    interrupt: Interrupt,
}

/// Runs a benchmark before a terminal, which is clean afterwards.
pub fn watched<T>(run: impl FnOnce(&Terminal) -> Result<T, BenchError>) -> Result<T, Failure> {
    let terminal = Terminal { bar: progress::bar(0, "steps"), interrupt: Interrupt::listen()? };
    let result = run(&terminal);
    terminal.bar.finish_and_clear();
    Ok(result?)
}

impl Observer for Terminal {
    fn begin(&self, parts: u64) {
        self.bar.set_length(parts);
        self.bar.reset();
    }

    fn message(&self, text: String) {
        self.bar.set_message(text);
    }

    fn advance(&self) {
        self.bar.inc(1);
    }

    fn is_stopped(&self) -> bool {
        self.interrupt.is_pressed()
    }
}

impl From<BenchError> for Failure {
    fn from(error: BenchError) -> Self {
        match error {
            BenchError::Input(text) => Self::Input(text),
            BenchError::Stopped(text) => Self::Stopped(text),
            BenchError::Interrupted => Self::Interrupted("nothing was written".into()),
        }
    }
}
