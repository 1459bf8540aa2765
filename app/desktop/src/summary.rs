//! `summary.json`, and the short table a run ends with.

use brooklet_fluid::solver::pbf::{IterationWeights, has_coarse_correction};
use brooklet_fluid::{Relaxation, Scene, measure};
use brooklet_gpu::{Gpu, PassTimes, Passes, Plan, Quantiles, Timings, stages, tier_name};
use brooklet_render::Concession;
use brooklet_render::left_out::Absent;
use serde::Serialize;
use serde_json::{Map, Value};

use crate::{
    commit::{COMMIT, VERSION},
    drawn_meshes::DrawnMeshes,
    measured::{Counted, Measured, Worst},
    plan::said_particles,
    run_mesh::WrittenMesh,
    spacing::other_spacing,
    table::{bytes, ms, table},
};

/// A run in numbers. Values that were not measured are null.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    scene: String,
    particles: u64,
    slots: u32,
    #[serde(skip)]
    said_particles: String,
    /// Of its particles, m.
    spacing_m: f64,
    #[serde(skip)]
    other_spacing: Option<String>,
    steps: u64,
    simulated_s: f64,
    /// From the first step to the end of the last one, pictures included.
    wall_s: f64,
    /// Whether the run ended early, by Ctrl-C or because it could not go on.
    interrupted: bool,
    solver: Solver,
    gpu_ms_per_step: Option<Quantiles>,
    /// By pass: times of all its dispatches of a frame together, how many those are, and the sum
    /// over the run.
    passes: Passes<PassTimes>,
    timing: Timing,
    density_error: Option<measure::Summary>,
    compression: Option<measure::Summary>,
    max_speed_m_s: Option<f64>,
    centre_of_mass_m: Option<[f64; 3]>,
    front_m: Option<f64>,
    energy_j: Option<Energy>,
    counters: Option<Counted>,
    /// The largest values that any measurement of the run had.
    worst: Option<Worst>,
    measured: Measurements,
    /// What was drawn as a mesh, if anything was.
    drawn_meshes: Option<DrawnMeshes>,
    /// What was taken out of the scene's particles before the first step.
    start_relaxation: Option<Relaxation>,
    /// What --mesh wrote.
    mesh: Option<WrittenMesh>,
    buffers: Map<String, Value>,
    bytes_per_particle: Option<f64>,
    left_out: Vec<Absent>,
    /// What of the scene the device could not do, and what was done instead.
    stepped_down: Vec<String>,
    device: Device,
    version: &'static str,
    commit: &'static str,
    files: Files,
}

#[derive(Clone, Debug, Serialize)]
struct Solver {
    name: &'static str,
    iterations: Option<u32>,
    /// What those of this scene come to: too few are plain, whatever it asks for.
    acceleration: Option<&'static str>,
    /// Whether the first of them has a coarse correction.
    coarse_correction: Option<bool>,
    /// The share of the last substep's pressure that each begins with.
    warm_start: Option<f64>,
    substeps: u32,
    dt_s: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Timing {
    /// `inside_passes`, `pass_per_stage`, `unsupported` or `off`.
    how: &'static str,
    frames: u64,
    /// At the start; medians and percentiles leave them out.
    warm_up_frames_left_out: u64,
    flagged_spans: u64,
}

#[derive(Clone, Copy, Debug, Serialize)]
struct Energy {
    kinetic: f64,
    potential: f64,
    total: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Measurements {
    count: u64,
    every_steps: u32,
    /// The step that density error, speed, energy and so on are of.
    last_step: Option<u64>,
}

#[derive(Clone, Debug, Serialize)]
struct Device {
    name: String,
    device_type: String,
    driver: String,
    tier: &'static str,
}

/// What a run wrote.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Files {
    /// Pictures, in order.
    pub images: Vec<String>,
    /// Those pictures as one file; none where it was not asked for.
    pub clip: Vec<String>,
    /// Particle files, in order.
    pub particles: Vec<String>,
    /// The capture.
    pub capture: Option<String>,
    /// Whether the capture holds the whole run.
    pub capture_complete: bool,
    /// This summary.
    pub summary: String,
    /// What could not be written: a full disk, say.
    pub not_written: Vec<String>,
}

/// What a summary is made of.
pub struct Facts<'a> {
    /// The scene that ran.
    pub scene: &'a Scene,
    /// Its plan.
    pub plan: &'a Plan,
    /// Number of slots.
    pub slots: u32,
    /// Bytes of GPU memory of the simulation, over the particles.
    pub bytes_per_particle: Option<f64>,
    /// Steps that were done.
    pub steps: u64,
    /// Time they took.
    pub wall_s: f64,
    /// Whether it ended early.
    pub interrupted: bool,
    /// GPU times.
    pub timings: &'a Timings,
    /// Measurements.
    pub measured: &'a Measured,
    /// What was taken out of the start.
    pub start_relaxation: Option<Relaxation>,
    /// Meshes of the pictures.
    pub meshes: &'a DrawnMeshes,
    /// The mesh that was written.
    pub mesh: Option<WrittenMesh>,
    /// What was left out.
    pub left_out: Vec<Absent>,
    /// What of the scene the device could not do.
    pub concessions: Vec<Concession>,
    /// The device.
    pub gpu: &'a Gpu,
    /// What was written.
    pub files: Files,
}

