//! `brooklet bench` as a person uses it: the table over the number of particles.

use brooklet_tests::program::Workshop;
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

#[test]
fn the_table_has_every_load_and_its_figures_belong_together() {
    let workshop = Workshop::new();
    let arguments = ["bench", "--max-particles", "4096", "--budget", "30", "--json", "--plot", "table.svg"];
    let table = workshop.succeed(&arguments).json();
    let rows = table["rows"].as_array().unwrap();
    let loads: Vec<_> =
        rows.iter().map(|row| (row["iterations"].as_u64().unwrap(), row["terms"].as_str().unwrap())).collect();
    assert_eq!(loads, [(4, "default terms"), (6, "default terms"), (4, "every term, measuring")]);
    let rates = &table["rates"];
    for rate in ["copy_bytes_per_s", "gathers_per_s", "multiply_adds_per_s", "launch_s"] {
        assert!(number(&rates[rate]) > 0.0, "{rates}");
    }
    for row in rows {
        assert_eq!(row["particles"], 4096);
        // What is at rest keeps the neighbours of a slightly disordered lattice.
        assert!((24.0..32.0).contains(&number(&row["neighbours_mean"])), "{row}");
        let ms = number(&row["step_ms"]["median"]) + number(&row["measure_ms"]);
        let work = 4096.0 * number(&row["iterations"]);
        assert!((number(&row["particle_iterations_per_s"]) * ms * 1e-3 / work - 1.0).abs() < 1e-9, "{row}");
        let passes = row["passes"].as_object().unwrap();
        assert!(number(&row["grid_share"]) < 1.0 && passes.contains_key("constrain_density"), "{row}");
        for (stage, pass) in passes {
            let (median, bound) = (number(&pass["median_ms"]), number(&pass["bound_ms"]));
            let bytes = number(&pass["compulsory_bytes"]);
            assert!(bytes > 0.0, "{stage} moves nothing");
            let bounds = pass["bounds"].as_object().unwrap();
            let nearest = bounds.values().map(number).max_by(f64::total_cmp).unwrap();
            assert_eq!(
                (bound, &bounds[&format!("{}_ms", pass["nearest"].as_str().unwrap())]),
                (nearest, &bound.into())
            );
            let copied = bytes / number(&rates["copy_bytes_per_s"]) * 1e3;
            assert!((copied / number(&bounds["memory_ms"]) - 1.0).abs() < 1e-9, "{stage}: {pass}");
            assert!((number(&pass["share_of_bound"]) * median / bound - 1.0).abs() < 1e-9, "{stage}: {pass}");
            assert!((number(&pass["gb_per_s"]) * median * 1e6 / bytes - 1.0).abs() < 1e-9, "{stage}: {pass}");
        }
        let every_term = row["terms"] != "default terms";
        for stage in ["curl", "confine_vorticity", "measure_particles"] {
            assert_eq!(passes.contains_key(stage), every_term, "{stage}");
        }
        assert_eq!(number(&row["measure_ms"]) > 0.0, every_term);
    }
    // Targets are about larger sizes.
    assert_eq!(table["targets"].as_array().unwrap().len(), 0);
    let plot = std::fs::read_to_string(workshop.path("table.svg")).unwrap();
    for text in ["<svg", "constrain_density", "4k", "default terms, 6 iterations"] {
        assert!(plot.contains(text), "no {text:?} in the plot");
    }
}

