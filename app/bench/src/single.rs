//! One scene, without measurements; and what its pictures cost, if asked.

use brooklet_fluid::FrameRequest;
use brooklet_gpu::{TimingStatus, Timings, stages, tier_name};
use serde_json::json;

use super::{
    open,
    pictures::{self, picture_cost},
    stepping::Stepping,
};
use crate::{
    bench_options::BenchOptions,
    commit::COMMIT,
    failure::Failure,
    interrupt::Interrupt,
    job, progress,
    table::{bytes, ms, table},
};

/// Times and prints the scene that is called `name`.
pub fn bench(name: &str, options: &BenchOptions) -> Result<(), Failure> {
    let mut scene = job::load(name, &options.settings)?;
    scene.outputs.images = 0;
    scene.outputs.measure_every_steps = 0;
    let gpu = open(&options.device)?;
    let planned = job::plan(&scene, gpu.tier())?;
    let per_particle = planned.session.recorded.bytes_per_particle(planned.plan());
    let (total_bytes, stages) = (planned.plan().bytes(), stages(planned.plan().passes()));
    let particles = planned.session.slot_count();
    let mut session = brooklet_render::start(&gpu, planned.session).map_err(Failure::input)?;
    let interrupt = Interrupt::listen()?;
    let mut timings = Timings::new(options.warm_up);
    session.finish().map_err(Failure::stopped)?;

    let steps = options.warm_up + options.steps;
    let bar = progress::bar(steps);
    let request = FrameRequest { steps: 1, ..FrameRequest::default() };
    let mut stepping = Stepping { session: &mut session, request, interrupt: &interrupt };
    let outcome = stepping.run(steps, &mut timings, || bar.inc(1));
    bar.finish_and_clear();
    outcome?;

    let picture = picture_cost(&gpu, &scene, options, &interrupt)?;
    let iterations = scene.solver.pbf.iterations * scene.solver.substeps;
    let work = f64::from(particles) * f64::from(iterations);
    let rate = timings.step_ms().map(|step| work / (step.median * 1e-3));
    let info = gpu.info();
    let passes = timings.passes(&stages);
    if options.json {
        let all = json!({
            "scene": scene.name,
            "particles": particles,
            "steps": options.steps,
            "warm_up_steps": options.warm_up,
            "gpu_ms_per_step": timings.step_ms(),
            "particle_iterations_per_s": rate,
            "passes": passes,
            "picture": picture,
            "bytes": total_bytes,
            "bytes_per_particle": per_particle,
            "timing": timings.status().name(),
            "flagged_spans": timings.flagged_spans(),
            "device": { "name": info.name, "device_type": info.device_type, "tier": tier_name(gpu.tier()) },
            "commit": COMMIT,
        });
        say!("{}", serde_json::to_string_pretty(&all).map_err(Failure::stopped)?);
        return Ok(());
    }

    say!(
        "{}: {particles} particles, {iterations} iterations a step, {} steps after {} of warm-up, on {} as {}",
        scene.name,
        options.steps,
        options.warm_up,
        info.name,
        tier_name(gpu.tier()),
    );
    if info.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    if timings.status() == TimingStatus::PassPerStage {
        say!("(this device times whole passes only: a pass per dispatch costs time itself)");
    }
    let mut list = table(&["pass", "median ms", "p95 ms", "dispatches"], &[1, 2, 3]);
    for (stage, pass) in &passes.0 {
        list.add_row([stage.to_string(), ms(pass.median_ms), ms(pass.p95_ms), pass.dispatches.to_string()]);
    }
    let step = timings.step_ms();
    list.add_row(["a step, with gaps".to_string(), ms(step.map(|t| t.median)), ms(step.map(|t| t.p95)), String::new()]);
    say!("\n{}\n", list.trim_fmt());
    match rate {
        Some(rate) => say!("{:.2} million particle iterations a second", rate * 1e-6),
        None => say!("no usable times: {} flagged spans", timings.flagged_spans()),
    }
    say!("{}, {:.0} bytes a particle", bytes(total_bytes), per_particle.unwrap_or(0.0));
    picture.iter().for_each(pictures::print);
    Ok(())
}
