//! Files that shapes are read from. Nothing of a file is believed: sizes are held against what is there before anything of
//! that size is made.

mod gltf;
mod obj;
mod png;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::mesh::Mesh;
pub use png::{Image, image};

/// The largest file that is read.
pub const MOST_BYTES: u64 = 256 << 20;

/// The bytes of a file.
///
/// # Errors
/// What the system says, or that it is too long.
pub fn bytes(path: &Path) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| format!("cannot be read: {error}"))?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| format!("cannot be read: {error}"))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(format!("cannot be read: it has more than {MOST_BYTES} bytes"));
    }
    Ok(bytes)
}

/// The triangles of a file: `.obj`, `.gltf` or `.glb`; all of its objects, where its scene puts them.
///
/// # Errors
/// In words, without the file's name.
pub fn mesh(path: &Path) -> Result<Mesh, String> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    match ending.as_str() {
        "obj" => obj::mesh(&bytes(path)?),
        "gltf" | "glb" => gltf::mesh(&bytes(path)?, path.parent()),
        _ => Err("must end in .obj, .gltf or .glb".to_owned()),
    }
}

/// The same of bytes that are at hand, by what the file would end in; files that a glTF file names are not read.
///
/// # Errors
/// As [`mesh`].
pub fn mesh_of(bytes: &[u8], ending: &str) -> Result<Mesh, String> {
    if ending == "obj" { obj::mesh(bytes) } else { gltf::mesh(bytes, None) }
}
