//! `brooklet plan`: what a run would do, without doing it; needs no GPU.

use brooklet_fluid::Scene;
use brooklet_gpu::{KeptBuffer, Plan, Tier};
use brooklet_render::ScenePlan;
use brooklet_render::left_out::{self, Absent};
use serde::Serialize;
use serde_json::json;

use crate::{
    cli::{OutputOptions, PlanOptions},
    failure::Failure,
    job,
    spacing::other_spacing,
    table::{bytes, table},
};

/// A pass of the plan.
#[derive(Clone, Debug, Serialize)]
struct Pass {
    recording: &'static str,
    stage: &'static str,
    variant: &'static str,
    source: &'static str,
    dispatches: u32,
    /// Whether the GPU says how many groups or instances.
    indirect: bool,
}

/// Prints the plan of a scene.
pub fn plan(options: &PlanOptions) -> Result<(), Failure> {
    let scene = job::scene(&options.scene, Some(&options.outputs))?;
    let tier = options.tier.map_or(Tier::Desktop, Into::into);
    let particles = u32::try_from(scene.particle_count()).map_err(Failure::input)?;
    let planned = job::plan_for(&scene, particles, tier)?;
    let OutputOptions { no_capture, no_timing, .. } = options.outputs;
    let recorded = left_out::Recorded { no_times: no_timing.then_some("--no-timing"), no_capture };
    let absent = left_out::list(&scene, tier, &planned, &recorded).map_err(job::refused)?;
    if options.json {
        print_json(&scene, &planned, &absent, no_timing)
    } else {
        print_tables(&scene, &planned, &absent, no_timing);
        Ok(())
    }
}

fn passes(plan: &Plan) -> Vec<Pass> {
    plan.passes()
        .iter()
        .map(|pass| Pass {
            recording: pass.recording.label(),
            stage: pass.stage,
            variant: pass.module.name,
            source: pass.module.source,
            dispatches: pass.count,
            indirect: pass.indirect,
        })
        .collect()
}

/// The buffer whose memory another has, if it is not its own.
fn shared_memory(plan: &Plan, buffer: &KeptBuffer) -> Option<String> {
    (buffer.memory != buffer.id).then(|| plan.resources().label(buffer.memory).to_owned())
}

fn print_json(scene: &Scene, planned: &ScenePlan, absent: &[Absent], no_timing: bool) -> Result<(), Failure> {
    let buffers: serde_json::Map<_, _> =
        planned.plan().buffers().into_iter().map(|buffer| (buffer.label, buffer.bytes.into())).collect();
    let shared: serde_json::Map<_, _> = planned
        .plan()
        .buffers()
        .into_iter()
        .filter_map(|buffer| Some((buffer.label.clone(), shared_memory(planned.plan(), &buffer)?.into())))
        .collect();
    let all = json!({
        "scene": scene.name,
        "particles": scene.particle_count(),
        "slots": planned.session.slot_count(),
        "passes": passes(planned.plan()),
        "buffers": buffers,
        "shared_memory": shared,
        "bytes": planned.plan().bytes(),
        "bytes_without_sharing": planned.plan().buffers().iter().map(|buffer| buffer.bytes).sum::<u64>(),
        "timestamps": timestamps(planned.plan(), no_timing).into_iter().collect::<serde_json::Map<_, _>>(),
        "timestamp_bytes": if no_timing { 0 } else { planned.timestamp_memory() },
        "bytes_per_particle": planned.session.recorded.bytes_per_particle(planned.plan()),
        "own_bytes_per_particle": planned.session.recorded.own_bytes_per_particle(planned.plan()),
        "left_out": absent,
    });
    let text = serde_json::to_string_pretty(&all).map_err(Failure::stopped)?;
    say!("{text}");
    Ok(())
}

/// How many particles there are at the start, and how many slots where there are more.
pub fn said_particles(scene: &Scene, slots: u32) -> String {
    match scene.slot_capacity() {
        Some(_) => format!("{} particles in {slots} slots", scene.particle_count()),
        None => format!("{slots} particles"),
    }
}

/// How many timestamps one run of each recording takes at most.
fn timestamps(plan: &Plan, no_timing: bool) -> Vec<(String, serde_json::Value)> {
    let bound = |recording| if no_timing { 0 } else { plan.timestamp_bound(recording) };
    plan.recordings().map(|recording| (recording.label().to_owned(), bound(recording).into())).collect()
}

fn print_tables(scene: &Scene, planned: &ScenePlan, absent: &[Absent], no_timing: bool) {
    say!("{}: {}", scene.name, said_particles(scene, planned.session.slot_count()));
    if let Some(other) = other_spacing(scene) {
        say!("{other}");
    }
    say!();
    let mut list = table(&["recording", "pass", "variant", "shader", "runs"], &[4]);
    for pass in passes(planned.plan()) {
        let runs = format!("{}{}", pass.dispatches, if pass.indirect { ", indirect" } else { "" });
        list.add_row([pass.recording, pass.stage, pass.variant, pass.source, &runs]);
    }
    say!("{}\n", list.trim_fmt());

    let mut list = table(&["buffer", "bytes", "", "in the memory of"], &[1, 2]);
    for buffer in planned.plan().buffers() {
        let memory = shared_memory(planned.plan(), &buffer).unwrap_or_default();
        list.add_row([buffer.label, buffer.bytes.to_string(), bytes(buffer.bytes), memory]);
    }
    let total = planned.plan().bytes();
    list.add_row(["in all, each memory once".to_string(), total.to_string(), bytes(total), String::new()]);
    say!("{}", list.trim_fmt());
    if let Some(per_particle) = planned.session.recorded.bytes_per_particle(planned.plan()) {
        let own = planned.session.recorded.own_bytes_per_particle(planned.plan()).unwrap_or_default();
        say!(
            "{per_particle:.0} bytes a particle, without what is drawn; {own:.0} of its own, the rest in memory that pictures need"
        );
    }
    if !no_timing {
        let each: Vec<String> =
            timestamps(planned.plan(), no_timing).iter().map(|(name, count)| format!("{name} {count}")).collect();
        let memory = bytes(planned.timestamp_memory());
        say!("timestamps of a run, at most: {}; {memory} for the frames in flight", each.join(", "));
    }

    if absent.is_empty() {
        say!("\nnothing is left out");
        return;
    }
    let mut list = table(&["left out", "kind", "bytes", "because"], &[2]);
    for absent in absent {
        list.add_row([absent.name.clone(), absent.kind.to_string(), absent.bytes.to_string(), absent.reason.clone()]);
    }
    say!("\n{}", list.trim_fmt());
}
