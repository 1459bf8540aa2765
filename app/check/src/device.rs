//! The device that cases run on, and what is kept of a case that runs: which modules ran, and how far off they were.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use std::sync::Once;
use std::time::Instant;

use brooklet_gpu::{Command, Engine, Gpu, Plan};
use brooklet_kernels::Module;

use crate::wrong::{IN_CASE, OrRaise as _, Skipped, Wrong};

/// A case: small known inputs, what the device makes of them, and what it should.
#[derive(Clone, Copy, Debug)]
pub struct KnownAnswer {
    /// The file it stands in.
    pub room: &'static str,
    /// What it says, in words joined by underscores.
    pub name: &'static str,
    /// The stages whose known answer it is; others it runs on the way. None: it holds for the device.
    pub stages: &'static [&'static str],
    pub(crate) run: fn(&Device),
}

/// The modules of a command, each with its stage.
pub(crate) fn modules_of(command: &Command) -> Vec<(&'static str, &'static Module)> {
    match command {
        Command::Dispatch(dispatch) => vec![(dispatch.stage, dispatch.module)],
        Command::Draw(draw) => {
            [Some(draw.vertex), draw.fragment].into_iter().flatten().map(|m| (draw.stage, m)).collect()
        }
        _ => Vec::new(),
    }
}

/// An open device on which cases run, one after the other.
pub struct Device {
    gpu: Gpu,
    small: bool,
    replacements: Vec<&'static Module>,
    pub(crate) record: Rc<Record>,
}

/// What one module did in a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModuleRun {
    /// Its stage.
    pub stage: &'static str,
    /// The kernel and variant.
    pub module: &'static str,
    /// Plans that ran it.
    pub runs: usize,
    /// Numbers that were compared within a tolerance.
    pub compared: usize,
    /// The largest difference and its tolerance, both relative to a scale of the case's.
    pub worst: Option<[f64; 2]>,
    /// Values that were compared exactly and said so.
    pub exact: usize,
}

impl ModuleRun {
    /// Of a module that did nothing so far.
    pub(crate) fn none_yet(stage: &'static str, module: &'static str) -> Self {
        Self { stage, module, runs: 0, compared: 0, worst: None, exact: 0 }
    }

    /// Adds what it did in another case.
    pub(crate) fn add(&mut self, other: &ModuleRun) {
        self.stage = other.stage;
        self.runs += other.runs;
        self.exact += other.exact;
        if let Some(worst) = other.worst {
            self.compare(other.compared, worst);
        }
    }

    fn compare(&mut self, count: usize, worst: [f64; 2]) {
        let share = |[difference, tolerance]: [f64; 2]| difference / tolerance;
        self.compared += count;
        self.worst = Some(self.worst.filter(|before| share(*before) >= share(worst)).unwrap_or(worst));
    }
}

/// How a case ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// All is as it should be.
    Right,
    /// Something is not.
    Wrong(Wrong),
    /// It cannot run here: why.
    Skipped(String),
}

/// A case that was run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The case.
    pub known: &'static KnownAnswer,
    /// How long it took, twin included.
    pub wall_s: f64,
    /// Every module that it ran, by name.
    pub modules: Vec<ModuleRun>,
    /// How it ended.
    pub verdict: Verdict,
    /// Lines for who reads a test's output.
    pub notes: Vec<String>,
}

impl Outcome {
    /// Whether something is not as it should be.
    pub fn is_wrong(&self) -> bool {
        matches!(self.verdict, Verdict::Wrong(_))
    }
}

/// What is kept while a case runs.
#[derive(Default)]
pub(crate) struct Record {
    /// Counts the plans that were run.
    pub plan: Cell<u64>,
    modules: RefCell<BTreeMap<&'static str, ModuleRun>>,
    /// Of the last plan: stage and module.
    last: RefCell<Vec<(&'static str, &'static str)>>,
    /// What comparators found that were left before they told.
    pub untold: RefCell<Vec<Wrong>>,
    notes: RefCell<Vec<String>>,
    /// The stage whose numbers were compared last, of the last plan.
    subject: Cell<&'static str>,
}

impl Record {
    fn begin(&self) {
        self.modules.take();
        self.last.take();
        self.untold.take();
        self.notes.take();
    }

    fn ran(&self, plan: &Plan) {
        self.plan.set(self.plan.get() + 1);
        self.subject.set("");
        let commands = plan.recordings().flat_map(|recording| plan.commands(recording));
        let mut last: Vec<_> = commands.flat_map(modules_of).map(|(stage, module)| (stage, module.name)).collect();
        last.sort_unstable();
        last.dedup();
        let mut modules = self.modules.borrow_mut();
        for &(stage, module) in &last {
            modules.entry(module).or_insert(ModuleRun::none_yet(stage, module)).runs += 1;
        }
        self.last.replace(last);
    }

