//! Two captures against each other, pass by pass: the ratio of medians with an interval that holds for all
//! passes at once.
//!
//! Times of neighbouring frames are alike (heat, clocks, what the fluid does), so a frame is not a draw of
//! its own. The error of a median is that of medians of resampled *blocks* of frames (circular block
//! bootstrap, Politis & Romano 1992), blocks three times as long as the times stay alike: that length is the
//! integrated autocorrelation of being above the median, summed while pairs are positive (Geyer 1992). A
//! drift over the whole run makes blocks as long as a tenth of it; with so few, the error is itself
//! uncertain, which Student's t with their number takes into account. The level is 5 % over all passes
//! together (Bonferroni), on the logarithm of the ratio.

use std::{collections::BTreeMap, path::Path};

use serde::Serialize;

use crate::{
    CaptureError, Ending, FRAME_TOPIC, FrameRow, Item, PASSES_TOPIC, STATE_TOPIC, StateRow, Trust,
    series::StageNumbers,
    statistics::{BlockError, median, student_t},
    stream::{message_problem, read_file},
    summary::Metadata,
};

/// Error level over all passes.
const LEVEL: f64 = 0.05;
/// Frames at the start that do not count, and the most part of a run that they are: clocks rise and caches
/// fill then.
const WARM_UP: usize = 10;
/// Fewer frames of a pass than this say nothing.
const LEAST_FRAMES: usize = 20;
/// Frames of a capture that are kept.
const MOST_FRAMES: usize = 1 << 20;

/// The times of a capture, and what they were taken of.
#[derive(Clone, Debug, Default)]
pub struct Times {
    /// How the file ended.
    pub ending: Ending,
    /// Counts of what cannot be believed.
    pub trust: Trust,
    /// How the times were taken.
    pub timing: String,
    /// A frame on the GPU and each stage, ms, in the order of the run.
    pub stages: Vec<(String, Vec<f32>)>,
    /// Metadata.
    pub metadata: Metadata,
    /// The attached scene: its name and text.
    pub scene: Option<(String, String)>,
    /// Distinct settings that a viewer ran with: tier, precision, surface, rung.
    pub settings: Vec<String>,
}

/// What the whole frame is called among the stages.
pub const FRAME: &str = "(frame)";

impl Times {
    /// Reads them from a capture.
    ///
    /// # Errors
    /// As [`crate::summarize`].
    pub fn read(path: &Path) -> Result<Self, CaptureError> {
        let name = path.display().to_string();
        let mut times = Self::default();
        let mut stages = StageNumbers::default();
        let mut columns: Vec<Vec<f32>> = Vec::new();
        let mut frames: Vec<f32> = Vec::new();
        let mut add = |item: Item<'_>| -> Result<(), (String, serde_json::Error)> {
            let Item::Message(message) = item else {
                times.about(item);
                return Ok(());
            };
            let topic = message.channel.topic.as_str();
            let of_topic = |error| (topic.to_string(), error);
            match topic {
                FRAME_TOPIC => {
                    let row: FrameRow = serde_json::from_slice(message.data).map_err(of_topic)?;
                    times.trust.add(&row);
                    frames.extend(row.gpu_ms.map(|ms| ms as f32).filter(|_| frames.len() < MOST_FRAMES));
                    if row.spans > 0 || times.timing.is_empty() {
                        times.timing = row.timing;
                    }
                }
                PASSES_TOPIC => {
                    let add = &mut |stage: usize, ms: f64| {
                        if stage >= columns.len() {
                            columns.resize_with(stage + 1, Vec::new);
                        }
                        if columns[stage].len() < MOST_FRAMES {
                            columns[stage].push(ms as f32);
                        }
                    };
                    stages.read(message.data, add).map_err(of_topic)?;
                }
                STATE_TOPIC => {
                    let row: StateRow = serde_json::from_slice(message.data).map_err(of_topic)?;
                    let settings = format!("{} {} {} rung {}", row.tier, row.precision, row.surface, row.rung);
                    if !times.settings.contains(&settings) && times.settings.len() < 100 {
                        times.settings.push(settings);
                    }
                }
                _ => {}
            }
            Ok(())
        };
        let ending = read_file(path, &mut |item| {
            add(item).map_err(|(topic, error)| message_problem(&name, &topic, 0, &error.to_string()))
        })?;
        times.ending = ending;
        times.stages.push((FRAME.into(), frames));
        times.stages.extend(stages.names.into_iter().zip(columns));
        Ok(times)
    }

    fn about(&mut self, item: Item<'_>) {
        match item {
            Item::Metadata(name, fields) => {
                self.metadata.insert(name.into(), fields.clone());
            }
            Item::Attachment(file) if file.media_type == "application/toml" => {
                self.scene = Some((file.name.clone(), String::from_utf8_lossy(&file.data).into_owned()));
            }
            _ => {}
        }
    }

    fn fact(&self, record: &str, key: &str) -> &str {
        self.metadata.get(record).and_then(|fields| fields.get(key)).map_or("not told", String::as_str)
    }
}

