//! Anybody's particles from a PLY file: ASCII or binary of either byte order, x, y and z of any number type.

use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind, Read};
use std::path::Path;

use indicatif::ProgressBar;
use serde::Deserialize;
use serde_ply::{DeserializeError, ElementDef, PlyReader, PropertyType};

use crate::failure::Failure;

/// Positions are as far from the origin at most: their squares are far below what 32 bits hold.
const MOST_M: f64 = 1.0e12;

/// Particles of a file.
pub struct PointCloud {
    /// Positions that are finite.
    pub positions_m: Vec<[f64; 3]>,
    /// Particles left out because theirs is not.
    pub not_finite: usize,
}

#[derive(Deserialize)]
struct Vertex {
    x: f64,
    y: f64,
    z: f64,
}

/// A row that nobody asks for.
#[derive(Deserialize)]
struct Ignored {}

/// Reads the particles of `path`; `bar` goes along.
///
/// # Errors
/// If the file cannot be read, is no PLY file, or has no particles; the line names the file.
pub fn read(path: &Path, bar: &ProgressBar) -> Result<PointCloud, Failure> {
    let refused = |why: String| Failure::Input(format!("{}: {why}", path.display()));
    let unreadable = |error: std::io::Error| refused(format!("cannot be read: {error}"));
    let file = File::open(path).map_err(unreadable)?;
    let about = file.metadata().map_err(unreadable)?;
    if about.is_dir() {
        return Err(refused("is a folder; name a PLY file".into()));
    }
    bar.set_length(about.len());
    let mut from = BufReader::with_capacity(1 << 20, bar.wrap_read(file));
    let start = from.fill_buf().map_err(unreadable)?;
    if !start.starts_with(b"ply") {
        return Err(refused("is no PLY file: it does not begin with \"ply\"".into()));
    }
    // The last number of a text may end with the file, and the library reads on to what ends it.
    let head = &start[..start.len().min(1 << 10)];
    let is_text = head.windows(12).any(|window| window == b"format ascii");
    let end: &[u8] = if is_text { b"\n" } else { b"" };
    let vertices = vertices(from.chain(end)).map_err(refused)?;
    let all = vertices.len();
    let positions_m: Vec<[f64; 3]> = vertices
        .into_iter()
        .map(|Vertex { x, y, z }| [x, y, z])
        .filter(|position_m| position_m.iter().all(|m| m.is_finite()))
        .collect();
    if positions_m.is_empty() {
        return Err(refused(match all {
            0 => "has no particles: its element vertex has no rows".into(),
            _ => format!("none of its {all} particles has a finite position"),
        }));
    }
    if let Some(far) = positions_m.iter().find(|position_m| position_m.iter().any(|m| m.abs() > MOST_M)) {
        return Err(refused(format!("a particle is at {far:?}; each of these may be from -1e12 to 1e12")));
    }
    Ok(PointCloud { not_finite: all - positions_m.len(), positions_m })
}

fn vertices(from: impl BufRead) -> Result<Vec<Vertex>, String> {
    let of_header = |error: DeserializeError| format!("its header cannot be read: {}", error.0);
    let mut reader = PlyReader::from_reader(from).map_err(of_header)?;
    let names: Vec<String> = reader.header().elem_defs.iter().map(|element| element.name.clone()).collect();
    while let Some(element) = reader.current_element() {
        let (name, count) = (element.name.clone(), element.count);
        let of_rows = |error: DeserializeError| match error.0.kind() {
            ErrorKind::UnexpectedEof => format!("it is cut off: its header promises {count} rows of element {name}"),
            _ => format!("element {name} cannot be read: {}", error.0),
        };
        if name == "vertex" {
            check_fields(element)?;
            return reader.next_element().map_err(of_rows);
        }
        reader.next_element::<Vec<Ignored>>().map_err(of_rows)?;
    }
    let names = if names.is_empty() { "no elements at all".into() } else { names.join(", ") };
    Err(format!("has no particles: PLY calls them vertex, and it has {names}"))
}

fn check_fields(element: &ElementDef) -> Result<(), String> {
    for axis in ["x", "y", "z"] {
        match element.get_property(axis).map(|field| &field.property_type) {
            Some(PropertyType::Scalar(_)) => {}
            Some(PropertyType::List { .. }) => return Err(format!("its field {axis} is a list, not a number")),
            None => {
                let has: Vec<&str> = element.properties.iter().map(|field| field.name.as_str()).collect();
                let has = if has.is_empty() { "no fields".into() } else { has.join(", ") };
                return Err(format!("its particles have no field {axis}: they have {has}"));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "element face 1\nproperty list uchar int vertex_indices\nelement vertex 2\n\
                          property float density\nproperty double z\nproperty list uchar short near\n\
                          property float x\nproperty int y\nend_header\n";

    fn read_bytes(bytes: &[u8]) -> Result<PointCloud, Failure> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.ply");
        std::fs::write(&path, bytes).unwrap();
        read(&path, &ProgressBar::hidden())
    }

    /// The rows of `HEADER` in binary.
    fn rows(number: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
        let mut bytes = vec![2];
        let mut add = |little_endian: &[u8]| bytes.extend(number(little_endian));
        add(&7_i32.to_le_bytes());
        add(&8_i32.to_le_bytes());
        for (z, x, y) in [(0.125_f64, 0.5_f32, 2_i32), (f64::NAN, 1.0, 1)] {
            add(&9.0_f32.to_le_bytes());
            add(&z.to_le_bytes());
            add(&[1]);
            add(&3_i16.to_le_bytes());
            add(&x.to_le_bytes());
            add(&y.to_le_bytes());
        }
        bytes
    }

    #[test]
    fn each_kind_of_file_is_read() {
        let text = format!("ply\r\nformat ascii 1.0\r\n{HEADER}2 7 8\n9 0.125 1 3 0.5 2\n9 nan 0 1 1");
        let little =
            [format!("ply\nformat binary_little_endian 1.0\n{HEADER}").as_bytes(), &rows(<[u8]>::to_vec)].concat();
        let turned = rows(|bytes| bytes.iter().rev().copied().collect());
        let big = [format!("ply\nformat binary_big_endian 1.0\n{HEADER}").as_bytes(), &turned].concat();
        for bytes in [text.into_bytes(), little, big] {
            let Ok(cloud) = read_bytes(&bytes) else { panic!("{}", String::from_utf8_lossy(&bytes)) };
            assert_eq!((cloud.positions_m, cloud.not_finite), (vec![[0.5, 2.0, 0.125]], 1));
        }
    }
}
