//! The program as a person uses it: what it writes, what it says, how it ends.

use std::collections::BTreeSet;

use brooklet_capture::Capture;
use brooklet_tests::captures::python::read_in_python;
use brooklet_tests::program::Workshop;
use serde_json::Value;

const RUN: [&str; 10] = ["run", "scene.toml", "--steps", "8", "--images", "2", "--particles", "ply", "--out", "result"];

/// Every key of `summary.json`, as scripts rely on it.
const SUMMARY_KEYS: [&str; 32] = [
    "scene",
    "particles",
    "steps",
    "slots",
    "simulated_s",
    "wall_s",
    "interrupted",
    "solver",
    "spacing_m",
    "gpu_ms_per_step",
    "passes",
    "timing",
    "density_error",
    "compression",
    "max_speed_m_s",
    "centre_of_mass_m",
    "front_m",
    "energy_j",
    "counters",
    "worst",
    "measured",
    "drawn_meshes",
    "start_relaxation",
    "stepped_down",
    "mesh",
    "buffers",
    "bytes_per_particle",
    "left_out",
    "device",
    "version",
    "commit",
    "files",
];

fn keys(value: &Value) -> BTreeSet<&str> {
    value.as_object().unwrap_or_else(|| panic!("no object: {value}")).keys().map(String::as_str).collect()
}

#[test]
fn a_run_writes_pictures_particles_capture_and_summary() {
    let workshop = Workshop::new();
    let ended = workshop.succeed(&RUN);
    for name in ["frame_0000.png", "frame_0001.png", "particles_0000.ply", "particles_0001.ply"] {
        assert!(workshop.has(&format!("result/{name}")), "{name}");
        assert!(!std::fs::read(workshop.path(&format!("result/{name}"))).unwrap().is_empty(), "{name}");
    }
    assert!(!workshop.has("result/frame_0002.png") && !workshop.has("result/particles_0002.ply"));
    for name in ["frame_0001.png", "capture.mcap", "summary.json"] {
        assert!(ended.stdout.contains(&format!("result/{name}")), "{name} is not named in {}", ended.stdout);
    }

    let summary = workshop.json("result/summary.json");
    assert_eq!(keys(&summary), BTreeSet::from(SUMMARY_KEYS));
    assert_eq!((&summary["scene"], summary["spacing_m"].as_f64()), (&"scene".into(), Some(0.05)));
    assert_eq!((summary["particles"].as_u64(), summary["steps"].as_u64()), (Some(64), Some(8)));
    let simulated_s = summary["simulated_s"].as_f64().unwrap();
    assert!((simulated_s - 8.0 * summary["solver"]["dt_s"].as_f64().unwrap()).abs() < 1e-12);
    let solver =
        BTreeSet::from(["name", "iterations", "acceleration", "coarse_correction", "warm_start", "substeps", "dt_s"]);
    assert_eq!(keys(&summary["solver"]), solver);
    for field in ["density_error", "compression"] {
        assert_eq!(keys(&summary[field]), BTreeSet::from(["mean", "p99", "max"]), "{field}");
    }
    // The scene's own coordinates: its domain starts at (1, 2, 3).
    let centre_m = summary["centre_of_mass_m"].as_array().unwrap();
    for (axis, low) in [1.0, 2.0, 3.0].into_iter().enumerate() {
        let at = centre_m[axis].as_f64().unwrap();
        assert!((low..low + 0.4).contains(&at), "axis {axis}: {at}");
    }
    assert!((1.15..1.45).contains(&summary["front_m"].as_f64().unwrap()), "{}", summary["front_m"]);
    assert_eq!(summary["measured"]["last_step"], 8);
    assert_eq!(summary["files"]["images"].as_array().unwrap().len(), 2);
    assert_eq!(summary["files"]["capture_complete"], true);
    // A particle's bytes are those that simulating and measuring take, as the plan has them: no more than without pictures.
    let planned = workshop.succeed(&["plan", "scene.toml", "--images", "2", "--json"]).json();
    assert_eq!(summary["bytes_per_particle"], planned["bytes_per_particle"]);
    let pictureless = workshop.succeed(&["plan", "scene.toml", "--set", "outputs.images=0", "--json"]).json();
    let most = pictureless["bytes_without_sharing"].as_f64().unwrap() / 64.0;
    assert!((0.5 * most..most).contains(&summary["bytes_per_particle"].as_f64().unwrap()), "{most}");
    let bytes: u64 = summary["buffers"].as_object().unwrap().values().map(|b| b.as_u64().unwrap()).sum();
    assert!(bytes > pictureless["bytes"].as_u64().unwrap(), "pictures take memory");

    // What an earlier run wrote is kept.
    workshop.succeed(&[&RUN[..], &["--clip"]].concat());
    assert_eq!(workshop.json("result/summary.json"), summary);
    let clip = &workshop.json("result-1/summary.json")["files"]["clip"];
    assert_eq!(clip, &serde_json::json!(["result-1/clip.webp"]));
    let bytes = std::fs::read(workshop.path("result-1/clip.webp")).unwrap();
    assert!(bytes.starts_with(b"RIFF") && bytes.windows(4).filter(|word| word == b"ANMF").count() == 2, "two pictures");
}

