//! The fluid's surface as a file: of a run, and of anybody's particles; read by an independent reader.

use brooklet_capture::Capture;
use brooklet_tests::mesh_files::{ball, ply_of, read_closed_obj, scene_of_drops, volume};
use brooklet_tests::program::Workshop;
use brooklet_tests::python::read_in_python;
use glam::DVec3;
use serde_json::Value;

use crate::bad_input::assert_refused;

const SPACING_M: f64 = 0.05;

#[test]
fn trimesh_calls_an_exported_ball_watertight() {
    let workshop = Workshop::new();
    let (middle_m, radius) = (DVec3::new(100.0, -20.0, 3.0), 10);
    let particles_m = ball(middle_m, radius, SPACING_M);
    std::fs::write(workshop.path("ball.ply"), ply_of(&particles_m)).unwrap();
    let expected_m3 = particles_m.len() as f64 * SPACING_M.powi(3);
    for name in ["mesh.ply", "mesh.obj"] {
        let said = workshop.succeed(&["mesh", "ball.ply", "--spacing", "0.05", "--out", name, "--json"]).json();
        assert_eq!(said["particles"], particles_m.len());
        let Some(seen) = read_in_python("read_mesh.py", &workshop.path(name)) else { continue };
        let seen = seen.unwrap();
        let number = |value: &Value| value.as_f64().unwrap();
        assert_eq!((&seen["vertices"], &seen["triangles"]), (&said["vertices"], &said["triangles"]), "{name}");
        for what in ["is_watertight", "is_winding_consistent", "is_volume", "merged_is_watertight"] {
            assert_eq!(seen[what], true, "{name}: {what}");
        }
        assert_eq!((&seen["euler_number"], &seen["merged_vertices"]), (&2.into(), &seen["vertices"]), "{name}");
        let (seen_m3, said_m3) = (number(&seen["volume_m3"]), number(&said["volume_m3"]));
        assert!((seen_m3 / expected_m3 - 1.0).abs() < 0.02, "{name}: {seen_m3} for {expected_m3} m3");
        // The file's positions are 32 bits of numbers around 100 m.
        assert!((seen_m3 / said_m3 - 1.0).abs() < 1e-3, "{name}: {seen_m3} and {said_m3} m3");
        for axis in 0..3 {
            let reach_m = f64::from(radius) * SPACING_M;
            let [low_m, high_m] = [number(&seen["min_m"][axis]), number(&seen["max_m"][axis])];
            let off_m = [middle_m[axis] - reach_m - low_m, high_m - middle_m[axis] - reach_m];
            assert!(off_m.iter().all(|off_m| off_m.abs() < SPACING_M), "{name}: {low_m} to {high_m} along {axis}");
        }
        assert!(number(&seen["outward_normals"]) > 0.999 && number(&seen["normal_length_error"]) < 1e-5, "{name}");
    }
    read_closed_obj(&workshop.path("mesh.obj")).expect("each edge has two sides");
    // Both readers can say no: a triangle is missing.
    let text = std::fs::read_to_string(workshop.path("mesh.obj")).unwrap();
    let (without_last, _) = text.trim_end().rsplit_once('\n').unwrap();
    std::fs::write(workshop.path("open.obj"), without_last).unwrap();
    assert!(read_closed_obj(&workshop.path("open.obj")).is_err());
    if let Some(seen) = read_in_python("read_mesh.py", &workshop.path("open.obj")) {
        let seen = seen.unwrap();
        assert_eq!((&seen["is_watertight"], &seen["is_volume"]), (&false.into(), &false.into()));
    }
}

