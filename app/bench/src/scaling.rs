//! The same workload at rising numbers of particles: how time, rate and memory scale.

use std::time::Instant;

use brooklet_fluid::Session;
use brooklet_gpu::{Gpu, Passes, Timings, stages, tier_name};

use crate::{
    BenchError, Observer,
    bounds::Bounds,
    figures::{LeftOut, Pass, Row, Scaling},
    rates::{self, Rates},
    stepping::{LEAST_STEPS, Paced, pace},
    targets, traffic,
    workload::{EDGES, LOADS, Load},
};

/// What is timed.
#[derive(Clone, Debug)]
pub struct Options {
    /// What is changed of the workload, as `solver.neighbour_slots=40`.
    pub settings: Vec<String>,
    /// The largest size.
    pub max_particles: u32,
    /// Time for the whole table, s: what would take longer is left out.
    pub budget_s: f64,
}

impl Options {
    /// # Errors
    /// [`BenchError::Input`] for a setting that no scene takes.
    pub fn check(&self) -> Result<(), BenchError> {
        LOADS[0].scene(EDGES[0], &self.settings).map(drop)
    }
}

/// Times every load at every size that fits the budget.
///
/// # Errors
/// Every [`BenchError`].
pub fn run(gpu: &Gpu, options: &Options, observer: &dyn Observer) -> Result<Scaling, BenchError> {
    options.check()?;
    let rates = rates::measure(gpu, observer)?;
    let mut bencher = Bencher { gpu, options, observer, rates, begun: Instant::now() };
    let (rows, left_out) = bencher.all()?;
    let info = gpu.info();
    Ok(Scaling {
        device: info.name.clone(),
        device_type: info.device_type.clone(),
        driver: format!("{} {}", info.driver, info.driver_info),
        tier: tier_name(gpu.tier()),
        rates,
        targets: targets::verdicts(&rows),
        rows,
        left_out,
    })
}

struct Bencher<'a> {
    gpu: &'a Gpu,
    options: &'a Options,
    observer: &'a dyn Observer,
    rates: Rates,
    begun: Instant,
}