#[test]
fn the_papers_rows_are_timed_by_every_solver_beside_their_figures() {
    let workshop = Workshop::new();
    let table = workshop.succeed(&["bench", "papers", "--max-particles", "1024", "--budget", "10", "--json"]).json();
    let rows = table["rows"].as_array().unwrap();
    let solvers: Vec<&str> = rows.iter().map(|row| row["method"].as_str().unwrap()).collect();
    assert!(solvers.contains(&"pbf") && solvers.contains(&"sph") && !solvers.contains(&"none"), "{solvers:?}");
    for row in rows {
        assert_eq!(row["particles"], 1024);
        let (ms, dt_s) = (number(&row["step_ms"]["median"]), number(&row["dt_s"]));
        assert!((number(&row["s_per_s"]) * dt_s * 1e3 / ms - 1.0).abs() < 1e-9 && ms > 0.0, "{row}");
        assert!((100.0..400.0).contains(&number(&row["bytes_per_particle"])), "{row}");
        let published = row["published"].as_array().unwrap();
        match row["method"].as_str() {
            Some("sph") => assert_eq!((published.len(), number(&published[0]["step_ms"])), (1, 3.9)),
            _ => assert!(published.is_empty(), "{row}"),
        }
    }
    // What does not fit the time is said.
    let table = workshop.succeed(&["bench", "papers", "--max-particles", "4096", "--budget", "0.001"]);
    assert!(table.stdout.contains("left out: 4096 particles: pbf: --budget 0.001 leaves no time"), "{}", table.stdout);
    let wrong = workshop.run(&["bench", "papers", "--set", "solver.substeps=0"]);
    assert_eq!(wrong.code, Some(2), "{}", wrong.stderr);
    assert!(wrong.stderr.contains("solver.substeps = 0: must be"), "{}", wrong.stderr);
}

#[test]
fn a_picture_is_timed_pass_by_pass() {
    let workshop = Workshop::new();
    let arguments = ["bench", "scene.toml", "--steps", "2", "--warm-up", "1", "--pictures", "3", "--json"];
    let picture = workshop.succeed(&arguments).json()["picture"].take();
    assert_eq!((&picture["pictures"], &picture["size_px"]), (&3.into(), &vec![64, 36].into()));
    let passes = picture["passes"].as_object().unwrap();
    let mut shares = 0.0;
    for (stage, pass) in passes {
        assert!(number(&pass["bytes"]) > 0.0, "{stage}: {pass}");
        shares += pass["share"].as_f64().unwrap_or(0.0);
    }
    for stage in ["anisotropy", "draw_fluid_depth", "draw_smooth_narrow_range", "draw_thickness", "draw_water"] {
        assert!(passes.contains_key(stage), "{stage}");
    }
    // Radiance and depth of 128 x 72 drawn pixels are drawn to, 12 bytes each, and a uniform or more is bound.
    let sky = number(&passes["draw_sky"]["bytes"]);
    assert!((12.0 * 128.0 * 72.0..12.1 * 128.0 * 72.0).contains(&sky), "{sky}");
    assert!((shares - 1.0).abs() < 1e-9, "{shares}");
    assert!((0.0..1.0).contains(&number(&picture["smoothing_share"])) && number(&picture["bytes"]) > 0.0);
    // What is not asked for is not drawn.
    let none = workshop.succeed(&["bench", "scene.toml", "--steps", "2", "--json"]).json();
    assert!(none["picture"].is_null());
}

#[test]
fn ways_to_sort_are_compared_in_pairs() {
    let workshop = Workshop::new();
    let arguments = ["bench", "sorting", "--particles", "5000", "--pairs", "3", "--json"];
    let compared = workshop.succeed(&arguments).json();
    assert_eq!(compared["particles"], 4096);
    let outcomes = compared["comparisons"].as_array().unwrap();
    for optimisation in ["locality", "aggregated atomics", "shared-memory scan", "bank-conflict padding"] {
        assert!(outcomes.iter().any(|outcome| outcome["optimisation"] == optimisation), "no {optimisation}");
    }
    for outcome in outcomes {
        assert_eq!(outcome["pairs"], 3, "{outcome}");
        let [low, median, high] = ["ratio_p10", "ratio", "ratio_p90"].map(|key| number(&outcome[key]));
        assert!(0.0 < low && low <= median && median <= high, "{outcome}");
        assert!(number(&outcome["baseline_ms"]) > 0.0 && number(&outcome["alternative_ms"]) > 0.0, "{outcome}");
    }
}