/// What is different between two captures, besides their times.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Differences {
    /// Other scenes, in words; the ratios are then of different work.
    pub scenes: Option<String>,
    /// Other devices, drivers, tiers, builds or settings: each as `what: A and B`.
    pub others: Vec<String>,
}

impl Differences {
    /// Between two captures.
    pub fn of(a: &Times, b: &Times) -> Self {
        let scenes = match (&a.scene, &b.scene) {
            (Some((a_name, a_text)), Some((b_name, b_text))) if a_text != b_text => Some(if a_name == b_name {
                format!("{a_name}, with other settings: {}", first_difference(a_text, b_text))
            } else {
                format!("{a_name} and {b_name}")
            }),
            (Some((name, _)), None) => Some(format!("{name} and none that is told")),
            (None, Some((name, _))) => Some(format!("none that is told and {name}")),
            _ => None,
        };
        let facts = [
            ("device", "name"),
            ("device", "driver"),
            ("device", "driver_info"),
            ("device", "tier"),
            ("build", "version"),
            ("build", "commit"),
        ];
        let mut others: Vec<String> = facts
            .into_iter()
            .filter(|(record, key)| a.fact(record, key) != b.fact(record, key))
            .map(|(record, key)| format!("{record} {key}: {} and {}", a.fact(record, key), b.fact(record, key)))
            .collect();
        if a.timing != b.timing {
            others.push(format!("times: {} and {}", a.timing, b.timing));
        }
        if a.settings != b.settings {
            others.push(format!("settings: {} and {}", listed(&a.settings), listed(&b.settings)));
        }
        for (which, times) in [("A", a), ("B", b)] {
            if times.settings.len() > 1 {
                others.push(format!("{which} changed its settings while it ran: {}", listed(&times.settings)));
            }
        }
        Self { scenes, others }
    }
}

fn listed(settings: &[String]) -> String {
    if settings.is_empty() { "none told".into() } else { settings.join(", ") }
}

fn first_difference(a: &str, b: &str) -> String {
    let lines = a.lines().map(Some).chain(std::iter::repeat(None));
    let pairs = lines.zip(b.lines().map(Some).chain(std::iter::repeat(None)));
    let different = pairs.take(a.lines().count().max(b.lines().count())).find(|(a, b)| a != b);
    let text = |line: Option<&str>| line.map_or("nothing".to_string(), |line| format!("`{}`", line.trim()));
    different.map_or("line ends".into(), |(a, b)| format!("{} and {}", text(a), text(b)))
}

/// What is told of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The whole interval lies above 1.
    Slower,
    /// The whole interval lies below 1.
    Faster,
    /// The interval has 1 in it.
    NotTold,
}

