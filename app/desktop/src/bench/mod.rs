//! `brooklet bench`: the time of every pass, of one scene or of one workload at rising sizes.

mod bodies;
#[cfg(feature = "window")]
mod ladder;
#[cfg(feature = "window")]
mod offscreen_window;
mod papers;
mod scaling;
mod single;
mod sorting;
mod submissions;
mod surfaces;
mod terminal;
#[cfg(feature = "window")]
mod window;

use std::path::Path;

use brooklet_bench as timed;
use brooklet_gpu::Gpu;
use serde::Serialize;

use crate::{
    bench_options::{
        BenchOptions, BenchStudy, BodiesOptions, PapersOptions, SortingOptions, SubmissionsOptions, SurfacesOptions,
    },
    commit::COMMIT,
    failure::Failure,
    job, out_dir,
    shared_options::DeviceOptions,
};
use terminal::watched;

/// Runs and prints the benchmark that is asked for.
pub fn bench(options: &BenchOptions) -> Result<(), Failure> {
    match (&options.study, &options.scene) {
        (Some(BenchStudy::Bodies(options)), _) => bench_bodies(options),
        (Some(BenchStudy::Papers(options)), _) => bench_papers(options),
        (Some(BenchStudy::Sorting(options)), _) => bench_sorting(options),
        (Some(BenchStudy::Submissions(options)), _) => bench_submissions(options),
        (Some(BenchStudy::Surfaces(options)), _) => bench_surfaces(options),
        #[cfg(feature = "window")]
        (Some(BenchStudy::Window(options)), _) => window::bench(options),
        #[cfg(feature = "window")]
        (Some(BenchStudy::Ladder(options)), _) => ladder::bench(options),
        (None, Some(scene)) => bench_scene(scene, options),
        (None, None) => bench_sizes(options),
    }
}

fn bench_scene(name: &str, options: &BenchOptions) -> Result<(), Failure> {
    let scene = job::load(name, &options.settings)?;
    let gpu = open(&options.device)?;
    let &BenchOptions { warm_up, steps, pictures, .. } = options;
    let cost = watched(|terminal| {
        timed::single::run(&gpu, &scene, timed::single::Options { warm_up, steps, pictures }, terminal)
    })?;
    show(options.json, &cost, single::print)
}

fn bench_sizes(options: &BenchOptions) -> Result<(), Failure> {
    let sizes = timed::scaling::Options {
        settings: options.settings.clone(),
        max_particles: options.max_particles,
        budget_s: options.budget,
    };
    // A setting that no scene takes is told before anything runs.
    sizes.check()?;
    if let Some(path) = &options.plot {
        check_folder("--plot", path)?;
    }
    let gpu = open(&options.device)?;
    let table = watched(|terminal| timed::scaling::run(&gpu, &sizes, terminal))?;
    if let Some(path) = &options.plot {
        out_dir::write_file(path, table.to_svg()?.as_bytes())?;
    }
    show(options.json, &table, scaling::print)
}

fn bench_bodies(options: &BodiesOptions) -> Result<(), Failure> {
    let gpu = open(&options.device)?;
    let wanted = timed::bodies::Options {
        settings: options.settings.clone(),
        particles: options.particles,
        rounds: options.rounds,
    };
    let cost = watched(|terminal| timed::bodies::run(&gpu, &wanted, terminal))?;
    show(options.json, &cost, bodies::print)
}

fn bench_papers(options: &PapersOptions) -> Result<(), Failure> {
    let gpu = open(&options.device)?;
    let wanted = timed::papers::Options {
        settings: options.settings.clone(),
        max_particles: options.max_particles,
        budget_s: options.budget,
    };
    let table = watched(|terminal| timed::papers::run(&gpu, &wanted, terminal))?;
    show(options.json, &table, papers::print)
}

fn bench_sorting(options: &SortingOptions) -> Result<(), Failure> {
    let gpu = open(&options.device)?;
    let (particles, pairs) = (options.particles, options.pairs as usize);
    let compared =
        watched(|terminal| timed::sorting::run(&gpu, timed::sorting::Options { particles, pairs }, terminal))?;
    show(options.json, &compared, sorting::print)
}

fn bench_submissions(options: &SubmissionsOptions) -> Result<(), Failure> {
    let scene = job::scene(&options.scene, None)?;
    let (gpu, untimed) = (open(&options.device)?, job::open(&options.device, false)?);
    let rounds = options.rounds;
    let found = watched(|terminal| {
        timed::submissions::run(&gpu, &untimed, &scene, timed::submissions::Options { rounds }, terminal)
    })?;
    show(options.json, &found, submissions::print)
}

fn bench_surfaces(options: &SurfacesOptions) -> Result<(), Failure> {
    for (option, file) in [("--plot", &options.plot), ("--csv", &options.csv), ("--picture", &options.picture)] {
        if let Some(file) = file {
            check_folder(option, file)?;
        }
    }
    let beside = options.beside.as_deref().map(timed::surfaces::OtherProgram::find).transpose()?;
    let gpu = open(&options.device)?;
    let all_if_none = |chosen: &Vec<_>, all: fn() -> Vec<_>| if chosen.is_empty() { all() } else { chosen.clone() };
    let wanted = timed::surfaces::Options {
        bodies: all_if_none(&options.bodies, timed::surfaces::bodies),
        ways: all_if_none(&options.ways, timed::surfaces::ways),
        size_px: [options.width, options.height],
        repeats: options.repeats as usize,
        beside,
    };
    let (held, sheet) = watched(|terminal| timed::surfaces::run(&gpu, &wanted, terminal))?;
    if let Some(file) = &options.csv {
        out_dir::write_file(file, held.to_csv()?.as_bytes())?;
        out_dir::write_file(&file.with_extension("meshes.csv"), held.meshes_to_csv()?.as_bytes())?;
    }
    if let Some(file) = &options.plot {
        out_dir::write_file(file, held.to_svg()?.as_bytes())?;
    }
    if let Some(file) = &options.picture {
        sheet.save(file)?;
    }
    show(options.json, &held, surfaces::print)
}

/// A result with the commit that it was measured with.
#[derive(Serialize)]
struct Stamped<'a, T> {
    #[serde(flatten)]
    result: &'a T,
    commit: &'static str,
}

/// Prints a result as JSON, or as people read it.
fn show<T: Serialize>(json: bool, result: &T, print: impl FnOnce(&T)) -> Result<(), Failure> {
    if json {
        let stamped = Stamped { result, commit: COMMIT };
        say!("{}", serde_json::to_string_pretty(&stamped).map_err(Failure::stopped)?);
    } else {
        print(result);
    }
    Ok(())
}

/// Minutes of measuring would be lost on a folder that cannot be written to.
fn check_folder(option: &str, file: &Path) -> Result<(), Failure> {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match tempfile::tempfile_in(folder) {
        Ok(_) => Ok(()),
        Err(error) => Err(Failure::Input(format!("{option} {}: cannot be written: {error}", file.display()))),
    }
}

/// Opens a device that gives GPU times.
fn open(options: &DeviceOptions) -> Result<Gpu, Failure> {
    let gpu = job::open(options, true)?;
    if gpu.timing().is_measured() {
        Ok(gpu)
    } else {
        Err(Failure::Input(format!("{} gives no GPU times, and a benchmark is made of them", gpu.info().name)))
    }
}
