//! A scene's recordings and what others add to them, swept into the plan of a session.

use brooklet_gpu::{Plan, PlanError, Recording, RecordingId, ResourceId, Resources, Tier};

use crate::body_motion::BodyMotion;
use crate::diffuse::DiffuseSet;
use crate::state::State;

use super::TimeBase;
use super::relax::plan_relaxation;
use crate::drag::{DragPass, record_drag};
use crate::drag_body::{BodyDragPass, record_drag_body};
use crate::measure::{Sample, record_sample};
use crate::particles::{ParticleSet, sample_lattice};
use crate::scene::Scene;
use crate::slot_changes::{SlotChanges, record_slot_changes};
use crate::step::{Recorded, record_count};

/// Where a session's particles come from.
#[derive(Clone, Debug)]
pub enum ParticleSource {
    /// The scene's fluids, on their lattice, without compression where blocks overlap.
    Scene,
    /// These.
    Given(ParticleSet),
    /// Slots for so many, or for the scene's capacity, which nobody visits until [`crate::Session::adopt`] or
    /// [`crate::Session::write_particles`]: also for a plan that is only looked at.
    Count(u32),
}

/// A scene that is recorded, before the sweep. Another crate records what reads the simulation's buffers beside
/// it: into [`SessionRecorder::resources`], from [`SessionRecorder::recorded`], and keeps its recordings' handles
/// for [`crate::FrameRequest::then`].
pub struct SessionRecorder {
    /// Where buffers, textures and recordings are declared.
    pub resources: Resources,
    /// The simulation's recordings and buffers.
    pub recorded: Recorded,
    scene: Scene,
    particles: Option<ParticleSet>,
    drag: Option<DragPass>,
    drag_body: Option<BodyDragPass>,
    slot_changes: Option<SlotChanges>,
    sample: Option<Sample>,
    relaxes: bool,
    is_fresh: bool,
    init: Vec<RecordingId>,
    others: Vec<Recording>,
    wanted: Vec<ResourceId>,
}

impl SessionRecorder {
    /// Records `scene`: its start, a step, and a measurement if the scene measures.
    pub fn new(scene: &Scene, source: ParticleSource) -> Self {
        Self::over(Resources::new(), scene, source)
    }

    /// As [`SessionRecorder::new`] for a device of `tier`: on a phone's rather with less memory than with fewer dispatches.
    pub fn for_tier(scene: &Scene, source: ParticleSource, tier: Tier) -> Self {
        let resources = match tier {
            Tier::Desktop => Resources::new(),
            Tier::Mobile | Tier::Floor => Resources::saving_memory(),
        };
        Self::over(resources, scene, source)
    }

    fn over(mut resources: Resources, scene: &Scene, source: ParticleSource) -> Self {
        let is_fresh = matches!(source, ParticleSource::Scene);
        let (particles, count) = match source {
            ParticleSource::Scene => with_count(sample_lattice(scene), scene),
            ParticleSource::Given(particles) => with_count(particles, scene),
            ParticleSource::Count(count) => (None, count.max(scene.slot_capacity().unwrap_or_default())),
        };
        let recorded = record_count(&mut resources, scene, count);
        Self {
            init: vec![recorded.init.id()],
            wanted: recorded.measured_ids(),
            resources,
            recorded,
            scene: scene.clone(),
            particles,
            drag: None,
            drag_body: None,
            slot_changes: None,
            sample: None,
            relaxes: false,
            is_fresh,
            others: Vec::new(),
        }
    }

    /// Lets frames drag the fluid ([`crate::FrameRequest::drag`]) and the bodies in it
    /// ([`crate::FrameRequest::drag_body`]).
    pub fn with_drag(mut self) -> Self {
        let drag = record_drag(&mut self.resources, &mut self.recorded);
        self.others.push(drag.recording.clone());
        self.drag = Some(drag);
        self.drag_body = record_drag_body(&mut self.resources, &mut self.recorded);
        self.others.extend(self.drag_body.as_ref().map(|pass| pass.recording.clone()));
        self
    }

    /// Lets frames activate blocks of at most `most_activated` particles, and deactivate
    /// ([`crate::FrameRequest::activate`], [`crate::FrameRequest::deactivate`]).
    pub fn with_slot_changes(mut self, most_activated: u32) -> Self {
        let changes = record_slot_changes(&mut self.resources, &mut self.recorded, most_activated);
        self.others.extend([changes.deactivate.clone(), changes.activate.clone()]);
        self.slot_changes = Some(changes);
        self
    }

