//! What a phone's owner sends: one small file of the device and its limits, what the self-check found, and the GPU times of the
//! two small scenes, pass by pass.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use brooklet_fluid::Scene;
use brooklet_gpu::{FrameReport, Gpu, GpuError, PassTimes, Passes, Quantiles, Timings, stages, tier_name};
use brooklet_render::View;
use brooklet_viewer::ladder::RUNGS;
use brooklet_viewer::viewer_scene::{SceneDesc, Start, ViewerFrame, ViewerScene};
use brooklet_viewer::{NewModules, ViewerError};
use serde::Serialize;

use crate::self_check::{Checked, WrongAnswer};
use crate::worker::{Gate, Worker};

/// Its file, beside the captures.
pub const FILE: &str = "report.json";
/// Of this file's form.
const FORMAT: u32 = 1;
/// The scenes of the published table on an Adreno 540.
pub const SCENES: [&str; 2] = ["phone-1k", "phone-5k"];
/// A scene's frames are timed for so long at most, and no more of them than these,
pub const TIME: Duration = Duration::from_secs(10);
const MOST_FRAMES: u64 = 200;
/// but these at least, however slow the device is.
const LEAST_FRAMES: u64 = 8;
/// Frames that do not count: the clock rises, and the mesh finds its room.
const WARM_UP: u64 = 4;
/// A frame that is not back by then never comes.
const LONGEST_FRAME: Duration = Duration::from_secs(60);

/// The file.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    format: u32,
    program: &'static str,
    version: &'static str,
    device: DeviceFacts,
    /// Modules that are not built, and why.
    refused: Vec<WrongAnswer>,
    self_check: Option<Checked>,
    /// What was timed.
    pub scenes: Vec<SceneTimes>,
}

#[derive(Clone, Debug, Serialize)]
struct DeviceFacts {
    name: String,
    driver: String,
    driver_info: String,
    kind: String,
    vendor: u32,
    device: u32,
    tier: &'static str,
    /// How GPU times are taken.
    timing: &'static str,
    timestamp_period_ns: f64,
    limits: BTreeMap<&'static str, u64>,
}

/// A scene's frames of one step and one picture each, with nothing given up.
#[derive(Clone, Debug, Serialize)]
pub struct SceneTimes {
    /// Its name.
    pub scene: &'static str,
    /// Why there are no times, or fewer.
    pub trouble: Option<String>,
    particles: u32,
    picture_px: [u32; 2],
    /// What the device cannot do of it, and what it has instead.
    does_without: Vec<String>,
    /// Frames that count.
    pub frames: u64,
    /// One step, without a picture.
    pub step_ms: Option<Quantiles>,
    /// The whole frame, from its first pass to its last.
    pub gpu_ms: Option<Quantiles>,
    /// From handing a frame over until its report is back; one at a time.
    pub wall_ms: Option<Quantiles>,
    /// Times that cannot be right.
    flagged_spans: u64,
    passes: Option<Passes<PassTimes>>,
}

/// Begins to make one: of a picture of that size, a scene for `time` at most.
///
/// # Errors
/// If the system has no thread left.
pub fn begin(
    gpu: &Gpu,
    checked: Option<&Checked>,
    picture_px: [u32; 2],
    time: Duration,
) -> Result<Worker<Report>, String> {
    let (gpu, self_check) = (gpu.clone(), checked.cloned());
    Worker::begin("report", move |gate| {
        let scenes = (0..SCENES.len()).map(|index| timed(&gpu, index, picture_px, time, gate)).collect();
        let info = gpu.info().clone();
        let refused = gpu.refused().into_iter().map(|(module, reason)| WrongAnswer { module, reason }).collect();
        Report {
            format: FORMAT,
            program: "brooklet mobile",
            version: env!("CARGO_PKG_VERSION"),
            device: DeviceFacts {
                name: info.name,
                driver: info.driver,
                driver_info: info.driver_info,
                kind: info.device_type,
                vendor: info.vendor,
                device: info.device,
                tier: tier_name(gpu.tier()),
                timing: gpu.timing().name(),
                timestamp_period_ns: info.timestamp_period_ns,
                limits: info.limits.into_iter().collect(),
            },
            refused,
            self_check,
            scenes,
        }
    })
}

fn timed(gpu: &Gpu, index: usize, picture_px: [u32; 2], time: Duration, gate: &mut Gate<Report>) -> SceneTimes {
    let mut times = SceneTimes {
        scene: SCENES[index],
        trouble: None,
        particles: 0,
        picture_px,
        does_without: Vec::new(),
        frames: 0,
        step_ms: None,
        gpu_ms: None,
        wall_ms: None,
        flagged_spans: 0,
        passes: None,
    };
    if let Err(trouble) = time_frames(gpu, index, time, gate, &mut times) {
        times.trouble = Some(trouble);
    }
    times
}