#[test]
fn the_capture_shows_every_pass_of_the_plan() {
    let workshop = Workshop::new();
    workshop.succeed(&RUN);
    let plan = workshop.succeed(&["plan", "scene.toml", "--images", "2", "--json"]).json();
    let stages: BTreeSet<String> =
        plan["passes"].as_array().unwrap().iter().map(|pass| pass["stage"].as_str().unwrap().into()).collect();
    assert!(stages.contains("constrain_density") && stages.contains("draw_water"), "{stages:?}");

    let path = workshop.path("result/capture.mcap");
    let capture = Capture::open(&path).unwrap();
    assert!(capture.complete);
    assert_eq!(capture.frames.len(), 8, "a frame a step");
    assert_eq!(capture.stages.iter().cloned().collect::<BTreeSet<_>>(), stages);
    let attached: Vec<&str> = capture.attachments.iter().map(|attached| &*attached.name).collect();
    assert_eq!(attached, ["scene.toml", "plan.json", "shaders.json"]);
    for (record, field) in [("device", "name"), ("device", "tier"), ("build", "commit")] {
        assert!(!capture.metadata[record][field].is_empty(), "{record}.{field}");
    }
    assert!(!capture.metadata["limits"].is_empty());
    let steps: Vec<f64> = capture.stats.iter().map(|row| row.values["step"]).collect();
    assert_eq!(steps, [2.0, 4.0, 6.0, 8.0], "measured every other step");

    let summary = workshop.json("result/summary.json");
    assert_eq!(keys(&summary["passes"]), stages.iter().map(String::as_str).collect());
    let timed = summary["timing"]["how"] != "unsupported";
    let ran: BTreeSet<String> = capture.spans.iter().map(|span| span.stage.clone()).collect();
    assert_eq!(ran, if timed { stages.clone() } else { BTreeSet::new() });
    if timed {
        for (stage, pass) in summary["passes"].as_object().unwrap() {
            let times = capture.stage_ms(stage);
            let (low, high) = times.iter().fold((f64::MAX, 0.0_f64), |(l, h), &ms| (l.min(ms), h.max(ms)));
            let median = pass["median_ms"].as_f64().unwrap();
            // The capture rounds to 1e-6 ms.
            assert!((low - 1e-6..=high + 1e-6).contains(&median), "{stage}: {median} is not in {low}..{high}");
        }
        // Dispatches in the summary are those that were timed in a frame.
        let per_frame = |stage: &str| {
            let frame = capture.spans.iter().find(|span| span.stage == stage).unwrap().frame;
            capture.spans.iter().filter(|span| span.frame == frame && span.stage == stage).count() as u64
        };
        for stage in ["constrain_density", "count_cells", "measure_totals"] {
            assert_eq!(summary["passes"][stage]["dispatches"].as_u64(), Some(per_frame(stage)), "{stage}");
        }
    }

    // The same seen by a reader that is not ours.
    if let Some(seen) = read_in_python(&path) {
        let seen = seen.unwrap();
        let fields = seen["topics"]["/gpu/passes"]["fields"].as_array().unwrap();
        for stage in &stages {
            assert!(fields.contains(&format!("{stage}_ms").into()), "{stage}");
        }
        assert_eq!(seen["topics"]["/gpu/frame"]["rows"].as_array().unwrap().len(), 8);
        let frames = seen["topics"]["/gpu/span"]["rows"].as_array().into_iter().flatten();
        let spans: usize = frames.map(|row| row["ticks"].as_array().map_or(0, Vec::len)).sum();
        assert_eq!(spans, capture.spans.len());
        let stats = seen["topics"]["/sim/stats"]["rows"].as_array().unwrap();
        assert_eq!(stats.last().unwrap()["density_error_mean"], summary["density_error"]["mean"]);
    }
}

