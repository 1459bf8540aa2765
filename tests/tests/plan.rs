//! What a scene does not need is not dispatched, not allocated, and not in the shader.

use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Engine, Plan, Resources};
use brooklet_tests::gpu;

const SMALL: &[&str] = &["spacing_m=0.1"];

fn plan(settings: &[&str]) -> Plan {
    let settings: Vec<String> = SMALL.iter().chain(settings).map(|&s| s.into()).collect();
    let scene = Scene::load("calm-pool", &settings).unwrap();
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &scene);
    let wanted = recorded.measure.as_ref().map(|measure| measure.id);
    Plan::sweep(resources, recorded.recordings, wanted.as_slice()).unwrap()
}

/// Stages and buffers of a plan by name.
fn names(plan: &Plan) -> (Vec<String>, Vec<String>) {
    let mut stages: Vec<String> = plan.passes().iter().map(|pass| pass.stage.to_string()).collect();
    stages.sort();
    stages.dedup();
    (stages, plan.buffers().iter().map(|buffer| buffer.label.to_string()).collect())
}

/// Runs one step and one measurement; what the engine counted.
fn counts(plan: Plan) -> (u64, u64, u64) {
    let recordings: Vec<&str> = plan.recordings().collect();
    let mut engine = Engine::new(&gpu(), plan).unwrap();
    let allocations = engine.allocation_count();
    engine.run(&recordings, &[]).unwrap();
    engine.finish().unwrap();
    (engine.dispatch_count(), allocations, engine.timestamp_query_count())
}

#[test]
fn each_optional_term_takes_its_stages_and_buffers_along() {
    // (setting that drops it, setting that has it, its stages, its buffers)
    let terms: &[(&str, &str, &[&str], &[&str])] = &[
        ("solver.vorticity_m_s=0", "solver.vorticity_m_s=0.1", &["curl", "confine_vorticity"], &["vorticities"]),
        ("solver.xsph=0", "solver.xsph=0.05", &["viscosity"], &["unsmoothed_velocities"]),
        (
            "outputs.measure_every_steps=0",
            "outputs.measure_every_steps=1",
            &["measure_particles", "measure_totals"],
            &["measure", "group_measures", "histograms"],
        ),
        ("domain.walls=false", "domain.walls=true", &[], &["wall_weights"]),
        ("solver.iterations=0", "solver.iterations=2", &["constrain_density", "correct_positions"], &["constrained"]),
    ];
    for (without, with, stages, buffers) in terms {
        let (lean, full) = (plan(&[without]), plan(&[with]));
        let ((lean_stages, lean_buffers), (full_stages, full_buffers)) = (names(&lean), names(&full));
        for stage in *stages {
            assert!(full_stages.contains(&stage.to_string()), "{with}: {stage} is missing from {full_stages:?}");
            assert!(!lean_stages.contains(&stage.to_string()), "{without}: {stage} is still there");
        }
        for buffer in *buffers {
            assert!(full_buffers.contains(&buffer.to_string()), "{with}: {buffer} is missing from {full_buffers:?}");
            assert!(!lean_buffers.contains(&buffer.to_string()), "{without}: {buffer} is still there");
        }
        assert!(lean.bytes() < full.bytes(), "{without} saves no byte");
        // And so it runs: fewer dispatches, allocations and timestamps, not just fewer names.
        let (lean, full) = (counts(lean), counts(full));
        if !stages.is_empty() {
            assert!(lean.0 < full.0 && lean.2 <= full.2, "{without}: {lean:?} against {full:?}");
        }
        assert!(lean.1 < full.1, "{without}: {lean:?} against {full:?}");
    }
}

#[test]
fn a_term_that_is_off_is_not_in_the_shader() {
    let variants = |settings: &[&str]| -> Vec<String> {
        plan(settings).passes().iter().map(|pass| pass.module.name.to_string()).collect()
    };
    let (without, with) = (variants(&["solver.s_corr_k=0"]), variants(&["solver.s_corr_k=0.1"]));
    assert!(with.iter().any(|module| module.starts_with("CorrectPositions") && module.contains("S_CORR")), "{with:?}");
    assert!(!without.iter().any(|module| module.contains("S_CORR")), "{without:?}");
    let code = |on: bool| {
        brooklet_kernels::modules()
            .find(|module| {
                module.name.starts_with("CorrectPositions")
                    && module.name.contains("WALLS")
                    && !module.name.contains("NARROW")
                    && module.name.contains("S_CORR") == on
            })
            .unwrap()
            .spirv
            .len()
    };
    assert!(code(false) < code(true));
}