    /// Of the last plan's modules those of the stage that `of` begins with, or of all that begin with it; all where there
    /// is none.
    pub fn modules_of(&self, of: &str) -> Vec<&'static str> {
        self.last_or_all(|stage| of.starts_with(stage) || (!of.is_empty() && stage.starts_with(of)))
    }

    /// Of the last plan's modules those of some stages; all where there is none.
    fn modules_of_stages(&self, stages: &[&str]) -> Vec<&'static str> {
        self.last_or_all(|stage| stages.contains(&stage))
    }

    fn last_or_all(&self, belongs: impl Fn(&str) -> bool) -> Vec<&'static str> {
        let last = self.last.borrow();
        let of_stages: Vec<_> = last.iter().filter(|(stage, _)| belongs(stage)).map(|(_, name)| *name).collect();
        if of_stages.is_empty() { last.iter().map(|(_, name)| *name).collect() } else { of_stages }
    }

    /// Numbers of these modules were compared.
    pub fn compared(&self, names: &[&'static str], count: usize, worst: [f64; 2]) {
        for run in self.modules.borrow_mut().values_mut().filter(|run| names.contains(&run.module)) {
            run.compare(count, worst);
        }
    }

    /// Values of a stage were compared exactly, in all of the case.
    pub fn exact(&self, of: &str, count: usize) {
        let of_last = self.modules_of(of);
        let mut modules = self.modules.borrow_mut();
        let has_stage = modules.values().any(|run| of.starts_with(run.stage));
        let counts =
            |run: &ModuleRun| if has_stage { of.starts_with(run.stage) } else { of_last.contains(&run.module) };
        modules.values_mut().filter(|run| counts(run)).for_each(|run| run.exact += count);
    }
}

impl Device {
    /// Runs cases on an open device. `small` leaves out the sizes that take minutes on a driver that interprets its
    /// shaders.
    pub fn new(gpu: Gpu, small: bool) -> Self {
        Self { gpu, small, replacements: Vec::new(), record: Rc::default() }
    }

    /// The same with other modules in place of those of the same names: faults that are put in on purpose.
    pub fn with_modules(self, replacements: Vec<&'static Module>) -> Self {
        Self { replacements, ..self }
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Whether sizes are kept small.
    pub fn small(&self) -> bool {
        self.small
    }

    /// How far the device may move a triangle's corners, in pixels, and with them all that they show: Vulkan lets it round
    /// them to 2^-bits of a pixel, and each device says to how many bits it does.
    pub(crate) fn snap_px(&self) -> f64 {
        0.5f64.powi(self.gpu.driver_facts().subpixel_bits as i32)
    }

    /// A plan's engine; what it runs is kept.
    pub(crate) fn engine(&self, plan: Plan) -> Engine {
        Engine::new(&self.gpu, self.plan(plan)).or_raise()
    }

    /// A plan that is about to run.
    pub(crate) fn plan(&self, plan: Plan) -> Plan {
        let other = |module: &'static Module| self.replacements.iter().find(|new| new.name == module.name).copied();
        let plan = plan.with_modules(other).or_raise();
        self.record.ran(&plan);
        plan
    }

    /// Keeps a line for who reads a test's output.
    pub(crate) fn note(&self, line: String) {
        if !IN_CASE.get() {
            println!("{line}");
        }
        self.record.notes.borrow_mut().push(line);
    }

    /// Numbers that the last plan's modules of a stage made were compared: how far off they are at most, and may be.
    /// What is said to be wrong next is of them.
    pub(crate) fn compared(&self, of: &'static str, count: usize, worst: [f64; 2]) {
        self.record.subject.set(of);
        self.record.compared(&self.record.modules_of(of), count, worst);
    }

    /// Runs a case, whatever becomes of it.
    pub fn run(&self, known: &'static KnownAnswer) -> Outcome {
        self.record.begin();
        let started = Instant::now();
        let ended = silently(|| (known.run)(self));
        let mut verdict = match ended {
            Ok(()) => Verdict::Right,
            Err(Ended::Wrong(wrong)) => Verdict::Wrong(wrong),
            Err(Ended::Skipped(reason)) => Verdict::Skipped(reason),
        };
        // A number that is wrong says more than what it led to.
        if let Some(wrong) = self.record.untold.take().into_iter().next() {
            verdict = Verdict::Wrong(wrong);
        }
        if let Some(reason) = self.gpu.is_lost() {
            verdict = Verdict::Wrong(Wrong::new(format!("the device was lost: {reason}")));
        }
        if let Verdict::Wrong(wrong) = &mut verdict
            && wrong.modules.is_empty()
        {
            if wrong.of.is_empty() {
                wrong.of = self.record.subject.get().to_owned();
            }
            wrong.modules = match wrong.of.as_str() {
                "" => self.record.modules_of_stages(known.stages),
                of => self.record.modules_of(of),
            };
        }
        Outcome {
            known,
            wall_s: started.elapsed().as_secs_f64(),
            modules: self.record.modules.take().into_values().collect(),
            verdict,
            notes: self.record.notes.take(),
        }
    }
}

enum Ended {
    Wrong(Wrong),
    Skipped(String),
}

thread_local! {
    /// What the case's last panic said, and where.
    static SAID: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Runs a case; one that a device's nonsense made panic ends as one that is wrong, and prints nothing.
fn silently(case: impl FnOnce()) -> Result<(), Ended> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| match IN_CASE.get() {
            true => SAID.set(panic.to_string()),
            false => before(panic),
        }));
    });
    IN_CASE.set(true);
    let ended = catch_unwind(AssertUnwindSafe(case));
    IN_CASE.set(false);
    let said = SAID.take();
    ended.map_err(|payload: Box<dyn Any + Send>| match payload.downcast::<Wrong>() {
        Ok(wrong) => Ended::Wrong(*wrong),
        Err(payload) => match payload.downcast::<Skipped>() {
            Ok(skipped) => Ended::Skipped(skipped.0),
            Err(_) => Ended::Wrong(Wrong::new(format!("the comparison broke off: {said}"))),
        },
    })
}
