//! A scene's whole chain as one plan: simulated, measured and drawn, as far as anything of it is wanted.

use brooklet_fluid::{Recorded, Scene, record, record_count};
use brooklet_gpu::{Plan, PlanError, ResourceId, Resources, Tier};

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
        Self::sweep(scene, resources, recorded, (scene.outputs.images > 0).then_some(looks), &[])
    }

    /// Sweeps what was recorded, with a picture if one is looked at, and `wanted` besides.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn sweep(
        scene: &Scene,
        mut resources: Resources,
        mut recorded: Recorded,
        looks: Option<(View, FrameOptions)>,
        wanted: &[ResourceId],
    ) -> Result<Self, ScenePlanError> {
        let mut recordings = std::mem::take(&mut recorded.recordings);
        let mut passes = None;
        if let Some((view, options)) = looks {
            let drawn = crate::record(&mut resources, &view, &Particles::of(&recorded), &options)
                .map_err(|error| ScenePlanError::Render { scene: scene.name.clone(), error })?;
            recordings.extend([drawn.init.clone(), drawn.recording.clone()]);
            passes = Some(drawn);
        }
        let measure = recorded.measure.as_ref().map(|measure| measure.id);
        let color = passes.as_ref().map(|passes| passes.color.id);
        let wanted: Vec<ResourceId> = measure.into_iter().chain(color).chain(wanted.iter().copied()).collect();
        Ok(Self { plan: Plan::sweep(resources, recordings, &wanted)?, recorded, passes })
    }
}