impl Summary {
    /// Puts the facts in their places.
    pub fn new(facts: Facts<'_>) -> Self {
        let Facts { scene, plan, timings, measured, gpu, .. } = facts;
        let last = measured.last;
        let any = last.is_some();
        let weights = scene.solver.iterations().map(|_| IterationWeights::of(scene));
        Self {
            scene: scene.name.clone(),
            particles: scene.particle_count(),
            slots: facts.slots,
            said_particles: said_particles(scene, facts.slots),
            spacing_m: scene.fitted_spacing_m(),
            other_spacing: other_spacing(scene),
            steps: facts.steps,
            simulated_s: facts.steps as f64 * scene.solver.dt_s,
            wall_s: facts.wall_s,
            interrupted: facts.interrupted,
            solver: Solver {
                name: scene.solver.method.name(),
                iterations: scene.solver.iterations(),
                acceleration: weights.as_ref().map(|weights| weights.acceleration().name()),
                coarse_correction: weights.as_ref().map(|weights| has_coarse_correction(scene, weights)),
                warm_start: weights.as_ref().map(|_| scene.solver.pbf.warm_start),
                substeps: scene.solver.substeps,
                dt_s: scene.solver.dt_s,
            },
            gpu_ms_per_step: timings.step_ms(),
            passes: timings.passes(&stages(plan.passes())),
            timing: Timing {
                how: gpu.timing().name(),
                frames: timings.frames(),
                warm_up_frames_left_out: timings.warm_up(),
                flagged_spans: timings.flagged_spans(),
            },
            density_error: last.filter(|stats| stats.has_density).map(|stats| stats.density_error),
            compression: last.filter(|stats| stats.has_density).map(|stats| stats.compression),
            max_speed_m_s: last.map(|stats| stats.max_speed_m_s),
            centre_of_mass_m: last.map(|stats| stats.centre_of_mass_m),
            front_m: last.map(|stats| stats.front_m),
            energy_j: last.map(|stats| Energy {
                kinetic: stats.kinetic_j,
                potential: stats.potential_j,
                total: stats.kinetic_j + stats.potential_j,
            }),
            counters: any.then_some(measured.counted),
            worst: any.then_some(measured.worst),
            measured: Measurements {
                count: measured.count,
                every_steps: scene.outputs.measure_every_steps,
                last_step: any.then_some(measured.last_step),
            },
            drawn_meshes: facts.meshes.last().map(|_| facts.meshes.clone()),
            start_relaxation: facts.start_relaxation,
            mesh: facts.mesh,
            buffers: plan.buffers().into_iter().map(|buffer| (buffer.label, buffer.bytes.into())).collect(),
            bytes_per_particle: facts.bytes_per_particle,
            left_out: facts.left_out,
            stepped_down: facts.concessions.iter().map(ToString::to_string).collect(),
            device: Device {
                name: gpu.info().name.clone(),
                device_type: gpu.info().device_type.clone(),
                driver: format!("{} {}", gpu.info().driver, gpu.info().driver_info),
                tier: tier_name(gpu.tier()),
            },
            version: VERSION,
            commit: COMMIT,
            files: facts.files,
        }
    }

