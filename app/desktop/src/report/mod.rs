//! `brooklet report`: what a device computes and how fast, as one page that its owner can send.
//!
//! Each part is this program's own commands with `--json`, each in a process of its own. The page and `report.json` are
//! written anew as each part ends, so that whatever ends a report early leaves a page of what was done.

mod child;
mod compare;
mod page;
mod parts;
mod show;

use std::{path::Path, time::Instant};

use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use serde_json::Value;

use crate::{
    commit::{COMMIT, VERSION},
    failure::Failure,
    interrupt::Interrupt,
    job,
    out_dir::{self, OutDir},
    report_options::{PartName, ReportCommand, ReportOptions},
};

pub use compare::FORMAT;

/// The page's file.
pub const PAGE: &str = "index.html";
/// The figures' file.
pub const FIGURES: &str = "report.json";

/// How far a part came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum State {
    /// Not begun.
    Waiting,
    /// Under way: where a report ends here, this is what it was doing.
    UnderWay,
    /// Done, or as much of it as its time allowed.
    Done,
    /// Left out by `--skip`.
    LeftOut,
}

/// A part and what it found.
#[derive(Clone, Debug, Serialize)]
pub struct Part {
    /// Which.
    pub name: &'static str,
    /// How far it came.
    pub state: State,
    /// What it took, s.
    pub seconds: f64,
    /// What could not be done, and why.
    pub troubles: Vec<String>,
    /// What its commands printed, by command.
    pub figures: serde_json::Map<String, Value>,
}

/// A report as far as it is.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Of this file's form.
    pub format: u32,
    /// The program's version.
    pub version: &'static str,
    /// The commit that it was built from.
    pub commit: &'static str,
    /// The device's name.
    pub device: String,
    /// Its driver and that one's version.
    pub driver: String,
    /// What it was used as.
    pub tier: &'static str,
    /// Whether it is a driver that runs on the processor.
    pub is_processor: bool,
    /// What it was given.
    pub minutes: f64,
    /// In order.
    pub parts: Vec<Part>,
}

/// Makes a report, or compares two.
pub fn report(options: &ReportOptions) -> Result<(), Failure> {
    match &options.compare {
        Some(ReportCommand::Compare(options)) => compare::compare(options),
        None => make(options),
    }
}

fn make(options: &ReportOptions) -> Result<(), Failure> {
    // The device is looked at here, and given back: parts open it themselves.
    let mut report = {
        let gpu = job::open(&options.device, true)?;
        let info = gpu.info();
        Report {
            format: FORMAT,
            version: VERSION,
            commit: COMMIT,
            device: info.name.clone(),
            driver: format!("{} {}", info.driver, info.driver_info),
            tier: brooklet_gpu::tier_name(gpu.tier()),
            is_processor: info.device_type == "cpu",
            minutes: options.minutes,
            parts: parts::ALL.iter().map(|part| Part::new(part.name, &options.skip)).collect(),
        }
    };
    let interrupt = Interrupt::listen()?;
    let out = OutDir::create(options.out.as_deref().unwrap_or(Path::new("out/report")))?;
    write(&report, &out.path).inspect_err(|_| out.remove())?;
    let bar = ProgressBar::new(parts::ALL.len() as u64);
    let style = ProgressStyle::with_template("{bar:32} {elapsed}  {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(std::time::Duration::from_millis(500));
    let outcome = all(&mut report, options, &out.path, &interrupt, &bar);
    bar.finish_and_clear();
    let page = out.path.join(PAGE);
    outcome.map_err(|failure| match failure {
        Failure::Interrupted(text) => Failure::Interrupted(format!("{text}: {}", page.display())),
        other => other,
    })?;
    say!("{}", page.display());
    let troubles: Vec<String> = report.parts.iter().flat_map(Part::told).collect();
    for trouble in &troubles {
        say!("  {trouble}");
    }
    if report.parts.iter().any(Part::is_wrong) {
        return Err(Failure::Stopped(format!("the device is wrong in something; see {}", page.display())));
    }
    Ok(())
}

fn all(
    report: &mut Report,
    options: &ReportOptions,
    out: &Path,
    interrupt: &Interrupt,
    bar: &ProgressBar,
) -> Result<(), Failure> {
    let begun = Instant::now();
    for (index, part) in parts::ALL.iter().enumerate() {
        if report.parts[index].state == State::LeftOut {
            bar.inc(1);
            continue;
        }
        let left_s = 60.0 * options.minutes - begun.elapsed().as_secs_f64();
        let shares: f64 =
            parts::ALL[index..].iter().filter(|part| !options.skip.contains(&part.name)).map(|part| part.share).sum();
        bar.set_message(part.name.word());
        report.parts[index].state = State::UnderWay;
        write(report, out)?;
        let iterations_per_s = show::most_iterations_per_s(report);
        let running = &mut parts::Running {
            part: &mut report.parts[index],
            device: &options.device,
            out,
            interrupt,
            begun: Instant::now(),
            seconds: left_s * part.share / shares,
            is_processor: report.is_processor,
            iterations_per_s,
        };
        let outcome = (part.run)(running);
        running.part.seconds = running.begun.elapsed().as_secs_f64();
        if outcome.is_ok() {
            running.part.state = State::Done;
        }
        write(report, out)?;
        outcome?;
        bar.inc(1);
    }
    Ok(())
}

fn write(report: &Report, out: &Path) -> Result<(), Failure> {
    let json = serde_json::to_string_pretty(report).map_err(Failure::stopped)?;
    out_dir::write_file(&out.join(FIGURES), json.as_bytes())?;
    out_dir::write_file(&out.join(PAGE), page::page(report, out).as_bytes())
}

impl Part {
    fn new(name: PartName, skip: &[PartName]) -> Self {
        Self {
            name: name.word(),
            state: if skip.contains(&name) { State::LeftOut } else { State::Waiting },
            seconds: 0.0,
            troubles: Vec::new(),
            figures: serde_json::Map::new(),
        }
    }

    /// Its troubles, each with its name.
    fn told(&self) -> Vec<String> {
        self.troubles.iter().map(|trouble| format!("{}: {trouble}", self.name)).collect()
    }

    /// That it found the device wrong.
    fn tell_wrong(&mut self) {
        self.figures.insert("wrong".into(), Value::Bool(true));
    }

    /// Whether it found the device wrong, and not only slow or small.
    fn is_wrong(&self) -> bool {
        self.figures.get("wrong").is_some_and(|wrong| wrong == &Value::Bool(true))
    }
}
