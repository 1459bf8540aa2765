//! The parts of a report, and the commands that each is made of.

use std::{fs, path::Path, time::Instant};

use serde_json::{Value, json};

use super::{Part, child};
use crate::{failure::Failure, interrupt::Interrupt, report_options::PartName, shared_options::DeviceOptions};

/// A part.
pub struct Planned {
    /// Which.
    pub name: PartName,
    /// Its part of the time that the parts from it on have.
    pub share: f64,
    /// What it does.
    pub run: fn(&mut Running<'_>) -> Result<(), Failure>,
}

/// In the order in which they are wanted if time or device gives out: what is right first, then how fast.
pub const ALL: [Planned; 9] = [
    Planned { name: PartName::Device, share: 0.5, run: device },
    Planned { name: PartName::Check, share: 6.0, run: check },
    Planned { name: PartName::Scaling, share: 8.0, run: scaling },
    Planned { name: PartName::Runs, share: 3.0, run: runs },
    Planned { name: PartName::Pictures, share: 7.0, run: pictures },
    Planned { name: PartName::Sorting, share: 2.0, run: sorting },
    Planned { name: PartName::Submissions, share: 2.0, run: submissions },
    Planned { name: PartName::Errors, share: 3.0, run: errors },
    Planned { name: PartName::Extremes, share: 4.0, run: extremes },
];

/// Ways to draw, each with the name of its folder and picture.
pub const SURFACES: [&str; 3] = ["screen-space", "marching-cubes", "points"];
/// The case whose error is drawn against time, and the plot that a study makes of it.
const ERROR_CASE: &str = "elliptical-drop";
/// See [`ERROR_CASE`].
pub const ERROR_PLOT: &str = "errors/plots/work-precision-elliptical-drop.svg";
/// The scene of runs and pictures.
const SCENE: &str = "dam-break";
/// Its particles times its iterations a step.
const STEP_ITERATIONS: f64 = 30_600.0 * 4.0;
/// Size of a picture, pixels; a processor's driver with less time than this for pictures draws a quarter of it.
const PICTURE_PX: [u32; 2] = [1920, 1080];
const FULL_SIZE_S: f64 = 60.0;
/// A run is made so long that it should take this part of its time: a device's speed varies, and a run that is cut off
/// has no figures.
const PLANNED_PART: f64 = 0.4;
/// A command is cut off so much before its part's end, that the page is written in time.
const SPARE_S: f64 = 0.5;

/// A part under way.
pub struct Running<'a> {
    /// What is found.
    pub part: &'a mut Part,
    /// Which device.
    pub device: &'a DeviceOptions,
    /// The report's folder.
    pub out: &'a Path,
    /// Ctrl-C.
    pub interrupt: &'a Interrupt,
    /// Since when.
    pub begun: Instant,
    /// How long it may take.
    pub seconds: f64,
    /// Whether the device is a driver that runs on the processor.
    pub is_processor: bool,
    /// Particle iterations a second, as the scaling table found; nothing if it did not come so far.
    pub iterations_per_s: Option<f64>,
}

impl Running<'_> {
    fn left_s(&self) -> f64 {
        self.seconds - self.begun.elapsed().as_secs_f64() - SPARE_S
    }

    /// Runs a command for `most_s` at most; whether it ended well. What it printed is kept under `label`.
    fn command(&mut self, label: &str, arguments: &[&str], most_s: f64) -> Result<bool, Failure> {
        if most_s <= 0.0 {
            self.part.troubles.push(format!("{label}: no time was left for it"));
            return Ok(false);
        }
        let ended = child::run(&self.arguments(arguments), most_s, self.interrupt)?;
        let mut printed: Option<Value> = serde_json::from_str(&ended.stdout).ok();
        // A page that is sent says nothing of its owner's folders.
        if let Some(Value::Object(printed)) = &mut printed {
            printed.remove("files");
        }
        match (ended.trouble, &printed) {
            (Some(trouble), _) => self.part.troubles.push(format!("{label}: {trouble}")),
            (None, None) => self.part.troubles.push(format!("{label}: printed no figures")),
            (None, Some(_)) => {}
        }
        let is_there = printed.is_some();
        self.part.figures.extend(printed.map(|printed| (label.to_string(), printed)));
        Ok(is_there)
    }

    /// Runs a study, which prints for people and leaves files.
    fn study(&mut self, label: &str, arguments: &[&str], most_s: f64) -> Result<(), Failure> {
        if most_s <= 0.0 {
            self.part.troubles.push(format!("{label}: no time was left for it"));
            return Ok(());
        }
        let ended = child::run(&self.arguments(arguments), most_s, self.interrupt)?;
        self.part.troubles.extend(ended.trouble.map(|trouble| format!("{label}: {trouble}")));
        Ok(())
    }

    /// Those of a command, with the device and the tier of this report's.
    fn arguments(&self, arguments: &[&str]) -> Vec<String> {
        let tier = self.device.tier.map(|tier| brooklet_gpu::tier_name(tier.into()).to_string());
        let wanted = [("--device", &self.device.device), ("--tier", &tier)];
        let wanted = wanted.into_iter().filter_map(|(option, value)| Some([option.to_string(), value.clone()?]));
        arguments.iter().map(ToString::to_string).chain(wanted.flatten()).collect()
    }

    /// Steps of [`SCENE`] that should take a part of `most_s`, from `least` to `most`.
    fn steps(&self, most_s: f64, least: u32, most: u32) -> u32 {
        let iterations_per_s = self.iterations_per_s.unwrap_or(if self.is_processor { 1e6 } else { 1e9 });
        ((PLANNED_PART * most_s * iterations_per_s / STEP_ITERATIONS) as u32).clamp(least, most)
    }

    fn path(&self, name: &str) -> String {
        self.out.join(name).display().to_string()
    }
}

