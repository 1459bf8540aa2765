//! Whether this phone computes what it should: known answers of every kernel of the small scene, at the first start and from
//! the menu. What is wrong is refused, so that scenes are planned without it; the result is kept for each version and driver.
//!
//! The first start has no time for all of them on a slow device: it stops where a limit is over, at answers of stages that have
//! one already, and says how many it did not reach. The menu's check asks all.

use std::path::Path;
use std::time::Duration;

use brooklet_check::{CheckedModule, Device, ModuleVerdict, Report, Verdict, Wanted};
use brooklet_fluid::Scene;
use brooklet_gpu::{Gpu, tier_name};
use brooklet_kernels::Module;
use brooklet_render::ScenePlan;
use serde::{Deserialize, Serialize};

use crate::kept;
use crate::worker::{Gate, Worker};

/// Where the result is kept.
const FILE: &str = "self-check.json";
/// Time that the first start has for it; a case that is under way then still comes to its end.
pub const LIMIT: Duration = Duration::from_secs(20);
/// Android takes an app that does not answer for 5 s as hung.
pub const PATIENCE: Duration = Duration::from_secs(3);

/// What came of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Checked {
    /// Version, device, driver and tier that it holds for.
    pub of: String,
    /// Known answers that were asked.
    pub cases: usize,
    /// That could not run here.
    pub skipped: usize,
    /// That there was no time for.
    #[serde(default)]
    pub not_reached: usize,
    /// Kernels that therefore have no answer at all.
    #[serde(default)]
    pub unanswered: Vec<String>,
    /// How long it took, s.
    pub wall_s: f64,
    /// What is wrong.
    pub wrong: Vec<WrongAnswer>,
    /// Other wrong answers, which that explains.
    pub explained: usize,
}

/// A wrong answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WrongAnswer {
    /// The kernel and variant; empty if it is not known which.
    pub module: String,
    /// What was wrong with it.
    pub reason: String,
}

impl Checked {
    /// What a result on this device is of.
    pub fn key(gpu: &Gpu) -> String {
        let info = gpu.info();
        let version = env!("CARGO_PKG_VERSION");
        format!("{version}, {}, {} {}, {}", info.name, info.driver, info.driver_info, tier_name(gpu.tier()))
    }

    /// In a line.
    pub fn summary(&self) -> String {
        match self.wrong.as_slice() {
            [] => format!(
                "{} known answers, all right ({:.1} s){}",
                self.cases.saturating_sub(self.skipped),
                self.wall_s,
                self.left_out()
            ),
            wrong => {
                let mut names: Vec<&str> = wrong.iter().map(|wrong| wrong.module.as_str()).collect();
                names.dedup();
                let more = match self.explained {
                    0 => String::new(),
                    more => format!("; {more} answers more are wrong where that ran"),
                };
                format!("computes wrongly: {}{more}{}", names.join(", "), self.left_out())
            }
        }
    }

    /// What there was no time for, as the end of a sentence; nothing if all was asked.
    fn left_out(&self) -> String {
        match (self.not_reached, self.unanswered.len()) {
            (0, _) => String::new(),
            (more, 0) => format!("; no time for {more} more, which the menu's check asks"),
            (more, kernels) => {
                format!("; no time for {more} more, and none of {kernels} kernels: the menu's check asks them")
            }
        }
    }

    /// For captures.
    pub fn fields(&self) -> Vec<(String, String)> {
        let wrong = self.wrong.iter().map(|wrong| (format!("wrong {}", wrong.module), wrong.reason.clone()));
        let facts = [
            ("of", self.of.clone()),
            ("summary", self.summary()),
            ("cases", self.cases.to_string()),
            ("not_reached", self.not_reached.to_string()),
            ("unanswered", self.unanswered.join(", ")),
        ];
        facts.map(|(name, value)| (name.to_owned(), value)).into_iter().chain(wrong).collect()
    }

    /// Takes what is wrong from the device: no pipeline of it is built from now on.
    pub fn refuse_wrong(&self, gpu: &Gpu) {
        for WrongAnswer { module, reason } in self.wrong.iter().filter(|wrong| !wrong.module.is_empty()) {
            gpu.refuse(module, reason);
        }
    }

    /// The result that is kept of this version and driver.
    pub fn load(folder: &Path, gpu: &Gpu) -> Option<Self> {
        let text = std::fs::read_to_string(folder.join(FILE)).ok()?;
        // One that cannot be read is asked for again.
        let kept: Self = serde_json::from_str(&text).ok()?;
        (kept.of == Self::key(gpu)).then_some(kept)
    }

    /// Keeps it.
    ///
    /// # Errors
    /// If that cannot be written, with the file's name.
    pub fn save(&self, folder: &Path) -> Result<(), String> {
        kept::save(folder, FILE, self)
    }
}

/// What is asked.
#[derive(Clone, Debug)]
pub struct Asked {
    /// Known answers of these rooms; of all where none is named.
    pub rooms: Vec<String>,
    /// Run in place of the kernels of their names.
    pub replacements: Vec<&'static Module>,
    /// After this time the first start begins no further one.
    pub limit: Duration,
    /// So long a suspend waits for the case that is under way.
    pub patience: Duration,
}