    /// Lets frames sample at most so many particles ([`crate::FrameRequest::sample`]).
    pub fn with_samples(mut self, most_points: u32) -> Self {
        let sample = record_sample(&mut self.resources, &self.recorded, most_points);
        self.others.push(sample.recording.clone());
        self.wanted.push(sample.samples.id);
        self.sample = Some(sample);
        self
    }

    /// Takes out compression while time stands: what a change of settings leaves over ([`crate::Session::apply`],
    /// [`crate::Session::adopt`]), and on demand ([`crate::Session::relax`]). Needs a scene that measures. A scene's own
    /// particles start without compression whether it is asked for or not ([`super::relax_particles`]).
    pub fn with_relaxation(mut self) -> Self {
        let relaxation = &self.recorded.relaxation;
        self.others.extend([relaxation.list.clone(), relaxation.relax.clone()]);
        self.relaxes = true;
        self
    }

    /// Adds a recording that runs once, before the first frame. What it uploads can be changed while the session
    /// runs ([`crate::Session::apply`]).
    pub fn add_init(&mut self, recording: &Recording) {
        self.init.push(recording.id());
        self.add(recording);
    }

    /// Adds a recording that frames name.
    pub fn add(&mut self, recording: &Recording) {
        self.others.push(recording.clone());
    }

    /// Adds an output, whose passes stay in the plan.
    pub fn want(&mut self, output: ResourceId) {
        self.wanted.push(output);
    }

    /// Leaves out what nothing wants.
    ///
    /// # Errors
    /// If a recording is wrong: a fault of the program that recorded it.
    pub fn sweep(self) -> Result<SessionPlan, PlanError> {
        let relaxation = if self.is_fresh { plan_relaxation(&self.scene, self.recorded.slots.capacity)? } else { None };
        let recordings = self.recorded.recordings().into_iter().chain(self.others).collect();
        Ok(SessionPlan {
            plan: Plan::sweep(self.resources, recordings, &self.wanted)?,
            recorded: self.recorded,
            bodies: BodyMotion::first(&self.scene),
            diffuse: DiffuseSet::default(),
            scene: self.scene,
            particles: self.particles,
            drag: self.drag,
            drag_body: self.drag_body,
            slot_changes: self.slot_changes,
            sample: self.sample,
            relaxes: self.relaxes,
            relaxation: relaxation.map(Box::new),
            init: self.init,
            start: TimeBase::default(),
        })
    }
}

fn with_count(mut particles: ParticleSet, scene: &Scene) -> (Option<ParticleSet>, u32) {
    particles.fill_slots(scene.slot_capacity().unwrap_or_default());
    let count = particles.positions.len() as u32;
    (Some(particles), count)
}

/// All that a session needs but a device.
pub struct SessionPlan {
    /// What runs, and what was left out. May be exchanged for the same plan with other modules
    /// ([`Plan::with_modules`]).
    pub plan: Plan,
    /// The simulation's recordings and buffers.
    pub recorded: Recorded,
    /// The scene.
    pub scene: Scene,
    pub(super) particles: Option<ParticleSet>,
    pub(super) bodies: BodyMotion,
    pub(super) diffuse: DiffuseSet,
    pub(super) drag: Option<DragPass>,
    pub(super) drag_body: Option<BodyDragPass>,
    pub(super) slot_changes: Option<SlotChanges>,
    pub(super) sample: Option<Sample>,
    pub(super) relaxes: bool,
    pub(super) relaxation: Option<Box<SessionPlan>>,
    pub(super) init: Vec<RecordingId>,
    pub(super) start: TimeBase,
}

impl SessionPlan {
    /// Begins at a state's time and steps, with its bodies, if there are as many, its spray, foam and bubbles; its particles are
    /// the recorder's source.
    pub fn start_at(&mut self, state: &State) {
        self.start = TimeBase { steps: state.steps, simulated_s: state.time_s };
        if state.bodies.states.len() == self.bodies.states.len() {
            self.bodies = state.bodies.clone();
        }
        self.diffuse = state.diffuse.clone();
    }

    /// Number of slots: of particles, where a scene says no capacity.
    pub fn slot_count(&self) -> u32 {
        self.recorded.slots.capacity
    }
}
