//! Files: what they say, what they lie about, and damage.

use base64::Engine as _;
use fastrand::Rng;
use glam::DVec3;

use crate::checked;
use crate::import::{image, mesh_of};

const OBJ: &str = "# a cube\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

/// A cube of two units as glTF, whose JSON has one part replaced, turned by a node.
fn gltf(from: &str, to: &str) -> String {
    let corners = mesh_of(OBJ.as_bytes(), "obj").unwrap();
    let mut bytes: Vec<u8> =
        corners.positions_m.iter().flat_map(|at| at.as_vec3().to_array()).flat_map(f32::to_le_bytes).collect();
    bytes.extend(corners.triangles.iter().flatten().flat_map(|&corner| (corner as u16).to_le_bytes()));
    let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"children":[1],"scale":[2,1,1]}},{{"mesh":0,"translation":[1,0,0]}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]}},
        {{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":96}},{{"buffer":0,"byteOffset":96,"byteLength":72}}],
        "buffers":[{{"byteLength":168,"uri":"data:application/octet-stream;base64,{data}"}}]}}"#
    );
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn obj_and_gltf_are_the_meshes_that_they_say() {
    let (cube, repairs) = checked(mesh_of(OBJ.as_bytes(), "obj").unwrap(), false).unwrap();
    assert_eq!(repairs.said(), None);
    assert!((cube.volume_m3() - 8.0).abs() < 1e-12);
    let (moved, repairs) = checked(mesh_of(gltf("", "").as_bytes(), "gltf").unwrap(), false).unwrap();
    assert_eq!(repairs.said(), None);
    assert!((moved.volume_m3() - 16.0).abs() < 1e-9);
    assert_eq!(moved.bounds_m(), [DVec3::new(0.0, -1.0, -1.0), DVec3::new(4.0, 1.0, 1.0)]);
    // Mirrored by its node it still faces outward.
    let mirrored = mesh_of(gltf("[2,1,1]", "[-2,1,1]").as_bytes(), "gltf").unwrap();
    assert!((mirrored.volume_m3() - 16.0).abs() < 1e-9);
}

