//! Which modules a plan runs, which cases are their known answers, and what came of them, a module at a time.

use std::collections::{BTreeMap, BTreeSet};

use brooklet_gpu::{Gpu, Plan};

use crate::cost;
use crate::device::{Device, KnownAnswer, ModuleRun, Outcome, Verdict, modules_of};
use crate::registry::KNOWN_ANSWERS;

/// Modules whose answers are wanted: by name, the stage that runs each, or `None` where any may.
pub struct Wanted {
    modules: BTreeMap<&'static str, Option<&'static str>>,
    rooms: Vec<String>,
    cheapest_first: bool,
}

/// What is known of a module after the cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModuleVerdict {
    /// Every case whose stages it is of came out right.
    Right,
    /// A case came out wrong, and it made the result.
    Wrong,
    /// No case that came to an end is its known answer: none is listed, it was skipped, or it ended before.
    NotChecked,
}

/// A module (kernel and variant) after the cases.
#[derive(Clone, Debug)]
pub struct CheckedModule {
    /// What ran, in all cases together.
    pub run: ModuleRun,
    /// Cases that are its known answers and came out right.
    pub right: usize,
    /// What is known of it.
    pub verdict: ModuleVerdict,
}

/// Cases that were run, and what they say of modules.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Every case that was run, in order.
    pub outcomes: Vec<Outcome>,
    /// Cases that were not: it was stopped before, or the device was lost.
    pub not_reached: usize,
    /// Every module that was wanted, by name.
    pub modules: Vec<CheckedModule>,
}

impl Wanted {
    /// What a plan runs.
    pub fn of_plan(plan: &Plan) -> Self {
        let mut modules = BTreeMap::new();
        for command in plan.recordings().flat_map(|recording| plan.commands(recording)) {
            for (stage, module) in modules_of(command) {
                modules.insert(module.name, Some(stage));
            }
        }
        Self { modules, rooms: Vec::new(), cheapest_first: false }
    }

    /// Everything that the device's tier can run.
    pub fn of_tier(gpu: &Gpu) -> Self {
        let allowed = brooklet_kernels::modules().filter(|module| module.tier <= gpu.tier());
        let modules = allowed.map(|module| (module.name, None)).collect();
        Self { modules, rooms: Vec::new(), cheapest_first: false }
    }

    /// Of the same modules, only what cases of some rooms say; all where none is named.
    pub fn in_rooms(self, rooms: &[String]) -> Self {
        Self { rooms: rooms.to_vec(), ..self }
    }

    /// The same in another order, for who may stop early: an answer of every stage first, cheap ones before dear ones.
    pub fn cheapest_first(self) -> Self {
        Self { cheapest_first: true, ..self }
    }

    /// The cases that are known answers of it.
    pub fn cases(&self) -> Vec<&'static KnownAnswer> {
        let all = self.modules.values().any(Option::is_none);
        let stages: BTreeSet<&str> = self.modules.values().flatten().copied().collect();
        let in_room = |known: &KnownAnswer| self.rooms.is_empty() || self.rooms.iter().any(|room| room == known.room);
        let wanted = |known: &&KnownAnswer| {
            in_room(known)
                && (all || known.stages.is_empty() || known.stages.iter().any(|stage| stages.contains(stage)))
        };
        let cases = KNOWN_ANSWERS.iter().filter(wanted).collect();
        if self.cheapest_first { cost::cheapest_first(cases) } else { cases }
    }
}

/// How far a check has come.
pub struct Progress<'a> {
    /// Cases that were run.
    pub done: usize,
    /// Cases there are.
    pub total: usize,
    /// The case that came to an end, if one did.
    pub ended: Option<&'a Outcome>,
    /// The case that begins, if one does: what was under way should the driver end the program.
    pub begins: Option<&'static KnownAnswer>,
}

/// Whether an open device computes right, as a program asks before it believes one: runs the known answers of what is
/// wanted, [`Wanted::of_plan`] a scene's plan or [`Wanted::of_tier`] all, one after the other until the device is lost.
/// `small` leaves out the sizes that take minutes where the driver runs on the processor. `progress` is called before
/// each case and behind the last.
///
/// It takes seconds and runs on this thread. A case that breaks off is caught by unwinding: a program that aborts on
/// panics ends there.
pub fn run(gpu: &Gpu, wanted: &Wanted, small: bool, progress: &mut dyn FnMut(Progress<'_>)) -> Report {
    Report::run(&Device::new(gpu.clone(), small), wanted, progress)
}

impl Report {
    /// As [`run`], on a device whose modules may have been replaced.
    pub fn run(device: &Device, wanted: &Wanted, progress: &mut dyn FnMut(Progress<'_>)) -> Self {
        Self::run_while(device, wanted, &mut |at| {
            progress(at);
            true
        })
    }

    /// As [`Report::run`], for as long as `goes_on` says so before a case.
    pub fn run_while(device: &Device, wanted: &Wanted, goes_on: &mut dyn FnMut(Progress<'_>) -> bool) -> Self {
        let cases = wanted.cases();
        let total = cases.len();
        let mut outcomes: Vec<Outcome> = Vec::new();
        for (done, &known) in cases.iter().enumerate() {
            if !goes_on(Progress { done, total, ended: outcomes.last(), begins: Some(known) }) {
                break;
            }
            outcomes.push(device.run(known));
            if device.gpu().is_lost().is_some() {
                break;
            }
        }
        goes_on(Progress { done: outcomes.len(), total, ended: outcomes.last(), begins: None });
        Self { modules: checked(wanted, &outcomes), not_reached: total - outcomes.len(), outcomes }
    }

    /// Whether nothing is wrong.
    pub fn is_right(&self) -> bool {
        !self.outcomes.iter().any(Outcome::is_wrong)
    }
}

fn checked(wanted: &Wanted, outcomes: &[Outcome]) -> Vec<CheckedModule> {
    let mut modules: BTreeMap<&'static str, CheckedModule> = BTreeMap::new();
    for (&module, stage) in &wanted.modules {
        let run = ModuleRun::none_yet(stage.unwrap_or(""), module);
        modules.insert(module, CheckedModule { run, right: 0, verdict: ModuleVerdict::NotChecked });
    }
    for outcome in outcomes {
        for run in &outcome.modules {
            let Some(module) = modules.get_mut(run.module) else { continue };
            module.run.add(run);
            match &outcome.verdict {
                Verdict::Wrong(wrong) if wrong.modules.contains(&run.module) => module.verdict = ModuleVerdict::Wrong,
                Verdict::Right if outcome.known.stages.contains(&run.stage) => module.right += 1,
                _ => {}
            }
        }
    }
    for module in modules.values_mut().filter(|module| module.right > 0 && module.verdict != ModuleVerdict::Wrong) {
        module.verdict = ModuleVerdict::Right;
    }
    modules.into_values().collect()
}
