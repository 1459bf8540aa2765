//! Each particle's neighbours: sorted indices in ascending order as deltas of 16 bits, in slices of
//! particles. (Shaders: `shared/list.hlsli`, `grid/list_neighbours.compute`.)
//!
//! 16 bits take half the memory and the loads of 32: 1.39 million lists of 48 fit a binding of 128 MiB.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, LIST_CHUNK, LIST_ESCAPE, LIST_ESCAPE_DELTA, LIST_SLICE, ListHead, ListNeighbours, ListNeighboursVariant,
    SearchGroups,
};

use super::{Grid, Sorted, dispatch_if_due};
use crate::scene::Scene;
use crate::slots::Slots;
use crate::step_context::StepContext;

/// Room for neighbours a particle, in runs of `LIST_CHUNK`.
pub fn list_chunks(scene: &Scene) -> u32 {
    scene.neighbour_slots().div_ceil(LIST_CHUNK)
}

/// Runs of four neighbours in the lists of so many slots, whole slices.
pub fn list_length(slots: u32, list_chunks: u32) -> u32 {
    slots.next_multiple_of(LIST_SLICE).saturating_mul(list_chunks)
}

/// The neighbours of particle `i` in lists of `list_chunks` runs that were read back.
pub fn listed(i: u32, head: ListHead, lists: &[[u32; 2]], list_chunks: u32) -> impl Iterator<Item = u32> {
    let first_chunk = i / LIST_SLICE * LIST_SLICE * list_chunks + i % LIST_SLICE;
    let mut last = head.first.wrapping_sub(1);
    (0..head.entries).filter_map(move |entry| {
        let chunk = lists[(first_chunk + entry / LIST_CHUNK * LIST_SLICE) as usize];
        let delta = chunk[(entry / 2 % 2) as usize] >> (entry % 2 * 16) & 0xffff;
        last = last.wrapping_add(if delta == LIST_ESCAPE { LIST_ESCAPE_DELTA } else { delta });
        (delta != LIST_ESCAPE).then_some(last)
    })
}

/// The lists, made once a substep.
pub struct Neighbours {
    /// Deltas of sorted indices, four of a particle side by side, interleaved over slices of
    /// `LIST_SLICE` particles.
    pub deltas: Buffer<[u32; 2]>,
    /// Where each list begins, and its length.
    pub heads: Buffer<ListHead>,
}

impl Neighbours {
    /// Declares the lists of so many slots, with room for `list_chunks` runs each. They persist from the step that made
    /// them to the measurement that reads them.
    pub fn declare(resources: &mut Resources, capacity: u32, list_chunks: u32) -> Self {
        Self {
            deltas: resources.persistent("neighbours", list_length(capacity, list_chunks)),
            heads: resources.persistent("list_heads", capacity),
        }
    }

    /// The same lists, for another owner.
    pub fn alias(&self) -> Self {
        Self { deltas: self.deltas.alias(), heads: self.heads.alias() }
    }

    /// Nobody reads the lists until they are made anew, for every slot: a substep that visits nothing leaves them as they are.
    pub(super) fn forget(&self, recording: &mut Recording, slots: &Slots) {
        if slots.are_all_visited() {
            recording.forget(&self.deltas);
            recording.forget(&self.heads);
        }
    }

    /// Lists the neighbours of the sorted particles.
    pub fn record(&mut self, recording: &mut Recording, context: &mut StepContext, grid: &Grid, sorted: &Sorted) {
        self.record_if_due(recording, context, grid, sorted, None);
    }

    /// The same, in substeps that the GPU says.
    pub(super) fn record_if_due(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        grid: &Grid,
        sorted: &Sorted,
        due: Option<&Buffer<SearchGroups>>,
    ) {
        dispatch_if_due(
            recording,
            &context.slots,
            due,
            &ListNeighbours {
                variant: ListNeighboursVariant {
                    wrapped: grid.wrapped,
                    periodic: grid.periodic,
                    precision: sorted.precision,
                },
                sorted_positions: sorted.positions.read(),
                quantized_positions: sorted.quantized_positions.read(),
                cell_starts: grid.cell_starts.read(),
                neighbours: self.deltas.write(),
                list_heads: self.heads.write(),
                counters: context.counters.write(),
                step_state: context.slots.state.uniform(),
                grid: grid.params.uniform(),
            },
        );
    }
}
