//! Wavefront OBJ, by `tobj`.

use glam::DVec3;
use tobj::LoadOptions;

use crate::mesh::{MOST_TRIANGLES, Mesh};

pub fn mesh(bytes: &[u8]) -> Result<Mesh, String> {
    let options = LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..LoadOptions::default() };
    // What materials it names is nothing to a shape.
    let (models, _) = tobj::load_obj_buf(&mut &bytes[..], &options, |_| Ok(Default::default()))
        .map_err(|error| format!("is no OBJ file that can be read: {error}"))?;
    let mut mesh = Mesh::default();
    for model in models {
        let own = model.mesh;
        let name = &model.name;
        let first = mesh.positions_m.len() as u32;
        let places = own.positions.chunks_exact(3).map(|at| DVec3::new(at[0].into(), at[1].into(), at[2].into()));
        mesh.positions_m.extend(places);
        let corners = mesh.positions_m.len() as u32 - first;
        for triangle in own.indices.chunks_exact(3) {
            if let Some(corner) = triangle.iter().find(|&&corner| corner >= corners) {
                return Err(format!("object {name:?} has a face with corner {corner}, and there are {corners}"));
            }
            mesh.triangles.push([triangle[0], triangle[1], triangle[2]].map(|corner| first + corner));
        }
        if mesh.triangles.len() > MOST_TRIANGLES {
            return Err(format!("has more than the {MOST_TRIANGLES} triangles that fit"));
        }
    }
    Ok(mesh)
}
