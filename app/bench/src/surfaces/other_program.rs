//! Another program's meshes of the same particles: those of splashsurf.

use std::{
    fmt::Display,
    fs,
    io::BufReader,
    path::{Path, PathBuf},
    process::{Command, Output},
};

use brooklet_gpu::Quantiles;
use brooklet_kernels::MeshVertex;
use brooklet_render::surface::marching_cubes::export::HostMesh;
use glam::DVec3;
use serde::Deserialize;

use super::{
    mesh_errors::mesh_errors,
    meshes::MeshRow,
    shapes::{SPACING_M, Shape},
    ways::Cells,
};
use crate::{BenchError, Observer};

/// What its manual has for particles that fill a lattice: half a spacing is their radius, the kernel reaches twice as
/// far as the smoothing length, which is in radii.
const RADIUS_M: f64 = 0.5 * SPACING_M;
const SMOOTHING_LENGTH: &str = "2.0";
const THRESHOLD: &str = "0.6";
/// Its manual's pipeline for a smooth mesh.
const SMOOTHED: [&str; 4] =
    ["--mesh-cleanup=on", "--mesh-smoothing-weights=on", "--mesh-smoothing-iters=25", "--normals-smoothing-iters=10"];

/// A `splashsurf` to be held against the same bodies.
#[derive(Clone, Debug)]
pub struct OtherProgram {
    path: PathBuf,
    /// With its version.
    name: String,
}

#[derive(Deserialize)]
struct Vertex {
    x: f32,
    y: f32,
    z: f32,
    nx: f32,
    ny: f32,
    nz: f32,
}

#[derive(Deserialize)]
struct Face {
    vertex_indices: Vec<u32>,
}

#[derive(Deserialize)]
struct Ply {
    vertex: Vec<Vertex>,
    face: Vec<Face>,
}

impl OtherProgram {
    /// The program at `path`, or of that name where programs are looked for.
    ///
    /// # Errors
    /// If it cannot be started, or does not say its version.
    pub fn find(path: &Path) -> Result<Self, BenchError> {
        let mut found = Self { path: path.to_owned(), name: String::new() };
        let output = found.run(&["--version"], "asked for its --version")?;
        let said = String::from_utf8_lossy(&output.stdout);
        match said.lines().map(str::trim).find(|line| !line.is_empty()) {
            Some(line) => found.name = line.to_owned(),
            None => return Err(found.refused("asked for its --version, it said nothing")),
        }
        Ok(found)
    }

    /// Its mesh of a body, made `repeats` times; smoothed if that is wanted.
    pub(crate) fn mesh(
        &self,
        (shape, particles_m): (Shape, &[DVec3]),
        (cells, is_smoothed): (Cells, bool),
        repeats: usize,
        observer: &dyn Observer,
    ) -> Result<MeshRow, BenchError> {
        let body = shape.name();
        let how = format!("{}cells {}", if is_smoothed { "smoothed, " } else { "" }, cells.name);
        observer.message(format!("{body}: {}, {how}", self.name));
        let folder = tempfile::tempdir().map_err(BenchError::stopped)?;
        let [particles, mesh] = ["particles.xyz", "mesh.ply"].map(|name| folder.path().join(name));
        let xyz: Vec<u8> =
            particles_m.iter().flat_map(|at_m| at_m.as_vec3().to_array()).flat_map(f32::to_le_bytes).collect();
        fs::write(&particles, xyz).map_err(BenchError::stopped)?;
        let [input, output] = [&particles, &mesh].map(|path| path.to_string_lossy().into_owned());
        // Cells are in radii too.
        let [radius, cube] = [RADIUS_M, cells.ratio * SPACING_M / RADIUS_M].map(|number| number.to_string());
        let mut arguments = vec!["reconstruct", &input, "-o", &output, "-r", &radius, "-l", SMOOTHING_LENGTH];
        arguments.extend(["-c", &cube, "-t", THRESHOLD, "--normals=on"]);
        arguments.extend(if is_smoothed { &SMOOTHED[..] } else { &[] });
        let mut all_ms = Vec::new();
        for _ in 0..repeats {
            observer.check()?;
            let ran = self.run(&arguments, &format!("given the {body} with {how}"))?;
            all_ms.extend(reported_ms(&String::from_utf8_lossy(&ran.stdout)));
        }
        let made = read(&mesh).map_err(|why| self.refused(format_args!("given the {body} with {how}, {why}")))?;
        let errors = mesh_errors(shape, &made)
            .ok_or_else(|| self.refused(format_args!("given the {body} with {how}, it wrote a mesh of no area")))?;
        Ok(MeshRow {
            shape: body,
            program: self.name.clone(),
            mesh: format!("{}, {how}", self.name),
            cells: cells.name,
            cell_ratio: cells.ratio,
            vertices: made.vertices.len() as u32,
            triangles: made.triangles.len() as u32,
            errors,
            ms: Quantiles::of(all_ms).map(|quantiles| quantiles.median),
            bytes: None,
        })
    }