#[test]
fn files_that_lie_are_refused_by_what_they_lie_about() {
    let refused = |from: &str, to: &str| mesh_of(gltf(from, to).as_bytes(), "gltf").unwrap_err();
    let cases = [
        (r#""byteLength":168"#, r#""byteLength":99999999999"#, "buffer 0 is said to have 99999999999 bytes, and 168"),
        (r#""count":36"#, r#""count":4000000000"#, "accessor 1 of 4000000000 elements that reaches beyond"),
        (r#""byteOffset":96,"byteLength":72"#, r#""byteOffset":96,"byteLength":96"#, ""),
        (r#""byteOffset":96"#, r#""byteOffset":18446744073709551615"#, ""),
        (r#""children":[1]"#, r#""children":[0,1]"#, "nodes in a circle"),
        ("data:application/octet-stream;base64,", "data:text/plain,", "not base64"),
        ("data:application/octet-stream;base64,", "../../etc/passwd?", "must be a file beside it"),
        (r#""mesh":0"#, r#""mesh":7"#, "no glTF file"),
        (r#""componentType":5123"#, r#""componentType":5126"#, "indices that are not whole"),
        (r#""POSITION":0"#, r#""POSITION":1"#, ""),
        (r#""POSITION":0"#, r#""POSITION":9"#, "positions in accessor 9, and there are 2"),
        (r#"{"asset""#, r#"{"asset"#, "no glTF file"),
        (r#""scenes":[{"nodes":[0]}],"#, r#""scenes":[],"#, ""),
    ];
    for (from, to, words) in cases {
        match mesh_of(gltf(from, to).as_bytes(), "gltf") {
            Err(error) => assert!(error.contains(words) && !error.contains('\n'), "{to}: {error}"),
            // A view that is longer than what it is used for.
            Ok(_) => assert!(to.ends_with(":96"), "{to} is read"),
        }
    }
    // An index of a corner that is not there.
    let last = refused(r#""count":8"#, r#""count":7"#);
    assert!(last.contains("has index 7 in place") && last.contains("there are 7 positions"), "{last}");
    for (text, words) in [
        ("v 1 2\nf 1 1 1\n", "no OBJ file"),
        ("v 1 2 3\nf 1 2 9\n", "out of bounds"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n", ""),
        ("v a b c\n", "position parse error"),
    ] {
        let error = mesh_of(text.as_bytes(), "obj").map(|mesh| checked(mesh, false));
        match error {
            Err(error) => assert!(error.contains(words), "{text}: {error}"),
            Ok(read) => assert!(read.is_err(), "{text} is read"),
        }
    }
}

/// Damaged files are read or refused, without a panic and without memory that they do not explain.
#[test]
fn damaged_files_do_no_harm() {
    let mut rng = Rng::with_seed(11);
    let png = png_of(png::BitDepth::Sixteen, &[0, 0, 255, 255, 128, 0, 64, 0]);
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    let json = gltf("", "");
    let padded = format!("{json}{}", " ".repeat(json.len().wrapping_neg() % 4));
    glb.extend((padded.len() as u32 + 20).to_le_bytes());
    glb.extend((padded.len() as u32).to_le_bytes());
    glb.extend(b"JSON");
    glb.extend(padded.bytes());
    assert!(mesh_of(&glb, "glb").is_ok());
    let (mut read, mut refused) = (0, 0);
    for (text, ending) in [(OBJ.as_bytes().to_vec(), "obj"), (json.into_bytes(), "gltf"), (glb, "glb"), (png, "png")] {
        for _ in 0..15000 {
            let mut bytes = text.clone();
            for _ in 0..rng.usize(1..4) {
                let at = rng.usize(0..bytes.len());
                match rng.u8(0..4) {
                    0 => bytes[at] ^= 1 << rng.u8(0..8),
                    1 => bytes[at] = b"0123456789-.e{}[],\"\n "[rng.usize(0..21)],
                    2 => bytes.truncate(at + 1),
                    _ => {
                        let other = rng.usize(0..bytes.len());
                        let piece: Vec<u8> = bytes[at.min(other)..at.max(other)].iter().take(40).copied().collect();
                        bytes.splice(at..at, piece);
                    }
                }
            }
            let is_read = match ending {
                "png" => image(&bytes).is_ok(),
                _ => mesh_of(&bytes, ending)
                    .and_then(|mesh| checked(mesh, false).map_err(|flaw| flaw.to_string()))
                    .is_ok(),
            };
            *(if is_read { &mut read } else { &mut refused }) += 1;
        }
    }
    println!("{read} read, {refused} refused");
    assert!(read > 100 && refused > 1000);
}

fn png_of(depth: png::BitDepth, pixels: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(depth);
    encoder.write_header().unwrap().write_image_data(pixels).unwrap();
    bytes
}

#[test]
fn gray_images_are_shares_of_white() {
    let bytes = image(&png_of(png::BitDepth::Eight, &[0, 51, 255, 102])).unwrap();
    assert_eq!((bytes.columns, bytes.rows, bytes.shares), (2, 2, vec![0.0, 0.2, 1.0, 0.4]));
    let words = image(&png_of(png::BitDepth::Sixteen, &[0, 0, 255, 255, 51, 51, 0, 1])).unwrap();
    assert_eq!(words.shares, [0.0, 1.0, 0.2, 1.0 / 65535.0]);
    let mut colored = Vec::new();
    let mut encoder = png::Encoder::new(&mut colored, 2, 2);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().unwrap().write_image_data(&[0; 12]).unwrap();
    assert!(image(&colored).unwrap_err().contains("must be gray"));
    assert!(image(b"not a png").unwrap_err().contains("no PNG file"));
}
