//! A scene on the GPU, as the window shows it: simulated, measured and drawn.

use brooklet_fluid::drag::Drag;
use brooklet_fluid::drag_body::BodyDrag;
use brooklet_fluid::particles::resample;
use brooklet_fluid::scene::poses_before;
use brooklet_fluid::state::State;
use brooklet_fluid::{BodyMotion, FrameRequest, ParticleSource, Scene, Session, SessionRecorder};
use brooklet_gpu::{FrameReport, Gpu, RecordingId, ResourceId, Tier};
use brooklet_kernels::{MeshCounts, SolidPose};
use brooklet_render::frame::FrameValues;
use brooklet_render::left_out::{self, Absent};
use brooklet_render::surface::marching_cubes::MeshRoom;
use brooklet_render::{Camera, Concession, FrameOptions, FramePasses, ScenePlan, View, start_stepping_down};
use glam::{DQuat, DVec2, DVec3};

use crate::ViewerError;
use crate::ladder::Rung;
use crate::orbit::ray;
use crate::pick::{Hit, PickSolid, pick};
use crate::reload::NewModules;

/// What a scene is made from.
#[derive(Clone, Debug)]
pub struct SceneDesc {
    /// The scene as it was chosen, before the ladder.
    pub scene: Scene,
    /// What the ladder gives up.
    pub rung: Rung,
    /// Size of the window, pixels.
    pub window_px: [u32; 2],
    /// From where it is seen.
    pub camera: Camera,
    /// Where its particles come from.
    pub start: Start,
    /// Shaders that were compiled anew.
    pub modules: NewModules,
    /// Room for the surface's mesh, if more of it is wanted than there is at first.
    pub mesh_room: Option<MeshRoom>,
    /// Why it is made, for captures.
    pub why: String,
}

/// Where a scene's particles come from.
#[derive(Clone, Debug)]
pub enum Start {
    /// The scene's fluids.
    Scene,
    /// The scene before it, which has so many: [`ViewerScene::adopt`] brings them.
    Carry(u32),
    /// A state's, whose scene has another spacing: the same fluid, on another lattice.
    Resampled(Box<State>),
    /// A state's.
    State(Box<State>),
}

/// What one drawn frame does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewerFrame {
    /// Steps.
    pub steps: u32,
    /// Whether the state is measured after them.
    pub measures: bool,
    /// Whether the picture comes back to the host as a screenshot.
    pub screenshot: bool,
    /// Whether picture and points come back to the host for a capture.
    pub records: bool,
}

/// Points that a capture has of the fluid.
const MOST_POINTS: u32 = 1000;

/// A running scene.
pub struct ViewerScene {
    /// The scene as it was chosen.
    pub scene: Scene,
    /// What steps it, as it is after the ladder.
    pub session: Session,
    /// What its plan does without.
    pub left_out: Vec<Absent>,
    /// What of the scene the device could not do, and what `scene` has instead.
    pub concessions: Vec<Concession>,
    view: View,
    options: FrameOptions,
    passes: FramePasses,
    solids: Vec<PickSolid>,
    /// Where they were in the last picture that came back.
    poses: Vec<SolidPose>,
}

impl ViewerScene {
    /// Plans the desc and builds it, without what the device cannot do of it where that can be done without; `progress` is told
    /// of each part that is done.
    ///
    /// # Errors
    /// If the scene has no plan, or the device no room for it.
    pub fn build(
        gpu: &Gpu,
        desc: SceneDesc,
        progress: &mut dyn FnMut(usize, usize, &str),
    ) -> Result<ViewerScene, ViewerError> {
        let count = desc.rung.scene(&desc.scene).particle_count().try_into().unwrap_or(u32::MAX);
        let plan_of = |scene: &Scene| {
            let simulated = desc.rung.scene(scene);
            let looks = options(&simulated, &desc.rung, gpu.tier(), desc.mesh_room);
            let planned = plan(&simulated, ParticleSource::Count(count), View::of_scene(&simulated), looks).ok()?;
            Some(planned.session.plan)
        };
        let start = |scene: &Scene| Self::build_as_it_is(gpu, scene, &desc, progress);
        let cause = |error: &ViewerError| match error {
            ViewerError::Gpu(error) => Some(error.clone()),
            _ => None,
        };
        let (mut built, _, concessions) = start_stepping_down(gpu, &desc.scene, &plan_of, start, cause)?;
        built.concessions = concessions;
        Ok(built)
    }

