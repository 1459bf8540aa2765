//! What every stage of a substep is given, whichever solver records it.

use brooklet_gpu::Resources;
use brooklet_kernels::{Buffer, Counters, StepParams, WallsKeyword};

use crate::boundary::solids::Solids;
use crate::boundary::{DragWalls, RepelWalls};
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
    /// What repels from its walls, if more than pressure does.
    pub repel_walls: Option<RepelWalls>,
    /// What drags along its walls, if anything does.
    pub drag_walls: Option<DragWalls>,
    /// The solids in it, if there are any.
    pub solids: Option<Solids>,
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
            repel_walls: RepelWalls::declare(resources, scene),
            drag_walls: DragWalls::declare(resources, scene),
            solids: Solids::declare(resources, scene, &slots, &step),
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
