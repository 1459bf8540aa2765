//! Bad input, one row each: one message that names what is wrong, exit code 2, nothing written.
//! `app/desktop/BAD_INPUT.md` has the same rows.

use std::path::Path;

use brooklet_fluid::Scene;
use brooklet_fluid::particles::sample_lattice;
use brooklet_tests::program::{Ended, SCENE, Workshop, without_fluid};
use brooklet_tests::states::{OLD_SCENE, of_version, state_of, version_1, with_section};

/// The run of a bad input must end so, and leave the folder as it was.
pub fn assert_refused(workshop: &Workshop, arguments: &[&str], words: &[&str]) {
    let before = listing(&workshop.path("."));
    let ended = workshop.run(arguments);
    assert_refusal(&ended, arguments, words);
    assert_eq!(listing(&workshop.path(".")), before, "{arguments:?} left something behind");
}

fn assert_refusal(ended: &Ended, arguments: &[&str], words: &[&str]) {
    let Ended { code, stdout, stderr } = ended;
    assert_eq!(*code, Some(2), "{arguments:?}: {stderr}");
    for word in words {
        assert!(stderr.contains(word), "{arguments:?}: no {word:?} in {stderr}");
    }
    assert!(!stderr.contains("panicked"), "{arguments:?}: {stderr}");
    assert!(stdout.is_empty(), "{arguments:?}: {stdout}");
    // A driver may have something to say as well.
    let errors: Vec<&str> = stderr.lines().filter(|line| line.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 1, "{arguments:?}: {stderr}");
    let is_claps = stderr.contains("For more information, try '--help'");
    assert!(is_claps || stderr.trim_end().lines().last() == Some(errors[0]), "{arguments:?}: {stderr}");
    assert!(errors[0].len() < 600, "{arguments:?}: a long message: {stderr}");
}

fn listing(folder: &Path) -> Vec<(String, u64)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = entry.path().display().to_string();
        // The driver's own caches lie below XDG_RUNTIME_DIR.
        found.push((name, entry.metadata().unwrap().len()));
        if entry.path().is_dir() {
            found.extend(listing(&entry.path()));
        }
    }
    found.sort();
    found
}

/// `SCENE` with one line replaced.
fn scene(from: &str, to: &str) -> String {
    assert!(SCENE.contains(from), "{from}");
    SCENE.replacen(from, to, 1)
}

#[test]
fn scene_files_that_are_none() {
    let workshop = Workshop::new();
    let deep = format!("x = {}", "[".repeat(100_000));
    let rows: &[(&str, &[u8], &[&str])] = &[
        ("empty.toml", b"", &["empty.toml", "spacing_m is missing"]),
        ("not-text.toml", b"spacing_m = 1\n\xff\xfe", &["not-text.toml", "byte 14 is no UTF-8"]),
        ("not-toml.toml", b"spacing_m = \n", &["not-toml.toml:1:"]),
        ("picture.toml", b"\x89PNG\r\n\x1a\n", &["picture.toml", "byte 0 is no UTF-8"]),
        ("huge.toml", &[b'#'; 1_048_577], &["huge.toml", "1048576 bytes"]),
        ("deep.toml", deep.as_bytes(), &["deep.toml:1:", "recurs"]),
        ("twice.toml", b"spacing_m = 1\nspacing_m = 1\n", &["twice.toml:2:1", "duplicate key", "spacing_m = 1"]),
    ];
    for (name, bytes, words) in rows {
        std::fs::write(workshop.path(name), bytes).unwrap();
        assert_refused(&workshop, &["run", name, "--steps", "1"], words);
    }
    std::fs::create_dir(workshop.path("folder.toml")).unwrap();
    assert_refused(&workshop, &["run", "folder.toml"], &["folder.toml", "directory"]);
    assert_refused(&workshop, &["run", "no/such.toml"], &["no/such.toml", "neither a file nor a shipped scene"]);
    assert_refused(&workshop, &["run", "scene.toml/below"], &["scene.toml/below", "Not a directory"]);
    assert_refused(&workshop, &["run", "scene.toml", "--clip"], &["--clip", "no pictures", "--images 1"]);
    assert_refused(&workshop, &["run", "dam-brake"], &["dam-brake", "did you mean dam-break"]);
    #[cfg(target_os = "linux")]
    assert_refused(&workshop, &["run", "/dev/zero"], &["/dev/zero", "1048576 bytes"]);
}

