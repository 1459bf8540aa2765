//! Whether a capture keeps what its format promises, and whether its times can be believed.

use std::{
    collections::{BTreeMap, HashMap},
    path::Path,
};

use serde::Serialize;

use crate::{
    CaptureError, Ending, FRAME_TOPIC, FrameRow, Item, Message, SPAN_TOPIC, SpanRow, Trust,
    spans::SpanReader,
    stream::{printable, read_file},
    validate::Expected,
};

/// Problems that are told one by one.
const MOST_TOLD: usize = 20;
/// More spans of a kind that cannot be, or frames whose passes exceed them, are a problem of the device or
/// the driver and not of a moment.
const MOST_WRONG: f64 = 0.01;

/// What was found.
#[derive(Clone, Debug, Default, Serialize)]
pub struct CheckReport {
    /// How the file ended.
    pub ending: Ending,
    /// Messages of each topic.
    pub topics: BTreeMap<String, u64>,
    /// What is wrong, the first ones in words.
    pub problems: Vec<String>,
    /// How much is wrong.
    pub problem_count: u64,
    /// What is worth knowing, and not wrong.
    pub notes: Vec<String>,
    /// Counted anew from the frames.
    pub trust: Trust,
}

impl CheckReport {
    /// Whether nothing is wrong.
    pub fn is_good(&self) -> bool {
        self.problem_count == 0
    }

    fn problem(&mut self, text: String) {
        self.problem_count += 1;
        if self.problems.len() < MOST_TOLD {
            self.problems.push(printable(&text));
        }
    }
}

#[derive(Default)]
struct Checking {
    report: CheckReport,
    expected: HashMap<u16, Expected>,
    sequences: SpanReader,
    last_log_time: u64,
    stated: Option<BTreeMap<String, String>>,
    /// Of the frame whose spans came last: its number, and how many of them are flagged.
    spans: Option<(u64, usize, usize)>,
}

/// Checks a capture: each message against its schema, `log_time`, damage, flags against ticks, and the counts
/// that it states against those of its frames.
///
/// # Errors
/// If it cannot be read or is no capture of this version; what is wrong inside is in the report.
pub fn check(path: &Path) -> Result<CheckReport, CaptureError> {
    let mut checking = Checking::default();
    let ending = read_file(path, &mut |item| {
        match item {
            Item::Channel(channel) => {
                let expected = Expected::of(channel).unwrap_or_else(|problem| {
                    checking.report.problem(format!("{}: {problem}", channel.topic));
                    Expected::Unknown
                });
                checking.expected.insert(channel.id, expected);
            }
            Item::Message(message) => checking.message(message),
            Item::Metadata("trust", fields) => checking.stated = Some(fields.clone()),
            _ => {}
        }
        Ok(())
    })?;
    checking.report.ending = ending;
    Ok(checking.end())
}

impl Checking {
    fn message(&mut self, message: Message<'_>) {
        let topic = &message.channel.topic;
        let index = self.report.topics.entry(topic.clone()).or_default();
        *index += 1;
        let index = *index - 1;
        if message.log_time < self.last_log_time {
            let back = self.last_log_time - message.log_time;
            self.report.problem(format!("message {index} of {topic}: log_time goes back by {back} ns"));
        }
        self.last_log_time = message.log_time;
        if message.publish_time > message.log_time {
            self.report.problem(format!("message {index} of {topic}: logged before it happened"));
        }
        let expected = self.expected.get(&message.channel.id);
        if let Some(problem) = expected.and_then(|expected| expected.problem(message.data)) {
            self.report.problem(format!("message {index} of {topic}: {problem}"));
            return;
        }
        match topic.as_str() {
            FRAME_TOPIC => match serde_json::from_slice::<FrameRow>(message.data) {
                Ok(row) => self.frame(&row),
                Err(error) => self.report.problem(format!("message {index} of {topic}: {error}")),
            },
            SPAN_TOPIC => match self.sequences.rows(message.data) {
                Ok(rows) => {
                    let flagged = rows.iter().filter(|row| row.flag != "ok").count();
                    let impossible = |row: &&SpanRow| row.flag == "ok" && row.end_ticks <= row.begin_ticks;
                    if let Some(row) = rows.iter().find(impossible) {
                        let SpanRow { frame, stage, .. } = row;
                        self.report
                            .problem(format!("frame {frame}: {stage} takes no time or less, and is not flagged"));
                    }
                    self.spans = rows.first().map(|row| (row.frame, rows.len(), flagged));
                }
                Err(problem) => self.report.problem(format!("message {index} of {topic}: {problem}")),
            },
            _ => {}
        }
    }

    fn frame(&mut self, row: &FrameRow) {
        self.report.trust.add(row);
        let by_kind = row.zero_spans + row.negative_spans + row.overlapping_spans + row.gap_spans;
        if by_kind != row.flagged_spans {
            self.report
                .problem(format!("frame {}: {} spans are flagged, {by_kind} by kind", row.frame, row.flagged_spans));
        }
        let told = self.spans.take().filter(|(frame, ..)| *frame == row.frame);
        if let Some((frame, spans, flagged)) = told
            && (spans, flagged) != (row.spans as usize, row.flagged_spans as usize)
        {
            self.report.problem(format!(
                "frame {frame}: {} spans with {} flagged are counted, {spans} with {flagged} are there",
                row.spans, row.flagged_spans
            ));
        }
    }

    fn end(mut self) -> CheckReport {
        let report = &mut self.report;
        let Ending { complete, damaged_bytes, unnamed_messages, .. } = report.ending;
        if damaged_bytes > 0 {
            report.problem(format!("{damaged_bytes} bytes are damaged or cut off"));
        } else if !complete {
            report.problem("the file has no proper end".into());
        }
        if unnamed_messages > 0 {
            report.problem(format!("{unnamed_messages} messages have no topic left"));
        }
        match &self.stated {
            Some(stated) => {
                for (key, count) in report.trust.counts() {
                    // Raised times are known to the writer alone; `log_time` was looked at above.
                    let is_other = stated.get(key).is_some_and(|stated| *stated != count.to_string());
                    if is_other && key != "log_times_raised" {
                        report.problem(format!("`trust` states {key} = {}, and there are {count}", stated[key]));
                    }
                }
            }
            None if complete => report.notes.push("it states no `trust`".into()),
            None => {}
        }
        let trust = report.trust;
        let kinds = [
            ("are negative", trust.negative_spans),
            ("overlap", trust.overlapping_spans),
            ("were dropped", trust.dropped_spans),
            ("took no time", trust.zero_spans),
            ("follow a gap", trust.gap_spans),
        ];
        for (place, (what, count)) in kinds.into_iter().enumerate().filter(|(_, (_, count))| *count > 0) {
            let all = trust.spans + trust.dropped_spans;
            let text = format!("{count} of {all} spans {what}");
            // The first three cannot be; short passes and clears are as the last two say.
            if place < 3 && count as f64 > MOST_WRONG * all as f64 {
                report.problem(text)
            } else {
                report.notes.push(text)
            }
        }
        if trust.sums_over_frame > 0 {
            let text = format!(
                "in {} of {} frames the passes sum up to more than the frame",
                trust.sums_over_frame, trust.frames
            );
            let is_wrong = trust.sums_over_frame as f64 > MOST_WRONG * trust.frames as f64;
            if is_wrong { report.problem(text) } else { report.notes.push(text) }
        }
        if trust.dropped_frames > 0 {
            report.notes.push(format!("{} frames gave no report", trust.dropped_frames));
        }
        self.report
    }
}
