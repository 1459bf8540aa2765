//! Solids of files that are no solids: one message each that names file and element, exit code 2. And what is repaired of one,
//! which is said.

use std::fmt::Write as _;

use crate::bad_input::assert_refused;
use brooklet_tests::program::{SCENE, Workshop};

const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];
const FACES: [[u32; 4]; 6] = [[4, 3, 2, 1], [5, 6, 7, 8], [1, 2, 6, 5], [3, 4, 8, 7], [2, 3, 7, 6], [4, 1, 5, 8]];

/// A cube of two units as OBJ.
fn cube(corners: &[[f64; 3]], faces: &[[u32; 4]]) -> String {
    let mut text = String::new();
    for [x, y, z] in corners {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for [a, b, c, d] in faces {
        writeln!(text, "f {a} {b} {c} {d}").unwrap();
    }
    text
}

fn scene(solid: &str) -> String {
    format!("{SCENE}[[solid]]\n{solid}\ncentre_m = [1.2, 2.3, 3.2]\n")
}

/// One pixel after another, black to white.
fn png(color: png::ColorType, side: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side, side);
    encoder.set_color(color);
    let pixels = side as usize * side as usize * color.samples();
    let shades: Vec<u8> = (0..pixels).map(|k| (k * 255 / pixels) as u8).collect();
    encoder.write_header().unwrap().write_image_data(&shades).unwrap();
    bytes
}

