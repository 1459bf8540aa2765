//! The progress bar, on standard error so that standard output stays the result's.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar over so many of `what`.
pub fn bar(count: u64, what: &str) -> ProgressBar {
    let bar = ProgressBar::new(count);
    let style = ProgressStyle::with_template(&format!("{{bar:32}} {{pos}}/{{len}} {what}, {{eta}} left  {{msg}}"));
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}