fn device(running: &mut Running<'_>) -> Result<(), Failure> {
    let left_s = running.left_s().max(20.0);
    running.command("doctor", &["doctor", "--json"], left_s)?;
    let state = serde_json::to_value(brooklet_capture::DeviceState::find().read()).map_err(Failure::stopped)?;
    running.part.figures.insert("state".into(), state);
    Ok(())
}

/// Every kernel of the tier against its known answer, and every size; on a processor's driver those of one scene, on small
/// inputs.
fn check(running: &mut Running<'_>) -> Result<(), Failure> {
    let (left_s, which) = (running.left_s(), if running.is_processor { SCENE } else { "--all" });
    running.command("check", &["doctor", "--check", which, "--json"], left_s)?;
    if running.part.figures.get("check").is_some_and(|check| check["right"] == false) {
        running.part.tell_wrong();
    }
    Ok(())
}

/// A run with a capture; then two deterministic ones, which have to end alike to the last bit.
fn runs(running: &mut Running<'_>) -> Result<(), Failure> {
    let half_s = 0.5 * running.left_s();
    let (folder, steps) = (running.path("run"), running.steps(half_s, 12, 240).to_string());
    let run = ["run", SCENE, "--steps", &steps, "--images", "0", "--json", "--out", &folder];
    running.command("run", &run, half_s)?;
    let steps = running.steps(0.5 * running.left_s(), 4, 240);
    let mut ends = Vec::new();
    for name in ["deterministic-a", "deterministic-b"] {
        let folder = running.out.join(name);
        let (path, steps, left_s) = (folder.display().to_string(), steps.to_string(), running.left_s());
        let run = [
            "run",
            SCENE,
            "--set",
            "solver.deterministic=true",
            "--steps",
            &steps,
            "--images",
            "0",
            "--no-capture",
            "--no-timing",
            "--particles",
            "ply",
            "--json",
            "--out",
            &path,
        ];
        if running.command(name, &run, left_s)? {
            ends.extend(last_particles(&folder));
        }
        // Two megabytes that nobody opens; where they cannot be removed they do no harm.
        let _ = fs::remove_dir_all(&folder);
    }
    if let [a, b] = &ends[..] {
        let alike = a == b;
        let figures = json!({ "steps": steps, "alike": alike, "bytes": a.len() });
        running.part.figures.insert("deterministic".into(), figures);
        if !alike {
            running.part.tell_wrong();
            running.part.troubles.push("two deterministic runs end differently".into());
        }
    }
    Ok(())
}

/// The last file of particles in a run's folder.
fn last_particles(folder: &Path) -> Option<Vec<u8>> {
    let files = fs::read_dir(folder).ok()?.filter_map(|entry| Some(entry.ok()?.path()));
    fs::read(files.filter(|path| path.extension().is_some_and(|extension| extension == "ply")).max()?).ok()
}

fn scaling(running: &mut Running<'_>) -> Result<(), Failure> {
    let left_s = running.left_s();
    // The table keeps its own budget, but for what it has begun.
    let (budget, plot) = (format!("{:.1}", (0.7 * left_s).max(1.0)), running.path("scaling.svg"));
    let bench = ["bench", "--max-particles", "17000000", "--budget", &budget, "--plot", &plot, "--json"];
    running.command("scaling", &bench, left_s).map(drop)
}

