//! A triangle mesh as binary little-endian PLY or as OBJ, in the scene's coordinates.

use std::io::{self, Write};
use std::path::Path;

use brooklet_kernels::MeshVertex;
use brooklet_render::surface::marching_cubes::export::HostMesh;
use clap::ValueEnum;
use serde::{Serialize, Serializer};

use crate::{failure::Failure, out_dir};

/// File format of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MeshFormat {
    /// Binary little-endian PLY: x y z, nx ny nz, triangles
    Ply,
    /// OBJ: v, vn, f
    Obj,
}

impl MeshFormat {
    /// The format that a file's name ends in.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        [Self::Ply, Self::Obj].into_iter().find(|format| ending.eq_ignore_ascii_case(format.ending()))
    }

    /// What such a file's name ends in.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Ply => "ply",
            Self::Obj => "obj",
        }
    }
}

/// Writes `mesh`; `origin_m` is the corner of the domain that its positions are relative to.
pub fn write(path: &Path, format: MeshFormat, mesh: &HostMesh, origin_m: [f64; 3]) -> Result<(), Failure> {
    out_dir::write_with(path, |to| match format {
        MeshFormat::Ply => write_ply(to, mesh, origin_m),
        MeshFormat::Obj => write_obj(to, mesh, origin_m),
    })
}

fn position(vertex: &MeshVertex, origin_m: [f64; 3]) -> [f32; 3] {
    std::array::from_fn(|axis| (origin_m[axis] + f64::from(vertex.position_m[axis])) as f32)
}

#[derive(Serialize)]
struct Vertex {
    x: f32,
    y: f32,
    z: f32,
    nx: f32,
    ny: f32,
    nz: f32,
}

#[derive(Serialize)]
struct Face<'a> {
    vertex_indices: &'a [u32],
}

#[derive(Serialize)]
struct Elements<'a> {
    #[serde(serialize_with = "vertices")]
    vertex: (&'a [MeshVertex], [f64; 3]),
    #[serde(serialize_with = "faces")]
    face: &'a [[u32; 3]],
}

fn vertices<S: Serializer>((all, origin_m): &(&[MeshVertex], [f64; 3]), to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(all.iter().map(|vertex| {
        let ([x, y, z], [nx, ny, nz]) = (position(vertex, *origin_m), vertex.normal);
        Vertex { x, y, z, nx, ny, nz }
    }))
}

fn faces<S: Serializer>(all: &&[[u32; 3]], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(all.iter().map(|corners| Face { vertex_indices: corners }))
}

fn write_ply(to: &mut dyn Write, mesh: &HostMesh, origin_m: [f64; 3]) -> io::Result<()> {
    let elements = Elements { vertex: (&mesh.vertices, origin_m), face: &mesh.triangles };
    serde_ply::to_writer(&elements, serde_ply::SerializeOptions::binary_le(), to).map_err(|error| error.0)
}

fn write_obj(to: &mut dyn Write, mesh: &HostMesh, origin_m: [f64; 3]) -> io::Result<()> {
    for vertex in &mesh.vertices {
        let [x, y, z] = position(vertex, origin_m);
        writeln!(to, "v {x} {y} {z}")?;
    }
    for MeshVertex { normal: [x, y, z], .. } in &mesh.vertices {
        writeln!(to, "vn {x} {y} {z}")?;
    }
    // OBJ counts from 1.
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| u64::from(corner) + 1);
        writeln!(to, "f {a}//{a} {b}//{b} {c}//{c}")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron() -> HostMesh {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let vertices =
            corners.map(|position_m| MeshVertex { position_m, normal: [0.0, 0.0, -1.0], ..MeshVertex::default() });
        let triangles = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        HostMesh { vertices: vertices.to_vec(), triangles, ..HostMesh::default() }
    }

    fn written(format: MeshFormat) -> Vec<u8> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mesh");
        write(&path, format, &tetrahedron(), [10.0, 20.0, 30.0]).unwrap();
        std::fs::read(&path).unwrap()
    }

    #[test]
    fn volume_is_that_of_the_body() {
        let mut mesh = tetrahedron();
        assert!((mesh.volume_m3() - 1.0 / 6.0).abs() < 1e-12);
        mesh.triangles.iter_mut().for_each(|corners| corners.swap(0, 1));
        assert!(mesh.volume_m3() < 0.0, "turned inside out");
        assert_eq!(HostMesh::default().volume_m3(), 0.0);
    }

    /// By the format's description: a text header, then the rows without padding.
    #[test]
    fn ply_is_as_described() {
        let bytes = written(MeshFormat::Ply);
        let marker = b"end_header\n";
        let end = bytes.windows(marker.len()).position(|window| window == marker).unwrap() + marker.len();
        assert_eq!(
            std::str::from_utf8(&bytes[..end]).unwrap(),
            "ply\nformat binary_little_endian 1.0\n\
             element vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             property float nx\nproperty float ny\nproperty float nz\n\
             element face 4\nproperty list uint8 uint32 vertex_indices\nend_header\n"
        );
        let rows = &bytes[end..];
        assert_eq!(rows.len(), 4 * 24 + 4 * 13);
        let float = |at: usize| f32::from_le_bytes(rows[at..at + 4].try_into().unwrap());
        assert_eq!([24, 28, 32, 36, 40, 44].map(float), [11.0, 20.0, 30.0, 0.0, 0.0, -1.0]);
        let face = &rows[4 * 24 + 13..][..13];
        let corner = |k: usize| u32::from_le_bytes(face[1 + 4 * k..][..4].try_into().unwrap());
        assert_eq!((face[0], [0, 1, 2].map(corner)), (3, [0, 1, 3]));
    }

    #[test]
    fn obj_is_as_described() {
        let text = String::from_utf8(written(MeshFormat::Obj)).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!((lines.len(), lines[1], lines[4]), (12, "v 11 20 30", "vn 0 0 -1"));
        assert_eq!(lines[9], "f 1//1 2//2 4//4");
    }
}