#[test]
fn a_run_ends_with_its_surface() {
    let workshop = Workshop::new();
    let run = ["run", "scene.toml", "--steps", "4", "--mesh", "obj", "--out", "out"];
    let ended = workshop.succeed(&run);
    assert!(ended.stdout.contains("mesh      out/mesh.obj ("), "{}", ended.stdout);
    let summary = workshop.json("out/summary.json");
    let mesh = read_closed_obj(&workshop.path("out/mesh.obj")).unwrap();
    let said = &summary["mesh"];
    assert_eq!((&said["vertices"], &said["triangles"]), (&mesh.vertices_m.len().into(), &mesh.triangles.len().into()));
    assert_eq!(said["file"], "out/mesh.obj");
    // 64 particles of 5 cm in the corner of a tank; edges in the open are rounded.
    let particles_m3 = 64.0 * SPACING_M.powi(3);
    assert!((0.85..1.05).contains(&(volume(&mesh) / particles_m3)), "{} of {particles_m3} m3", volume(&mesh));
    let corner_m = DVec3::new(1.0, 2.0, 3.0);
    for at_m in &mesh.vertices_m {
        let inside_m = *at_m - corner_m;
        assert!(inside_m.min_element() > -1e-6 && inside_m.max_element() < 0.4 + 1e-6, "{at_m}");
    }
    // The frames do not know of it, and there is none unless asked for.
    assert!(summary["passes"].as_object().unwrap().keys().all(|stage| !stage.contains("mesh")));
    workshop.succeed(&["run", "scene.toml", "--steps", "1", "--out", "plain"]);
    assert!(workshop.json("plain/summary.json")["mesh"].is_null() && !workshop.has("plain/mesh.ply"));
}

#[test]
fn a_picture_whose_mesh_lacks_room_is_drawn_again_with_more() {
    let workshop = Workshop::new();
    std::fs::write(workshop.path("drops.toml"), scene_of_drops()).unwrap();
    let ended = workshop.succeed(&["run", "drops.toml", "--steps", "4", "--out", "drops", "--mesh", "obj"]);
    let summary = workshop.json("drops/summary.json");
    let drawn = &summary["drawn_meshes"];
    // The first picture's; the second has the room.
    assert_eq!((&drawn["without_room"], &drawn["cut_short"]), (&1.into(), &0.into()), "{drawn}");
    assert!(drawn["lost_blocks"].as_u64().unwrap() > 0, "{drawn}");
    assert!(ended.stdout.contains("meshes that lacked room: 1, for "), "{}", ended.stdout);
    // What the last picture drew is what was exported.
    for what in ["vertices", "triangles", "blocks"] {
        assert_eq!(drawn[what], summary["mesh"][what], "{what}");
    }
    assert!(workshop.has("drops/frame_0001.png") && !workshop.has("drops/frame_0002.png"));
    let capture = Capture::open(&workshop.path("drops/capture.mcap")).unwrap();
    // Four steps, and a picture once more.
    assert!(capture.complete && capture.frames.len() == 5, "{}", capture.frames.len());
    assert!(capture.frames.windows(2).all(|pair| pair[0].frame + 1 == pair[1].frame));
    workshop.succeed(&["capture", "check", "drops/capture.mcap"]);
    // Pictures are drawn after the second and the fourth step, which are measured as well.
    let lost: Vec<f64> = capture.stats.iter().map(|row| row.values["mesh_lost_blocks"]).collect();
    assert_eq!(lost, [0.0, drawn["lost_blocks"].as_f64().unwrap(), 0.0, 0.0]);
    assert_eq!(capture.stats[3].values["mesh_triangles"], drawn["triangles"].as_f64().unwrap());
}

