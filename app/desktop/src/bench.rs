//! `brooklet bench`: the time of every pass, without pictures and measurements in between.

use brooklet_fluid::{INIT, STEP};
use brooklet_gpu::{Engine, TimingStatus, tier_name};
use serde_json::{Map, Value, json};

use crate::{
    cli::BenchOptions,
    commit::COMMIT,
    failure::Failure,
    interrupt::Interrupt,
    job, plan, progress,
    summary::{stages, timing_name},
    table::{bytes, ms, table},
    timings::Timings,
};

/// Runs and prints the benchmark.
pub fn bench(options: &BenchOptions) -> Result<(), Failure> {
    let mut scene = job::scene(&options.scene, None)?;
    scene.outputs.images = 0;
    scene.outputs.measure_every_steps = 0;
    let gpu = job::open(&options.device, true)?;
    let planned = job::plan(&scene, gpu.tier())?;
    if !gpu.timing().is_measured() {
        return Err(Failure::Input(format!("{} gives no GPU times, and a benchmark is made of them", gpu.info().name)));
    }
    let per_particle = plan::simulation_bytes_per_particle(&planned.plan, planned.particles);
    let (total_bytes, stages) = (planned.plan.bytes(), stages(&planned.plan));
    let particles = planned.particles;
    let mut engine = Engine::new(&gpu, planned.plan).map_err(Failure::input)?;
    let interrupt = Interrupt::listen()?;
    let mut timings = Timings::new(options.warm_up);
    engine.run(&[INIT], &[]).map_err(Failure::stopped)?;
    engine.finish().map_err(Failure::stopped)?;

    let steps = options.warm_up + options.steps;
    let bar = progress::bar(steps);
    for _ in 0..steps {
        if interrupt.is_pressed() {
            bar.finish_and_clear();
            return Err(Failure::Interrupted("nothing was written".into()));
        }
        engine.run(&[STEP], &[]).map_err(Failure::stopped)?;
        for report in engine.reports() {
            timings.add(&report, STEP);
        }
        bar.inc(1);
    }
    for report in engine.finish().map_err(Failure::stopped)? {
        timings.add(&report, STEP);
    }
    bar.finish_and_clear();

    let iterations = scene.solver.iterations * scene.solver.substeps;
    let work = f64::from(particles) * f64::from(iterations);
    let rate = timings.step_ms().map(|step| work / (step.median * 1e-3));
    let info = gpu.info();
    if options.json {
        let passes: Map<String, Value> = stages
            .iter()
            .map(|(stage, dispatches)| {
                let times = timings.stage_ms(stage);
                let pass = json!({
                    "median_ms": times.map(|t| t.median),
                    "p95_ms": times.map(|t| t.p95),
                    "dispatches": dispatches,
                });
                (stage.to_string(), pass)
            })
            .collect();
        let all = json!({
            "scene": scene.name,
            "particles": particles,
            "steps": options.steps,
            "warm_up_steps": options.warm_up,
            "gpu_ms_per_step": timings.step_ms(),
            "particle_iterations_per_s": rate,
            "passes": passes,
            "bytes": total_bytes,
            "bytes_per_particle": per_particle,
            "timing": timing_name(timings.status()),
            "flagged_spans": timings.flagged_spans(),
            "device": { "name": info.name, "device_type": info.device_type, "tier": tier_name(gpu.tier()) },
            "commit": COMMIT,
        });
        println!("{}", serde_json::to_string_pretty(&all).map_err(Failure::stopped)?);
        return Ok(());
    }

    println!(
        "{}: {particles} particles, {iterations} iterations a step, {} steps after {} of warm-up, on {} as {}",
        scene.name,
        options.steps,
        options.warm_up,
        info.name,
        tier_name(gpu.tier()),
    );
    if info.device_type == "cpu" {
        println!("(this driver runs on the processor: its times are the processor's)");
    }
    if timings.status() == TimingStatus::PassPerStage {
        println!("(this device times whole passes only: a pass per dispatch costs time itself)");
    }
    let mut list = table(&["pass", "median ms", "p95 ms", "dispatches"], &[1, 2, 3]);
    for (stage, dispatches) in &stages {
        let times = timings.stage_ms(stage);
        list.add_row([
            stage.to_string(),
            ms(times.map(|t| t.median)),
            ms(times.map(|t| t.p95)),
            dispatches.to_string(),
        ]);
    }
    let step = timings.step_ms();
    list.add_row(["a step, with gaps".to_string(), ms(step.map(|t| t.median)), ms(step.map(|t| t.p95)), String::new()]);
    println!("\n{}\n", list.trim_fmt());
    match rate {
        Some(rate) => println!("{:.2} million particle iterations a second", rate * 1e-6),
        None => println!("no usable times: {} flagged spans", timings.flagged_spans()),
    }
    println!("{}, {:.0} bytes a particle", bytes(total_bytes), per_particle.unwrap_or(0.0));
    Ok(())
}
