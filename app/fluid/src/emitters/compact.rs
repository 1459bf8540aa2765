//! Brings inactive slots behind all particles where no sort does. (Shader: `emitters/compact.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, CountCompacted, FillHoles, ListMovers, MarkActive};

use crate::grid::Scan;
use crate::particles::buffers::Particles;
use crate::slots::Slots;

/// What a compaction of slots needs.
pub struct Compaction {
    marks: Buffer<u32>,
    ranks: Buffer<u32>,
    movers: Buffer<u32>,
    scan: Scan,
}

impl Compaction {
    /// Declares the buffers of `capacity` slots.
    pub fn declare(resources: &mut Resources, capacity: u32) -> Self {
        Self {
            marks: resources.buffer("active_marks", capacity),
            ranks: resources.buffer("active_ranks", capacity),
            movers: resources.buffer("movers", capacity),
            scan: Scan::declare(resources, "active_ranks", capacity),
        }
    }

    /// Records it.
    pub fn record(&mut self, recording: &mut Recording, slots: &mut Slots, particles: &mut Particles) {
        let mark = MarkActive {
            active_marks: self.marks.write(),
            marked_positions: particles.positions.read(),
            step_state: slots.state.uniform(),
        };
        recording.dispatch(&mark, slots.capacity);
        self.scan.record(recording, &self.marks, &mut self.ranks);
        slots.dispatch(
            recording,
            &ListMovers {
                marked_slots: self.marks.read(),
                active_ranks: self.ranks.read(),
                movers: self.movers.write(),
                step_state: slots.state.uniform(),
            },
        );
        slots.dispatch(
            recording,
            &FillHoles {
                positions: particles.positions.write(),
                velocities: particles.velocities.write(),
                marked_slots: self.marks.read(),
                active_ranks: self.ranks.read(),
                listed_movers: self.movers.read(),
                step_state: slots.state.uniform(),
            },
        );
        let count = CountCompacted {
            marked_slots: self.marks.read(),
            active_ranks: self.ranks.read(),
            compacted_state: slots.state.write(),
        };
        recording.dispatch_groups(&count, [1; 3]);
    }
}
