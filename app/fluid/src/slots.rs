//! The slots that particles stand in, and what only the GPU may know of them: how many a substep visits, its time.
//! (Shader: `shared/step_state.hlsli`.)

use std::mem::offset_of;

use brooklet_gpu::{DrawState, Recording, Resources, Targets};
use brooklet_kernels::{BeginSubstep, Buffer, Draw, EndStep, GROUPS_PER_ROW, Kernel, Predict, StepParams, StepState};

use crate::particles::{ParticleSet, is_inactive};

/// Threads of a group that the dispatch arguments in a [`StepState`] are for.
const SLOTS_PER_GROUP: u32 = Predict::GROUP_SIZE[0];

/// The slots of a simulation.
pub struct Slots {
    /// What only the GPU may know of a substep.
    pub state: Buffer<StepState>,
    /// How many there are.
    pub capacity: u32,
    /// Whether particles come and go, so that each sort counts them.
    pub counts_vary: bool,
    /// Whether the GPU chooses the substeps, of which some then visit nothing.
    pub substeps_vary: bool,
}

impl Slots {
    /// Declares the state of `capacity` slots, all of which every substep visits.
    pub fn declare(resources: &mut Resources, capacity: u32) -> Self {
        let state = resources.persistent("step_state", 1);
        Self { state, capacity, counts_vary: false, substeps_vary: false }
    }

    /// Whether every substep visits all of them. Where it does not, the GPU's number is asked by each dispatch and draw; else
    /// a dispatch of a fixed size spares the driver a look.
    pub(crate) fn are_all_visited(&self) -> bool {
        !self.counts_vary && !self.substeps_vary
    }

    /// The same slots, for another owner.
    pub fn alias(&self) -> Self {
        Self { state: self.state.alias(), ..*self }
    }

    /// Opens a substep. (Shader: `particles/begin_substep.compute`.)
    pub fn begin_substep(&mut self, recording: &mut Recording, step: &Buffer<StepParams>) {
        let kernel = BeginSubstep { step_state: self.state.write(), step_params: step.uniform() };
        recording.dispatch_groups(&kernel, [1; 3]);
    }

    /// Ends a step of substeps that vary. (Shader: `particles/end_step.compute`.)
    pub fn end_step(&mut self, recording: &mut Recording) {
        if self.substeps_vary {
            recording.dispatch_groups(&EndStep { step_state: self.state.write() }, [1; 3]);
        }
    }

    /// Runs `kernel` with a thread for each slot that the substep visits.
    pub fn dispatch<K: Kernel>(&self, recording: &mut Recording, kernel: &K) {
        const { assert!(K::GROUP_SIZE[0] * K::GROUP_SIZE[1] * K::GROUP_SIZE[2] == SLOTS_PER_GROUP) };
        match self.are_all_visited() {
            true => recording.dispatch(kernel, self.capacity),
            false => recording.dispatch_indirect(
                kernel,
                &self.state,
                offset_of!(StepState, slot_groups) as u32,
                self.capacity,
            ),
        }
    }

    /// Draws a triangle for each slot that the substep visits.
    pub fn draw<D: Draw>(&self, recording: &mut Recording, draw: &D, targets: &Targets<'_>, state: DrawState) {
        match self.are_all_visited() {
            true => recording.draw(draw, targets, state, 3, self.capacity),
            false => {
                let offset = offset_of!(StepState, vertex_count) as u32;
                recording.draw_indirect(draw, targets, state, &self.state, offset, self.capacity);
            }
        }
    }
}

/// The state in which a substep visits `slot_count` slots. (Shader: `VisitSlots`.)
pub fn visit_slots(slot_count: u32) -> StepState {
    let groups = slot_count.div_ceil(SLOTS_PER_GROUP);
    StepState {
        slot_count,
        active_count: slot_count,
        slot_groups: [groups.min(GROUPS_PER_ROW), groups.div_ceil(GROUPS_PER_ROW), 1],
        vertex_count: 3,
        instance_count: slot_count,
        ..StepState::default()
    }
}

impl Slots {
    /// The state in which `particles` begin at `time_s`: all of them are visited, whatever stands between them; every slot
    /// where their number is the same from step to step.
    pub fn state_of(&self, particles: &ParticleSet, time_s: f64) -> StepState {
        let last = particles.positions.iter().rposition(|position| !is_inactive(position.tag));
        let visited = match self.counts_vary {
            true => last.map_or(0, |last| last as u32 + 1),
            false => self.capacity,
        };
        let rounded_s = time_s as f32;
        let time_lost_s = (f64::from(rounded_s) - time_s) as f32;
        StepState { time_s: rounded_s, time_lost_s, ..visit_slots(visited) }
    }
}
