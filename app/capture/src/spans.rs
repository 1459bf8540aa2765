//! `/gpu/span` as it is read: a frame's ticks back to one row a pass.

use std::collections::HashMap;

use serde::Deserialize;

use crate::SpanRow;

/// A message of `/gpu/span`.
#[derive(Debug, Deserialize)]
struct SpansMessage {
    frame: u64,
    sequence: u32,
    passes: Option<Vec<String>>,
    first_ticks: u64,
    begin_ticks: Vec<i64>,
    ticks: Vec<i64>,
    flags: Option<Vec<String>>,
}

/// Reads messages of `/gpu/span`, and knows the sequences of passes that they told so far.
#[derive(Debug, Default)]
pub struct SpanReader {
    passes: HashMap<u32, Vec<(String, String)>>,
}

impl SpanReader {
    /// The rows of a message, or what is wrong with it.
    pub fn rows(&mut self, message: &[u8]) -> Result<Vec<SpanRow>, String> {
        let message: SpansMessage = serde_json::from_slice(message).map_err(|error| error.to_string())?;
        if let Some(passes) = message.passes {
            let split = |pass: String| {
                let (recording, stage) = pass.split_once('/').ok_or(format!("pass `{pass}` has no recording"))?;
                Ok((recording.to_string(), stage.to_string()))
            };
            let passes = passes.into_iter().map(split).collect::<Result<_, String>>()?;
            self.passes.insert(message.sequence, passes);
        }
        let Some(passes) = self.passes.get(&message.sequence) else {
            return Err(format!("sequence {} was not told", message.sequence));
        };
        let lengths = [passes.len(), message.begin_ticks.len(), message.ticks.len()];
        let flags = message.flags.unwrap_or_else(|| vec!["ok".into(); passes.len()]);
        if lengths != [flags.len(); 3] {
            return Err(format!("lists of {lengths:?} entries and {} flags for the same passes", flags.len()));
        }
        let ticks = message.begin_ticks.iter().zip(&message.ticks);
        let rows = passes.iter().zip(ticks).zip(flags).map(|(((recording, stage), (begin, length)), flag)| {
            let begin_ticks = message.first_ticks.wrapping_add(*begin as u64);
            SpanRow {
                frame: message.frame,
                recording: recording.clone(),
                stage: stage.clone(),
                begin_ticks,
                end_ticks: begin_ticks.wrapping_add(*length as u64),
                flag,
            }
        });
        Ok(rows.collect())
    }
}