    /// The text of `summary.json`.
    pub fn to_json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(self)
    }

    /// The short table.
    pub fn print(&self, plan_bytes: u64) {
        say!(
            "{}: {}, {} steps ({:.3} s simulated) in {:.2} s, on {} as {}",
            self.scene,
            self.said_particles,
            self.steps,
            self.simulated_s,
            self.wall_s,
            self.device.name,
            self.device.tier,
        );
        if let Some(other) = &self.other_spacing {
            say!("{other}");
        }
        if let Some(Relaxation { rounds, compression: [before, after] }) = &self.start_relaxation
            && *rounds > 0
        {
            say!(
                "the start was relaxed: its largest compression, {:.2} %, is {:.2} % after {rounds} rounds",
                100.0 * before.max,
                100.0 * after.max,
            );
        }
        match &self.gpu_ms_per_step {
            Some(step) => say!(
                "GPU time of a step: {:.3} ms (median), {:.3} ms (95 of 100); \
                 the first {} frames do not count",
                step.median,
                step.p95,
                self.timing.warm_up_frames_left_out,
            ),
            None => say!("GPU time of a step: not measured (timing {})", self.timing.how),
        }
        if self.device.device_type == "cpu" {
            say!("(this driver runs on the processor: its times are the processor's)");
        }
        if self.timing.flagged_spans > 0 {
            say!(
                "{} of the GPU's times are in doubt (zero, negative, overlapping, or behind a gap that no \
                 pass accounts for): see the flags in the capture",
                self.timing.flagged_spans,
            );
        }
        self.print_passes();
        self.print_measured();
        if let Some(meshes) = &self.drawn_meshes {
            meshes.print();
        }
        match self.bytes_per_particle {
            Some(each) => say!("memory: {}; {each:.0} bytes a particle without what is drawn", bytes(plan_bytes)),
            None => say!("memory: {}; there are no particles", bytes(plan_bytes)),
        }
    }

    /// The line of the mesh that was written, if one was.
    pub fn print_mesh(&self) {
        if let Some(mesh) = &self.mesh {
            say!(
                "mesh      {} ({} vertices, {} triangles, {:.6e} m3)",
                mesh.file,
                mesh.vertices,
                mesh.triangles,
                mesh.volume_m3
            );
        }
    }

    fn print_passes(&self) {
        let all: f64 = self.passes.0.iter().filter_map(|(_, pass)| pass.total_ms).sum();
        let mut list = table(&["pass", "median ms", "p95 ms", "of the run", "dispatches"], &[1, 2, 3, 4]);
        for (stage, pass) in &self.passes.0 {
            let share = pass.total_ms.filter(|_| all > 0.0).map(|ms| 100.0 * ms / all);
            list.add_row([
                stage.to_string(),
                ms(pass.median_ms),
                ms(pass.p95_ms),
                share.map_or_else(|| "-".into(), |share| format!("{share:.1} %")),
                pass.dispatches.to_string(),
            ]);
        }
        say!("\n{}\n", list.trim_fmt());
    }

    fn print_measured(&self) {
        let (Some(energy), Some(counted)) = (self.energy_j, self.counters) else {
            say!("nothing was measured (outputs.measure_every_steps = 0)");
            return;
        };
        if let (Some(density), Some(compression)) = (self.density_error, self.compression) {
            let mut list = table(&["at the end", "mean", "99 of 100", "largest"], &[1, 2, 3]);
            for (name, summary) in [("density error", density), ("compression", compression)] {
                let percent = |ratio: f64| format!("{:.2} %", 100.0 * ratio);
                list.add_row([name.to_string(), percent(summary.mean), percent(summary.p99), percent(summary.max)]);
            }
            say!("{}", list.trim_fmt());
        }
        say!(
            "largest speed {:.3} m/s, front at x = {:.3} m, energy {:.2} J",
            self.max_speed_m_s.unwrap_or_default(),
            self.front_m.unwrap_or_default(),
            energy.total,
        );
        say!(
            "counted: {} neighbours without a slot, {} crowded searches, {} clamped speeds, {} clamped corrections, \
             {} held displacements, {} long substeps, {} particles without a slot, {} quarantined, {} escaped",
            counted.neighbour_overflow,
            counted.crowded,
            counted.speed_clamps,
            counted.correction_clamps,
            counted.displacement_clamps,
            counted.long_substeps,
            counted.capacity_overflow,
            counted.quarantined,
            counted.escaped,
        );
        if counted.emitted + counted.drained + counted.capacity_overflow > 0 {
            say!(
                "particles that came: {}, that went: {}, that found no slot: {}",
                counted.emitted,
                counted.drained,
                counted.capacity_overflow
            );
        }
        if counted.diffuse_spawned + counted.diffuse_dropped > 0 {
            say!(
                "spray, foam and bubbles: {} spawned, {} ended, {} overwritten by younger ones, {} without a slot",
                counted.diffuse_spawned,
                counted.diffuse_ended,
                counted.diffuse_overwritten,
                counted.diffuse_dropped
            );
        }
        if let Some(word) = counted.instability() {
            say!("{word}");
        }
        if counted.density_iterations + counted.divergence_iterations + counted.unsolved > 0 {
            say!(
                "pressure solves: {} iterations for divergence, {} for density; {} ended above their tolerance",
                counted.divergence_iterations,
                counted.density_iterations,
                counted.unsolved,
            );
        }
    }
}