#[test]
fn files_that_are_no_solids() {
    let workshop = Workshop::new();
    let mut nowhere = CORNERS;
    nowhere[2][1] = f64::NAN;
    let mut flat = CORNERS;
    flat.iter_mut().for_each(|corner| *corner = [corner[0], 0.0, 0.0]);
    let write = |name: &str, bytes: &[u8]| std::fs::write(workshop.path(name), bytes).unwrap();
    write("good.obj", cube(&CORNERS, &FACES).as_bytes());
    write("open.obj", cube(&CORNERS, &FACES[..5]).as_bytes());
    write("nowhere.obj", cube(&nowhere, &FACES).as_bytes());
    write("flat.obj", cube(&flat, &FACES).as_bytes());
    write("short.obj", cube(&CORNERS[..7], &FACES).as_bytes());
    write("empty.obj", b"# nothing\n");
    write("empty.gltf", b"");
    write(
        "bomb.gltf",
        br#"{"asset":{"version":"2.0"},"scenes":[],"buffers":[{"byteLength":9000000000000000,"uri":"data:;base64,AAAA"}]}"#,
    );
    write("shape.stl", b"solid");
    write("color.png", &png(png::ColorType::Rgb, 4));
    write("gray.png", &png(png::ColorType::Grayscale, 8));
    let mesh = |file: &str| format!("mesh = {{ file = \"{file}\", scale_m = 0.08 }}");
    let file = |name: &str| format!("solid.0.mesh.file = \"{}", workshop.path(name).display());
    let hull = |points: &str| format!("hull = {{ points_m = [{points}] }}");
    let ground = |rest: &str| format!("terrain = {{ size_m = [0.4, 0.1, 0.4], {rest} }}");
    for (solid, words) in [
        (mesh("none.obj"), vec![file("none.obj"), "cannot be read: No such file".into()]),
        (
            mesh("open.obj"),
            vec![file("open.obj"), "is open: 4 of its edges have one triangle".into(), "thickness_m".into()],
        ),
        (mesh("nowhere.obj"), vec![file("nowhere.obj"), "is at [0.08, NaN, -0.08]".into()]),
        (mesh("flat.obj"), vec![file("flat.obj"), "has 12 triangles, none of which has an area".into()]),
        (mesh("short.obj"), vec![file("short.obj"), "face vertex index out of bounds".into()]),
        (mesh("empty.obj"), vec![file("empty.obj"), "has no triangles".into()]),
        (mesh("empty.gltf"), vec![file("empty.gltf"), "is no glTF file that can be read".into()]),
        (
            mesh("bomb.gltf"),
            vec![file("bomb.gltf"), "buffer 0 is said to have 9000000000000000 bytes, and 3 are".into()],
        ),
        (mesh("shape.stl"), vec![file("shape.stl"), "must end in .obj, .gltf or .glb".into()]),
        (mesh("."), vec!["must end in .obj".into()]),
        ("mesh = { file = \"good.obj\", scale_m = 1e7 }".into(), vec!["solid.0.mesh.scale_m = 1e7".into()]),
        (
            "mesh = { file = \"good.obj\", scale_m = 100 }".into(),
            vec!["solid.0.mesh.cell_m = 0.025".into(), "4194304 fit".into(), "or more, or a smaller solid".into()],
        ),
        (
            "mesh = { file = \"good.obj\", scale_m = 0.08, cell_m = 0.2 }".into(),
            vec!["solid.0.mesh.cell_m = 0.2".into(), "at most a spacing".into()],
        ),
        (
            "mesh = { file = \"good.obj\", scale_m = 0.002 }".into(),
            vec!["solid.0.mesh = 0.004 x 0.004 x 0.004 m".into(), "so thin that particles would pass it".into()],
        ),
        (
            "mesh = { file = \"open.obj\", scale_m = 0.08, cell_m = 0.05 }\nthickness_m = 1e-5".into(),
            vec!["solid.0.mesh = 0.16 x 0.16 x 0.16 m".into(), "so thin".into()],
        ),
        (format!("{}\nopen = \"y_max\"", mesh("good.obj")), vec!["solid.0.open".into()]),
        (
            hull("[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]"),
            vec!["solid.0.hull.points_m = 3 points".into(), "in one plane".into()],
        ),
        (hull(""), vec!["solid.0.hull.points_m = 0 points".into()]),
        (
            format!("{}\nthickness_m = 0.1", hull("[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]")),
            vec!["solid.0.thickness_m = 0.1".into(), "not with a hull".into()],
        ),
        (
            "hull = { file = \"good.obj\", points_m = [[0, 0, 0]] }".into(),
            vec!["solid.0.hull.file".into(), "give one of the two".into()],
        ),
        (ground("file = \"color.png\""), vec!["solid.0.terrain.file".into(), "has Rgb pixels of 8 bits".into()]),
        (ground("file = \"good.obj\""), vec!["solid.0.terrain.file".into(), "is no PNG file".into()]),
        (ground("relief = \"sea\""), vec!["solid.0.terrain.relief = \"sea\"".into(), "\"hills\" or \"valley\"".into()]),
        (ground("cell_m = 1e-4"), vec!["solid.0.terrain.cell_m = 1e-4".into(), "nodes".into()]),
        (format!("{}\n{}", mesh("good.obj"), ground("seed = 1")), vec!["solid.0 = 2 shapes".into()]),
    ] {
        std::fs::write(workshop.path("bad.toml"), scene(&solid)).unwrap();
        let mut words: Vec<&str> = words.iter().map(String::as_str).collect();
        words.push("scene bad.toml");
        assert_refused(&workshop, &["run", "bad.toml", "--steps", "1"], &words);
    }
    for (name, solid) in [("good", mesh("good.obj")), ("gray", ground("file = \"gray.png\""))] {
        std::fs::write(workshop.path("good.toml"), scene(&solid)).unwrap();
        let ended = workshop.succeed(&["run", "good.toml", "--steps", "1", "--out", name]);
        assert!(!ended.stderr.contains("repaired"), "{}", ended.stderr);
    }
}

#[test]
fn what_is_repaired_of_a_mesh_is_said() {
    let workshop = Workshop::new();
    let inward = FACES.map(|[a, b, c, d]| [d, c, b, a]);
    let mut faces = FACES.to_vec();
    faces[1].reverse();
    faces.push([1, 1, 2, 2]);
    for (name, faces, words) in [
        ("inward", &inward[..], "all of it faced inward, and was turned over"),
        (
            "odd",
            &faces[..],
            "2 triangles without an area left out; 2 triangles turned over to face as their neighbours do",
        ),
    ] {
        std::fs::write(workshop.path("cube.obj"), cube(&CORNERS, faces)).unwrap();
        let text = scene("mesh = { file = \"cube.obj\", scale_m = 0.08 }");
        std::fs::write(workshop.path("cube.toml"), text).unwrap();
        let ended = workshop.succeed(&["run", "cube.toml", "--steps", "1", "--out", name]);
        assert!(ended.stderr.contains(&format!("solid.0.mesh, repaired: {words}")), "{}", ended.stderr);
    }
}
