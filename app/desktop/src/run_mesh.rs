//! `brooklet run --mesh`: the surface of a run's last state, whatever its pictures show.

use std::path::Path;

use brooklet_fluid::{Scene, Session};
use brooklet_gpu::Gpu;
use brooklet_render::MarchingCubesOptions;
use brooklet_render::surface::marching_cubes::export::{ExportError, check_room, mesh_particles};
use serde::Serialize;

use crate::{
    failure::Failure,
    mesh_file::{self, MeshFormat},
};

/// The mesh that a run is to end with. It is made in an engine of its own, so that the run's frames do not know of it.
pub struct RunMesh {
    gpu: Gpu,
    meshing: MarchingCubesOptions,
    format: MeshFormat,
}

/// A mesh that was written.
#[derive(Clone, Debug, Serialize)]
pub struct WrittenMesh {
    /// Its file.
    pub file: String,
    /// Side of a cell, m.
    pub cell_m: f64,
    /// Blocks of 4 x 4 x 4 cells that the surface may cross.
    pub blocks: u32,
    /// Vertices.
    pub vertices: usize,
    /// Triangles.
    pub triangles: usize,
    /// Volume inside.
    pub volume_m3: f64,
}

impl RunMesh {
    /// That of so many particles at most.
    ///
    /// # Errors
    /// If the device has no room for it, as far as that can be known before.
    pub fn new(gpu: &Gpu, scene: &Scene, slots: u32, format: MeshFormat) -> Result<Self, Failure> {
        let meshing = MarchingCubesOptions::for_scene(scene);
        check_room(gpu, slots.max(1) as usize, &meshing).map_err(|error| refused(scene, &error))?;
        Ok(Self { gpu: gpu.clone(), meshing, format })
    }

    /// Meshes the particles of `session`, whose memory it takes, and writes the file.
    ///
    /// # Errors
    /// If the device has no room after all, or the file cannot be written.
    pub fn write(self, mut session: Session, scene: &Scene, out: &Path) -> Result<WrittenMesh, Failure> {
        let positions = session.read_particles().map_err(Failure::stopped)?.positions;
        drop(session);
        let mesh = mesh_particles(&self.gpu, &positions, &self.meshing).map_err(|error| refused(scene, &error))?;
        let path = out.join("mesh").with_extension(self.format.ending());
        mesh_file::write(&path, self.format, &mesh, scene.domain.min_m)?;
        Ok(WrittenMesh {
            file: path.display().to_string(),
            cell_m: self.meshing.cell_m,
            blocks: mesh.blocks,
            vertices: mesh.vertices.len(),
            triangles: mesh.triangles.len(),
            volume_m3: mesh.volume_m3(),
        })
    }
}

fn refused(scene: &Scene, error: &ExportError) -> Failure {
    let advice = match error {
        ExportError::TooFine { .. } => "; brooklet mesh --cell makes larger ones, of what --particles ply writes",
        _ => "",
    };
    let text = format!("scene {}: --mesh: {error}{advice}", scene.name);
    if error.is_input() { Failure::Input(text) } else { Failure::Stopped(text) }
}
