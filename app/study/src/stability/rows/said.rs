//! What of the program's own words says that a figure is beyond its limit.
//!
//! A count says what it counts: a clamped speed is no word of particles that passed through each other. A figure
//! that is a measurement of the program's own is said by it.

use crate::backend::GpuRun;

/// A word of the program's about a figure of that name.
type Word = fn(&GpuRun, usize) -> bool;

const WORDS: &[(&str, Word)] = &[
    ("lost or not finite", |run, injected| quarantined(run) > injected || escaped(run)),
    ("outside", |run, _| escaped(run)),
    ("speed at the end", is_measured),
    ("compression at the end", is_measured),
    ("compression over the law's", is_measured),
    ("law's error", is_measured),
    ("kinetic energy", is_measured),
    ("energy rise", is_measured),
    ("fastest over the wall", is_measured),
    // Neighbours that one of a pair has and the other has not push with nothing against them.
    ("momentum drift", |run, _| is_list_short(run)),
    ("difference", |run, _| is_list_short(run)),
];

/// Whether the program said it. What stands in no list is said by nothing.
pub(super) fn is_said(figure: &str, run: &GpuRun, injected: usize) -> bool {
    WORDS.iter().any(|(name, word)| *name == figure && word(run, injected))
}

fn quarantined(run: &GpuRun) -> usize {
    run.measured.last().map_or(0, |measured| measured.stats.quarantined as usize)
}

fn escaped(run: &GpuRun) -> bool {
    run.measured.iter().any(|measured| measured.stats.escaped > 0)
}

fn is_measured(run: &GpuRun, _: usize) -> bool {
    !run.measured.is_empty()
}

fn is_list_short(run: &GpuRun) -> bool {
    let counted = run.counted();
    counted.neighbour_overflow + counted.crowded > 0
}
