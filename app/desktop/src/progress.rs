//! The progress bar, on standard error so that standard output stays the result's.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar over `steps` steps.
pub fn bar(steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    let style = ProgressStyle::with_template("{bar:32} {pos}/{len} steps, {eta} left  {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}