impl Default for Asked {
    fn default() -> Self {
        Self { rooms: Vec::new(), replacements: Vec::new(), limit: LIMIT, patience: PATIENCE }
    }
}

/// Who waits for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Occasion {
    /// The first start of a version on a driver: there is nothing to see before it is done.
    FirstStart,
    /// The menu.
    Menu,
}

/// Begins a check.
///
/// # Errors
/// If the system has no thread left.
pub fn begin(gpu: &Gpu, scene: &Scene, asked: &Asked, occasion: Occasion) -> Result<Worker<Checked>, String> {
    let (gpu, scene, asked) = (gpu.clone(), scene.clone(), asked.clone());
    Worker::begin("self-check", move |gate| check(&gpu, &scene, asked, occasion, gate))
}

fn check(gpu: &Gpu, scene: &Scene, asked: Asked, occasion: Occasion, gate: &mut Gate<Checked>) -> Checked {
    let count = scene.particle_count().try_into().unwrap_or(u32::MAX);
    let mut checked = Checked { of: Checked::key(gpu), ..Checked::default() };
    let planned = match ScenePlan::of_count(scene, count, gpu.tier()) {
        Ok(planned) => planned,
        Err(error) => {
            checked.wrong.push(WrongAnswer { module: String::new(), reason: error.to_string() });
            return checked;
        }
    };
    // The sizes that take minutes on a processor are for a developer's machine.
    let device = Device::new(gpu.clone(), true).with_modules(asked.replacements);
    let wanted = Wanted::of_plan(planned.plan()).in_rooms(&asked.rooms).cheapest_first();
    let report = Report::run_while(&device, &wanted, &mut |progress| {
        gate.pass([progress.done, progress.total]) && (occasion == Occasion::Menu || gate.worked() < asked.limit)
    });
    checked.cases = report.outcomes.len();
    checked.not_reached = report.not_reached;
    let is_unanswered = |module: &&CheckedModule| module.verdict == ModuleVerdict::NotChecked;
    if report.not_reached > 0 {
        checked.unanswered = report.modules.iter().filter(is_unanswered).map(|m| m.run.module.to_owned()).collect();
    }
    checked.skipped = report.outcomes.iter().filter(|outcome| matches!(outcome.verdict, Verdict::Skipped(_))).count();
    let answers = report.outcomes.iter().filter_map(|outcome| {
        let Verdict::Wrong(wrong) = &outcome.verdict else { return None };
        Some(Answer {
            blamed: wrong.modules.clone(),
            ran: outcome.modules.iter().map(|run| run.module).collect(),
            reason: format!("{}: {wrong}", outcome.known.name),
        })
    });
    (checked.wrong, checked.explained) = guilty(answers.collect());
    checked.wall_s = gate.worked().as_secs_f64();
    checked
}

/// A case that came out wrong.
struct Answer {
    /// The modules that made the result.
    blamed: Vec<&'static str>,
    /// All that ran in it.
    ran: Vec<&'static str>,
    reason: String,
}

/// Whom wrong answers are due to, and how many of them others explain. A picture is wrong if anything is that it was drawn from:
/// so the answers that blame fewest are believed first, and those in which a guilty module ran say nothing of the others.
fn guilty(mut answers: Vec<Answer>) -> (Vec<WrongAnswer>, usize) {
    // What names nobody may be due to anybody.
    answers.sort_by_key(|answer| if answer.blamed.is_empty() { usize::MAX } else { answer.blamed.len() });
    let (mut guilty, mut explained) = (Vec::<WrongAnswer>::new(), 0);
    for Answer { blamed, ran, reason } in answers {
        if ran.iter().any(|module| guilty.iter().any(|known| known.module == *module)) {
            explained += 1;
        } else if blamed.is_empty() {
            guilty.push(WrongAnswer { module: String::new(), reason });
        } else {
            guilty.extend(blamed.into_iter().map(|name| WrongAnswer { module: name.into(), reason: reason.clone() }));
        }
    }
    (guilty, explained)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(blamed: &[&'static str], ran: &[&'static str]) -> Answer {
        Answer { blamed: blamed.to_vec(), ran: ran.to_vec(), reason: "off".into() }
    }

    fn names(guilty: &[WrongAnswer]) -> Vec<&str> {
        guilty.iter().map(|wrong| wrong.module.as_str()).collect()
    }

    #[test]
    fn what_a_wrong_kernel_spoils_is_not_blamed_on_others() {
        let picture = || answer(&["Water", "Floor"], &["Normals", "Water", "Floor"]);
        let (found, explained) = guilty(vec![picture(), answer(&["Normals"], &["Normals"]), answer(&[], &["Normals"])]);
        assert_eq!((names(&found), explained), (vec!["Normals"], 2));
        // Alone it is all that is known.
        assert_eq!(names(&guilty(vec![picture()]).0), ["Water", "Floor"]);
        let (found, explained) = guilty(vec![answer(&[], &[]), answer(&["Xsph"], &["Xsph"]), picture()]);
        assert_eq!((names(&found), explained), (vec!["Xsph", "Water", "Floor", ""], 0));
        assert_eq!(guilty(Vec::new()), (Vec::new(), 0));
    }
}