    fn build_as_it_is(
        gpu: &Gpu,
        scene: &Scene,
        desc: &SceneDesc,
        progress: &mut dyn FnMut(usize, usize, &str),
    ) -> Result<ViewerScene, ViewerError> {
        let simulated = desc.rung.scene(scene);
        progress(0, 0, "filling the scene with particles");
        let resampled = matches!(desc.start, Start::Resampled(_));
        let (source, state) = match &desc.start {
            Start::Scene => (ParticleSource::Scene, None),
            Start::Carry(count) => (ParticleSource::Count(*count), None),
            Start::Resampled(state) => {
                (ParticleSource::Given(resample(&state.scene, &state.particles, &simulated)), Some(state))
            }
            Start::State(state) => (ParticleSource::Given(state.particles.clone()), Some(state)),
        };
        let view =
            View { camera: desc.camera, size_px: desc.rung.picture_px(desc.window_px), ..View::of_scene(&simulated) };
        let options = options(&simulated, &desc.rung, gpu.tier(), desc.mesh_room);
        let planned = plan(&simulated, source, view, options)?;
        let left_out =
            left_out::list(&simulated, gpu.tier(), &planned, &left_out::Recorded::default()).unwrap_or_default();
        let ScenePlan { session: mut planned, passes, .. } = planned;
        let passes = passes.ok_or(ViewerError::NoPicture)?;
        if let Some(state) = state {
            planned.start_at(state);
        }
        planned.plan = desc.modules.put_into(planned.plan).map_err(ViewerError::Shader)?;
        let mut session = Session::start_with_progress(gpu, planned, progress)?;
        if resampled {
            session.relax_start()?;
        }
        let (concessions, solids) = (Vec::new(), PickSolid::all(&simulated));
        let poses = poses_before(&simulated, &BodyMotion::first(&simulated).states);
        Ok(ViewerScene { scene: scene.clone(), session, left_out, concessions, view, options, passes, solids, poses })
    }

