//! Where particles come from and go to while a scene runs: nozzles, fills, drains, lifetimes. (Shaders: `emitters/`.)
//!
//! All of it is a substep's first stages: drains and ends of lifetimes empty slots, then emitters fill slots behind all
//! particles, which the substep visits as well. What is emptied is behind all particles after the next sort. Where there is no
//! sort, a compaction does that. Nothing is read back, and nothing of it is in the plan of a scene without.

mod compact;
mod drains;
mod emit;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Counters, EmitterState};

use crate::particles::buffers::Particles;
use crate::scene::{Method, Scene};
use crate::slots::Slots;
pub use compact::Compaction;
pub use drains::{Drains, drain_params};
pub use emit::{Emitters, emission_params};

/// The emitters and drains of a scene.
pub struct Sources {
    drains: Option<Drains>,
    compaction: Option<Compaction>,
    emitters: Option<Emitters>,
}

impl Sources {
    /// None of a scene whose particles neither come nor go.
    pub(crate) fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Option<Self> {
        let sorts = scene.solver.method != Method::None;
        let sources = Self {
            drains: Drains::declare(resources, scene, capacity),
            compaction: (!sorts && !scene.emitters.is_empty()).then(|| Compaction::declare(resources, capacity)),
            emitters: Emitters::declare(resources, scene),
        };
        (sources.drains.is_some() || sources.emitters.is_some()).then_some(sources)
    }

    pub(crate) fn record_init(&mut self, init: &mut Recording, scene: &Scene, capacity: u32) {
        if let Some(drains) = &mut self.drains {
            drains.record_init(init, scene);
        }
        if let Some(emitters) = &mut self.emitters {
            emitters.record_init(init, scene, capacity);
        }
    }

    /// Records what comes and goes in a substep that was begun.
    pub(crate) fn record(
        &mut self,
        recording: &mut Recording,
        slots: &mut Slots,
        counters: &mut Buffer<Counters>,
        particles: &mut Particles,
    ) {
        if let Some(drains) = &mut self.drains {
            drains.record(recording, slots, counters, particles);
        }
        if let Some(compaction) = &mut self.compaction {
            compaction.record(recording, slots, particles);
        }
        if let Some(emitters) = &mut self.emitters {
            emitters.record(recording, slots, counters, particles);
        }
    }

    /// What lasts of its emitters from substep to substep.
    pub(crate) fn emitter_states(&self) -> Option<&Buffer<EmitterState>> {
        Some(self.emitters.as_ref()?.states())
    }
}
