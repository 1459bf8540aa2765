//! Room in a mesh's buffers: what there is, and what a mesh that found too little of it needs.

use brooklet_kernels::MeshCounts;

use super::{MarchingCubesOptions, is_whole};

/// The most that numbers of blocks, vertices and triangles hold: a vertex' number has 29 bits on the GPU.
const MOST: MeshRoom = MeshRoom { blocks: 1 << 26, vertices: 1 << 29, triangles: 1 << 30 };

/// Blocks, vertices and triangles that there is memory for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshRoom {
    /// Blocks of 4 x 4 x 4 cells that the surface may cross.
    pub blocks: u32,
    /// Vertices.
    pub vertices: u32,
    /// Triangles.
    pub triangles: u32,
}

impl MeshRoom {
    /// Room that pictures are given beyond what a mesh lacked: the next ones may be larger.
    pub const SPARE: f64 = 0.25;

    /// What the mesh that came to `counts` in this room needs, and `spare` of that more; none if all of it is there.
    /// What blocks without a place would have held is not known: they are taken to be as the others.
    /// Of a subdivided mesh, `parts` to a side, the numbers are those before.
    pub fn needed(self, counts: &MeshCounts, spare: f64, parts: u32) -> Option<Self> {
        if is_whole(counts) {
            return None;
        }
        let blocks = f64::from(counts.blocks) + f64::from(counts.lost_blocks);
        let share = blocks / f64::from(counts.blocks.max(1));
        let fine = f64::from(parts.pow(2));
        let vertices = share * (f64::from(counts.vertices) + f64::from(counts.lost_vertices)) / fine;
        // Triangles that are lost for want of a vertex have a place all the same.
        let without_place =
            if counts.triangles < self.triangles.saturating_mul(parts.pow(2)) { 0 } else { counts.lost_triangles };
        let triangles = share * (f64::from(counts.triangles) + f64::from(without_place)) / fine;
        let grown = |has: u32, needed: f64, most: u32| match needed > f64::from(has) {
            true => ((1.0 + spare) * needed).ceil().min(f64::from(most)) as u32,
            false => has,
        };
        Some(Self {
            blocks: grown(self.blocks, blocks, MOST.blocks),
            vertices: grown(self.vertices, vertices, MOST.vertices),
            triangles: grown(self.triangles, triangles, MOST.triangles),
        })
    }

    /// The larger of each.
    pub fn max(self, other: Self) -> Self {
        Self {
            blocks: self.blocks.max(other.blocks),
            vertices: self.vertices.max(other.vertices),
            triangles: self.triangles.max(other.triangles),
        }
    }

    /// For the same surface over cells `ratio` times as large: it crosses fewer by the square of that.
    pub(super) fn over_cells(self, ratio: f64) -> Self {
        let fewer = |number: u32| (f64::from(number) / (ratio * ratio)).ceil().max(1.0) as u32;
        Self { blocks: fewer(self.blocks), vertices: fewer(self.vertices), triangles: fewer(self.triangles) }
    }
}

impl MarchingCubesOptions {
    /// The room there is, of a subdivided mesh before and after that.
    pub fn room(&self) -> MeshRoom {
        let [vertices, triangles] = self.refine.coarse_room();
        MeshRoom {
            blocks: self.most_blocks,
            vertices: self.most_vertices.min(vertices),
            triangles: self.most_triangles.min(triangles),
        }
    }

    /// Room that the mesh which came to `counts` needs beside what there is, and `spare` of what it lacked more; none if it
    /// is whole, or there can be no more.
    pub fn lacked_room(&self, counts: &MeshCounts, spare: f64) -> Option<MeshRoom> {
        let room = self.room();
        room.needed(counts, spare, self.refine.parts).filter(|needed| *needed != room)
    }

    /// The same with other room.
    pub fn with_room(self, room: MeshRoom) -> Self {
        let MeshRoom { blocks: most_blocks, vertices: most_vertices, triangles: most_triangles } = room;
        let refine = self.refine.with_room(most_vertices, most_triangles);
        Self { most_blocks, most_vertices, most_triangles, refine, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_needed_is_what_there_was_and_what_was_lost() {
        let room = MeshRoom { blocks: 10, vertices: 100, triangles: 200 };
        let whole = MeshCounts { blocks: 10, vertices: 100, triangles: 200, ..MeshCounts::default() };
        assert_eq!(room.needed(&whole, 0.25, 1), None);
        let vertices = MeshCounts { lost_vertices: 20, triangles: 190, lost_triangles: 30, ..whole };
        assert_eq!(room.needed(&vertices, 0.0, 1), Some(MeshRoom { vertices: 120, ..room }));
        assert_eq!(room.needed(&vertices, 0.25, 1), Some(MeshRoom { vertices: 150, ..room }));
        let triangles = MeshCounts { lost_triangles: 30, ..whole };
        assert_eq!(room.needed(&triangles, 0.0, 1), Some(MeshRoom { triangles: 230, ..room }));
        let blocks = MeshCounts { lost_blocks: 10, ..whole };
        assert_eq!(room.needed(&blocks, 0.0, 1), Some(MeshRoom { blocks: 20, vertices: 200, triangles: 400 }));
        let endless = MeshCounts { lost_blocks: u32::MAX, lost_vertices: u32::MAX, lost_triangles: u32::MAX, ..whole };
        assert_eq!(room.needed(&endless, 1.0, 1), Some(MOST));
    }
}
