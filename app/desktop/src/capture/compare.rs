//! `brooklet capture compare`.

use brooklet_capture::{Comparison, PassRatio, Times, Verdict};

use super::{options::CompareOptions, plot, summary::damage};
use crate::{
    failure::Failure,
    table::{ms, table},
};

/// Prints how B compares with A.
pub fn compare(options: &CompareOptions) -> Result<(), Failure> {
    let a = Times::read(&options.a).map_err(Failure::input)?;
    let b = Times::read(&options.b).map_err(Failure::input)?;
    let comparison = Comparison::of(&a, &b);
    if let Some(scenes) = comparison.differences.scenes.as_ref().filter(|_| !options.anyway) {
        return Err(Failure::Input(format!(
            "{} and {}: captures of different scenes: {scenes}; --anyway compares them all the same",
            options.a.display(),
            options.b.display()
        )));
    }
    if comparison.passes.is_empty() {
        let why =
            comparison.left_out.first().map_or("neither has a pass".into(), |(stage, why)| format!("{stage}: {why}"));
        return Err(Failure::Input(format!(
            "{} and {}: nothing can be compared: {why}",
            options.a.display(),
            options.b.display()
        )));
    }
    if options.json {
        say!("{}", serde_json::to_string_pretty(&comparison).map_err(Failure::stopped)?);
    } else {
        for (which, times) in [("A", &a), ("B", &b)] {
            if let Some(damage) = damage(&times.ending) {
                say!("{which} is {damage}");
            }
            let trust = &times.trust;
            let wrong = trust.negative_spans + trust.overlapping_spans + trust.dropped_spans;
            if wrong > 0 {
                say!("{which}: of {} spans {wrong} are negative, overlapping or dropped", trust.spans);
            }
        }
        print(&comparison);
    }
    if let Some(path) = &options.plot {
        plot::ratios(path, &comparison.passes, options.fail_if_slower)?;
    }
    options.fail_if_slower.map_or(Ok(()), |share| judge(&comparison, share))
}

/// The verdict of `--fail-if-slower`.
pub fn judge(comparison: &Comparison, share: f64) -> Result<(), Failure> {
    let slower = comparison.slower_than(share);
    if slower.is_empty() {
        return Ok(());
    }
    let passes: Vec<String> = slower.iter().map(|pass| format!("{} {}", pass.stage, percent(pass))).collect();
    Err(Failure::Stopped(format!("slower by more than {:.1} %: {}", 100.0 * share, passes.join(", "))))
}

/// `+15.2 % (+13.1 to +17.4)`.
fn percent(pass: &PassRatio) -> String {
    let share = |ratio: f64| format!("{:+.1}", 100.0 * (ratio - 1.0));
    format!("{} % ({} to {})", share(pass.ratio), share(pass.interval[0]), share(pass.interval[1]))
}

fn print(comparison: &Comparison) {
    let differences = &comparison.differences;
    if let Some(scenes) = &differences.scenes {
        say!("different scenes: {scenes}: the ratios are of different work");
    }
    for other in &differences.others {
        say!("different {other}");
    }
    if differences.scenes.is_some() || !differences.others.is_empty() {
        say!();
    }
    let mut passes = table(&["pass", "A ms", "B ms", "B to A, %", "from", "to", "", "blocks"], &[1, 2, 3, 4, 5, 7]);
    for pass in &comparison.passes {
        let share = |ratio: f64| format!("{:+.1}", 100.0 * (ratio - 1.0));
        let verdict = match pass.verdict {
            Verdict::Slower => "slower",
            Verdict::Faster => "faster",
            Verdict::NotTold => "",
        };
        passes.add_row([
            pass.stage.clone(),
            ms(Some(pass.a_ms)),
            ms(Some(pass.b_ms)),
            share(pass.ratio),
            share(pass.interval[0]),
            share(pass.interval[1]),
            verdict.into(),
            pass.blocks.to_string(),
        ]);
    }
    say!("{passes}");
    say!();
    say!(
        "medians; intervals hold for all {} passes at once with {:.0} %: errors by block bootstrap, Bonferroni",
        comparison.passes.len(),
        100.0 * (1.0 - comparison.level)
    );
    for (stage, why) in &comparison.left_out {
        say!("left out: {stage}: {why}");
    }
}
