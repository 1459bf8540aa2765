//! The command line of `brooklet view`.

use std::path::PathBuf;

use clap::Args;

use crate::shared_options::{DeviceOptions, SceneOptions};

/// `brooklet view`.
#[derive(Clone, Debug, Args)]
pub struct ViewOptions {
    /// The scene, or a saved state.
    #[command(flatten)]
    pub scene: SceneOptions,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Folder that screenshots, captures and states are written to
    #[arg(long, value_name = "DIR", default_value = "out/view")]
    pub out: PathBuf,
    /// Size of the window, points
    #[arg(long, value_name = "WxH", default_value = "1280x800", value_parser = size)]
    pub size: [u32; 2],
    /// What a frame may take, ms: the ladder and the steps of a frame keep to it
    #[arg(long, value_name = "MS", default_value_t = 16.0, value_parser = budget)]
    pub budget: f64,
    /// Let the quality ladder hold the budget by itself from the start
    #[arg(long)]
    pub auto: bool,
    /// Rung of the quality ladder to begin on: 0 is everything
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = rung)]
    pub rung: usize,
    /// Shaders to watch: a kernel that is changed there is compiled and runs at once. That of a checkout the
    /// window is opened in, if not given
    #[arg(long, value_name = "DIR", default_value = "shaders/hlsl")]
    pub shaders: PathBuf,
    /// Lose the device at this frame, as a driver may
    #[arg(long, value_name = "FRAME", hide = true)]
    pub lose_device: Option<u64>,
    /// Lose the surface at this frame, as a window system may
    #[arg(long, value_name = "FRAME", hide = true)]
    pub lose_surface: Option<u64>,
    /// Write where the window's controls are, and what it says, to this file, one JSON object a line
    #[arg(long, value_name = "FILE", hide = true)]
    pub tell: Option<PathBuf>,
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides
        .filter(|sides| sides.iter().all(|side| (320..=8192).contains(side)))
        .ok_or_else(|| "WIDTHxHEIGHT, each from 320 to 8192, as 1280x800".into())
}

fn budget(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|value| (1.0..=10_000.0).contains(value));
    value.ok_or_else(|| "a number from 1 to 10000 ms is allowed".into())
}

fn rung(text: &str) -> Result<usize, String> {
    let last = brooklet_viewer::ladder::RUNGS.len() - 1;
    text.parse().ok().filter(|rung| *rung <= last).ok_or_else(|| format!("a whole number from 0 to {last} is allowed"))
}