fn time_frames(
    gpu: &Gpu,
    index: usize,
    time: Duration,
    gate: &mut Gate<Report>,
    times: &mut SceneTimes,
) -> Result<(), String> {
    let all = SCENES.len() * MOST_FRAMES as usize;
    let pass = |gate: &mut Gate<Report>, frames: u64, share: f64| {
        let share = share.max(frames as f64 / MOST_FRAMES as f64).min(1.0);
        gate.pass([((index as f64 + share) * MOST_FRAMES as f64) as usize, all])
    };
    if !pass(gate, 0, 0.0) {
        return Err("it was ended".into());
    }
    let scene = Scene::load(SCENES[index], &[]).map_err(|error| error.to_string())?;
    let desc = SceneDesc {
        rung: RUNGS[0],
        window_px: times.picture_px,
        camera: View::of_scene(&scene).camera,
        start: Start::Scene,
        modules: NewModules::default(),
        mesh_room: None,
        why: "report".into(),
        scene,
    };
    let mut running = ViewerScene::build(gpu, desc, &mut |_, _, _| {}).map_err(|error| error.to_string())?;
    times.particles = running.session.slot_count();
    times.does_without = running.concessions.iter().map(ToString::to_string).collect();
    let step = running.session.step_id();
    let (mut timings, mut wall_ms, mut gpu_ms) = (Timings::new(WARM_UP), Vec::new(), Vec::new());
    let begun = gate.worked();
    let mut outcome = Ok(());
    while timings.frames() < WARM_UP + MOST_FRAMES {
        let (frames, spent) = (timings.frames(), gate.worked().saturating_sub(begun));
        if frames >= WARM_UP + LEAST_FRAMES && spent >= time {
            break;
        }
        if !pass(gate, frames, spent.as_secs_f64() / time.as_secs_f64().max(1e-3)) {
            outcome = Err("it was ended".into());
            break;
        }
        match time_frame(&mut running) {
            Ok((report, ms)) => {
                timings.add(&report, step);
                if frames >= WARM_UP {
                    wall_ms.push(ms);
                    gpu_ms.extend(report.gpu_ms());
                }
            }
            Err(error) => {
                outcome = Err(error.to_string());
                break;
            }
        }
    }
    times.frames = timings.frames() - timings.warm_up();
    (times.step_ms, times.gpu_ms, times.wall_ms) = (timings.step_ms(), Quantiles::of(gpu_ms), Quantiles::of(wall_ms));
    times.flagged_spans = timings.flagged_spans();
    let recordings = running.frame_recordings();
    let plan = running.session.engine().plan().passes();
    let ran = plan.into_iter().filter(|pass| recordings.contains(&pass.recording));
    let mut passes = timings.passes(&stages(ran));
    passes.0.retain(|(_, pass)| pass.median_ms.is_some());
    times.passes = Some(passes);
    outcome
}

/// One frame, alone on the GPU, and how long it was away.
fn time_frame(running: &mut ViewerScene) -> Result<(FrameReport, f64), ViewerError> {
    let handed = Instant::now();
    let frame = running.run(&ViewerFrame { steps: 1, ..ViewerFrame::default() }, None, None)?;
    while handed.elapsed() < LONGEST_FRAME {
        let back = running.session.reports().into_iter().find(|back| back.report.frame == frame);
        if let Some(back) = back {
            let wall_ms = 1e3 * handed.elapsed().as_secs_f64();
            running.learn(&back.report);
            return Ok((back.report, wall_ms));
        }
        if let Some(reason) = running.session.engine().gpu().is_lost() {
            return Err(GpuError::DeviceLost { reason }.into());
        }
        std::thread::sleep(Duration::from_micros(200));
    }
    Err(GpuError::DeviceLost { reason: format!("a frame took more than {} s", LONGEST_FRAME.as_secs()) }.into())
}

impl Report {
    /// In a line.
    pub fn summary(&self) -> String {
        let one = |times: &SceneTimes| match (&times.trouble, times.gpu_ms.or(times.wall_ms)) {
            (Some(trouble), _) => format!("{}: {trouble}", times.scene),
            (None, Some(ms)) => format!("{}: {:.1} ms a frame", times.scene, ms.median),
            (None, None) => format!("{}: no times", times.scene),
        };
        self.scenes.iter().map(one).collect::<Vec<_>>().join("; ")
    }
}