#[test]
fn json_is_all_there_is_on_standard_output() {
    let workshop = Workshop::new();
    let ended = workshop.succeed(&["run", "scene.toml", "--steps", "3", "--json"]);
    assert_eq!(ended.json(), workshop.json("out/scene/summary.json"));
    let bench = workshop.succeed(&["bench", "scene.toml", "--steps", "5", "--warm-up", "2", "--json"]).json();
    assert!(bench["particle_iterations_per_s"].as_f64().unwrap() > 0.0, "{bench}");
    assert!(bench["passes"]["constrain_density"]["median_ms"].as_f64().is_some(), "{bench}");
    assert!(bench["passes"].get("measure_totals").is_none(), "{bench}");
    let scenes = workshop.succeed(&["scenes", "--json"]).json();
    assert!(scenes.as_array().unwrap().iter().any(|scene| scene["name"] == "dam-break"));
    let doctor = workshop.succeed(&["doctor", "--json"]).json();
    assert!(doctor.as_array().unwrap().iter().any(|device| device["tier"].is_string()), "{doctor}");
}

/// Water on a plate bears on it, and the capture says with how much; a scene without such a solid has no such field.
#[test]
fn a_capture_tells_what_pushes_a_solid() {
    let workshop = Workshop::new();
    let plate = "solid=[{ box = { size_m = [9, 0.1, 9] }, centre_m = [1.2, 2, 3.2], measure_force = true }]";
    let told = |settings: &[&str], out: &str| {
        let run = ["run", "scene.toml", "--steps", "24", "--images", "0", "--out", out];
        workshop.succeed(&[&run[..], settings].concat());
        Capture::open(&workshop.path(&format!("{out}/capture.mcap"))).unwrap()
    };
    let with = told(&["--set", plate], "with");
    let forces_n: Vec<f64> = with.stats.iter().map(|row| row.values["solid_0_force_y_n"]).collect();
    assert!(forces_n.iter().any(|force_n| *force_n < -1.0) && forces_n.iter().all(|n| *n < 1.0), "{forces_n:?}");
    let without = told(&[], "without");
    assert!(without.stat_fields.iter().all(|field| !field.name.contains("force")), "{:?}", without.stat_fields);
}

#[test]
fn what_is_not_wanted_leaves_nothing_behind() {
    let workshop = Workshop::new();
    let off = ["run", "scene.toml", "--steps", "4", "--set", "outputs.measure_every_steps=0", "--no-timing"];
    let summary = workshop.succeed(&[&off[..], &["--out", "off", "--json"]].concat()).json();
    assert!(!workshop.has("off/frame_0000.png") && !workshop.has("off/particles_0000.ply"));
    for stage in keys(&summary["passes"]) {
        assert!(!stage.starts_with("draw_") && !stage.starts_with("measure_"), "{stage}");
    }
    for buffer in keys(&summary["buffers"]) {
        assert!(!["picture", "measure", "histograms"].contains(&buffer), "{buffer}");
    }
    for field in ["gpu_ms_per_step", "density_error", "energy_j", "counters", "front_m"] {
        assert!(summary[field].is_null(), "{field}: {}", summary[field]);
    }
    let capture = Capture::open(&workshop.path("off/capture.mcap")).unwrap();
    assert_eq!((capture.frames.len(), capture.spans.len(), capture.stats.len()), (4, 0, 0));
    assert!(capture.stat_fields.is_empty());
    let reasons: BTreeSet<&str> =
        summary["left_out"].as_array().unwrap().iter().map(|item| item["reason"].as_str().unwrap()).collect();
    for reason in ["outputs.measure_every_steps = 0", "--no-timing"] {
        assert!(reasons.contains(reason), "{reasons:?}");
    }
    let bare =
        workshop.succeed(&["run", "scene.toml", "--steps", "4", "--no-capture", "--out", "bare", "--json"]).json();
    assert!(!workshop.has("bare/capture.mcap") && bare["files"]["capture"].is_null());
    assert!(bare["gpu_ms_per_step"]["median"].as_f64() > Some(0.0) || bare["timing"]["how"] == "unsupported");
}

