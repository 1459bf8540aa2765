//! `brooklet doctor --check`: whether a device computes what it should.

use std::collections::BTreeSet;
use std::time::Instant;

use brooklet_check::{CheckedModule, Device, KNOWN_ANSWERS, ModuleVerdict, Outcome, Report, Verdict, Wanted, Wrong};
use brooklet_gpu::{Gpu, tier_name};
use brooklet_kernels::Module;
use serde_json::{Value, json};

use crate::check_capture::Verdicts;
use crate::check_words::{title, verdict_name};
use crate::{cli::DoctorOptions, failure::Failure, job, progress, table::table};

/// Runs the known answers of a scene's plan, or all, and prints a verdict a module.
pub fn check(options: &DoctorOptions, scene: &str) -> Result<(), Failure> {
    let scene = job::load(scene, &options.settings)?;
    let replacements = options.replace.iter().map(|text| replacement(text)).collect::<Result<Vec<_>, _>>()?;
    let gpu = job::open(&options.device, true)?;
    let rooms: BTreeSet<&str> = KNOWN_ANSWERS.iter().map(|known| known.room).collect();
    if let Some(room) = options.room.iter().find(|room| !rooms.contains(room.as_str())) {
        let rooms: Vec<&str> = rooms.into_iter().collect();
        return Err(Failure::Input(format!("--room {room}: there is none; allowed: {}", rooms.join(", "))));
    }
    let wanted = if options.all {
        Wanted::of_tier(&gpu)
    } else {
        let particles = u32::try_from(scene.particle_count()).map_err(Failure::input)?;
        Wanted::of_plan(job::plan_for(&scene, particles, gpu.tier())?.plan())
    }
    .in_rooms(&options.room);
    // A driver that runs on the processor takes minutes for millions of particles.
    let small = gpu.info().device_type == "cpu" && !options.all;
    let started = Instant::now();
    let mut capture = options.capture.as_deref().map(|path| Verdicts::create(path, &gpu)).transpose()?;
    let bar = progress::bar(wanted.cases().len() as u64, "cases");
    let device = Device::new(gpu.clone(), small).with_modules(replacements);
    let report = Report::run(&device, &wanted, &mut |progress| {
        bar.set_position(progress.done as u64);
        if let (Some(capture), Some(outcome)) = (&mut capture, progress.ended) {
            capture.case(outcome);
        }
        if let Some(known) = progress.begins {
            bar.set_message(title(known));
        }
    });
    bar.finish_and_clear();
    let captured = capture.map_or(Ok(()), |capture| capture.finish(&report));
    let what = if options.all { format!("tier {}", tier_name(gpu.tier())) } else { scene.name.clone() };
    let wall_s = started.elapsed().as_secs_f64();
    if options.json {
        let all = as_json(&report, &gpu, &what, small, wall_s);
        say!("{}", serde_json::to_string_pretty(&all).map_err(Failure::stopped)?);
    } else {
        print(&report, &gpu, &what, small, wall_s);
    }
    captured?;
    if report.is_right() {
        return Ok(());
    }
    let (wrong, all) = (report.outcomes.iter().filter(|outcome| outcome.is_wrong()).count(), report.outcomes.len());
    Err(Failure::Stopped(format!("{} computes wrong: {wrong} of {all} cases", gpu.info().name)))
}

/// A variant with the SPIR-V of a file.
fn replacement(text: &str) -> Result<&'static Module, Failure> {
    let refused = |reason: String| Failure::Input(format!("--replace {text}: {reason}"));
    let (name, file) = text.split_once('=').ok_or_else(|| refused("VARIANT=FILE is wanted".into()))?;
    let module = brooklet_kernels::modules().find(|module| module.name == name);
    let module = module.ok_or_else(|| refused(format!("there is no variant '{name}' (see `brooklet plan`)")))?;
    let spirv = std::fs::read(file).map_err(|error| refused(format!("{file}: {error}")))?;
    if !spirv.starts_with(&module.spirv.bytes()[..4]) || !spirv.len().is_multiple_of(4) {
        return Err(refused(format!("{file} holds no SPIR-V")));
    }
    Ok(module.with_spirv(&spirv, module.shared_bytes, module.tier))
}

