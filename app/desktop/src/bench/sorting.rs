//! `brooklet bench sorting` for people.

use brooklet_bench::sorting::Sorting;

use crate::table::table;

/// Prints the table of comparisons.
pub fn print(sorting: &Sorting) {
    say!("{} particles, on {} as {}", sorting.particles, sorting.device, sorting.tier);
    if sorting.device_type == "cpu" {
        say!(
            "(this driver runs on the processor, where atomics do not meet, and groupshared memory has no banks\n\
             and is no faster than any other: a GPU's answer may be another)"
        );
    }
    let header = ["optimisation", "case", "a", "b", "a ms", "b ms", "b / a", "10 to 90 of 100 pairs"];
    let mut list = table(&header, &[4, 5, 6, 7]);
    for outcome in &sorting.comparisons {
        list.add_row([
            outcome.optimisation.to_string(),
            outcome.case.clone(),
            outcome.baseline.to_string(),
            outcome.alternative.to_string(),
            format!("{:.3}", outcome.baseline_ms),
            format!("{:.3}", outcome.alternative_ms),
            format!("{:.2}", outcome.ratio),
            format!("{:.2} to {:.2}", outcome.ratio_p10, outcome.ratio_p90),
        ]);
    }
    say!("\n{}", list.trim_fmt());
}