fn pictures(running: &mut Running<'_>) -> Result<(), Failure> {
    let part = if running.is_processor && running.seconds < FULL_SIZE_S { 2 } else { 1 };
    let [width, height] = PICTURE_PX.map(|px| px / part);
    let size = [format!("outputs.width_px={width}"), format!("outputs.height_px={height}")];
    let folder = running.out.join("pictures");
    if let Err(error) = fs::create_dir_all(&folder) {
        running.part.troubles.push(format!("{}: cannot be created: {error}", folder.display()));
        return Ok(());
    }
    let methods = SURFACES.map(|method| (method, format!("surface.method={method}")));
    // First what is looked at, then what it costs.
    let jobs = methods.iter().map(|one| (one, true)).chain(methods.iter().map(|one| (one, false)));
    for (done, ((method, surface), is_picture)) in jobs.enumerate() {
        let most_s = running.left_s() / (2 * SURFACES.len() - done) as f64;
        let set = ["--set", surface, "--set", &size[0], "--set", &size[1]];
        if is_picture {
            let (path, steps) =
                (folder.join(method).display().to_string(), running.steps(0.5 * most_s, 4, 120).to_string());
            let run = ["run", SCENE, "--steps", &steps, "--images", "1", "--no-capture", "--json", "--out", &path];
            running.command(&format!("picture {method}"), &[&run[..], &set].concat(), most_s)?;
        } else {
            let steps = running.steps(0.2 * most_s, 2, 20).to_string();
            let pictures = if running.is_processor { "3" } else { "8" };
            let bench = ["bench", SCENE, "--warm-up", &steps, "--steps", &steps, "--pictures", pictures, "--json"];
            running.command(method, &[&bench[..], &set].concat(), most_s)?;
        }
    }
    Ok(())
}

fn sorting(running: &mut Running<'_>) -> Result<(), Failure> {
    let left_s = running.left_s();
    // Eleven comparisons; 27,000 particles take a processor 20 to 40 ms a pair.
    let (particles, pairs) = match running.is_processor {
        true => ("27000", ((left_s / 2.0) as u32).clamp(4, 40)),
        false => ("1000000", 40),
    };
    let pairs = pairs.to_string();
    let bench = ["bench", "sorting", "--particles", particles, "--pairs", &pairs, "--json"];
    running.command("sorting", &bench, left_s).map(drop)
}

fn submissions(running: &mut Running<'_>) -> Result<(), Failure> {
    let left_s = running.left_s();
    // Six ways of 32 steps a round, and a first one. A processor takes 50 ms for a step of the whole scene, and 10 with
    // particles of twice the size.
    let (rounds, coarser): (u32, &[&str]) = match running.is_processor {
        true => (((left_s / 5.0) as u32).clamp(1, 20), &["--set", "spacing_m=0.04"]),
        false => (20, &[]),
    };
    let rounds = rounds.to_string();
    let bench = ["bench", "submissions", "--rounds", &rounds, "--json"];
    running.command("submissions", &[&bench[..], coarser].concat(), left_s).map(drop)
}

/// Error against time of a stretched drop, iterations along the curve.
fn errors(running: &mut Running<'_>) -> Result<(), Failure> {
    let folder = running.out.join("errors");
    let path = folder.display().to_string();
    let study = ["study", "error", "--quick", "--scenes", ERROR_CASE, "--knobs", "iterations", "--out", &path];
    let most_s = running.left_s();
    running.study("error against time", &study, most_s)?;
    Ok(())
}

/// As many of the extreme cases as fit: each outcome is a line in a file, and what is cut off keeps them.
fn extremes(running: &mut Running<'_>) -> Result<(), Failure> {
    let folder = running.out.join("extremes");
    let path = folder.display().to_string();
    let left_s = running.left_s();
    running.study("extreme cases", &["study", "stability", "--quick", "--out", &path], left_s)?;
    let lines = fs::read_to_string(folder.join(brooklet_study::RESULTS)).unwrap_or_default();
    let outcomes: Vec<Value> = lines
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .map(|line| {
            json!({
                "case": line["task"]["case"],
                "tier": line["task"]["tier"],
                "state": line["outcome"]["state"],
                "reason": line["outcome"]["reason"],
            })
        })
        .collect();
    let silent =
        outcomes.iter().any(|outcome| outcome["state"].as_str().is_some_and(|s| s.eq_ignore_ascii_case("silent")));
    if silent {
        running.part.tell_wrong();
        running.part.troubles.push("a case went wrong without the program's own counts saying so".into());
    }
    running.part.figures.insert("extremes".into(), Value::Array(outcomes));
    Ok(())
}
