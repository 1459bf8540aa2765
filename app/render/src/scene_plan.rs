//! A scene's whole chain as one plan: simulated, measured and drawn, as far as anything of it is wanted.

use brooklet_fluid::{ParticleSource, Scene, SessionPlan, SessionRecorder};
use brooklet_gpu::{FRAMES_IN_FLIGHT, Plan, PlanError, Tier, timestamp_bytes};

use crate::surface::marching_cubes::MeshRoom;
use crate::{FrameOptions, FramePasses, Particles, RenderError, Solids, View};

/// A scene's plan for a session, and the picture's handles in it.
pub struct ScenePlan {
    /// What simulates, measures and draws.
    pub session: SessionPlan,
    /// The picture's recordings and textures, if there is one.
    pub passes: Option<FramePasses>,
    /// Room for the picture's mesh, if one is drawn.
    pub mesh_room: Option<MeshRoom>,
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
    /// Plans `scene` as it says, with its particles, for a device of `tier`.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn new(scene: &Scene, tier: Tier) -> Result<Self, ScenePlanError> {
        Self::of(scene, ParticleSource::Scene, tier, None)
    }

    /// As [`ScenePlan::new`] for so many particles, which are not made: for what is only looked at.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn of_count(scene: &Scene, particles: u32, tier: Tier) -> Result<Self, ScenePlanError> {
        Self::of(scene, ParticleSource::Count(particles), tier, None)
    }

    /// As [`ScenePlan::of_count`] with at least so much room for the picture's mesh: for a session that takes over another's
    /// particles ([`brooklet_fluid::Session::adopt`]).
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn with_mesh_room(scene: &Scene, particles: u32, tier: Tier, room: MeshRoom) -> Result<Self, ScenePlanError> {
        Self::of(scene, ParticleSource::Count(particles), tier, Some(room))
    }

    fn of(
        scene: &Scene,
        source: ParticleSource,
        tier: Tier,
        mesh_room: Option<MeshRoom>,
    ) -> Result<Self, ScenePlanError> {
        let options = FrameOptions::for_scene(scene, tier);
        let looks = (View::of_scene(scene), mesh_room.map_or(options, |room| options.with_mesh_room(room)));
        Self::sweep(scene, SessionRecorder::for_tier(scene, source, tier), (scene.outputs.images > 0).then_some(looks))
    }

    /// Adds a picture of `scene` to what was recorded of it, if one is looked at, and sweeps.
    ///
    /// # Errors
    /// Every [`ScenePlanError`].
    pub fn sweep(
        scene: &Scene,
        mut recorder: SessionRecorder,
        looks: Option<(View, FrameOptions)>,
    ) -> Result<Self, ScenePlanError> {
        let (mut passes, mut mesh_room) = (None, None);
        if let Some((view, options)) = looks {
            let particles = Particles::of(&recorder.recorded);
            let solids = Solids::of(scene, &recorder.recorded);
            let drawn = crate::record_with_solids(&mut recorder.resources, &view, &particles, solids, &options)
                .map_err(|error| ScenePlanError::Render { scene: scene.name.clone(), error })?;
            recorder.add_init(&drawn.init);
            drawn.recordings().for_each(|recording| recorder.add(recording));
            recorder.want(drawn.color.id);
            drawn.auto.iter().for_each(|auto| recorder.want(auto.covered_px.id));
            // Read back with a picture: whether its mesh had room.
            drawn.mesh_counts().into_iter().for_each(|counts| recorder.want(counts.id));
            passes = Some(drawn);
            mesh_room = options.mesh_room();
        }
        Ok(Self { session: recorder.sweep()?, passes, mesh_room })
    }

    /// What runs, and what was left out.
    pub fn plan(&self) -> &Plan {
        &self.session.plan
    }

    /// Bytes that timestamps take of a frame that does everything, for all frames in flight.
    pub fn timestamp_memory(&self) -> u64 {
        let recorded = &self.session.recorded;
        let measure = recorded.measure.as_ref().map(|measure| measure.recording.id());
        let bound = |recording| self.plan().timestamp_bound(recording);
        // Of several recordings of a picture a frame runs one.
        let drawn = self.passes.iter().flat_map(|passes| passes.recordings()).map(|draw| bound(draw.id())).max();
        let all = [recorded.step.id()].into_iter().chain(measure).map(bound).chain(drawn);
        FRAMES_IN_FLIGHT as u64 * timestamp_bytes(all.sum())
    }
}
