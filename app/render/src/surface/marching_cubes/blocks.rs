//! The blocks of the grid that the field is made in: those that the surface may cross, or all of them.

use brooklet_gpu::{Recording, Resources, group_grid};
use brooklet_kernels::{BLOCK_LISTED, Buffer, FIELD_BLOCKS, ListBlocks, MarkBlocks, MeshCounts, MeshParams};

use super::bins::Bins;
use super::scanned;

/// Blocks, and what is known of each.
pub(super) struct Blocks {
    /// Its place in the list, or what all of it is.
    pub entries: Buffer<u32>,
    /// Which of its points are inside, a bit each.
    pub inside: Buffer<[u32; 2]>,
    /// The blocks that the field is made in.
    pub listed: Buffer<u32>,
}

/// Records the blocks that the surface may cross, and how many they are.
pub(super) fn record_sparse(
    resources: &mut Resources,
    recording: &mut Recording,
    bins: &Bins,
    (mesh, params): (&Buffer<MeshParams>, &MeshParams),
    counts: &mut Buffer<MeshCounts>,
) -> Blocks {
    let mut is_listed = resources.buffer("block_listed", params.block_count);
    let mut entries = resources.buffer("block_entries", params.block_count);
    let mut inside = resources.buffer("block_inside", params.block_count);
    recording.clear(counts);
    recording.dispatch_groups(
        &MarkBlocks {
            bin_starts: bins.starts.read(),
            block_listed: is_listed.write(),
            block_entries: entries.write(),
            block_inside: inside.write(),
            mesh: mesh.uniform(),
        },
        group_grid(params.mark_groups.iter().product()),
    );
    let starts = scanned(resources, recording, "block_starts", &is_listed);
    let mut listed = resources.buffer("listed_blocks", params.most_blocks);
    recording.dispatch(
        &ListBlocks {
            block_listed: is_listed.read(),
            block_starts: starts.read(),
            block_entries: entries.write(),
            listed_blocks: listed.write(),
            mesh_counts: counts.write(),
            mesh: mesh.uniform(),
        },
        params.block_count,
    );
    Blocks { entries, inside, listed }
}

/// Uploads that all blocks are listed.
pub(super) fn record_dense(
    resources: &mut Resources,
    (init, recording): (&mut Recording, &mut Recording),
    params: &MeshParams,
    counts: &mut Buffer<MeshCounts>,
) -> Blocks {
    let count = params.block_count;
    let mut listed = resources.persistent("listed_blocks", count);
    init.upload(&mut listed, &(0..count).collect::<Vec<u32>>());
    let mut entries = resources.persistent("block_entries", count);
    init.upload(&mut entries, &(0..count).map(|block| block + BLOCK_LISTED).collect::<Vec<u32>>());
    let mut all_counts = resources.persistent("all_blocks", 1);
    init.upload(
        &mut all_counts,
        &[MeshCounts {
            blocks: count,
            block_groups: group_grid(count),
            field_groups: group_grid(count.div_ceil(FIELD_BLOCKS)),
            ..MeshCounts::default()
        }],
    );
    recording.copy(&all_counts, counts);
    let mut inside = resources.buffer("block_inside", count);
    // GatherField writes all of it, which the recording cannot know.
    recording.clear(&mut inside);
    Blocks { entries, inside, listed }
}
