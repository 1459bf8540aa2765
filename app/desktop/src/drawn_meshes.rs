//! The meshes of a run's pictures: what they came to, and what of them found no room.

use brooklet_kernels::MeshCounts;
use brooklet_render::surface::marching_cubes::is_whole;
use serde::Serialize;

/// The meshes of a run's pictures.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct DrawnMeshes {
    /// Of the last one.
    pub blocks: u32,
    /// Of the last one.
    pub vertices: u32,
    /// Of the last one.
    pub triangles: u32,
    /// Meshes that lacked room: their pictures are drawn once more with more of it, as far as the device has that.
    pub without_room: u64,
    /// Blocks that those lacked, summed.
    pub lost_blocks: u64,
    /// Vertices that those lacked, summed.
    pub lost_vertices: u64,
    /// Triangles that those lacked, summed.
    pub lost_triangles: u64,
    /// Pictures that were written with a part of the mesh, as the device has no more room.
    pub cut_short: u64,
    #[serde(skip)]
    last: Option<MeshCounts>,
}

impl DrawnMeshes {
    /// Takes that of a picture.
    pub fn add(&mut self, counts: &MeshCounts) {
        self.last = Some(*counts);
        (self.blocks, self.vertices, self.triangles) = (counts.blocks, counts.vertices, counts.triangles);
        self.without_room += u64::from(!is_whole(counts));
        self.lost_blocks += u64::from(counts.lost_blocks);
        self.lost_vertices += u64::from(counts.lost_vertices);
        self.lost_triangles += u64::from(counts.lost_triangles);
    }

    /// The last one.
    pub fn last(&self) -> Option<&MeshCounts> {
        self.last.as_ref()
    }

    /// Says what there was of them, if anything.
    pub fn print(&self) {
        if self.last.is_none() {
            return;
        }
        say!("mesh: {} vertices, {} triangles in the last picture", self.vertices, self.triangles);
        if self.without_room > 0 {
            say!(
                "meshes that lacked room: {}, for {} blocks, {} vertices and {} triangles in all; drawn again with more of \
                 it, but for {} that show a part",
                self.without_room,
                self.lost_blocks,
                self.lost_vertices,
                self.lost_triangles,
                self.cut_short,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_and_what_was_lost() {
        let mut meshes = DrawnMeshes::default();
        meshes.add(&MeshCounts { vertices: 9, triangles: 8, lost_triangles: 3, ..MeshCounts::default() });
        meshes.add(&MeshCounts { vertices: 9, triangles: 11, ..MeshCounts::default() });
        assert_eq!((meshes.triangles, meshes.lost_triangles, meshes.without_room), (11, 3, 1));
        assert_eq!(meshes.last().unwrap().triangles, 11);
    }
}
