//! The whole of it: takes what the user did, moves the scene, paints.

use std::path::PathBuf;
use std::time::Instant;

use brooklet_fluid::Scene;
use brooklet_gpu::Gpu;
use brooklet_render::View;
use brooklet_render::surface::marching_cubes::MeshRoom;
use egui::{Context, FullOutput, PlatformOutput, RawInput, TextureId, TexturesDelta};

use crate::ViewerError;
use crate::action::{self, Action};
use crate::device_speed::{DeviceSpeed, Work, default_budget_ms};
use crate::flow::Flow;
use crate::governor::Governor;
use crate::hands::Hands;
use crate::ladder::RUNGS;
use crate::loading::Loading;
use crate::messages::{Kind, Messages};
use crate::orbit::Orbit;
use crate::panels::settings::Draft;
use crate::panels::{Face, PanelInput, PanelOutput, Panels};
use crate::playback::Playback;
use crate::presenter::{Presenter, Target};
use crate::recorder::{self, Recorder};
use crate::reload::{NewModule, NewModules};
use crate::style;
use crate::viewer_scene::{SceneDesc, Start, ViewerScene};

/// Why a plan is made whose mesh has more room.
const MESH_ROOM: &str = "room for the mesh";

/// What the program around it decides.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Where screenshots, captures and states are written.
    pub folder: PathBuf,
    /// What a frame may take, ms; none: what suits the device.
    pub budget_ms: Option<f64>,
    /// Rung of the ladder to stay on; none: it holds the budget by itself, and begins where the device's kind lets it.
    pub rung: Option<usize>,
}

/// What a frame leaves to the program around it.
pub struct Painted {
    /// The cursor, the clipboard.
    pub platform: PlatformOutput,
    /// Whether the next frame is wanted at once; otherwise when something happens.
    pub again: bool,
    /// When it is wanted at the latest.
    pub within: std::time::Duration,
    /// Actions that only the window can do: the whole screen, the end.
    pub for_window: Vec<Action>,
}

/// A scene in a window.
pub struct Viewer {
    pub(crate) gpu: Gpu,
    context: Context,
    presenter: Presenter,
    pub(crate) settings: Settings,
    pub(crate) panels: Panels,
    pub(crate) messages: Messages,
    pub(crate) current: Option<ViewerScene>,
    pub(crate) loading: Option<Loading>,
    /// What is wanted once that is done.
    next: Option<SceneDesc>,
    picture: Option<TextureId>,
    /// Fonts and icons that are not on the GPU yet.
    textures: TexturesDelta,
    pub(crate) playback: Playback,
    pub(crate) orbit: Option<Orbit>,
    /// Whether somebody moved the camera; until then it frames the scene in whatever room there is.
    pub(crate) steered: bool,
    pub(crate) room_px: [u32; 2],
    room_since: Instant,
    pub(crate) rung: usize,
    pub(crate) auto: bool,
    pub(crate) governor: Governor,
    /// The rung that it was last said the ladder had taken by itself.
    pub(crate) told_rung: Option<usize>,
    /// What each rung comes to, for the scene and the window as they are.
    pub(crate) works: Vec<Work>,
    pub(crate) waiting: Vec<String>,
    pub(crate) hands: Hands,
    modules: NewModules,
    /// Room for the surface's mesh beyond what a scene begins with.
    mesh_room: Option<MeshRoom>,
    /// Whether the device refused more of it.
    mesh_room_ends: bool,
    /// Gravity in place of the scene's own.
    pub(crate) gravity_m_s2: Option<[f64; 3]>,
    /// What is above it the ladder does not take by itself any more.
    pub(crate) least_rung: usize,
    /// Nor this, for the scene that is open: the device has no room for more of it.
    pub(crate) roomy_rung: usize,
    /// Metadata of captures.
    pub(crate) about: Vec<(String, Vec<(String, String)>)>,
}

