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
    /// What a frame may take, ms: the ladder and the steps of a frame keep to it. Where not given, 16 on a GPU, 32 on a
    /// phone's, 80 on a processor
    #[arg(long, value_name = "MS", value_parser = crate::shared_options::budget)]
    pub budget: Option<f64>,
    /// Stay on this rung of the quality ladder, 0 being everything. Where not given, the ladder holds the budget by itself
    #[arg(long, value_name = "N", value_parser = crate::shared_options::rung)]
    pub rung: Option<usize>,
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
