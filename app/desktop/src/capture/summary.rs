//! `brooklet capture summary`.

use brooklet_capture::{CaptureSummary, Ending, Quantiles, summarize};

use super::{options::SummaryOptions, plot};
use crate::{
    failure::Failure,
    table::{ms, table},
};

/// States that are shown.
const STATES: usize = 12;

/// Prints what a capture says.
pub fn summary(options: &SummaryOptions) -> Result<(), Failure> {
    let summary = summarize(&options.file).map_err(Failure::input)?;
    if options.json {
        say!("{}", serde_json::to_string_pretty(&summary).map_err(Failure::stopped)?);
    } else {
        print(&summary);
    }
    if let Some(path) = &options.plot {
        let passes: Vec<(&str, Quantiles)> =
            summary.passes.iter().map(|(name, quantiles)| (&**name, *quantiles)).collect();
        plot::passes(path, &passes)?;
    }
    Ok(())
}

/// What is wrong with the file, in a line; none if nothing is.
pub fn damage(ending: &Ending) -> Option<String> {
    (!ending.complete).then(|| {
        let lost = match (ending.damaged_bytes, ending.unnamed_messages) {
            (0, 0) => "it has no proper end".into(),
            (bytes, 0) => format!("{bytes} bytes are damaged or cut off"),
            (bytes, messages) => format!("{bytes} bytes are damaged, and {messages} messages have no topic left"),
        };
        format!("incomplete: {lost}; what follows is of its {} whole chunks", ending.chunks)
    })
}

fn print(summary: &CaptureSummary) {
    let fact = |record: &str, key: &str| summary.metadata.get(record).and_then(|fields| fields.get(key));
    if let Some(damage) = damage(&summary.ending) {
        say!("{damage}\n");
    }
    if let (Some(name), Some(tier)) = (fact("device", "name"), fact("device", "tier")) {
        let driver = [fact("device", "driver"), fact("device", "driver_info")];
        let driver: Vec<&str> = driver.into_iter().flatten().map(String::as_str).collect();
        say!("device    {name} as {tier}, {}", driver.join(" "));
    }
    let files: Vec<&str> = summary.attachments.iter().map(|(name, _)| &**name).collect();
    if !files.is_empty() {
        say!("attached  {}", files.join(", "));
    }
    let trust = &summary.trust;
    say!("frames    {} in {:.1} s, times {}", trust.frames, summary.duration_s, summary.timing);
    if let Some(frame) = &summary.frame_ms {
        say!(
            "GPU       {} ms a frame, p95 {}, largest {}",
            ms(Some(frame.median)),
            ms(Some(frame.p95)),
            ms(Some(frame.max))
        );
    }
    if let Some(share) = trust.pass_share() {
        say!("passes    {:.1} % of the frames' time; the rest is gaps between them", 100.0 * share);
    }
    say!(
        "trust     of {} spans {} zero, {} negative, {} overlapping, {} behind gaps, {} dropped; {} frames dropped",
        trust.spans,
        trust.zero_spans,
        trust.negative_spans,
        trust.overlapping_spans,
        trust.gap_spans,
        trust.dropped_spans,
        trust.dropped_frames
    );
    if let Some(capture) = &summary.capture_ms {
        let cost = fact("capture_cost", "share").and_then(|share| share.parse::<f64>().ok());
        let measured = cost.map_or(String::new(), |share| format!("; by A/B {:+.2} % of a frame", 100.0 * share));
        say!("capture   {} ms of the processor a frame{measured}", ms(Some(capture.median)));
    }
    if let Some(hottest) = summary.hottest_c {
        say!("heat      {hottest:.0} degC at most");
    }
    if !summary.power_sources.is_empty() {
        say!("power     {}", summary.power_sources.join(", "));
    }
    let topics: Vec<String> = summary.topics.iter().map(|(topic, count)| format!("{topic} {count}")).collect();
    say!("messages  {}", topics.join(", "));
    if !summary.passes.is_empty() {
        say!();
        print_passes(summary);
    }
    if !summary.states.is_empty() {
        say!();
        let mut states = table(&["at", "state", "what changed"], &[0]);
        for row in summary.states.iter().take(STATES) {
            let state = format!("{} {} {} rung {}", row.tier, row.precision, row.surface, row.rung);
            states.add_row([format!("{:.1} s", row.wall_s), state, row.event.clone()]);
        }
        say!("{states}");
        if summary.states.len() > STATES {
            say!("and {} more", summary.states.len() - STATES);
        }
    }
}

fn print_passes(summary: &CaptureSummary) {
    let frames = summary.frame_ms.map_or(0.0, |frame| frame.mean * frame.count as f64);
    let mut passes = table(&["pass", "median ms", "p95 ms", "largest ms", "of all"], &[1, 2, 3, 4]);
    for (stage, quantiles) in &summary.passes {
        let share = if frames > 0.0 { 100.0 * quantiles.mean * quantiles.count as f64 / frames } else { 0.0 };
        passes.add_row([
            stage.clone(),
            ms(Some(quantiles.median)),
            ms(Some(quantiles.p95)),
            ms(Some(quantiles.max)),
            format!("{share:.1} %"),
        ]);
    }
    say!("{passes}");
}