#[test]
fn scene_files_with_wrong_values() {
    let workshop = Workshop::new();
    let block = "block = { min_m = [1.0, 2.0, 3.0], max_m = [1.2, 2.2, 3.2] }";
    let many = format!("{SCENE}{}", format!("[[fluid]]\n{block}\n").repeat(128));
    let camera = format!("{SCENE}[camera]\neye_m = [1, 0, 0]\ntarget_m = [1, 0, 0]\n");
    let domain = "max_m = [1.4, 2.4, 3.4]";
    let rows: &[(String, &str, &[&str])] = &[
        // Wrong types.
        (scene("spacing_m = 0.05", "spacing_m = \"5 cm\""), "spacing_m = \"5 cm\"", &["a number from 1e-6", ":3:13"]),
        (scene("images = 0", "images = 1.5"), "outputs.images = 1.5", &["a whole number from 0 to 100000"]),
        (scene("images = 0", "images = -1"), "outputs.images = -1", &["a whole number from 0 to 100000"]),
        (scene("images = 0", "images = 4000000000"), "outputs.images = 4000000000", &["0 to 100000"]),
        (scene("width_px = 64", "width_px = 1000000"), "outputs.width_px = 1000000", &["1 to 8192 pixels"]),
        (scene(domain, "max_m = [1.4, 2.4]"), "domain.max_m = [1.4, 2.4]", &["three numbers"]),
        (scene(block, "block = 3"), "fluid.0.block = 3", &["a table of keys"]),
        (scene(block, "block = { min_m = [1, 2, 3] }"), "fluid.0.block.max_m is missing", &["three numbers"]),
        // Unknown keys.
        (scene("spacing_m", "spacing"), "unknown key `spacing`", &["did you mean `spacing_m`"]),
        (scene(block, "blok = 1"), "unknown key `blok`", &["did you mean `block`", ":8:1"]),
        // Not finite, not positive, absurd.
        (scene("spacing_m = 0.05", "spacing_m = 0.05\ncapacity = 7"), "capacity = 7", &["64 or more", "begins with"]),
        (scene("spacing_m = 0.05", "spacing_m = 0.05\ncapacity = 0"), "capacity = 0", &["1 to 16777216"]),
        (scene("spacing_m = 0.05", "spacing_m = 0.05\ncapacity = 2e9"), "capacity", &["1 to 16777216"]),
        (scene("spacing_m = 0.05", "spacing_m = nan"), "spacing_m = nan", &["1e-6 to 1000 m"]),
        (scene("spacing_m = 0.05", "spacing_m = -0.05"), "spacing_m = -0.05", &["1e-6 to 1000 m"]),
        (scene("spacing_m = 0.05", "spacing_m = 1e-30"), "spacing_m = 1e-30", &["1e-6 to 1000 m"]),
        (scene("spacing_m = 0.05", "spacing_m = 1e30"), "spacing_m = 1e30", &["1e-6 to 1000 m"]),
        (scene(domain, "max_m = [1e30, 1e30, 1e30]"), "domain.max_m = [1e30, 1e30, 1e30]", &["-1e6 to 1e6 m"]),
        (scene(domain, "max_m = [inf, 2.4, 3.4]"), "domain.max_m = [inf, 2.4, 3.4]", &["-1e6 to 1e6 m"]),
        (scene(domain, "max_m = [1.0, 2.4, 3.4]"), "domain.max_m = [1, 2.4, 3.4]", &["above min_m = [1, 2, 3]"]),
        (scene(domain, "max_m = [1.01, 2.4, 3.4]"), "domain = [0.01, 0.4, 0.4] m", &["at least spacing_m = 0.05"]),
        (scene(domain, "max_m = [9e3, 2.4, 3.4]"), "domain = [8999, 0.4, 0.4] m", &["spacing_m 0.138 or more"]),
        // Periodic axes and two dimensions. h = 0.1 m, so a periodic side is a multiple of 0.4 m.
        (
            scene(domain, "max_m = [1.5, 2.4, 3.4]\nperiodic = [true, false, false]"),
            "domain.periodic = [true, false, false]",
            &["a whole multiple of 4 h", "= 0.4 m", "along x is 0.5 m, 0.4 or 0.8 would do"],
        ),
        (
            scene(domain, "max_m = [1.4, 2.4, 3.1]\nperiodic = [true, false, true]"),
            "domain.periodic = [true, false, true]",
            &["along z is 0.1 m, 0.4 or 0.8 would do"],
        ),
        (scene(domain, "max_m = [1.4, 2.4, 3.4]\nperiodic = true"), "domain.periodic = true", &["three of true or"]),
        (
            scene(domain, "max_m = [1.4, 2.4, 3.4]\nperiodic = [true, false]"),
            "domain.periodic = [true, false]",
            &["three of true or false"],
        ),
        (scene(domain, "max_m = [1.4, 2.4, 3.4]\ndimensions = 1"), "domain.dimensions = 1", &["from 2 to 3"]),
        (
            scene(domain, "max_m = [1.4, 2.4, 3.4]\ndimensions = 2\nperiodic = [false, false, true]"),
            "domain.periodic = [false, false, true]",
            &["two dimensions have no axis z"],
        ),
        (
            scene("spacing_m", "gravity_m_s2 = [0, 0, 1]\nspacing_m")
                .replace(domain, "max_m = [1.4, 2.4, 3.4]\ndimensions = 2"),
            "gravity_m_s2 = [0, 0, 1]",
            &["must be 0 along z"],
        ),
        (
            scene(domain, "max_m = [1.4, 2.4, 3.4]\ndimensions = 2")
                .replace(block, &format!("velocity_m_s = [1, 0, 2]\n{block}")),
            "fluid.0.velocity_m_s = [1, 0, 2]",
            &["must be 0 along z"],
        ),
        (
            scene(domain, "max_m = [1.4, 2.4, 4.4]\ndimensions = 2"),
            "fluid.0.block",
            &["no room for a particle", "the plane z = 3.7"],
        ),
        // Fluids.
        (scene(block, ""), "fluid.0 = nothing", &["`block`, `sphere` and `cylinder`"]),
        (scene("max_m = [1.2, 2.2", "max_m = [1.2, 2.6"), "fluid.0.block", &["inside the domain, [1, 2, 3] to [1.4"]),
        (scene("max_m = [1.2, 2.2", "max_m = [1.2, 2.01"), "fluid.0.block", &["no room for a particle"]),
        (many, "fluid = 129 fluids", &["at most 127"]),
        // More than fits.
        (
            scene("spacing_m = 0.05", "spacing_m = 0.0013").replace("[1.2, 2.2, 3.2]", "[1.4, 2.4, 3.4]"),
            "spacing_m = 0.0013",
            &["2.922e7 particles", "16777216 fit", "make it 0.00158 or more"],
        ),
        // Keys that have moved.
        (
            scene("[[fluid]]", "[solver]\niterations = 4\nxsph = 0.02\n[[fluid]]"),
            "",
            &["solver.iterations = 4 is now solver.pbf.iterations, solver.xsph = 0.02 is now forces.xsph"],
        ),
        (camera, "camera.eye_m = [1, 0, 0]", &["away from target_m"]),
    ];
    for (text, field, words) in rows {
        std::fs::write(workshop.path("bad.toml"), text).unwrap();
        let all: Vec<&str> = [&["scene bad.toml", *field], *words].concat();
        assert_refused(&workshop, &["plan", "bad.toml"], &all);
        assert_refused(&workshop, &["run", "bad.toml", "--steps", "1"], &all);
    }
}