    fn run(&self, arguments: &[&str], when: &str) -> Result<Output, BenchError> {
        let output = Command::new(&self.path)
            .args(arguments)
            .output()
            .map_err(|error| self.refused(format_args!("cannot be started: {error}")))?;
        if output.status.success() {
            return Ok(output);
        }
        let said = [&output.stderr, &output.stdout].map(|text| String::from_utf8_lossy(text).into_owned());
        let lines = || said.iter().flat_map(|text| text.lines()).map(str::trim).filter(|line| !line.is_empty());
        let line = lines().rfind(|line| line.to_lowercase().contains("error")).or_else(|| lines().next());
        Err(self.refused(format_args!(
            "{when}, it ended with {}: {}",
            output.status,
            line.unwrap_or("it said nothing")
        )))
    }

    fn refused(&self, why: impl Display) -> BenchError {
        BenchError::input(format_args!("--beside {}: {why}", self.path.display()))
    }
}

/// The mesh of a PLY file, checked as far as a comparison needs it to be right.
fn read(path: &Path) -> Result<HostMesh, String> {
    let file = fs::File::open(path).map_err(|_| "it wrote no mesh".to_owned())?;
    let unreadable = |error: serde_ply::DeserializeError| format!("its mesh cannot be read: {}", error.0);
    let Ply { vertex, face } = serde_ply::from_reader(BufReader::new(file)).map_err(unreadable)?;
    let vertices: Vec<MeshVertex> = vertex
        .into_iter()
        .map(|Vertex { x, y, z, nx, ny, nz }| MeshVertex {
            position_m: [x, y, z],
            normal: [nx, ny, nz],
            ..MeshVertex::default()
        })
        .collect();
    let is_finite =
        |vertex: &MeshVertex| [vertex.position_m, vertex.normal].as_flattened().iter().all(|x| x.is_finite());
    if let Some(wrong) = vertices.iter().position(|vertex| !is_finite(vertex)) {
        return Err(format!("vertex {wrong} of its mesh is not finite"));
    }
    let corners = |face: Face| match <[u32; 3]>::try_from(face.vertex_indices) {
        Ok(corners) if corners.iter().all(|&corner| (corner as usize) < vertices.len()) => Ok(corners),
        Ok(corners) => Err(format!("its mesh has a triangle {corners:?} and {} vertices", vertices.len())),
        Err(corners) => Err(format!("its mesh has a face of {} corners", corners.len())),
    };
    let triangles = face.into_iter().map(corners).collect::<Result<_, _>>()?;
    Ok(HostMesh { vertices, triangles, ..HostMesh::default() })
}

/// Its own time of a reconstruction, without reading and writing, ms; none if its log has another form.
fn reported_ms(log: &str) -> Option<f64> {
    let part = |name: &str| -> Option<f64> {
        let (_, figures) = log.lines().find_map(|line| line.split_once(&format!(" {name}: ")))?;
        figures.split_once(", ")?.1.split_once("ms avg")?.0.parse().ok()
    };
    Some(part("surface reconstruction")? - part("loading particle positions")? - part("write surface mesh to file")?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_time_is_without_files() {
        let log = "[INFO] reconstruct subcommand: 100.00%, 53.26ms avg, 1 call (total: 0.053s)\n\
                   [INFO]   surface reconstruction: 99.22%, 52.84ms avg, 1 call (total: 0.053s)\n\
                   [INFO]     loading particle positions: 0.75%, 0.40ms avg, 1 call (total: 0.000s)\n\
                   [INFO]     surface reconstruction subdomain-grid: 88.30%, 46.66ms avg, 1 call (total: 0.047s)\n\
                   [INFO]     write surface mesh to file: 1.22%, 0.65ms avg, 1 call (total: 0.001s)\n";
        assert!((reported_ms(log).unwrap() - 51.79).abs() < 1e-9);
        assert_eq!(reported_ms(&log.replace("ms avg", "s")), None);
    }

    #[test]
    fn what_is_no_mesh_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mesh.ply");
        let read_text = |x: &str, face: &str| {
            let fields: String =
                ["x", "y", "z", "nx", "ny", "nz"].map(|name| format!("property float {name}\n")).concat();
            let text = format!(
                "ply\nformat ascii 1.0\nelement vertex 3\n{fields}element face 1\n\
                 property list uchar uint vertex_indices\nend_header\n{x} 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n{face}\n"
            );
            fs::write(&path, text).unwrap();
            read(&path)
        };
        assert_eq!(read(&path).unwrap_err(), "it wrote no mesh");
        let mesh = read_text("0", "3 0 1 2").unwrap();
        assert_eq!((mesh.vertices[1].position_m, mesh.triangles), ([1.0, 0.0, 0.0], vec![[0, 1, 2]]));
        for (x, face, word) in [
            ("nan", "3 0 1 2", "vertex 0"),
            ("0", "3 0 1 3", "[0, 1, 3]"),
            ("0", "4 0 1 2 0", "4 corners"),
            ("0", "3 0 1", "cannot be read"),
        ] {
            let why = read_text(x, face).unwrap_err();
            assert!(why.contains(word), "{why}");
        }
    }
}