const WAYS: [&str; 11] = [
    "none",
    "gaussian",
    "bilateral",
    "bilateral-2d",
    "narrow-range",
    "curvature-flow 60",
    "ellipsoids",
    "ellipsoids, narrow-range",
    "mesh, cells d/2",
    "mesh, not smoothed",
    "density field",
];

#[test]
fn surfaces_are_held_against_known_bodies() {
    let workshop = Workshop::new();
    let bodies = ["sphere", "calm pool"];
    let chosen: Vec<&str> =
        bodies.iter().flat_map(|name| ["--body", name]).chain(WAYS.iter().flat_map(|name| ["--way", name])).collect();
    let size = ["--width", "192", "--height", "108", "--repeats", "1"];
    let files = ["--csv", "s.csv", "--plot", "s.svg", "--picture", "s.png", "--json"];
    let study = workshop.succeed(&[&["bench", "surfaces"], &chosen[..], &size, &files].concat()).json();
    let rows = study["rows"].as_array().unwrap();
    assert_eq!(rows.len(), bodies.len() * 3 * WAYS.len());
    let mean = |way: &str, shape: &str, figure: &str| -> f64 {
        let of = |row: &&Value| row["filter"] == way && row["shape"] == shape;
        rows.iter().filter(of).map(|row| number(&row[figure])).sum::<f64>() / 3.0
    };
    let mean_deg = |way: &str, shape: &str| mean(way, shape, "normal_mean_deg");
    for shape in bodies {
        for way in &WAYS[1..] {
            assert!(
                mean_deg(way, shape) < mean_deg("none", shape),
                "{way} leaves the {shape} rougher than it found it"
            );
        }
    }
    // The filter that scenes have by default follows a round body closely.
    assert!(mean_deg("narrow-range", "sphere") < 8.0, "{}", mean_deg("narrow-range", "sphere"));
    // Ellipsoids take away most of the bumps, and of what spheres stand out by.
    let outline = |way: &str| mean(way, "sphere", "outline_spacings");
    assert!(mean_deg("ellipsoids", "sphere") < 0.7 * mean_deg("none", "sphere"));
    assert!(outline("ellipsoids, narrow-range") < 0.5 * outline("narrow-range"));
    // Meshes are smoother with their normals smoothed, and flat where the water is.
    assert!(mean_deg("mesh, cells d/2", "sphere") < 0.8 * mean_deg("mesh, not smoothed", "sphere"));
    assert!(mean_deg("mesh, cells d/2", "calm pool") < 0.5 * mean_deg("narrow-range", "calm pool"));
    for row in rows {
        let drawn = row["filter"] != "density field";
        assert_eq!(row["surface_ms"].as_f64().is_some_and(|ms| ms > 0.0), drawn, "{row}");
        let smooths = drawn && !["none", "ellipsoids", "mesh, not smoothed"].iter().any(|name| row["filter"] == *name);
        assert_eq!(row["smoothing_ms"].as_f64().is_some_and(|ms| ms > 0.0), smooths, "{row}");
        assert!(number(&row["outline_spacings"]) < 1.0, "{row}");
    }
    let csv = |name: &str| std::fs::read_to_string(workshop.path(name)).unwrap();
    assert_eq!(csv("s.csv").lines().count(), 1 + rows.len());
    assert_eq!(csv("s.meshes.csv").lines().count(), 1 + study["meshes"].as_array().unwrap().len());
    let plot = std::fs::read_to_string(workshop.path("s.svg")).unwrap();
    for text in ["<svg", "narrow-range", "calm pool", "mesh, not smoothed", "Hausdorff"] {
        assert!(plot.contains(text), "no {text:?} in the plot");
    }
    assert!(!plot.contains("torus"), "a body that nobody asked for is in the plot");
    assert!(std::fs::metadata(workshop.path("s.png")).unwrap().len() > 10_000);
}

