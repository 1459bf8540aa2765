//! What tasks run with: devices, the cache of f64 runs, and whoever listens.

use std::cell::RefCell;
use std::collections::HashMap;

use brooklet_gpu::{Gpu, Plan, TIERS, Tier, tier_name};
use thiserror::Error;

use crate::backend::{Cache, Counted, GpuRun, Options, Origin, converged};
use crate::store::StoreError;
use crate::{Sample, Setup, State, Task};

/// Why a study ends early.
#[derive(Debug, Error)]
pub enum StudyError {
    /// Outcomes cannot be kept.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A device of a tier that tasks want is not there.
    #[error("{0}")]
    Device(String),
    /// A task names something that there is not.
    #[error("{0}")]
    Unknown(String),
}

/// What a runner tells while it works.
#[derive(Clone, Debug, PartialEq)]
pub enum Event<'a> {
    /// So much lies ahead, in particle iterations; of it, so much is done already.
    Begin {
        /// All of it.
        total: f64,
        /// What outcomes of an earlier run cover.
        done: f64,
    },
    /// A task begins.
    Task(&'a Task),
    /// So much of all is done.
    Done(f64),
    /// Something worth a line.
    Note(String),
}

/// Opens the device as one of a tier, with GPU times or without.
pub type Open<'a> = &'a dyn Fn(Tier, bool) -> Result<Gpu, String>;

/// What a test changes of every run, to see that it is found.
#[derive(Clone, Copy)]
pub struct Fault<'a> {
    /// Of its settings, behind every check.
    pub setup: &'a dyn Fn(&mut Setup),
    /// Of its plan.
    pub plan: &'a dyn Fn(Plan) -> Plan,
}

/// What tasks run with.
pub struct Session<'a> {
    open: Open<'a>,
    gpus: RefCell<HashMap<&'static str, Gpu>>,
    /// Where f64 runs are kept.
    pub cache: Cache,
    stop: &'a dyn Fn() -> bool,
    notify: &'a dyn Fn(Event<'_>),
    fault: Option<Fault<'a>>,
    /// Particle iterations done before the present task, and of it.
    done: RefCell<(f64, f64)>,
}

impl<'a> Session<'a> {
    /// `open` gives devices, `stop` says when to end, `notify` hears what happens.
    pub fn new(open: Open<'a>, cache: Cache, stop: &'a dyn Fn() -> bool, notify: &'a dyn Fn(Event<'_>)) -> Self {
        let done = RefCell::new((0.0, 0.0));
        Self { open, gpus: RefCell::new(HashMap::new()), cache, stop, notify, fault: None, done }
    }

    /// Has every run changed: how tests put faults in.
    pub fn with_fault(mut self, fault: Fault<'a>) -> Self {
        self.fault = Some(fault);
        self
    }

    /// The device as one of a tier, opened once.
    ///
    /// # Errors
    /// If it is not there.
    pub fn gpu(&self, name: &str) -> Result<Gpu, StudyError> {
        let tier = TIERS
            .into_iter()
            .find(|tier| tier_name(*tier) == name)
            .ok_or_else(|| StudyError::Unknown(format!("there is no tier '{name}'")))?;
        if let Some(gpu) = self.gpus.borrow().get(tier_name(tier)) {
            return Ok(gpu.clone());
        }
        let gpu = (self.open)(tier, true).map_err(StudyError::Device)?;
        self.gpus.borrow_mut().insert(tier_name(tier), gpu.clone());
        Ok(gpu)
    }

    /// The device as one of a tier, making no timestamp query.
    ///
    /// # Errors
    /// If it is not there.
    pub fn gpu_without_times(&self, name: &str) -> Result<Gpu, StudyError> {
        let tier = self.gpu(name)?.tier();
        (self.open)(tier, false).map_err(StudyError::Device)
    }

    /// Runs a setup on the GPU; what it says where it cannot.
    pub fn run_setup(&self, gpu: &Gpu, setup: &Setup) -> Result<GpuRun, String> {
        let steps = setup.steps().max(1) as f64;
        let progress = |step: u64| self.progress(step as f64 / steps);
        let options = Options { stop: self.stop, edit: self.fault.map(|fault| fault.plan), progress: &progress };
        let mut setup = setup.clone();
        if let Some(fault) = self.fault {
            (fault.setup)(&mut setup);
        }
        crate::backend::run(gpu, &setup, &options).map_err(|error| error.to_string())
    }

    /// A run of f64, kept from an earlier time or computed; none if it was stopped.
    pub fn converge(&self, setup: &Setup) -> Option<Vec<Sample>> {
        let (samples, origin) = converged(setup, &self.cache, self.stop)?;
        if let Origin::Replaced(what) = origin {
            (self.notify)(Event::Note(format!("reference computed anew: {what}")));
        }
        Some(samples)
    }

    /// Tells whoever listens.
    pub(crate) fn tell(&self, event: Event<'_>) {
        (self.notify)(event);
    }

    /// A task begins, so many particle iterations being done before it, and so many in it.
    pub(crate) fn begin(&self, task: &Task, done: f64, weight: f64) {
        self.tell(Event::Task(task));
        *self.done.borrow_mut() = (done, weight);
    }

    /// So much of the present task is done.
    pub(crate) fn progress(&self, share: f64) {
        let (done, weight) = *self.done.borrow();
        self.tell(Event::Done(done + weight * share));
    }

    /// Whether it is to end.
    pub fn stops(&self) -> bool {
        (self.stop)()
    }
}

/// How a run ended, by its particles and by what the program told.
pub fn state_of(run: &GpuRun) -> (State, String) {
    let sound = run.samples.iter().all(Sample::is_sound);
    let said = run.measured.iter().any(|measured| {
        let stats = measured.stats;
        stats.quarantined > 0 || !stats.density_error.mean.is_finite()
    });
    let counted = run.counted();
    let counts = counted.to_string();
    match (sound, said) {
        (false, true) => (State::Unstable, "particles that are not finite, and quarantined".into()),
        (false, false) => (State::Silent, "particles are lost or not finite, and nothing says so".into()),
        (true, _) if counted != Counted::default() => (State::Clamped, counts),
        (true, _) => (State::Stable, String::new()),
    }
}
