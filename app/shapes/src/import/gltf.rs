//! glTF 2, by `gltf`: its structure is that crate's, its buffers are read here, where each size is held against the bytes that
//! there are.

use std::path::Path;

use base64::Engine as _;
use glam::{DMat4, DVec3};
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::Source;
use gltf::json::Root;
use gltf::json::validation::Checked;
use gltf::{Accessor, Document, Node, Primitive, Semantic, mesh::Mode};

use super::MOST_BYTES;
use crate::mesh::{MOST_TRIANGLES, Mesh};

/// Nodes below each other: a file in which they go in a circle has no end.
const DEEPEST: usize = 64;
/// Nodes in all.
const MOST_VISITS: usize = 100_000;

pub fn mesh(bytes: &[u8], folder: Option<&Path>) -> Result<Mesh, String> {
    let (file, blob) = file_of(bytes)?;
    let mut buffers = Vec::new();
    let mut all = 0;
    for buffer in file.buffers() {
        let data = match buffer.source() {
            Source::Bin => blob.clone().ok_or("has a buffer in a .glb file's binary part, which it lacks")?,
            Source::Uri(uri) => buffer_of(uri, folder)?,
        };
        if data.len() < buffer.length() {
            let (index, claimed) = (buffer.index(), buffer.length());
            return Err(format!("buffer {index} is said to have {claimed} bytes, and {} are there", data.len()));
        }
        all += data.len() as u64;
        if all > MOST_BYTES {
            return Err(format!("has buffers of more than {MOST_BYTES} bytes"));
        }
        buffers.push(data);
    }
    let scene = file.default_scene().or_else(|| file.scenes().next()).ok_or("has no scene")?;
    let mut reader = Reader { buffers, mesh: Mesh::default(), visits: 0 };
    for node in scene.nodes() {
        reader.node(&node, DMat4::IDENTITY, 0)?;
    }
    Ok(reader.mesh)
}

/// The file's structure, and the binary part of a .glb.
fn file_of(bytes: &[u8]) -> Result<(Document, Option<Vec<u8>>), String> {
    let unreadable = |error: String| format!("is no glTF file that can be read: {}", one_line(&error));
    let (json, blob) = match bytes.starts_with(b"glTF") {
        true => parts_of(bytes).map_err(|reason| unreadable(reason.to_owned()))?,
        false => (bytes, None),
    };
    let root: Root = gltf::json::deserialize::from_slice(json).map_err(|error| unreadable(error.to_string()))?;
    // The crate asks for these before it checks them.
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let positions = primitives.filter_map(|primitive| primitive.attributes.get(&Checked::Valid(Semantic::Positions)));
    let count = root.accessors.len();
    if let Some(accessor) = positions.map(|index| index.value()).find(|&index| index >= count) {
        return Err(format!("has positions in accessor {accessor}, and there are {count}"));
    }
    let file = Document::from_json(root).map_err(|error| unreadable(error.to_string()))?;
    Ok((file, blob.map(<[u8]>::to_vec)))
}

/// The parts of a .glb: JSON, and bytes. (The crate's own reader of these trusts the lengths that a file claims.)
fn parts_of(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), &'static str> {
    let word = |at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    if word(4) != Some(2) {
        return Err("its binary form is not of version 2");
    }
    let part = |at: usize, kind: &[u8; 4]| {
        let length = word(at)? as usize;
        let is_own = bytes.get(at + 4..at + 8)? == kind;
        is_own.then(|| bytes.get(at + 8..at.checked_add(8)?.checked_add(length)?)).flatten()
    };
    let json = part(12, b"JSON").ok_or("its JSON part is cut off, or not there")?;
    Ok((json, part(20 + json.len().next_multiple_of(4), b"BIN\0")))
}

fn one_line(error: &impl ToString) -> String {
    let text: String = error.to_string().chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    text.chars().take(300).collect()
}

fn buffer_of(uri: &str, folder: Option<&Path>) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,").ok_or("has a buffer of data that is not base64")?;
        return base64::engine::general_purpose::STANDARD
            .decode(text)
            .map_err(|error| format!("has a buffer of data that is not base64: {error}"));
    }
    let path = Path::new(uri);
    let is_below = path.components().all(|part| matches!(part, std::path::Component::Normal(_)));
    let (true, Some(folder)) = (is_below, folder) else {
        return Err(format!("has its buffer in {uri:?}: must be a file beside it"));
    };
    super::bytes(&folder.join(path)).map_err(|error| format!("has its buffer in {uri:?}, which {error}"))
}

struct Reader {
    buffers: Vec<Vec<u8>>,
    mesh: Mesh,
    visits: usize,
}