    /// Takes over the state of `old`, the same particles in another plan, without a way over the host.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn adopt(&mut self, old: &ViewerScene) -> Result<(), ViewerError> {
        self.passes.go_on_from(&old.passes);
        Ok(self.session.adopt(&old.session)?)
    }

    /// Applies another scene to the running one if only numbers of its plan change; false if it needs a
    /// plan of its own, and then nothing was changed.
    ///
    /// # Errors
    /// If the scene has no plan.
    pub fn apply_live(&mut self, scene: &Scene, rung: &Rung) -> Result<bool, ViewerError> {
        let simulated = rung.scene(scene);
        if needs_reset(self.session.scene(), &simulated) {
            return Ok(false);
        }
        let options = options(&simulated, rung, self.session.engine().gpu().tier(), self.options.mesh_room());
        let source = ParticleSource::Count(self.session.slot_count());
        let other = plan(&simulated, source, self.view, options)?;
        if !self.session.apply(&other.session)? {
            return Ok(false);
        }
        (self.scene, self.options) = (scene.clone(), options);
        Ok(true)
    }

    /// Runs with shaders that were compiled anew, from the next frame on.
    ///
    /// # Errors
    /// If the driver refuses one; what ran before then goes on.
    pub fn swap_modules(&mut self, modules: &NewModules) -> Result<(), ViewerError> {
        let plan = modules.put_into(self.session.engine().plan().clone()).map_err(ViewerError::Shader)?;
        Ok(self.session.swap_modules(plan)?)
    }

    /// From where it is seen, from the next picture on.
    ///
    /// # Errors
    /// If nothing could be seen from there.
    pub fn look_from(&mut self, camera: Camera) -> Result<(), ViewerError> {
        self.view.camera = camera;
        let values = FrameValues::new(&self.view, &self.options)?;
        let (engine, uniforms) = (self.session.engine_mut(), &self.passes.uniforms);
        engine.write(&uniforms.view, &[values.view]);
        engine.write(&uniforms.style, &[values.style]);
        Ok(())
    }

    /// From where it is seen.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Hands a frame to the GPU; returns its number, and waits for nothing.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn run(
        &mut self,
        request: &ViewerFrame,
        drag: Option<&Drag>,
        drag_body: Option<&BodyDrag>,
    ) -> Result<u64, ViewerError> {
        let particles = self.session.slot_count();
        let draw = [self.passes.next(self.session.engine_mut(), particles, true)];
        let color = Some(self.passes.color.id).filter(|_| request.records || request.screenshot);
        let seen = color.into_iter().chain(self.poses_id());
        let readbacks: Vec<ResourceId> = seen.chain(self.passes.readbacks()).collect();
        let request = FrameRequest {
            drag,
            drag_body,
            steps: request.steps,
            measure: request.measures,
            then: &draw,
            sample: request.records,
            readbacks: &readbacks,
            ..FrameRequest::default()
        };
        Ok(self.session.submit(&request)?)
    }

    /// The picture's texture.
    pub fn picture(&self) -> Option<&wgpu::TextureView> {
        self.session.engine().wgpu_view(self.passes.color.id)
    }

    /// The picture among a report's readbacks.
    pub fn picture_id(&self) -> ResourceId {
        self.passes.color.id
    }

    /// Takes what a finished frame tells of its picture; what its mesh came to, if it had one.
    pub fn learn(&mut self, report: &FrameReport) -> Option<MeshCounts> {
        if let Some(bytes) = self.poses_id().and_then(|id| report.readback(id)) {
            self.poses.clear();
            self.poses
                .extend(bytes.chunks_exact(size_of::<SolidPose>()).map(bytemuck::pod_read_unaligned::<SolidPose>));
        }
        self.passes.learn(report)
    }

    /// What comes back with every frame of a scene with solids: where they are.
    fn poses_id(&self) -> Option<ResourceId> {
        self.session.recorded().solid_poses.as_ref().map(|poses| poses.id)
    }

    /// The solid that was seen at a place of the picture, in parts of its width and height.
    pub fn pick(&self, at: DVec2) -> Option<Hit> {
        let ray = ray(&self.view, at);
        pick(&self.solids, &self.poses, ray.origin_m - self.view.domain_min_m, ray.direction)
    }

    /// Where a place of a solid's frame was seen, in parts of the picture's width and height.
    pub fn seen_at(&self, solid: usize, in_frame_m: DVec3) -> Option<DVec2> {
        let pose = self.poses.get(solid)?;
        let rotation = DQuat::from_array(pose.rotation.map(f64::from)).normalize();
        self.seen(DVec3::from_array(pose.position_m.map(f64::from)) + rotation * in_frame_m)
    }

    /// Where the middles of bodies' frames were seen, likewise; of those before the camera.
    pub fn bodies_seen(&self) -> impl Iterator<Item = DVec2> + '_ {
        let bodies = self.solids.iter().enumerate().filter(|(_, solid)| solid.body.is_some());
        bodies.filter_map(|(solid, _)| self.seen_at(solid, DVec3::ZERO))
    }

    /// Where a place relative to the domain's lowest corner is seen, in parts of the picture's width and height.
    pub fn seen(&self, at_m: DVec3) -> Option<DVec2> {
        let at_px = self.view.project(self.view.domain_min_m + at_m)?.at_px;
        Some(at_px / DVec2::from_array(self.view.size_px.map(f64::from)))
    }

    /// Whether the next picture would look different though nothing moves: its surface goes from one method to the other.
    pub fn fades(&self) -> bool {
        self.passes.fades(self.session.slot_count())
    }

    /// Whether its surface is a mesh, or may be one.
    pub fn is_meshed(&self) -> bool {
        self.passes.mesh_counts().is_some()
    }

    /// Room that a mesh lacked, and a quarter of that more; none if it is whole.
    pub fn lacked_room(&self, counts: &MeshCounts) -> Option<MeshRoom> {
        self.options.lacked_mesh_room(counts, MeshRoom::SPARE)
    }

    /// What frames run, in the order of their passes' times: steps, measurements, pictures.
    pub fn frame_recordings(&self) -> Vec<RecordingId> {
        let measure = self.session.recorded().measure.as_ref().map(|measure| measure.recording.id());
        let drawn = self.passes.recordings().map(|draw| draw.id());
        [self.session.step_id()].into_iter().chain(measure).chain(drawn).collect()
    }

    /// How another scene, as it is simulated, goes on with these particles: on the GPU where it has as many slots, over the
    /// host where it has not.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn start_in(&mut self, simulated: &Scene) -> Result<Start, ViewerError> {
        let slots = self.session.slot_count();
        if simulated.slot_capacity().is_none_or(|wanted| wanted == slots) {
            return Ok(Start::Carry(slots));
        }
        Ok(Start::State(Box::new(self.read_state()?)))
    }

    /// Waits, and copies the running scene to the host.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read_state(&mut self) -> Result<State, ViewerError> {
        Ok(self.session.read_state()?)
    }
}

fn options(scene: &Scene, rung: &Rung, tier: Tier, mesh_room: Option<MeshRoom>) -> FrameOptions {
    let options = rung.options(FrameOptions::for_scene(scene, tier));
    mesh_room.map_or(options, |room| options.with_mesh_room(room))
}

fn plan(scene: &Scene, source: ParticleSource, view: View, options: FrameOptions) -> Result<ScenePlan, ViewerError> {
    let recorder = SessionRecorder::new(scene, source).with_relaxation().with_drag().with_samples(MOST_POINTS);
    Ok(ScenePlan::sweep(scene, recorder, Some((view, options)))?)
}

/// Whether what the particles of one scene lack in the other is room for more.
pub fn only_grows(running: &Scene, other: &Scene) -> bool {
    let room = |scene: &Scene| scene.slot_capacity().map_or(scene.particle_count(), u64::from);
    let as_large = Scene { capacity: running.capacity, emitters: running.emitters.clone(), ..other.clone() };
    room(other) > room(running) && !needs_reset(running, &as_large)
}

/// Whether the particles of one scene mean nothing in the other.
pub fn needs_reset(running: &Scene, other: &Scene) -> bool {
    running.spacing_m != other.spacing_m
        || running.domain != other.domain
        || running.fluids != other.fluids
        || running.slot_capacity() != other.slot_capacity()
}