#[test]
fn plans_with_and_without_a_term_show_what_falls_away() {
    let workshop = Workshop::new();
    let plan = |setting: &str| workshop.succeed(&["plan", "scene.toml", "--set", setting, "--json"]).json();
    let stages = |plan: &Value| -> BTreeSet<String> {
        plan["passes"].as_array().unwrap().iter().map(|p| p["stage"].as_str().unwrap().into()).collect()
    };
    // What is left out saves its own bytes, but for what it would have stood in others' memory.
    let bytes = |plan: &Value| plan["bytes_without_sharing"].as_u64().unwrap();
    for (off, on, reason) in [
        ("forces.vorticity_m_s=0", "forces.vorticity_m_s=0.5", "forces.vorticity_m_s = 0"),
        ("forces.xsph=0", "forces.xsph=0.01", "forces.xsph = 0"),
        ("solver.pbf.s_corr_k=0", "solver.pbf.s_corr_k=0.1", "solver.pbf.s_corr_k = 0"),
        ("domain.walls=false", "domain.walls=true", "domain.walls = false"),
        ("outputs.measure_every_steps=0", "outputs.measure_every_steps=1", "outputs.measure_every_steps = 0"),
        ("outputs.images=0", "outputs.images=1", "no pictures (outputs.images = 0)"),
    ] {
        let (without, with) = (plan(off), plan(on));
        let list = |plan: &Value| -> Vec<Value> {
            plan["left_out"].as_array().unwrap().iter().filter(|item| item["reason"] == reason).cloned().collect()
        };
        assert!(list(&with).is_empty(), "{on}");
        let left_out = list(&without);
        assert!(!left_out.is_empty(), "{off}");
        let named: BTreeSet<String> = left_out
            .iter()
            .filter(|item| item["kind"] == "pass")
            .map(|item| item["name"].as_str().unwrap().into())
            .collect();
        assert_eq!(named, stages(&with).difference(&stages(&without)).cloned().collect(), "{off}");
        let saved: u64 = left_out.iter().map(|item| item["bytes"].as_u64().unwrap()).sum();
        assert_eq!(bytes(&without) + saved, bytes(&with), "{off}");
        let table = workshop.succeed(&["plan", "scene.toml", "--set", off]).stdout;
        assert!(table.contains(reason), "{table}");
    }

    let times = workshop.succeed(&["plan", "scene.toml", "--json"]).json();
    let none = workshop.succeed(&["plan", "scene.toml", "--json", "--no-timing", "--no-capture"]).json();
    assert!(times["timestamps"]["step"].as_u64() > Some(0) && none["timestamps"]["step"] == 0);
    let absent = |name: &str| none["left_out"].as_array().unwrap().iter().find(|item| item["name"] == name).cloned();
    let timestamps = absent("timestamps").unwrap();
    assert_eq!((&timestamps["reason"], &timestamps["bytes"]), (&"--no-timing".into(), &times["timestamp_bytes"]));
    assert_eq!(absent("capture.mcap").unwrap()["reason"], "--no-capture");
    assert_eq!((&none["passes"], &none["bytes"]), (&times["passes"], &times["bytes"]));
}