impl Viewer {
    /// Begins to load `scene`; windows have textures of `format`.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat, scene: Scene, settings: Settings, room_px: [u32; 2]) -> Self {
        let mut viewer = Self::without_scene(gpu, format, settings, room_px);
        viewer.begin(scene);
        viewer
    }

    /// As [`Viewer::new`], with no scene until one is opened.
    pub fn without_scene(gpu: &Gpu, format: wgpu::TextureFormat, settings: Settings, room_px: [u32; 2]) -> Self {
        let context = Context::default();
        style::apply(&context);
        let speed = DeviceSpeed::of_kind(&gpu.info().device_type, gpu.tier());
        let budget_ms = settings.budget_ms.unwrap_or_else(|| default_budget_ms(gpu));
        Self {
            gpu: gpu.clone(),
            context,
            presenter: Presenter::new(gpu, format),
            panels: Panels::default(),
            messages: Messages::default(),
            current: None,
            loading: None,
            next: None,
            picture: None,
            textures: TexturesDelta::default(),
            playback: Playback::new(),
            orbit: None,
            steered: false,
            room_px,
            room_since: Instant::now(),
            rung: settings.rung.unwrap_or_default().min(RUNGS.len() - 1),
            auto: settings.rung.is_none(),
            governor: Governor::new(budget_ms, speed),
            told_rung: None,
            works: Vec::new(),
            waiting: Vec::new(),
            hands: Hands::default(),
            modules: NewModules::default(),
            mesh_room: None,
            mesh_room_ends: false,
            gravity_m_s2: None,
            least_rung: 0,
            roomy_rung: 0,
            about: vec![("build".into(), recorder::build("brooklet view"))],
            settings,
        }
    }

    /// The user interface's context, for the program around it to feed.
    pub fn context(&self) -> &Context {
        &self.context
    }

    /// The running scene.
    pub fn current(&self) -> Option<&ViewerScene> {
        self.current.as_ref()
    }

    /// The last measurement.
    pub fn stats(&self) -> Option<&brooklet_fluid::Stats> {
        self.playback.stats.as_ref()
    }

    /// What came and went since the scene began.
    pub fn flow(&self) -> Flow {
        self.playback.flow
    }

    /// Whether the simulation stands.
    pub fn is_paused(&self) -> bool {
        self.playback.paused
    }

    /// The capture being written.
    pub fn capture(&self) -> Option<&std::path::Path> {
        self.playback.recorder.as_ref().map(Recorder::path)
    }

    /// Whether a scene is in the making, or a picture of another size is wanted.
    pub fn is_loading(&self) -> bool {
        self.loading.is_some() || self.settling()
    }

    /// Notes in the capture what capturing costs.
    pub fn record_cost(&mut self, cost: &brooklet_capture::CaptureCost) {
        self.playback.record_cost(cost, &mut self.messages);
    }

    /// Rung of the quality ladder.
    pub fn rung(&self) -> usize {
        self.rung
    }

    /// Whether the ladder holds the budget by itself.
    pub fn is_auto(&self) -> bool {
        self.auto
    }

    /// What a step and the rest of a frame take, ms, medians of the last frames.
    pub fn cost_ms(&self) -> Option<(f64, f64)> {
        self.playback.times.cost_ms()
    }

    /// What the window says now.
    pub fn messages(&self) -> impl Iterator<Item = &str> {
        self.messages.latest().iter().map(|message| message.text.as_str())
    }

    /// Says something in the window.
    pub fn notify(&mut self, kind: Kind, text: impl Into<String>) {
        self.messages.notify(kind, text);
    }

    /// Whether a frame painted now would show anything new: something came back from the GPU, a load goes
    /// on, something is written. What the user does is for the program around it to know.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn has_news(&mut self) -> Result<bool, ViewerError> {
        let painted = self.presenter.reports();
        let Some(current) = &mut self.current else { return Ok(true) };
        self.playback.take_reports(current, painted, &mut self.messages)?;
        Ok(self.loading.is_some() || self.playback.has_room() || self.playback.jobs.poll(&mut self.messages))
    }

    /// Takes shaders that were compiled anew, or what is wrong with them: then those before go on.
    pub fn reload(&mut self, news: Result<Vec<NewModule>, String>) {
        let modules = match news {
            Ok(modules) if modules.is_empty() => return,
            Ok(modules) => modules,
            Err(problem) => return self.messages.notify(Kind::Error, problem),
        };
        let count = modules.len();
        let before = self.modules.clone();
        self.modules.add(modules);
        let Some(current) = &mut self.current else { return };
        match current.swap_modules(&self.modules) {
            Ok(()) => {
                self.messages.notify(Kind::Done, format!("{count} shaders compiled anew"));
                self.playback.redraw();
            }
            Err(error) => {
                self.modules = before;
                self.messages.notify(Kind::Error, error.to_string());
            }
        }
    }

    /// One frame: what the user did, what the simulation does, and all of it painted.
    ///
    /// # Errors
    /// If the device is lost. Everything else is said in the window.
    pub fn frame(&mut self, input: RawInput, target: Option<&Target<'_>>) -> Result<Painted, ViewerError> {
        self.frame_with(input, target, None)
    }

    /// As [`Viewer::frame`], with `face` in place of the panels.
    ///
    /// # Errors
    /// As [`Viewer::frame`].
    pub fn frame_with(
        &mut self,
        input: RawInput,
        target: Option<&Target<'_>>,
        face: Option<&mut Face<'_>>,
    ) -> Result<Painted, ViewerError> {
        self.take_loaded();
        let painted = self.presenter.reports();
        if let Some(current) = &mut self.current {
            self.playback.take_reports(current, painted, &mut self.messages)?;
        }
        let is_writing = self.playback.jobs.poll(&mut self.messages);
        let (mut output, panel_output) = self.lay_out(input, face);
        // Kept until it is painted: a frame may have nothing to be painted on.
        self.textures.append(std::mem::take(&mut output.textures_delta));
        let mut for_window = Vec::new();
        for action in panel_output.actions {
            for_window.extend(self.handle_action(action));
        }
        self.reach(&panel_output.pointing);
        self.follow_room(panel_output.room_px);
        self.hold_budget();
        self.make_mesh_room();
        let advanced = self.advance()?;
        let again = self.is_moving() || is_writing;
        let within = output.viewport_output.values().map(|viewport| viewport.repaint_delay).min().unwrap_or_default();
        let FullOutput { platform_output, shapes, pixels_per_point, .. } = output;
        if let Some(target) = target {
            let shapes = self.context.tessellate(shapes, pixels_per_point);
            let frame = self.presenter.paint(target, &shapes, &mut self.textures);
            if advanced {
                self.playback.painted_as(frame);
            }
        }
        Ok(Painted { platform: platform_output, again, within, for_window })
    }

    fn lay_out(&mut self, input: RawInput, mut face: Option<&mut Face<'_>>) -> (FullOutput, PanelOutput) {
        let has_messages = self.messages.fade();
        let mut panel_output = PanelOutput::default();
        let picture_px = self.current.as_ref().map(|current| current.view().size_px);
        let shown = PanelInput {
            gpu: &self.gpu,
            current: self.current.as_ref(),
            stats: self.playback.stats.as_ref(),
            loading: self.loading.as_ref().map(|loading| (loading.desc.scene.name.as_str(), &loading.progress)),
            picture: self.picture.zip(picture_px),
            paused: self.playback.paused,
            speed: self.playback.clock.speed,
            rung: self.rung,
            auto: self.auto,
            governor: &self.governor,
            times: &self.playback.times,
            left_out: self.current.as_ref().map_or(&[], |current| &current.left_out),
            capture: self.playback.recorder.as_ref().map(|recorder| (recorder.path(), recorder.bytes())),
            messages: &self.messages,
            waiting: &self.waiting,
            flow: &self.playback.flow,
            placing: self.hands.placing,
            tether: self.current.as_ref().and_then(|current| self.hands.tether(current)),
        };
        let panels = &mut self.panels;
        let context = self.context.clone();
        let output = context.run_ui(input, |ui| {
            match &mut face {
                Some(face) => face(ui, &shown, &mut panel_output),
                None => panel_output = panels.show(ui, &shown),
            }
            panel_output.actions.extend(action::pressed(ui.ctx()));
            if has_messages {
                ui.ctx().request_repaint_after(std::time::Duration::from_millis(500));
            }
        });
        (output, panel_output)
    }

    /// The view of a scene in the room there is.
    pub(crate) fn framed(&self, scene: &Scene) -> View {
        let mut scene = scene.clone();
        [scene.outputs.width_px, scene.outputs.height_px] = self.room_px;
        View::of_scene(&scene)
    }

    pub(crate) fn load(&mut self, scene: Scene, start: Start, why: &str) {
        self.weigh(&scene);
        let orbit = *self.orbit.get_or_insert(Orbit::of(&self.framed(&scene)));
        let modules = self.modules.clone();
        if !matches!(start, Start::Carry(_)) {
            (self.mesh_room, self.mesh_room_ends) = (None, false);
        }
        let desc = SceneDesc {
            scene,
            rung: RUNGS[self.rung],
            window_px: self.room_px,
            camera: orbit.camera(),
            start,
            modules,
            mesh_room: self.mesh_room,
            why: why.to_owned(),
        };
        if self.loading.is_some() {
            // A new plan for what is not there yet is the same as that with the new plan.
            let starts_anew = |desc: &SceneDesc| !matches!(desc.start, Start::Carry(_));
            let current = self.loading.as_ref().map(|loading| &loading.desc);
            let fresh = [self.next.as_ref(), current].into_iter().flatten().find(|desc| starts_anew(desc));
            let start = match (&desc.start, fresh) {
                (Start::Carry(_), Some(fresh)) => fresh.start.clone(),
                (start, _) => start.clone(),
            };
            self.next = Some(SceneDesc { start, ..desc });
            return;
        }
        match Loading::begin(&self.gpu, desc) {
            Ok(loading) => self.loading = Some(loading),
            Err(error) => self.messages.notify(Kind::Error, error.to_string()),
        }
    }

    fn take_loaded(&mut self) {
        let Some(result) = self.loading.as_mut().and_then(Loading::poll) else { return };
        let Some(Loading { mut desc, .. }) = self.loading.take() else { return };
        let carries = matches!(desc.start, Start::Carry(_));
        let why = std::mem::take(&mut desc.why);
        match result {
            Ok(mut current) => {
                if carries
                    && let Some(old) = &self.current
                    && let Err(error) = current.adopt(old)
                {
                    self.messages.notify(Kind::Error, error.to_string());
                }
                if matches!(desc.start, Start::Scene) {
                    self.playback.flow = Flow::default();
                }
                self.playback.begin(&current, carries, &mut self.messages);
                for repair in current.scene.repairs() {
                    self.messages.notify(Kind::Warning, repair);
                }
                for concession in &current.concessions {
                    self.messages.notify(Kind::Warning, concession.to_string());
                }
                self.picture = current.picture().map(|picture| self.presenter.show(picture));
                self.panels.draft = Some(Draft::new(current.scene.clone()));
                self.waiting.clear();
                self.hands.let_go();
                self.current = Some(current);
                self.governor.settle();
                self.note(&why);
                self.tell_quality();
            }
            Err(error) => {
                self.messages.notify(Kind::Error, error.to_string());
                self.load_less(&error, desc);
                if why == MESH_ROOM {
                    (self.mesh_room, self.mesh_room_ends) = (None, true);
                }
                if let Some(current) = &self.current {
                    self.panels.draft = Some(Draft::new(current.scene.clone()));
                }
            }
        }
        if let Some(desc) = self.next.take() {
            self.load(desc.scene, desc.start, &desc.why);
        }
    }

    /// A picture of the room's size, once the room has kept it for a moment.
    fn follow_room(&mut self, room_px: [u32; 2]) {
        const STILL: std::time::Duration = std::time::Duration::from_millis(150);
        if room_px != self.room_px {
            self.room_px = room_px;
            self.room_since = Instant::now();
        }
        let Some(current) = &self.current else { return };
        let wanted_px = RUNGS[self.rung].picture_px(self.room_px);
        if self.loading.is_none() && current.view().size_px != wanted_px && self.room_since.elapsed() >= STILL {
            let (scene, start) = (current.scene.clone(), Start::Carry(current.session.slot_count()));
            self.load(scene, start, "picture size");
        }
    }

    /// More room for the surface's mesh from the next picture on, where the last one lacked some.
    fn make_mesh_room(&mut self) {
        let (Some(room), Some(current)) = (self.playback.mesh_room, &self.current) else { return };
        if self.loading.is_some() || self.mesh_room_ends {
            return;
        }
        let lost = self.playback.mesh.map_or(0, |mesh| mesh.lost_triangles.max(mesh.lost_blocks));
        let text = format!("the surface's mesh lacked room for {lost} triangles or blocks: it gets more");
        self.messages.notify(Kind::Warning, text);
        self.mesh_room = Some(room);
        let (scene, start) = (current.scene.clone(), Start::Carry(current.session.slot_count()));
        self.load(scene, start, MESH_ROOM);
    }

    fn advance(&mut self) -> Result<bool, ViewerError> {
        let Some(current) = &mut self.current else { return Ok(false) };
        if let Some(gravity_m_s2) = self.gravity_m_s2 {
            current.session.set_gravity(gravity_m_s2);
        }
        let advanced = self.playback.advance(current, self.governor.budget_ms)?;
        self.hands.rest(&self.playback);
        Ok(advanced)
    }

    /// Whether there is something to see in the next frame that is not in this one.
    fn is_moving(&self) -> bool {
        self.loading.is_some() || self.current.is_some() && self.playback.is_moving() || self.settling()
    }

    fn settling(&self) -> bool {
        let wanted_px = RUNGS[self.rung].picture_px(self.room_px);
        self.current.as_ref().is_some_and(|current| current.view().size_px != wanted_px)
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        // What was never painted has nobody who misses it.
        self.textures.clear();
        self.end_capture();
        self.playback.jobs.finish();
    }
}
