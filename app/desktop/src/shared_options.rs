//! What most commands take: which scene, and on which device.

use brooklet_gpu::Tier;
use clap::{Args, ValueEnum};

/// Which scene, and what to change in it.
#[derive(Clone, Debug, Args)]
pub struct SceneOptions {
    /// A shipped scene's name (see `brooklet scenes`), or the path of a scene file
    #[arg(value_name = "SCENE", default_value = "dam-break")]
    pub scene: String,
    /// Change a value of the scene, as solver.pbf.iterations=8; may be given again
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub settings: Vec<String>,
}

/// Which device, and how to use it.
#[derive(Clone, Debug, Args)]
pub struct DeviceOptions {
    /// Use the device whose name contains this (see `brooklet doctor`); the best one if not given
    #[arg(long, value_name = "NAME", env = "BROOKLET_DEVICE")]
    pub device: Option<String>,
    /// Use the device as one of this tier, asking only for that tier's limits
    #[arg(long, value_enum, env = "BROOKLET_TIER")]
    pub tier: Option<TierName>,
    /// Note which kernel the driver is about to build, and do without one that ended an earlier run with this option
    #[arg(long)]
    pub careful: bool,
}

/// A device tier on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TierName {
    /// Discrete and integrated desktop GPUs
    Desktop,
    /// Adreno 6xx/7xx, Mali
    Mobile,
    /// Adreno 540, SwiftShader
    Floor,
}

impl From<TierName> for Tier {
    fn from(name: TierName) -> Self {
        match name {
            TierName::Desktop => Tier::Desktop,
            TierName::Mobile => Tier::Mobile,
            TierName::Floor => Tier::Floor,
        }
    }
}

/// The most steps of a run: what a step's number in the capture and a picture's in its name hold.
pub const MOST_STEPS: u64 = 1_000_000_000;

/// A number of steps, `least` or more.
pub fn steps_from(least: u64) -> clap::builder::RangedU64ValueParser {
    clap::value_parser!(u64).range(least..=MOST_STEPS)
}

/// A positive, finite time.
pub fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds.is_finite() => Ok(seconds),
        _ => Err("must be a positive number of seconds".into()),
    }
}

/// What a frame may take, ms.
#[cfg(feature = "window")]
pub fn budget(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|value| (1.0..=10_000.0).contains(value));
    value.ok_or_else(|| "a number from 1 to 10000 ms is allowed".into())
}

/// A rung of the quality ladder.
#[cfg(feature = "window")]
pub fn rung(text: &str) -> Result<usize, String> {
    let last = brooklet_viewer::ladder::RUNGS.len() - 1;
    text.parse().ok().filter(|rung| *rung <= last).ok_or_else(|| format!("a whole number from 0 to {last} is allowed"))
}