#[test]
fn command_lines_that_cannot_be_done() {
    let workshop = Workshop::new();
    std::fs::write(workshop.path("file"), "mine").unwrap();
    std::fs::create_dir(workshop.path("folder")).unwrap();
    let rows: &[(&[&str], &[&str])] = &[
        (&["--set", "solver.pbf.iteration=8"], &["`iteration`", "did you mean `iterations`"]),
        (&["--set", "solver.pbf.iterations"], &["--set solver.pbf.iterations", "path=value"]),
        (&["--set", "solver.iterations=8"], &["--set solver.iterations=8", "the key is now solver.pbf.iterations"]),
        (&["--set", "solver.pbf.relaxation=7"], &["scene.toml", "solver.pbf.relaxation = 7", "0.001 to 1"]),
        (&["--set", "solver.pbf.iterations=many"], &["solver.pbf.iterations = \"many\"", "whole number"]),
        (
            &["--set", "solver.substeps=1000", "--set", "solver.pbf.iterations=1000"],
            &["solver.pbf.iterations", "at most 10000"],
        ),
        (&["--seconds", "-1"], &["--seconds", "-1"]),
        (&["--seconds", "nan"], &["--seconds", "nan"]),
        (&["--seconds", "1e300"], &["--seconds", "2.400e302 steps", "1 to 1000000000 are possible"]),
        (&["--steps", "0"], &["--steps", "0"]),
        (&["--steps", "9223372036854775808"], &["--steps", "9223372036854775808", "1..=1000000000"]),
        (&["--steps", "1", "--seconds", "1"], &["--seconds", "--steps"]),
        (&["--images", "4000000000"], &["--images", "4000000000", "0..=100000"]),
        (&["--tier", "phone"], &["--tier", "phone", "floor"]),
        (&["--device", "no such device"], &["no such device", "there are"]),
        (&["--particles", "xyz"], &["--particles", "xyz", "ply"]),
        (&["--frobnicate"], &["--frobnicate"]),
        // Places to write to.
        (&["--out", "file"], &["--out file", "is a file"]),
        (&["--out", "file/below"], &["--out file", "cannot create the folder"]),
        (&["--out", ".."], &["--out ..", "name a folder"]),
        (&["--capture", "folder"], &["folder: cannot create", "directory"]),
        (&["--capture", "no/such/c.mcap"], &["no/such/c.mcap: cannot create"]),
        (&["--capture", "file"], &["file: cannot create", "is no capture; it is kept"]),
        (&["--capture", "scene.toml"], &["scene.toml: cannot create", "it is kept"]),
        (&["--capture", "c.mcap", "--no-capture"], &["--capture", "--no-capture"]),
    ];
    for (options, words) in rows {
        let steps: &[&str] =
            if options.iter().any(|o| ["--steps", "--seconds"].contains(o)) { &[] } else { &["--steps", "1"] };
        assert_refused(&workshop, &[&["run", "scene.toml"], *options, steps].concat(), words);
    }
    assert_eq!(std::fs::read_to_string(workshop.path("file")).unwrap(), "mine");
    // The table can fail: the same call without a mistake ends well.
    workshop.succeed(&["run", "scene.toml", "--steps", "1"]);
}