fn print(report: &Report, gpu: &Gpu, what: &str, small: bool, wall_s: f64) {
    say!(
        "{} ({} {}), tier {}: {what}\n",
        gpu.info().name,
        gpu.info().driver,
        gpu.info().driver_info,
        tier_name(gpu.tier())
    );
    let mut list = table(&["kernel and variant", "cases", "compared", "worst", "tolerance", "verdict"], &[1, 2, 3, 4]);
    for module in &report.modules {
        let [worst, tolerance] = match module.run.worst {
            Some(pair) => pair.map(|number| format!("{number:.1e}")),
            None if module.run.exact > 0 => ["exact".into(), String::new()],
            None => [String::new(), String::new()],
        };
        let compared = match module.run.compared + module.run.exact {
            0 => String::new(),
            compared => compared.to_string(),
        };
        let cells = [module.run.module.into(), module.right.to_string(), compared, worst, tolerance];
        list.add_row(cells.into_iter().chain([verdict_name(module.verdict).to_owned()]));
    }
    say!("{}\n", list.trim_fmt());
    for outcome in &report.outcomes {
        let case = title(outcome.known);
        match &outcome.verdict {
            Verdict::Wrong(wrong) => say!("WRONG    {case}\n         {wrong}"),
            Verdict::Skipped(reason) => say!("skipped  {case}: {reason}"),
            Verdict::Right if outcome.known.stages.is_empty() => say!("right    {case}"),
            Verdict::Right => {}
        }
        // What the device itself is like, which no kernel's row tells.
        if DEVICE_ROOMS.contains(&outcome.known.room) {
            outcome.notes.iter().for_each(|note| say!("         {note}"));
        }
    }
    let unchecked = of_verdict(report, ModuleVerdict::NotChecked);
    if unchecked > 0 {
        say!(
            "\n{unchecked} of {} kernels and variants are not checked: their cases were left out, skipped or broken off",
            report.modules.len()
        );
    }
    let right = of_verdict(report, ModuleVerdict::Right);
    let sizes =
        if small { ", on small inputs (the driver runs on the processor; --all takes large ones too)" } else { "" };
    say!("{right} of {} are right; {} cases in {wall_s:.1} s{sizes}", report.modules.len(), report.outcomes.len());
}

fn of_verdict(report: &Report, verdict: ModuleVerdict) -> usize {
    report.modules.iter().filter(|module| module.verdict == verdict).count()
}

/// Rooms of cases that say something of the device and not of one kernel.
const DEVICE_ROOMS: [&str; 2] = ["hardware", "runs"];

fn as_json(report: &Report, gpu: &Gpu, what: &str, small: bool, wall_s: f64) -> Value {
    json!({
        "device": gpu.info().name,
        "driver": gpu.info().driver,
        "driver_info": gpu.info().driver_info,
        "tier": tier_name(gpu.tier()),
        "checked": what,
        "small_inputs": small,
        "right": report.is_right(),
        "wall_s": wall_s,
        "modules": report.modules.iter().map(module_json).collect::<Vec<_>>(),
        "cases": report.outcomes.iter().map(case_json).collect::<Vec<_>>(),
    })
}

fn module_json(module: &CheckedModule) -> Value {
    json!({
        "module": module.run.module,
        "verdict": verdict_name(module.verdict).to_lowercase(),
        "cases": module.right,
        "compared": module.run.compared,
        "compared_exactly": module.run.exact,
        "worst": module.run.worst.map(|[difference, _]| difference),
        "tolerance": module.run.worst.map(|[_, tolerance]| tolerance),
    })
}

fn case_json(outcome: &Outcome) -> Value {
    let (verdict, skipped, wrong) = match &outcome.verdict {
        Verdict::Right => ("right", None, None),
        Verdict::Skipped(reason) => ("skipped", Some(reason), None),
        Verdict::Wrong(wrong) => ("wrong", None, Some(wrong_json(wrong))),
    };
    json!({
        "room": outcome.known.room,
        "case": outcome.known.name,
        "stages": outcome.known.stages,
        "verdict": verdict,
        "because": skipped,
        "wrong": wrong,
        "wall_s": outcome.wall_s,
        "notes": outcome.notes,
    })
}

fn wrong_json(wrong: &Wrong) -> Value {
    json!({
        "of": wrong.of,
        "modules": wrong.modules,
        "element": wrong.element,
        "got": wrong.got,
        "expected": wrong.expected,
        "difference": wrong.difference.map(|[difference, _]| difference),
        "tolerance": wrong.difference.map(|[_, tolerance]| tolerance),
        "beyond": wrong.beyond.map(|[beyond, _]| beyond),
        "of_values": wrong.beyond.map(|[_, all]| all),
        "note": wrong.note,
    })
}
