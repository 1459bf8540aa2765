//! The phone's app on a desktop: its screen in a window, the mouse for a finger, sensors from a file. Without a window it is
//! touched by a script, and leaves pictures and a capture.

mod headless;
mod rates;
mod window;

use std::path::PathBuf;
use std::process::ExitCode;

use brooklet_gpu::{GpuOptions, Tier};
use brooklet_mobile::script::Readings;
use brooklet_mobile::{App, AppPaths};
use clap::Parser;

/// The phone's app on a desktop. The left button is a finger; with Ctrl a second one mirrors it at the window's middle, to pinch
/// and turn. Escape is the back key.
#[derive(Parser)]
pub struct Options {
    /// Where captures and pictures go.
    #[arg(long, default_value = "out-phone")]
    files: PathBuf,
    /// Readings of an accelerometer: lines of t,x,y,z in s and m/s².
    #[arg(long)]
    sensors: Option<PathBuf>,
    /// The display's turn from the phone's own attitude.
    #[arg(long, default_value_t = 0, value_parser = clap::builder::PossibleValuesParser::new(["0", "90", "180", "270"]).map(|degrees| degrees.parse::<u32>().unwrap_or(0)))]
    rotation: u32,
    /// Size of the screen, points.
    #[arg(long, num_args = 2, value_names = ["WIDTH", "HEIGHT"], default_values_t = [411.0, 891.0])]
    size: Vec<f32>,
    /// Pixels a point.
    #[arg(long, default_value_t = 1.0)]
    scale: f32,
    /// What the device is used as; the highest that it reaches if this is not given.
    #[arg(long, value_parser = clap::builder::PossibleValuesParser::new(["floor", "mobile", "desktop"]).map(|name| tier(&name)))]
    tier: Option<Tier>,
    /// No window: a script of touches.
    #[arg(long)]
    headless: bool,
    /// No window, no touches: every shipped scene for some seconds, and a table of the frames a second that the quality ladder
    /// comes to, with what it gives up.
    #[arg(long, conflicts_with = "headless")]
    rates: bool,
}

use clap::builder::TypedValueParser as _;

fn tier(name: &str) -> Tier {
    match name {
        "floor" => Tier::Floor,
        "mobile" => Tier::Mobile,
        _ => Tier::Desktop,
    }
}

fn main() -> ExitCode {
    let options = Options::parse();
    match run(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    if !options.size.iter().chain([&options.scale]).all(|number| number.is_finite() && *number > 0.0) {
        return Err("--size and --scale: positive numbers are allowed".into());
    }
    let readings = options.sensors.as_deref().map(Readings::load).transpose()?.unwrap_or_default();
    let paths = AppPaths { files: options.files.clone(), cache: options.files.join("cache") };
    let gpu = GpuOptions { timing: true, tier: options.tier, ..GpuOptions::default() };
    let app = App::new(paths).with_gpu_options(gpu);
    match (options.rates, options.headless) {
        (true, _) => rates::run(app, options),
        (false, true) => headless::run(app, options, &readings),
        (false, false) => window::run(app, options, readings),
    }
}
