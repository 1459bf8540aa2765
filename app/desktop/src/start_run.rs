//! Starts a run's session, without what the device cannot do of the scene where that can be done without.

use brooklet_fluid::{Scene, Session};
use brooklet_gpu::{Gpu, GpuError, Plan};
use brooklet_render::left_out::{self, Absent, Recorded};
use brooklet_render::surface::marching_cubes::MeshRoom;
use brooklet_render::{Concession, FramePasses, ScenePlan, start_stepping_down};

use crate::{failure::Failure, job};

/// A session, and what its plan came to.
pub struct Started {
    /// The scene as it runs.
    pub scene: Scene,
    /// What of it the device could not do.
    pub concessions: Vec<Concession>,
    /// What simulates.
    pub session: Session,
    /// The picture's, if there is one.
    pub passes: Option<FramePasses>,
    /// Room for its mesh, if it has one.
    pub mesh_room: Option<MeshRoom>,
    /// What the plan does without.
    pub left_out: Vec<Absent>,
    /// What runs.
    pub plan: Plan,
    /// Of particles.
    pub slots: u32,
    /// Without what is drawn.
    pub bytes_per_particle: Option<f64>,
    /// Whether anything is measured.
    pub measures: bool,
}

/// Starts it.
pub fn start(gpu: &Gpu, scene: &Scene, recorded: &Recorded) -> Result<Started, Failure> {
    let count = u32::try_from(scene.particle_count()).unwrap_or(u32::MAX);
    let plan_of = |scene: &Scene| Some(ScenePlan::of_count(scene, count, gpu.tier()).ok()?.session.plan);
    let as_it_is = |scene: &Scene| -> Result<Started, (Failure, Option<GpuError>)> {
        let planned = job::plan(scene, gpu.tier()).map_err(|failure| (failure, None))?;
        let left_out =
            left_out::list(scene, gpu.tier(), &planned, recorded).map_err(|error| (job::refused(error), None))?;
        let ScenePlan { session: planned, passes, mesh_room } = planned;
        let (plan, slots) = (planned.plan.clone(), planned.slot_count());
        let (bytes_per_particle, measures) =
            (planned.recorded.bytes_per_particle(&plan), planned.recorded.measure.is_some());
        let session = brooklet_render::start(gpu, planned).map_err(|error| {
            let cause = error.gpu_error().clone();
            (Failure::input(error), Some(cause))
        })?;
        Ok(Started {
            scene: scene.clone(),
            concessions: Vec::new(),
            session,
            passes,
            mesh_room,
            left_out,
            plan,
            slots,
            bytes_per_particle,
            measures,
        })
    };
    let (started, _, concessions) = start_stepping_down(gpu, scene, &plan_of, as_it_is, |(_, cause)| cause.clone())
        .map_err(|(failure, _)| failure)?;
    Ok(Started { concessions, ..started })
}