#[test]
fn particles_of_any_kind_are_meshed() {
    let workshop = Workshop::new();
    let mut particles_m = ball(DVec3::splat(0.5), 4, SPACING_M);
    let count = particles_m.len();
    particles_m.extend([DVec3::splat(f64::NAN), DVec3::new(0.0, f64::INFINITY, 0.0)]);
    std::fs::write(workshop.path("p.ply"), ply_of(&particles_m)).unwrap();
    let ended = workshop.succeed(&["mesh", "p.ply", "--out", "m.obj"]);
    for line in [
        format!("particles {count}\n"),
        "2 more are left out: their positions are not finite".into(),
        "(estimated: half of them have their six nearest within)".into(),
        "file      m.obj".into(),
    ] {
        assert!(ended.stdout.contains(&line), "{line}: {}", ended.stdout);
    }
    let estimated = workshop.succeed(&["mesh", "p.ply", "--out", "m.obj", "--json"]).json();
    let spacing_m = estimated["spacing_m"].as_f64().unwrap();
    // In so small a ball half of the particles are at its rim, and look further for six.
    assert!((spacing_m / SPACING_M - 1.0).abs() < 0.1 && estimated["not_finite"] == 2, "{spacing_m}");
    // Through its middle goes a wall: the mesh ends there, flat.
    let walls = ["--walls", "0.5", "-1", "-1", "2", "2", "2"];
    let halved = [&["mesh", "p.ply", "--spacing", "0.05", "--out", "half.obj", "--json"][..], &walls].concat();
    let halved = workshop.succeed(&halved).json();
    assert_eq!(halved["particles"].as_u64().unwrap() + halved["outside"].as_u64().unwrap(), count as u64);
    let mesh = read_closed_obj(&workshop.path("half.obj")).unwrap();
    assert!(mesh.vertices_m.iter().all(|at_m| at_m.x > 0.5 - 1e-6));
    // What has no spacing of its own has one that is said; the file that was there is replaced.
    for particles_m in [vec![DVec3::ONE], vec![DVec3::ONE; 1000]] {
        std::fs::write(workshop.path("few.ply"), ply_of(&particles_m)).unwrap();
        workshop.succeed(&["mesh", "few.ply", "--spacing", "0.05", "--out", "few.obj"]);
        let drop = volume(&read_closed_obj(&workshop.path("few.obj")).unwrap()) / SPACING_M.powi(3);
        assert!((0.2..0.8).contains(&drop), "{drop} spacings cubed");
    }
    assert_eq!(std::fs::read_dir(workshop.path(".")).unwrap().flatten().filter(is_temporary).count(), 0);
}

fn is_temporary(entry: &std::fs::DirEntry) -> bool {
    entry.file_name().to_string_lossy().starts_with(".brooklet-")
}

#[test]
fn files_without_particles_are_refused() {
    let workshop = Workshop::new();
    let header = |body: &str| format!("ply\nformat ascii 1.0\n{body}end_header\n");
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let rows: &[(String, &[&str])] = &[
        (String::new(), &["is no PLY file"]),
        ("\u{89}PNG\r\n".into(), &["is no PLY file"]),
        ("ply\nformat ascii 1.0\nelement".into(), &["its header cannot be read"]),
        (header("element vertex many\n"), &["its header cannot be read", "many"]),
        (header(""), &["has no particles", "no elements at all"]),
        (header("element face 0\nproperty list uchar int vertex_indices\n"), &["has no particles", "it has face"]),
        (header("element vertex 1\nproperty float x\nproperty float density\n"), &["no field y", "x, density"]),
        (header("element vertex 1\n"), &["no field x", "no fields"]),
        (header(&format!("element vertex 1\nproperty list uchar float x\n{xyz}")), &["field x is a list"]),
        (header(&format!("element vertex 0\n{xyz}")), &["has no particles", "no rows"]),
        (header(&format!("element vertex 3\n{xyz}")) + "1 2 3\n4 5", &["it is cut off", "3 rows of element vertex"]),
        (header(&format!("element vertex 1\n{xyz}")) + "1 two 3\n", &["element vertex cannot be read"]),
        (header(&format!("element vertex 1\n{xyz}")) + "1 nan 3\n", &["none of its 1 particles", "finite"]),
        (header(&format!("element vertex 1\n{xyz}")) + "1 2e30 3\n", &["e30", "-1e12 to 1e12"]),
        (header(&format!("element vertex 1\n{xyz}")) + "1 2 3\n", &["one particle has no spacing", "--spacing"]),
        (header(&format!("element vertex 3\n{xyz}")) + &"1 2 3\n".repeat(3), &["in one place", "--spacing"]),
        (format!("ply\nformat binary_big_endian 1.0\nelement vertex 9\n{xyz}end_header\n1234"), &["it is cut off"]),
    ];
    for (content, words) in rows {
        std::fs::write(workshop.path("p.ply"), content).unwrap();
        let words: Vec<&str> = ["p.ply: "].iter().chain(*words).copied().collect();
        assert_refused(&workshop, &["mesh", "p.ply", "--out", "m.ply"], &words);
    }
    std::fs::create_dir(workshop.path("folder.ply")).unwrap();
    assert_refused(&workshop, &["mesh", "folder.ply", "--out", "m.ply"], &["folder.ply: is a folder"]);
    assert_refused(&workshop, &["mesh", "no.ply", "--out", "m.ply"], &["no.ply: cannot be read"]);
    #[cfg(target_os = "linux")]
    assert_refused(&workshop, &["mesh", "/dev/zero", "--out", "m.ply"], &["/dev/zero: is no PLY file"]);
}