impl Bencher<'_> {
    /// Every size that fits, smallest first, so that what the budget cuts off is the largest.
    fn all(&mut self) -> Result<(Vec<Row>, Vec<LeftOut>), BenchError> {
        let sizes = EDGES.map(|edge| (edge, edge.pow(3)));
        let wanted = sizes.iter().filter(|(_, particles)| *particles <= self.options.max_particles);
        let runs = wanted.clone().count() * LOADS.len();
        self.observer.begin(runs as u64);
        let (mut rows, mut left_out) = (Vec::new(), Vec::new());
        // What a particle takes in the slowest load so far, in seconds a step.
        let mut step_s_per_particle = 0.0;
        for (index, &(edge, particles)) in wanted.enumerate() {
            let remaining_s = self.options.budget_s - self.begun.elapsed().as_secs_f64();
            let least_s = step_s_per_particle * f64::from(particles) * LEAST_STEPS as f64;
            let runs_left = runs - index * LOADS.len();
            if index > 0 && least_s * LOADS.len() as f64 > remaining_s {
                let reason = format!("--budget {} leaves no time for it", self.options.budget_s);
                left_out.push(LeftOut { particles, reason });
                continue;
            }
            let share_s = remaining_s / runs_left as f64;
            for load in LOADS {
                self.observer.message(format!("{particles} particles, {}", load.terms()));
                match self.row(load, edge, share_s) {
                    Ok((row, step_s)) => {
                        step_s_per_particle = f64::max(step_s_per_particle, step_s / f64::from(particles));
                        rows.push(row);
                    }
                    // The device says which buffer is too large for it, or for its memory.
                    Err(BenchError::Input(reason)) if index > 0 => {
                        left_out.push(LeftOut { particles, reason: format!("{}: {reason}", load.terms()) });
                    }
                    Err(error) => return Err(error),
                }
                self.observer.advance();
            }
            // A smaller size's memory would only lie in the way.
            self.gpu.trim();
        }
        Ok((rows, left_out))
    }

    /// One load at one size in about `share_s` seconds, and how many a step took.
    fn row(&mut self, load: Load, edge: u32, share_s: f64) -> Result<(Row, f64), BenchError> {
        let scene = load.scene(edge, &self.options.settings)?;
        let Paced { mut session, timings, steps, step_s } = pace(self.gpu, &scene, true, share_s, self.observer)?;

        let heads = session.recorded().neighbours.as_ref().map(|listed| listed.heads.alias());
        let neighbours = match heads {
            Some(heads) => {
                let heads = session.engine_mut().read(&heads).map_err(BenchError::stopped)?;
                heads.iter().map(|head| u64::from(head.entries)).sum()
            }
            None => 0,
        };
        let row = self.shape(load, &session, &timings, neighbours, steps)?;
        Ok((row, step_s))
    }

    fn shape(
        &self,
        load: Load,
        session: &Session,
        timings: &Timings,
        neighbours: u64,
        steps: u64,
    ) -> Result<Row, BenchError> {
        let (scene, plan, recorded) = (session.scene(), session.engine().plan(), session.recorded());
        let particles = recorded.slots.capacity;
        let measure = recorded.measure.as_ref().map(|measure| measure.recording.id());
        let step_ms = timings.step_ms();
        let step_ms = step_ms.ok_or_else(|| {
            BenchError::Stopped(format!("no usable times: {} flagged spans", timings.flagged_spans()))
        })?;
        let iterations = scene.iterations_a_step();
        let work = f64::from(particles) * f64::from(iterations);
        let interval = f64::from(scene.outputs.measure_every_steps.max(1));
        let mut passes = Vec::new();
        let (mut measure_ms, mut grid_ms) = (0.0, 0.0);
        for (stage, dispatches) in stages(plan.passes()) {
            let times = timings.pass(stage, dispatches);
            let Some(median_ms) = times.median_ms else { continue };
            let info = plan.passes().into_iter().find(|pass| pass.stage == stage);
            let Some(info) = info else { continue };
            let mut ms_a_step = median_ms;
            if Some(info.recording) == measure {
                ms_a_step /= interval;
                measure_ms += ms_a_step;
            } else if info.module.source.starts_with("grid/") && stage != "list_neighbours" {
                grid_ms += ms_a_step;
            }
            let traffic = traffic::of(plan, info.recording, stage, neighbours);
            let all_bytes = traffic.compulsory_bytes + traffic.gathered_bytes;
            let bounds = Bounds::of(plan, info.recording, stage, traffic, neighbours, &self.rates);
            let (nearest, bound_ms) = bounds.nearest();
            let pass = Pass {
                times,
                ns_per_particle_iteration: ms_a_step * 1e6 / work,
                traffic,
                gb_per_s: traffic.compulsory_bytes as f64 / median_ms * 1e-6,
                gb_per_s_gathers_too: all_bytes as f64 / median_ms * 1e-6,
                bounds,
                nearest,
                bound_ms,
                share_of_bound: bound_ms / median_ms,
            };
            passes.push((stage, pass));
        }
        let above_bound = |pass: &Pass| pass.times.median_ms.unwrap_or_default() - pass.bound_ms;
        let furthest = passes.iter().max_by(|(_, a), (_, b)| above_bound(a).total_cmp(&above_bound(b)));
        let ms_a_step = step_ms.median + measure_ms;
        Ok(Row {
            particles,
            load,
            terms: load.terms(),
            iterations,
            steps,
            step_ms,
            measure_ms,
            particle_iterations_per_s: work / (ms_a_step * 1e-3),
            ns_per_particle_iteration: ms_a_step * 1e6 / work,
            bytes: plan.bytes(),
            bytes_per_particle: recorded.bytes_per_particle(plan).unwrap_or_default(),
            neighbours_mean: neighbours as f64 / f64::from(particles),
            grid_share: grid_ms / step_ms.median,
            furthest_from_bound: furthest.map(|(stage, _)| *stage),
            passes: Passes(passes),
            flagged_spans: timings.flagged_spans(),
        })
    }
}
