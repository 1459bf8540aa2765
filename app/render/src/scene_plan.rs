//! A scene's whole chain as one plan: simulated, measured and drawn, as far as anything of it is wanted.

use brooklet_fluid::{Recorded, Scene, record, record_count};
use brooklet_gpu::{
    FRAMES_IN_FLIGHT, Plan, PlanError, Recording, RecordingId, ResourceId, Resources, Tier, timestamp_bytes,
};

use crate::{FrameOptions, FramePasses, Particles, RenderError, View};

/// A swept plan, and what its recordings read and write.
pub struct ScenePlan {
    /// What runs, and what was left out.
    pub plan: Plan,
    /// The simulation's buffers; its recordings are in the plan.
    pub recorded: Recorded,
    /// The picture's, if there is one.
    pub passes: Option<FramePasses>,
}

/// Why a scene has no plan.
#[derive(Debug, thiserror::Error)]
pub enum ScenePlanError {
    /// The picture.
    #[error("scene {scene}: {error}")]
    Render {
        /// The scene's name.
        scene: String,
        /// What is wrong.
        error: RenderError,
    },
    /// The recordings (a fault of this program).
    #[error(transparent)]
    Plan(#[from] PlanError),
}

impl ScenePlan {
    /// Plans `scene` with its particles for a device of `tier`.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn new(scene: &Scene, tier: Tier) -> Result<Self, ScenePlanError> {
        let mut resources = Resources::new();
        let recorded = record(&mut resources, scene);
        Self::as_scene_says(scene, tier, resources, recorded)
    }

    /// As [`ScenePlan::new`] for so many particles, which are not made: for what is only looked at.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn of_count(scene: &Scene, particles: u32, tier: Tier) -> Result<Self, ScenePlanError> {
        let mut resources = Resources::new();
        let recorded = record_count(&mut resources, scene, particles);
        Self::as_scene_says(scene, tier, resources, recorded)
    }

    fn as_scene_says(
        scene: &Scene,
        tier: Tier,
        resources: Resources,
        recorded: Recorded,
    ) -> Result<Self, ScenePlanError> {
        let looks = (View::of_scene(scene), FrameOptions::for_scene(scene, tier));
        Self::sweep(scene, resources, recorded, (scene.outputs.images > 0).then_some(looks), (Vec::new(), &[]))
    }

    /// Sweeps what was recorded, with a picture if one is looked at, and other recordings and wanted outputs besides.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn sweep(
        scene: &Scene,
        mut resources: Resources,
        recorded: Recorded,
        looks: Option<(View, FrameOptions)>,
        (others, wanted): (Vec<Recording>, &[ResourceId]),
    ) -> Result<Self, ScenePlanError> {
        let mut recordings = recorded.recordings();
        recordings.extend(others);
        let mut passes = None;
        if let Some((view, options)) = looks {
            let drawn = crate::record(&mut resources, &view, &Particles::of(&recorded), &options)
                .map_err(|error| ScenePlanError::Render { scene: scene.name.clone(), error })?;
            recordings.extend([drawn.init.clone(), drawn.draw.clone()]);
            passes = Some(drawn);
        }
        let color = passes.as_ref().map(|passes| passes.color.id);
        let wanted: Vec<ResourceId> =
            recorded.measure_id().into_iter().chain(color).chain(wanted.iter().copied()).collect();
        Ok(Self { plan: Plan::sweep(resources, recordings, &wanted)?, recorded, passes })
    }

    /// What is run once before the first frame, in order.
    pub fn init(&self) -> Vec<RecordingId> {
        let draw_init = self.passes.as_ref().map(|passes| passes.init.id());
        [self.recorded.init.id()].into_iter().chain(draw_init).collect()
    }

    /// Bytes that timestamps take of a frame that does everything, for all frames in flight.
    pub fn timestamp_memory(&self) -> u64 {
        let measure = self.recorded.measure.as_ref().map(|measure| measure.recording.id());
        let draw = self.passes.as_ref().map(|passes| passes.draw.id());
        let all = [self.recorded.step.id()].into_iter().chain(measure).chain(draw);
        FRAMES_IN_FLIGHT as u64 * timestamp_bytes(all.map(|recording| self.plan.timestamp_bound(recording)).sum())
    }
}
