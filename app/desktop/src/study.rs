//! `brooklet study`: error against run time, published cases, extreme cases; a report of them.

use std::{
    fs,
    path::{Path, PathBuf},
    time::Duration,
};

use brooklet_gpu::{Gpu, GpuOptions, Tier};
use brooklet_study::{
    Event, RESULTS, Runner, Session, State, Store, Study, StudyError, Task, backend::Cache, error::Choice, report,
    shard,
};
use indicatif::{ProgressBar, ProgressStyle};

use crate::{
    commit::{COMMIT, VERSION},
    failure::Failure,
    interrupt::Interrupt,
    job,
    out_dir::OutDir,
    shared_options::DeviceOptions,
    study_options::{CurveOptions, MergeOptions, StudyMerge, StudyOptions, StudyPart},
};

/// Runs what is asked for and has no outcome yet, and writes the report.
pub fn study(options: &StudyOptions) -> Result<(), Failure> {
    if let Some(StudyMerge::Merge(options)) = &options.merge {
        return merge(options);
    }
    let study = chosen(options.part, &options.curves)?;
    let all = study.tasks().map_err(Failure::input)?;
    let tasks = match options.shard {
        Some((index, of)) => shard(all.clone(), index, of),
        None => all.clone(),
    };
    let default_out = default_out(options.shard);
    let folder = folder(options.out.as_deref().unwrap_or(&default_out))?;
    let mut store = Store::open(&folder, &program()).map_err(Failure::input)?;
    let known = tasks.iter().filter(|task| store.get(task).is_some()).count();
    if known > 0 {
        say!("going on in {}: {known} of {} runs are done", folder.display(), tasks.len());
    }
    let mut notes = other_versions(&store);
    let whole = run(&options.device, &tasks, &mut store, &mut notes).inspect_err(|_| remove_if_empty(&folder))?;
    if !whole {
        let done = tasks.iter().filter(|task| store.get(task).is_some()).count();
        let kept = format!("{done} of {} runs are in {}; the same command goes on", tasks.len(), folder.display());
        return Err(Failure::Interrupted(kept));
    }
    if let Some((index, of)) = options.shard {
        say!("part {index} of {of}: {} runs are in {}", tasks.len(), folder.join(RESULTS).display());
        return Ok(());
    }
    finish(&folder, &study, &all, &store, notes)
}

fn merge(options: &MergeOptions) -> Result<(), Failure> {
    let study = chosen(options.part, &options.curves)?;
    let tasks = study.tasks().map_err(Failure::input)?;
    for part in &options.parts {
        if !part.join(RESULTS).is_file() {
            return Err(Failure::Input(format!("{}: is no folder of a study: it has no {RESULTS}", part.display())));
        }
    }
    let folder = folder(options.out.as_deref().unwrap_or(&default_out(None)))?;
    let mut store = Store::open(&folder, &program()).map_err(Failure::input)?;
    for part in &options.parts {
        let taken = store.merge(part).map_err(Failure::input).inspect_err(|_| remove_if_empty(&folder))?;
        say!("{}: {taken} runs", part.display());
    }
    let mut notes = other_versions(&store);
    let missing = tasks.iter().filter(|task| store.get(task).is_none()).count();
    if missing > 0 {
        notes.push(format!("{missing} of {} runs are in none of the parts", tasks.len()));
    }
    finish(&folder, &study, &tasks, &store, notes)
}

fn chosen(part: StudyPart, curves: &CurveOptions) -> Result<Study, Failure> {
    let choice = Choice {
        cases: curves.scenes.clone(),
        methods: curves.methods.clone(),
        knobs: curves.knobs.clone(),
        quick: curves.quick,
    };
    if !choice.is_whole() && matches!(part, StudyPart::Validation | StudyPart::Precision | StudyPart::Stability) {
        let text = "--scenes, --methods and --knobs choose curves of error against time: study error";
        return Err(Failure::Input(text.into()));
    }
    // Curves that are asked for by name are all that is wanted.
    let others = choice.is_whole();
    Ok(Study {
        validation: others && matches!(part, StudyPart::All | StudyPart::Validation),
        precision: others && matches!(part, StudyPart::All | StudyPart::Precision),
        stability: others && matches!(part, StudyPart::All | StudyPart::Stability),
        error: matches!(part, StudyPart::All | StudyPart::Error).then_some(choice),
        quick: curves.quick,
    })
}

