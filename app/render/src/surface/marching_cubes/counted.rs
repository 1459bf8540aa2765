//! What a picture's mesh came to, read back with its frame.

use brooklet_kernels::MeshCounts;

/// What captures tell of a mesh: name, unit and description of each value of [`mesh_values`].
pub const MESH_FIELDS: [(&str, &str, &str); 6] = [
    ("mesh_blocks", "1", "Blocks of 4 x 4 x 4 cells of the last picture's mesh"),
    ("mesh_vertices", "1", "Vertices of the last picture's mesh"),
    ("mesh_triangles", "1", "Triangles of the last picture's mesh"),
    ("mesh_lost_blocks", "1", "Blocks for which it had no room"),
    ("mesh_lost_vertices", "1", "Vertices for which it had no room"),
    ("mesh_lost_triangles", "1", "Triangles for which it had no room"),
];

/// The values of [`MESH_FIELDS`].
pub fn mesh_values(counts: &MeshCounts) -> [f64; 6] {
    let drawn = [counts.blocks, counts.vertices, counts.triangles];
    let lost = [counts.lost_blocks, counts.lost_vertices, counts.lost_triangles];
    std::array::from_fn(|i| f64::from(if i < 3 { drawn[i] } else { lost[i - 3] }))
}

/// Whether all of the mesh was drawn.
pub fn is_whole(counts: &MeshCounts) -> bool {
    counts.lost_blocks == 0 && counts.lost_vertices == 0 && counts.lost_triangles == 0
}
