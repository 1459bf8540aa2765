//! What is drawn of the fluid, as a person chooses it: one run ends in water and one in nothing, and a plan shows what
//! each choice leaves out.

use std::collections::BTreeSet;

use brooklet_capture::Capture;
use brooklet_tests::program::Workshop;
use serde_json::Value;

/// Stages that draw water, and the words that any stage of a surface has in its name.
const WATER: [&str; 6] = [
    "anisotropy",
    "draw_fluid_depth",
    "draw_smooth_narrow_range",
    "draw_thickness",
    "draw_sun_thickness",
    "draw_water",
];

#[test]
fn one_capture_ends_in_water_and_one_in_nothing() {
    let workshop = Workshop::new();
    let mut stages = Vec::new();
    for method in ["screen-space", "none"] {
        let setting = format!("surface.method={method}");
        let run = ["run", "scene.toml", "--steps", "4", "--images", "2", "--set", &setting, "--out", method];
        workshop.succeed(&run);
        assert!(workshop.has(&format!("{method}/frame_0001.png")));
        let capture = Capture::open(&workshop.path(&format!("{method}/capture.mcap"))).unwrap();
        assert!(capture.complete && capture.frames.len() == 4, "{method}");
        // Pictures are drawn in the second and the last step.
        let last = capture.passes.last().unwrap();
        let drawn: BTreeSet<String> =
            last.stage_ms.keys().filter(|stage| capture.stages.contains(stage)).cloned().collect();
        let is_timed = !capture.spans.is_empty();
        assert!(!is_timed || drawn.contains("draw_resolve"), "{method}: {drawn:?}");
        stages.push((capture.stages.iter().cloned().collect::<BTreeSet<_>>(), drawn, is_timed));
    }
    let [(water, water_drawn, is_timed), (none, none_drawn, _)] = &stages[..] else { panic!("two runs") };
    for stage in WATER {
        assert!(water.contains(stage) && !none.contains(stage), "{stage}");
        assert!(!is_timed || water_drawn.contains(stage), "{stage} has no time in the last frame");
    }
    // Of a surface there is nothing left: these draw what is around it.
    let around = ["draw_floor", "draw_sky", "draw_edges", "draw_resolve"];
    for stage in none.iter().chain(none_drawn).filter(|stage| stage.starts_with("draw_")) {
        assert!(around.contains(&stage.as_str()), "{stage}");
    }
}

/// Counting sort, solver and marching cubes, in the order in which they are to run.
const CHAIN: [&str; 13] = [
    "count_cells",
    "scan_groups",
    "reorder",
    "list_neighbours",
    "constrain_density",
    "correct_positions",
    "update_velocity",
    "gather_field",
    "count_mesh",
    "emit_vertices",
    "emit_triangles",
    "draw_mesh_depth",
    "draw_water",
];

#[test]
fn a_capture_shows_the_chain_from_the_sort_to_the_mesh() {
    let workshop = Workshop::new();
    let run = ["run", "scene.toml", "--steps", "2", "--images", "1", "--set", "surface.method=marching-cubes"];
    workshop.succeed(&[&run[..], &["--out", "mesh"]].concat());
    let capture = Capture::open(&workshop.path("mesh/capture.mcap")).unwrap();
    let place = |stage: &&str| capture.stages.iter().position(|listed| listed == stage);
    let places: Vec<usize> = CHAIN.iter().map(|stage| place(stage).unwrap_or_else(|| panic!("{stage}"))).collect();
    assert!(places.is_sorted(), "{:?}", capture.stages);
    let last = capture.frames.last().unwrap().frame;
    let begins = |stage: &str| {
        let of_stage = capture.spans.iter().filter(|span| span.frame == last && span.stage == stage);
        of_stage.map(|span| span.begin_ticks).min()
    };
    // The GPU says so too, where it gives times.
    let begun: Vec<u64> = CHAIN.iter().filter_map(|stage| begins(stage)).collect();
    assert!(begun.is_sorted() && (capture.spans.is_empty() || begun.len() == CHAIN.len()), "{begun:?}");
}

#[test]
fn a_plan_shows_what_each_choice_leaves_out() {
    let workshop = Workshop::new();
    let plan =
        |setting: &str| workshop.succeed(&["plan", "scene.toml", "--images", "1", "--set", setting, "--json"]).json();
    let stages = |plan: &Value| -> BTreeSet<String> {
        plan["passes"].as_array().unwrap().iter().map(|p| p["stage"].as_str().unwrap().into()).collect()
    };
    for (off, on, reason) in [
        ("surface.method=none", "surface.method=screen-space", "surface.method = none"),
        ("surface.caustics=false", "surface.caustics=true", "surface.caustics = false"),
        ("surface.self_shadow=false", "surface.self_shadow=true", "surface.self_shadow = false"),
        ("surface.anisotropic=false", "surface.anisotropic=true", "surface.anisotropic = false"),
        ("surface.smoothing=none", "surface.smoothing=narrow-range", "surface.smoothing = none"),
        (
            "surface={ method = 'marching-cubes', mesh.smooth_normals = 0 }",
            "surface={ method = 'marching-cubes', mesh.smooth_normals = 4 }",
            "surface.mesh.smooth_normals = 0",
        ),
        (
            "surface={ method = 'marching-cubes', mesh.subdivide = 1 }",
            "surface={ method = 'marching-cubes', mesh.subdivide = 2 }",
            "surface.mesh.subdivide = 1",
        ),
    ] {
        let (without, with) = (plan(off), plan(on));
        let list = |plan: &Value| -> Vec<Value> {
            plan["left_out"].as_array().unwrap().iter().filter(|item| item["reason"] == reason).cloned().collect()
        };
        assert!(list(&with).is_empty(), "{on}");
        let left_out = list(&without);
        let named = |kind: &str| -> BTreeSet<String> {
            let of_kind = left_out.iter().filter(|item| item["kind"] == kind);
            of_kind.map(|item| item["name"].as_str().unwrap().into()).collect()
        };
        assert_eq!(named("pass"), stages(&with).difference(&stages(&without)).cloned().collect(), "{off}");
        let bytes = |plan: &Value| plan["bytes_without_sharing"].as_u64().unwrap();
        let saved: u64 = left_out.iter().map(|item| item["bytes"].as_u64().unwrap()).sum();
        assert!(saved > 0 && bytes(&without) + saved == bytes(&with), "{off}");
        let table = workshop.succeed(&["plan", "scene.toml", "--images", "1", "--set", off]).stdout;
        assert!(table.contains(reason), "{table}");
    }
    // Caustics are on where devices are fast, and off where they are not, unless a scene says so.
    let has_caustics = |arguments: &[&str]| {
        let plan = [&["plan", "scene.toml", "--images", "1", "--json"], arguments].concat();
        stages(&workshop.succeed(&plan).json()).contains("draw_caustics")
    };
    assert!(has_caustics(&["--tier", "desktop"]));
    assert!(!has_caustics(&["--tier", "mobile"]) && !has_caustics(&["--tier", "floor"]));
    assert!(has_caustics(&["--tier", "floor", "--set", "surface.caustics=true"]));
    assert!(!has_caustics(&["--tier", "desktop", "--set", "surface.caustics=false"]));
}