#[test]
fn meshes_are_held_against_known_bodies() {
    let workshop = Workshop::new();
    let small = ["--width", "64", "--height", "64", "--repeats", "1", "--json", "--way", "mesh, cells d/2"];
    let study = workshop.succeed(&[&["bench", "surfaces"], &small[..]].concat()).json();
    let meshes = study["meshes"].as_array().unwrap();
    assert_eq!(meshes.len(), 6);
    // At the default resolution they are within a spacing of their bodies and have 98 to 102 % of their volume. A box's
    // corner, which no particle fills, is a spacing and a bit off; a layer is thinner than a cell is long twice over.
    for mesh in meshes {
        let (farthest, volume) = match mesh["shape"].as_str().unwrap() {
            "box" => (1.2, 0.02),
            "sheet" => (1.0, 0.05),
            _ => (1.0, 0.02),
        };
        assert!(number(&mesh["hausdorff_spacings"]) < farthest, "{mesh}");
        assert!(number(&mesh["volume_error"]).abs() < volume, "{mesh}");
    }
}

/// A program that says its version and, asked for a mesh, does `then`; `$4` is the mesh's file.
#[cfg(unix)]
fn other_program(workshop: &Workshop, name: &str, then: &str) -> String {
    use std::os::unix::fs::PermissionsExt;
    let path = workshop.path(name);
    let script = format!("#!/bin/sh\n[ \"$1\" = --version ] && echo surfer 1.2 && exit\n{then}\n");
    std::fs::write(&path, script).unwrap();
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    path.to_string_lossy().into_owned()
}

/// An octahedron of half the sphere's radius around its middle, outward; the copied log gives 7 - 1 - 2 ms.
#[cfg(unix)]
const OCTAHEDRON: &str = r#"
printf '%s\n' '   surface reconstruction: 90.00%, 7.00ms avg, 1 call' \
    '    loading particle positions: 9.00%, 1.00ms avg, 1 call' '    write surface mesh to file: 9.00%, 2.00ms avg, 1 call'
cat > "$4" <<END
ply
format ascii 1.0
element vertex 6
property float x
property float y
property float z
property float nx
property float ny
property float nz
element face 8
property list uchar uint vertex_indices
end_header
0.625 0.5 0.5 1 0 0
0.375 0.5 0.5 -1 0 0
0.5 0.625 0.5 0 1 0
0.5 0.375 0.5 0 -1 0
0.5 0.5 0.625 0 0 1
0.5 0.5 0.375 0 0 -1
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
END"#;

