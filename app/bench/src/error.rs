//! Why a benchmark has no result.

use std::fmt::Display;

/// Why a benchmark has no result.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// What was asked for is wrong, or the device cannot do it.
    #[error("{0}")]
    Input(String),
    /// It began, and could not go on.
    #[error("{0}")]
    Stopped(String),
    /// Its [`Observer`](crate::Observer) ended it.
    #[error("ended before there was a result")]
    Interrupted,
}

impl BenchError {
    /// A mistake of the input, from whatever found it.
    pub(crate) fn input(error: impl Display) -> Self {
        Self::Input(error.to_string())
    }

    /// An end halfway, from whatever caused it.
    pub(crate) fn stopped(error: impl Display) -> Self {
        Self::Stopped(error.to_string())
    }
}