fn default_out(shard: Option<(usize, usize)>) -> PathBuf {
    match shard {
        Some((index, of)) => Path::new("out").join(format!("study-{index}-of-{of}")),
        None => Path::new("out").join("study"),
    }
}

/// The folder of a study that goes on, or a new one: a finished report is never touched.
fn folder(wanted: &Path) -> Result<PathBuf, Failure> {
    let unfinished = wanted.join(RESULTS).is_file() && !wanted.join(report::PAGE).exists();
    let empty = fs::read_dir(wanted).is_ok_and(|mut found| found.next().is_none());
    if unfinished || empty { Ok(wanted.to_path_buf()) } else { Ok(OutDir::create(wanted)?.path) }
}

/// What did not begin leaves nothing behind; a folder with something in it stays.
fn remove_if_empty(folder: &Path) {
    let _ = fs::remove_dir(folder);
}

fn other_versions(store: &Store) -> Vec<String> {
    let others = store.of_other_versions();
    let text = format!("{others} runs of another version of the program were there; they were run again");
    (others > 0).then_some(text).into_iter().collect()
}

fn program() -> String {
    format!("{VERSION} ({COMMIT})")
}

/// Runs the tasks that are open; false if Ctrl-C ended it.
fn run(device: &DeviceOptions, tasks: &[Task], store: &mut Store, notes: &mut Vec<String>) -> Result<bool, Failure> {
    // What runs on any tier runs on the best one that the device has.
    let best = job::open(device, true)?.tier();
    let interrupt = Interrupt::listen()?;
    let bar = ProgressBar::new(1);
    let template = "{bar:32} {percent:>3} %, {eta} left  {wide_msg}";
    bar.set_style(ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(Duration::from_millis(500));
    let heard = std::cell::RefCell::new(Vec::new());
    let notify = |event: Event<'_>| match event {
        Event::Begin { total, done } => {
            bar.set_length(total as u64);
            bar.set_position(done as u64);
            // What an earlier run did says nothing of this one's pace.
            bar.reset_eta();
        }
        Event::Task(task) => bar.set_message(task.describe()),
        Event::Done(done) => bar.set_position(done as u64),
        Event::Note(text) => heard.borrow_mut().push(text),
    };
    let open = |tier: Tier, timing: bool| open(device, tier.min(best), timing);
    let stop = || interrupt.is_pressed();
    let cache = Cache { folder: dirs::cache_dir().map(|folder| folder.join("brooklet").join("reference")) };
    let outcome = Runner::new(Session::new(&open, cache, &stop, &notify)).run(tasks, store);
    bar.finish_and_clear();
    notes.extend(heard.borrow_mut().drain(..));
    outcome.map_err(|error| match error {
        StudyError::Device(_) => Failure::input(error),
        error => Failure::stopped(error),
    })
}

fn open(device: &DeviceOptions, tier: Tier, timing: bool) -> Result<Gpu, String> {
    Gpu::open(&GpuOptions {
        device_name: device.device.clone(),
        tier: Some(tier),
        pipeline_cache: dirs::cache_dir().map(|folder| folder.join("brooklet")),
        timing,
        watch_builds: device.careful,
        ..GpuOptions::default()
    })
    .map_err(|error| error.to_string())
}

fn finish(folder: &Path, study: &Study, tasks: &[Task], store: &Store, notes: Vec<String>) -> Result<(), Failure> {
    let outcomes = || tasks.iter().filter_map(|task| store.get(task));
    let mut devices: Vec<String> =
        outcomes().map(|outcome| outcome.device.clone()).filter(|device| !device.is_empty()).collect();
    devices.sort();
    devices.dedup();
    let facts = report::Facts { devices, program: program(), notes };
    let written = report::write(folder, study, store, &facts).map_err(Failure::stopped)?;
    for note in &facts.notes {
        say!("{note}");
    }
    let count = |state: State| outcomes().filter(|outcome| outcome.state == state).count();
    let silent = count(State::Silent);
    say!(
        "{} runs: {} stable, {} clamped and said, {} refused and said, {} unstable and said, {silent} SILENT",
        outcomes().count(),
        count(State::Stable),
        count(State::Clamped),
        count(State::Refused),
        count(State::Unstable)
    );
    say!("report    {}", written.page.display());
    say!("table     {}", written.csv.display());
    say!("data      {}", written.json.display());
    say!("runs      {}", written.mcap.display());
    if silent > 0 {
        return Err(Failure::Stopped(format!("{silent} runs went wrong without a word; the report marks them")));
    }
    Ok(())
}