impl Reader {
    fn node(&mut self, node: &Node<'_>, above: DMat4, depth: usize) -> Result<(), String> {
        self.visits += 1;
        if depth > DEEPEST || self.visits > MOST_VISITS {
            return Err(format!(
                "has nodes in a circle, or more than {DEEPEST} below each other or {MOST_VISITS} in all"
            ));
        }
        let own = node.transform().matrix();
        let here = above * DMat4::from_cols_array_2d(&own.map(|column| column.map(f64::from)));
        if let Some(mesh) = node.mesh() {
            for primitive in mesh.primitives() {
                let name = format!("mesh {}, primitive {}", mesh.index(), primitive.index());
                self.primitive(&primitive, here).map_err(|error| format!("{name} {error}"))?;
            }
        }
        node.children().try_for_each(|child| self.node(&child, here, depth + 1))
    }

    fn primitive(&mut self, primitive: &Primitive<'_>, here: DMat4) -> Result<(), String> {
        let mode = primitive.mode();
        if matches!(mode, Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
            return Ok(());
        }
        let positions = primitive.get(&Semantic::Positions).ok_or("has no positions")?;
        if positions.data_type() != DataType::F32 || positions.dimensions() != Dimensions::Vec3 {
            return Err("has positions that are not three f32".into());
        }
        let first = self.mesh.positions_m.len() as u32;
        let mut places = Vec::new();
        self.each(&positions, 12, |bytes| {
            let at = |k: usize| f64::from(f32::from_le_bytes([bytes[k], bytes[k + 1], bytes[k + 2], bytes[k + 3]]));
            places.push(here.transform_point3(DVec3::new(at(0), at(4), at(8))));
        })?;
        let corners = places.len() as u32;
        let mut indices: Vec<u32> = Vec::new();
        match primitive.indices() {
            None => indices.extend(0..corners),
            Some(accessor) => {
                let size = match accessor.data_type() {
                    DataType::U8 => 1,
                    DataType::U16 => 2,
                    DataType::U32 => 4,
                    _ => return Err("has indices that are not whole".into()),
                };
                let number = |bytes: &[u8]| bytes.iter().rev().fold(0_u32, |high, &low| high << 8 | u32::from(low));
                self.each(&accessor, size, |bytes| indices.push(number(bytes)))?;
            }
        }
        if let Some((at, corner)) = indices.iter().enumerate().find(|(_, corner)| **corner >= corners) {
            return Err(format!("has index {corner} in place {at}, and there are {corners} positions"));
        }
        let of = |a: usize, b: usize, c: usize| [indices[a], indices[b], indices[c]].map(|corner| first + corner);
        let count = indices.len();
        let triangles: Vec<[u32; 3]> = match mode {
            Mode::TriangleStrip => {
                (2..count).map(|k| if k % 2 == 0 { of(k - 2, k - 1, k) } else { of(k - 1, k - 2, k) }).collect()
            }
            Mode::TriangleFan => (2..count).map(|k| of(0, k - 1, k)).collect(),
            _ => (2..count).step_by(3).map(|k| of(k - 2, k - 1, k)).collect(),
        };
        // A mirrored node turns its triangles over.
        let is_mirrored = here.determinant() < 0.0;
        self.mesh.triangles.extend(triangles.iter().map(|&[a, b, c]| if is_mirrored { [a, c, b] } else { [a, b, c] }));
        self.mesh.positions_m.extend(places);
        if self.mesh.triangles.len() > MOST_TRIANGLES || self.mesh.positions_m.len() > 3 * MOST_TRIANGLES {
            return Err(format!("makes more than the {MOST_TRIANGLES} triangles that fit"));
        }
        Ok(())
    }

    /// Calls `visit` with each element's bytes.
    fn each(&self, accessor: &Accessor<'_>, size: usize, mut visit: impl FnMut(&[u8])) -> Result<(), String> {
        let index = accessor.index();
        if accessor.sparse().is_some() {
            return Err(format!("has sparse accessor {index}, which is not read"));
        }
        let view = accessor.view().ok_or_else(|| format!("has accessor {index} without a buffer"))?;
        let data = &self.buffers[view.buffer().index()];
        let (stride, count) = (view.stride().unwrap_or(size), accessor.count());
        if count == 0 {
            return Ok(());
        }
        let last = (count - 1).checked_mul(stride).and_then(|length| length.checked_add(size));
        let end_in_view = last.and_then(|length| length.checked_add(accessor.offset()));
        let end = end_in_view.and_then(|end| end.checked_add(view.offset()));
        let fits = end_in_view.is_some_and(|end| end <= view.length()) && end.is_some_and(|end| end <= data.len());
        if !fits || stride == 0 {
            return Err(format!(
                "has accessor {index} of {count} elements that reaches beyond its buffer of {} bytes",
                data.len()
            ));
        }
        let first = view.offset() + accessor.offset();
        (0..count).for_each(|element| visit(&data[first + element * stride..first + element * stride + size]));
        Ok(())
    }
}
