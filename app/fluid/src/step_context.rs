//! What every stage of a substep is given, whichever solver records it.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Counters, Position, StepParams, Velocity, WallsKeyword};

use crate::boundary::DragWalls;
use crate::boundary::solids::Solids;
use crate::diffuse::Diffuse;
use crate::emitters::Sources;
use crate::scene::Scene;
use crate::slots::Slots;

/// Settings, counters and variants that the stages of a substep share.
pub struct StepContext {
    /// Gravity, domain, the step of time that is asked for.
    pub step: Buffer<StepParams>,
    /// The slots that particles stand in, and what only the GPU knows of a substep.
    pub slots: Slots,
    /// Events that are counted.
    pub counters: Buffer<Counters>,
    /// Whether the domain has walls.
    pub walls: bool,
    /// Whether it has periodic axes.
    pub periodic: bool,
    /// What drags along its walls, if anything does.
    pub drag_walls: Option<DragWalls>,
    /// The solids in it, if there are any.
    pub solids: Option<Solids>,
    /// Spray, foam and bubbles, if there are any.
    pub(crate) diffuse: Option<Diffuse>,
    /// What particles come from and go to, if they do.
    pub sources: Option<Sources>,
}

impl StepContext {
    /// Declares what `capacity` slots of `scene` need.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        let step = resources.persistent("step_params", 1);
        let slots = Slots {
            counts_vary: scene.slot_capacity().is_some(),
            substeps_vary: scene.adapts_substeps(),
            ..Slots::declare(resources, capacity)
        };
        Self {
            counters: resources.persistent("counters", 1),
            walls: scene.domain.has_walls(),
            periodic: scene.domain.is_periodic(),
            drag_walls: DragWalls::declare(resources, scene),
            solids: Solids::declare(resources, scene, &slots, &step),
            diffuse: Diffuse::declare(resources, scene, capacity),
            sources: Sources::declare(resources, scene, capacity),
            step,
            slots,
        }
    }

    /// What bounds the fluid, as stages choose their variants.
    pub fn boundary(&self) -> WallsKeyword {
        match self.solids {
            Some(_) => WallsKeyword::SolidWalls,
            None => self.walls.into(),
        }
    }
}

/// The particles between two substeps.
pub struct Particles {
    /// Where they are, relative to the domain's lowest corner.
    pub positions: Buffer<Position>,
    /// How fast they are, in the same order.
    pub velocities: Buffer<Velocity>,
}

impl Particles {
    /// Declares `count` particles.
    pub fn declare(resources: &mut Resources, count: u32) -> Self {
        Self {
            positions: resources.persistent("positions", count),
            velocities: resources.persistent("velocities", count),
        }
    }

    /// After a sort: what stands here is not read until all of it is written, from the sorted particles. Where the
    /// number of slots that are visited varies, those beyond it keep their ids.
    pub fn forget_until_moved(&self, recording: &mut Recording, slots: &Slots) {
        if slots.are_all_visited() {
            recording.forget(&self.positions);
            recording.forget(&self.velocities);
        }
    }
}