/// Nobody, not even root, makes folders there.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_cannot_be_written_to() {
    let workshop = Workshop::new();
    assert_refused(
        &workshop,
        &["run", "scene.toml", "--steps", "1", "--out", "/proc/brooklet"],
        &["--out /proc/brooklet"],
    );
    assert_refused(
        &workshop,
        &["run", "scene.toml", "--steps", "1", "--out", "made/for/it", "--capture", "/dev/full"],
        &["/dev/full", "No space left on device"],
    );
}

#[test]
fn more_particles_than_a_binding_holds() {
    let workshop = Workshop::new();
    // A binding of the floor tier holds 128 MiB: at 2 bytes a slot, 1024 slots of 65,536 particles.
    let settings = ["--tier", "floor", "--set", "solver.neighbour_slots=1024", "--set", "spacing_m=0.0046"];
    let too_many = [&["run", "scene.toml", "--steps", "1"], &settings[..]].concat();
    let ended = workshop.run(&too_many);
    assert_refusal(&ended, &too_many, &["scene scene: does not fit", "as floor", "buffer ", "134217728"]);
    let number_behind = |word: &str| -> f64 {
        let rest = ended.stderr.split(word).nth(1).unwrap_or_else(|| panic!("no {word:?} in {}", ended.stderr));
        rest.split([',', ' ', '\n']).next().unwrap().parse().unwrap_or_else(|error| panic!("{rest}: {error}"))
    };
    // 43 along each side of the block. How many fit is the layout's matter.
    assert!(ended.stderr.contains(" of 79507 particles fit"), "{}", ended.stderr);
    assert!((1.0..79507.0).contains(&number_behind("(max_storage_buffer_binding_size): ")));
    // Both ways out that it names are enough.
    for (setting, value) in [
        ("spacing_m", number_behind("spacing_m = ")),
        ("solver.neighbour_slots", number_behind("solver.neighbour_slots = ")),
    ] {
        let setting = format!("{setting}={value}");
        let plan = workshop.succeed(&[&["plan", "scene.toml", "--json"], &settings[..], &["--set", &setting]].concat());
        let largest = plan.json()["buffers"].as_object().unwrap().values().filter_map(|b| b.as_u64()).max().unwrap();
        assert!(largest <= 128 << 20, "{setting}: {largest}");
    }
}

