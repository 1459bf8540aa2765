//! `brooklet bench SCENE` for people.

use brooklet_bench::{pictures::PictureCost, single::SceneCost};
use brooklet_gpu::TimingStatus;

use crate::table::{bytes, ms, table};

/// Prints the table of passes, and that of a picture's.
pub fn print(cost: &SceneCost) {
    say!(
        "{}: {} particles, {} iterations a step, {} steps after {} of warm-up, on {} as {}",
        cost.scene,
        cost.particles,
        cost.iterations,
        cost.steps,
        cost.warm_up_steps,
        cost.device.name,
        cost.device.tier,
    );
    if cost.device.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    if cost.timing == TimingStatus::PassPerStage {
        say!("(this device times whole passes only: a pass per dispatch costs time itself)");
    }
    let mut list = table(&["pass", "median ms", "p95 ms", "dispatches"], &[1, 2, 3]);
    for (stage, pass) in &cost.passes.0 {
        list.add_row([stage.to_string(), ms(pass.median_ms), ms(pass.p95_ms), pass.dispatches.to_string()]);
    }
    let step = cost.gpu_ms_per_step;
    list.add_row(["a step, with gaps".to_string(), ms(step.map(|t| t.median)), ms(step.map(|t| t.p95)), String::new()]);
    say!("\n{}\n", list.trim_fmt());
    match cost.particle_iterations_per_s {
        Some(rate) => say!("{:.2} million particle iterations a second", rate * 1e-6),
        None => say!("no usable times: {} flagged spans", cost.flagged_spans),
    }
    say!("{}, {:.0} bytes a particle", bytes(cost.bytes), cost.bytes_per_particle.unwrap_or(0.0));
    cost.picture.iter().for_each(print_picture);
}

fn print_picture(cost: &PictureCost) {
    let [width, height] = cost.size_px;
    say!("\na picture of {width} x {height} pixels, {} drawn", cost.pictures);
    let mut list = table(&["pass", "median ms", "p95 ms", "share", "bytes", "runs"], &[1, 2, 3, 4, 5]);
    let percent = |share: Option<f64>| share.map_or_else(|| "-".into(), |share| format!("{:.1} %", 100.0 * share));
    for (stage, pass) in &cost.passes.0 {
        let times = pass.times;
        list.add_row([
            stage.to_string(),
            ms(times.median_ms),
            ms(times.p95_ms),
            percent(pass.share),
            bytes(pass.bytes),
            times.dispatches.to_string(),
        ]);
    }
    let picture = cost.picture_ms;
    let [median, p95] = [ms(picture.map(|t| t.median)), ms(picture.map(|t| t.p95))];
    list.add_row(["a picture, with gaps".into(), median, p95, String::new(), String::new(), String::new()]);
    say!("\n{}\n", list.trim_fmt());
    say!(
        "smoothing takes {} of the passes' time; pictures take {} of memory\n\
         (bytes: what a pass binds and draws to, once each time it runs; draws of one pass without a time of their\n\
         own are in that of the first)",
        percent(cost.smoothing_share),
        bytes(cost.bytes)
    );
}