#[test]
fn what_cannot_be_meshed_or_written_is_refused() {
    let workshop = Workshop::new();
    std::fs::write(workshop.path("p.ply"), ply_of(&ball(DVec3::ZERO, 3, SPACING_M))).unwrap();
    let far_m = [DVec3::ZERO, DVec3::splat(0.05), DVec3::splat(1000.0)];
    std::fs::write(workshop.path("far.ply"), ply_of(&far_m)).unwrap();
    std::fs::create_dir(workshop.path("folder.obj")).unwrap();
    let rows: &[(&[&str], &[&str])] = &[
        (&["p.ply", "--out", "m.stl"], &["--out m.stl", ".ply or .obj"]),
        (&["p.ply", "--out", "m"], &["--out m", ".ply or .obj"]),
        (&["p.ply"], &["--out <FILE>"]),
        (&["p.ply", "--out", "no/such/m.ply"], &["--out no/such/m.ply: cannot be written", "No such file"]),
        (&["p.ply", "--out", "p.ply/m.ply"], &["--out p.ply/m.ply: cannot be written"]),
        (&["p.ply", "--out", "folder.obj"], &["--out folder.obj: is a folder"]),
        (&["p.ply", "--out", "m.ply", "--spacing", "nan"], &["--spacing", "from 1e-12 to 1e12"]),
        (&["p.ply", "--out", "m.ply", "--spacing", "-1"], &["--spacing", "from 1e-12 to 1e12"]),
        (&["p.ply", "--out", "m.ply", "--cell", "x"], &["--cell", "as in 0.5x"]),
        (&["p.ply", "--out", "m.ply", "--walls", "0", "0", "0", "1", "-1", "1"], &["--walls", "above the first"]),
        (&["p.ply", "--out", "m.ply", "--walls", "8", "8", "8", "9", "9", "9"], &["--walls", "none of the"]),
        (
            &["far.ply", "--out", "m.ply", "--spacing", "0.05"],
            &["far.ply", "too small here", "blocks", "m fit (--cell)"],
        ),
    ];
    for (arguments, words) in rows {
        assert_refused(&workshop, &[&["mesh"], *arguments].concat(), words);
    }
    assert_refused(&workshop, &["run", "scene.toml", "--mesh", "stl"], &["--mesh", "ply, obj"]);
    // Neither is a run begun that could not end with its mesh.
    let wide = "domain.max_m=[2000, 2000, 2000]";
    let run = ["run", "scene.toml", "--set", wide, "--steps", "1", "--mesh", "ply", "--out", "out"];
    assert_refused(&workshop, &run, &["scene scene: --mesh: cells of", "too small here", "m fit"]);
}