/// A pass in both captures.
#[derive(Clone, Debug, Serialize)]
pub struct PassRatio {
    /// Its stage, or [`FRAME`].
    pub stage: String,
    /// Median in A, ms.
    pub a_ms: f64,
    /// Median in B, ms.
    pub b_ms: f64,
    /// B over A.
    pub ratio: f64,
    /// Interval of the ratio, for all passes at once.
    pub interval: [f64; 2],
    /// What it tells.
    pub verdict: Verdict,
    /// Frames that were compared, of A and B.
    pub frames: [usize; 2],
    /// Blocks that the smaller of both resampled.
    pub blocks: usize,
}

/// A comparison.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// What is different besides the times.
    pub differences: Differences,
    /// Passes that both have.
    pub passes: Vec<PassRatio>,
    /// Passes that only one has, or has too few frames or no time of: the stage, and why.
    pub left_out: Vec<(String, String)>,
    /// Error level over all passes.
    pub level: f64,
}

impl Comparison {
    /// Compares B with A. The same captures give the same result.
    pub fn of(a: &Times, b: &Times) -> Self {
        let in_b: BTreeMap<&str, &[f32]> = b.stages.iter().map(|(stage, times)| (&**stage, &**times)).collect();
        let mut left_out = Vec::new();
        let mut both = Vec::new();
        for (stage, a_times) in &a.stages {
            match in_b.get(stage.as_str()) {
                None => left_out.push((stage.clone(), "only A has it".to_string())),
                Some(b_times) => match usable(a_times).and_then(|a| Ok((a, usable(b_times)?))) {
                    Ok((a, b)) => both.push((stage, a, b)),
                    Err(why) => left_out.push((stage.clone(), why)),
                },
            }
        }
        let in_a = |stage: &str| a.stages.iter().any(|(of_a, _)| of_a == stage);
        let only_b = b.stages.iter().filter(|(stage, _)| !in_a(stage));
        left_out.extend(only_b.map(|(stage, _)| (stage.clone(), "only B has it".to_string())));
        let level = LEVEL / both.len().max(1) as f64;
        let passes = both.into_iter().map(|(stage, a, b)| PassRatio::of(stage, a, b, level)).collect();
        Self { differences: Differences::of(a, b), passes, left_out, level: LEVEL }
    }

    /// Passes that are slower in B by more than `share` (.05 for 5 %): their whole interval lies beyond it.
    pub fn slower_than(&self, share: f64) -> Vec<&PassRatio> {
        self.passes.iter().filter(|pass| pass.interval[0] > 1.0 + share).collect()
    }
}

/// The times that count, or why there are none.
fn usable(times: &[f32]) -> Result<&[f32], String> {
    let warm = &times[WARM_UP.min(times.len() / 4)..];
    if warm.len() < LEAST_FRAMES {
        return Err(format!("{} frames, and {LEAST_FRAMES} are needed", warm.len()));
    }
    if median(warm) > 0.0 { Ok(warm) } else { Err("its median is no time at all".into()) }
}

impl PassRatio {
    fn of(stage: &str, a: &[f32], b: &[f32], level: f64) -> Self {
        let (a_ms, b_ms) = (median(a), median(b));
        let (a_error, b_error) = (BlockError::of(a), BlockError::of(b));
        let blocks = a_error.blocks.min(b_error.blocks);
        let error = a_error.of_log.hypot(b_error.of_log);
        let reach = student_t(1.0 - level / 2.0, blocks - 1) * error;
        let ratio = b_ms / a_ms;
        let interval = [ratio * (-reach).exp(), ratio * reach.exp()];
        let verdict = match interval {
            [low, _] if low > 1.0 => Verdict::Slower,
            [_, high] if high < 1.0 => Verdict::Faster,
            _ => Verdict::NotTold,
        };
        Self { stage: stage.into(), a_ms, b_ms, ratio, interval, verdict, frames: [a.len(), b.len()], blocks }
    }
}
