//! Whoever waits for a benchmark: hears how far it is, and may end it.

use crate::BenchError;

/// Whoever waits for a benchmark.
pub trait Observer {
    /// A run of `parts` parts begins.
    fn begin(&self, parts: u64);

    /// What is timed now.
    fn message(&self, text: String);

    /// A part of the run is done.
    fn advance(&self);

    /// Whether to end without a result.
    fn is_stopped(&self) -> bool;

    /// # Errors
    /// [`BenchError::Interrupted`] once it is to end.
    fn check(&self) -> Result<(), BenchError> {
        if self.is_stopped() { Err(BenchError::Interrupted) } else { Ok(()) }
    }
}