#[test]
fn what_is_unusual_but_right_runs() {
    let workshop = Workshop::new();
    std::fs::write(workshop.path("none.toml"), without_fluid()).unwrap();
    let written = ["--steps", "4", "--images", "1", "--particles", "ply"];
    workshop.succeed(&[&["run", "none.toml", "--out", "none"], &written[..]].concat());
    let summary = workshop.json("none/summary.json");
    assert_eq!((summary["particles"].as_u64(), summary["steps"].as_u64()), (Some(0), Some(4)));
    assert!(workshop.has("none/frame_0000.png") && workshop.has("none/particles_0000.ply"));
    // 1, 2 and 3 cells an axis: a cell is as wide as a spacing.
    for cells in 1..=3 {
        let name = format!("cells-{cells}");
        let side = |low: f64| low + 0.05 * f64::from(cells) - 1e-9;
        let domain = format!("domain.max_m=[{}, {}, {}]", side(1.0), side(2.0), side(3.0));
        let fluid = "fluid.0.block.max_m=[1.05, 2.05, 3.05]";
        workshop.succeed(&["run", "scene.toml", "--set", &domain, "--set", fluid, "--steps", "20", "--out", &name]);
        let summary = workshop.json(&format!("{name}/summary.json"));
        assert_eq!(summary["particles"], 1);
        let counted = &summary["counters"];
        for event in ["neighbour_overflow", "quarantined", "escaped"] {
            assert_eq!(counted[event], 0, "{cells}: {event}");
        }
        let middle = summary["centre_of_mass_m"][1].as_f64().unwrap();
        assert!((2.0..2.05).contains(&middle), "{cells}: it fell out of its box, to {middle}");
    }
    // Two dimensions, of which one is periodic; a disc whose depth the domain does not have.
    let disc = "[domain]\nmin_m = [1.0, 2.0, 3.0]\nmax_m = [1.8, 2.8, 3.05]\ndimensions = 2\n\
                periodic = [true, false, false]\n[[fluid]]\nsphere = { centre_m = [1.4, 2.4, 3.025], radius_m = 0.21 }\n";
    std::fs::write(workshop.path("disc.toml"), format!("spacing_m = 0.05\n{disc}")).unwrap();
    workshop.succeed(&["run", "disc.toml", "--steps", "20", "--images", "1", "--out", "disc"]);
    // Points of a square lattice within 4.2 steps of one of them.
    assert_eq!(workshop.json("disc/summary.json")["particles"], 57);
    // Fluids that overlap: the first has the place, and nothing goes wrong where they meet.
    let overlapping = format!("{SCENE}[[fluid]]\nsphere = {{ centre_m = [1.2, 2.2, 3.2], radius_m = 0.12 }}\n");
    std::fs::write(workshop.path("two.toml"), overlapping).unwrap();
    workshop.succeed(&["run", "two.toml", "--steps", "40", "--out", "two"]);
    let summary = workshop.json("two/summary.json");
    assert!(summary["particles"].as_u64().unwrap() > 64);
    assert_eq!(summary["counters"]["quarantined"], 0);
    assert!(summary["max_speed_m_s"].as_f64().unwrap() < 10.0, "{}", summary["max_speed_m_s"]);
}

#[test]
fn saved_states_that_cannot_be_gone_on_with() {
    let workshop = Workshop::new();
    let scene = Scene::load("dam-break", &["spacing_m=0.08".into()]).unwrap();
    let particles = sample_lattice(&scene);
    let state = state_of(scene, particles, 30, 0.125);
    let good = state.to_bytes();
    let flat = version_1(&state, &OLD_SCENE.replace("iterations = 7", "iterations = -7"));
    for (name, bytes, words) in [
        ("foreign", b"PK\x03\x04".to_vec(), "it is no saved state of Brooklet"),
        ("cut", good[..good.len() / 2].to_vec(), "it is cut off: it has"),
        ("later", of_version(&good, 3), "version 3 of the format, and this program reads versions 1 to 2"),
        ("newer", with_section(&good, b"EMIT", 1, 0, b"x"), "a section EMIT of version 1, which this program does not"),
        ("old", flat, "solver.pbf.iterations = -7: must be a whole number"),
    ] {
        let name = format!("{name}.brooklet");
        std::fs::write(workshop.path(&name), bytes).unwrap();
        assert_refused(&workshop, &["view", &name], &[&format!("state {name}: "), words]);
    }
    assert_refused(&workshop, &["view", "none.brooklet"], &["state none.brooklet: cannot be read"]);
    // States that are read, new and old: what stops the window is the display.
    for (name, bytes) in [("good.brooklet", good), ("before.brooklet", version_1(&state, OLD_SCENE))] {
        std::fs::write(workshop.path(name), bytes).unwrap();
        let mut command = workshop.command(["view", name]);
        let command = command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
        let said = String::from_utf8_lossy(&command.output().unwrap().stderr).into_owned();
        assert!(said.contains("no window can be opened here"), "{said}");
        assert_refused(&workshop, &["view", name, "--set", "spacing_m=1"], &["--set spacing_m=1", "saved state"]);
    }
}