#[cfg(unix)]
#[test]
fn another_program_is_held_against_the_same_bodies() {
    let workshop = Workshop::new();
    let bench = ["bench", "surfaces", "--body", "two spheres", "--body", "sphere", "--way", "mesh, cells d"];
    let size = ["--width", "64", "--height", "64", "--repeats", "1"];
    let run = |more: &[&str]| workshop.run(&[&bench[..], &size, more].concat());
    // What it is given: so many particles of 12 bytes, a radius, cells.
    let records = format!("wc -c < \"$2\" >> given; echo \"$@\" >> given\n{OCTAHEDRON}");
    let program = other_program(&workshop, "surfer", &records);
    let ended = run(&["--beside", &program, "--json", "--csv", "s.csv", "--plot", "s.svg"]);
    assert_eq!(ended.code, Some(0), "{}", ended.stderr);
    let study = ended.json();
    let meshes = study["meshes"].as_array().unwrap();
    let names: Vec<&str> = meshes.iter().map(|mesh| mesh["mesh"].as_str().unwrap()).collect();
    assert_eq!(names[..3], ["mesh, cells d", "surfer 1.2, cells d", "surfer 1.2, smoothed, cells d"]);
    assert_eq!(names.len(), 6);
    for mesh in meshes.iter().filter(|mesh| mesh["program"] == "surfer 1.2" && mesh["shape"] == "sphere") {
        // Of half the radius: (4/3 r³/8) of 4/3 pi r³, and nowhere nearer than its corners.
        let volume = 1.0 / (8.0 * std::f64::consts::PI) - 1.0;
        assert!((number(&mesh["volume_error"]) - volume).abs() < 1e-6, "{mesh}");
        assert!((3.0..30.0).contains(&number(&mesh["mean_spacings"])), "{mesh}");
        // The sphere's normals at the corners are the mesh's.
        assert!(number(&mesh["normal_mean_deg"]) < 0.01, "{mesh}");
        assert_eq!((number(&mesh["ms"]), &mesh["bytes"], &mesh["triangles"]), (4.0, &Value::Null, &8.into()));
    }
    let given = std::fs::read_to_string(workshop.path("given")).unwrap();
    let lines: Vec<&str> = given.lines().collect();
    assert_eq!(lines.len(), 8);
    assert_eq!(lines[0].trim().parse::<usize>().unwrap() % 12, 0);
    assert!(lines[1].contains("-r 0.01 -l 2.0 -c 2 -t 0.6 --normals=on") && !lines[1].contains("smoothing-iters"));
    assert!(lines[3].contains("--mesh-smoothing-iters=25 --normals-smoothing-iters=10"), "{given}");
    for name in ["s.meshes.csv", "s.svg"] {
        assert!(std::fs::read_to_string(workshop.path(name)).unwrap().contains("surfer 1.2, smoothed"), "{name}");
    }
    for (name, then, word) in [
        ("fails", "echo 'no such kernel' >&2; exit 3", "exit status: 3: no such kernel"),
        ("writes-nothing", "exit 0", "wrote no mesh"),
        ("writes-words", "echo hello > \"$4\"", "cannot be read"),
    ] {
        let program = other_program(&workshop, name, then);
        let ended = run(&["--beside", &program, "--csv", "wrong.csv"]);
        assert_eq!(ended.code, Some(2), "{}", ended.stderr);
        assert!(ended.stderr.contains(&program) && ended.stderr.contains(word), "{}", ended.stderr);
        assert_eq!(ended.stderr.trim().lines().count(), 1, "{}", ended.stderr);
        assert!(ended.stdout.is_empty() && !workshop.has("wrong.csv"), "{}", ended.stdout);
    }
}

#[test]
fn a_wrong_wish_is_told_before_anything_is_timed() {
    let workshop = Workshop::new();
    let cases: [(&[&str], &str); 12] = [
        (&["bench", "surfaces", "--width", "3"], "--width"),
        (&["bench", "surfaces", "--csv", "no/such/folder.csv"], "no/such/folder.csv"),
        (&["bench", "surfaces", "--body", "cube"], "two spheres"),
        (&["bench", "surfaces", "--way", "median"], "narrow-range"),
        (&["bench", "surfaces", "--body", "sheet", "--way", "none"], "none of these ways meshes"),
        (&["bench", "surfaces", "--beside", "no-such-program"], "--beside no-such-program"),
        (&["bench", "sorting", "--pairs", "0"], "--pairs"),
        (&["bench", "--plot", "no/such/folder.svg"], "no/such/folder.svg"),
        (&["bench", "--set", "forces.xsph=7"], "forces.xsph"),
        (&["bench", "--max-particles", "10"], "--max-particles"),
        (&["bench", "--steps", "3"], "SCENE"),
        (&["bench", "scene.toml", "--plot", "a.svg"], "--plot"),
    ];
    for (arguments, word) in cases {
        let ended = workshop.run(arguments);
        assert_eq!(ended.code, Some(2), "{arguments:?}: {}", ended.stderr);
        assert!(ended.stderr.contains(word) && ended.stdout.is_empty(), "{arguments:?}: {}", ended.stderr);
    }
}
