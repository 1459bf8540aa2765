//! The whole of it: takes what the user did, moves the world, paints.

use std::path::PathBuf;
use std::time::Instant;

use brooklet_fluid::Scene;
use brooklet_gpu::Gpu;
use brooklet_render::View;
use egui::{Context, FullOutput, PlatformOutput, RawInput, TextureId, TexturesDelta};

use crate::WorldError;
use crate::action::{self, Action};
use crate::hand::Hand;
use crate::ladder::{Governor, RUNGS};
use crate::loading::Loading;
use crate::messages::{Kind, Messages};
use crate::orbit::Orbit;
use crate::panels::settings::Draft;
use crate::panels::{Asked, Panels, Shown};
use crate::presenter::{Presenter, Target};
use crate::recorder::Recorder;
use crate::reload::{NewModule, NewModules};
use crate::running::Running;
use crate::style;
use crate::world::{Order, Start, World};

/// What the program around it decides.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Where screenshots, captures and states are written.
    pub folder: PathBuf,
    /// What a frame may take, ms.
    pub budget_ms: f64,
    /// Whether the ladder holds that by itself from the start.
    pub auto: bool,
    /// Rung to begin on.
    pub rung: usize,
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
    pub(crate) world: Option<World>,
    pub(crate) loading: Option<Loading>,
    /// What is wanted once that is done.
    next: Option<Order>,
    picture: Option<TextureId>,
    /// Fonts and icons that are not on the GPU yet.
    textures: TexturesDelta,
    pub(crate) running: Running,
    pub(crate) orbit: Option<Orbit>,
    /// Whether somebody moved the camera; until then it frames the scene in whatever room there is.
    pub(crate) steered: bool,
    room_px: [u32; 2],
    room_since: Instant,
    pub(crate) rung: usize,
    pub(crate) auto: bool,
    pub(crate) governor: Governor,
    pub(crate) waiting: Vec<String>,
    hand: Hand,
    modules: NewModules,
}

impl Viewer {
    /// Goes on with what another viewer showed: the same scene, particles and rung.
    pub fn go_on(&mut self, state: brooklet_fluid::state::State, rung: usize) {
        self.rung = rung.min(RUNGS.len() - 1);
        let start = Start::Particles { particles: state.particles, steps: state.steps, simulated_s: state.time_s };
        self.load(state.scene, start, "tier");
    }

    /// Begins to load `scene`; windows have textures of `format`.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat, scene: Scene, settings: Settings, room_px: [u32; 2]) -> Self {
        let context = Context::default();
        style::apply(&context);
        let mut viewer = Self {
            gpu: gpu.clone(),
            context,
            presenter: Presenter::new(gpu, format),
            panels: Panels::default(),
            messages: Messages::default(),
            world: None,
            loading: None,
            next: None,
            picture: None,
            textures: TexturesDelta::default(),
            running: Running::new(),
            orbit: None,
            steered: false,
            room_px,
            room_since: Instant::now(),
            rung: settings.rung.min(RUNGS.len() - 1),
            auto: settings.auto,
            governor: Governor::new(settings.budget_ms),
            waiting: Vec::new(),
            hand: Hand::default(),
            modules: NewModules::default(),
            settings,
        };
        viewer.load(scene, Start::Scene, "scene");
        viewer
    }

    /// The user interface's context, for the program around it to feed.
    pub fn context(&self) -> &Context {
        &self.context
    }

    /// The running world.
    pub fn world(&self) -> Option<&World> {
        self.world.as_ref()
    }

    /// The last measurement.
    pub fn stats(&self) -> Option<&brooklet_fluid::Stats> {
        self.running.stats.as_ref()
    }

    /// Whether the simulation stands.
    pub fn is_paused(&self) -> bool {
        self.running.paused
    }

    /// The capture being written.
    pub fn capture(&self) -> Option<&std::path::Path> {
        self.running.recorder.as_ref().map(Recorder::path)
    }

    /// Whether a world is in the making, or a picture of another size is wanted.
    pub fn is_loading(&self) -> bool {
        self.loading.is_some() || self.settling()
    }

    /// Notes in the capture what capturing costs.
    pub fn tell_cost(&mut self, cost: &brooklet_capture::CaptureCost) {
        self.running.tell_cost(cost, &mut self.messages);
    }

    /// Rung of the quality ladder.
    pub fn rung(&self) -> usize {
        self.rung
    }

    /// What the window says now.
    pub fn words(&self) -> impl Iterator<Item = &str> {
        self.messages.latest().iter().map(|message| message.text.as_str())
    }

    /// Says something in the window.
    pub fn say(&mut self, kind: Kind, text: impl Into<String>) {
        self.messages.say(kind, text);
    }

    /// Whether a frame painted now would show anything new: something came back from the GPU, a load goes
    /// on, something is written. What the user does is for the program around it to know.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn has_news(&mut self) -> Result<bool, WorldError> {
        let painted = self.presenter.reports();
        let Some(world) = &mut self.world else { return Ok(true) };
        self.running.take_reports(world, painted, &mut self.messages)?;
        Ok(self.loading.is_some() || self.running.has_room() || self.running.jobs.poll(&mut self.messages))
    }

    /// Takes shaders that were compiled anew, or what is wrong with them: then those before go on.
    pub fn reload(&mut self, news: Result<Vec<NewModule>, String>) {
        let modules = match news {
            Ok(modules) if modules.is_empty() => return,
            Ok(modules) => modules,
            Err(problem) => return self.messages.say(Kind::Error, problem),
        };
        let count = modules.len();
        let before = self.modules.clone();
        self.modules.add(modules);
        let Some(world) = &mut self.world else { return };
        match world.exchange(&self.modules) {
            Ok(()) => {
                self.messages.say(Kind::Done, format!("{count} shaders compiled anew"));
                self.running.redraw();
            }
            Err(error) => {
                self.modules = before;
                self.messages.say(Kind::Error, error.to_string());
            }
        }
    }

    /// One frame: what the user did, what the simulation does, and all of it painted.
    ///
    /// # Errors
    /// If the device is lost. Everything else is said in the window.
    pub fn frame(&mut self, input: RawInput, target: Option<&Target<'_>>) -> Result<Painted, WorldError> {
        self.take_loaded();
        let painted = self.presenter.reports();
        if let Some(world) = &mut self.world {
            self.running.take_reports(world, painted, &mut self.messages)?;
        }
        let is_writing = self.running.jobs.poll(&mut self.messages);
        let (mut output, asked) = self.lay_out(input);
        // Kept until it is painted: a frame may have nothing to be painted on.
        self.textures.append(std::mem::take(&mut output.textures_delta));
        let mut for_window = Vec::new();
        for action in asked.actions {
            for_window.extend(self.act(action));
        }
        self.steer(&asked.pointing);
        self.follow_room(asked.room_px);
        self.hold_budget();
        let advanced = self.advance()?;
        let again = self.is_moving() || is_writing;
        let within = output.viewport_output.values().map(|viewport| viewport.repaint_delay).min().unwrap_or_default();
        let FullOutput { platform_output, shapes, pixels_per_point, .. } = output;
        if let Some(target) = target {
            let shapes = self.context.tessellate(shapes, pixels_per_point);
            let frame = self.presenter.paint(target, &shapes, &mut self.textures);
            if advanced {
                self.running.painted_as(frame);
            }
        }
        Ok(Painted { platform: platform_output, again, within, for_window })
    }

    fn lay_out(&mut self, input: RawInput) -> (FullOutput, Asked) {
        let has_messages = self.messages.fade();
        let mut asked = Asked::default();
        let picture_px = self.world.as_ref().map(|world| world.view().size_px);
        let shown = Shown {
            gpu: &self.gpu,
            world: self.world.as_ref(),
            loading: self.loading.as_ref().map(|loading| (loading.order.scene.name.as_str(), &loading.progress)),
            picture: self.picture.zip(picture_px),
            paused: self.running.paused,
            speed: self.running.clock.speed,
            rung: self.rung,
            auto: self.auto,
            governor: &self.governor,
            times: &self.running.times,
            left_out: self.world.as_ref().map_or(&[], |world| &world.left_out),
            capture: self.running.recorder.as_ref().map(|recorder| (recorder.path(), recorder.bytes())),
            messages: &self.messages,
            waiting: &self.waiting,
        };
        let panels = &mut self.panels;
        let context = self.context.clone();
        let output = context.run_ui(input, |ui| {
            asked = panels.show(ui, &shown);
            asked.actions.extend(action::pressed(ui.ctx()));
            if has_messages {
                ui.ctx().request_repaint_after(std::time::Duration::from_millis(500));
            }
        });
        (output, asked)
    }

    /// The view of a scene in the room there is.
    pub(crate) fn framed(&self, scene: &Scene) -> View {
        let mut scene = scene.clone();
        [scene.outputs.width_px, scene.outputs.height_px] = self.room_px;
        View::of_scene(&scene)
    }

    pub(crate) fn load(&mut self, scene: Scene, start: Start, why: &str) {
        let orbit = *self.orbit.get_or_insert(Orbit::of(&self.framed(&scene)));
        let modules = self.modules.clone();
        let order = Order {
            scene,
            rung: RUNGS[self.rung],
            window_px: self.room_px,
            camera: orbit.camera(),
            start,
            modules,
            why: why.to_owned(),
        };
        if self.loading.is_some() {
            // A new plan for what is not there yet is the same as that with the new plan.
            let starts_anew = |order: &Order| !matches!(order.start, Start::Carry(_));
            let current = self.loading.as_ref().map(|loading| &loading.order);
            let fresh = [self.next.as_ref(), current].into_iter().flatten().find(|order| starts_anew(order));
            let start = match (&order.start, fresh) {
                (Start::Carry(_), Some(fresh)) => fresh.start.clone(),
                (start, _) => start.clone(),
            };
            self.next = Some(Order { start, ..order });
            return;
        }
        match Loading::begin(&self.gpu, order) {
            Ok(loading) => self.loading = Some(loading),
            Err(error) => self.messages.say(Kind::Error, error.to_string()),
        }
    }

    fn take_loaded(&mut self) {
        let Some(loading) = &mut self.loading else { return };
        let Some(result) = loading.poll() else { return };
        let carries = matches!(loading.order.start, Start::Carry(_));
        let why = std::mem::take(&mut loading.order.why);
        self.loading = None;
        match result {
            Ok(mut world) => {
                if carries
                    && let Some(old) = &self.world
                    && let Err(error) = world.adopt(old)
                {
                    self.messages.say(Kind::Error, error.to_string());
                }
                self.running.begin(&world, carries, &mut self.messages);
                self.picture = world.picture().map(|picture| self.presenter.show(picture));
                self.panels.draft = Some(Draft::new(world.scene.clone()));
                self.waiting.clear();
                self.world = Some(world);
                self.governor.settle();
                self.note(&why);
            }
            Err(error) => {
                self.messages.say(Kind::Error, error.to_string());
                if let Some(world) = &self.world {
                    self.panels.draft = Some(Draft::new(world.scene.clone()));
                }
            }
        }
        if let Some(order) = self.next.take() {
            self.load(order.scene, order.start, &order.why);
        }
    }

    fn steer(&mut self, pointing: &crate::pointer::Pointing) {
        let Some(orbit) = &mut self.orbit else { return };
        self.steered |= pointing.steer(orbit);
        if !self.steered
            && let Some(world) = &self.world
        {
            self.orbit = Some(Orbit::of(&self.framed(&world.scene)));
        }
        let (Some(orbit), Some(world)) = (&self.orbit, &mut self.world) else { return };
        let camera = orbit.camera();
        if world.view().camera != camera {
            if let Err(error) = world.look_from(camera) {
                self.messages.say(Kind::Error, error.to_string());
            }
            self.running.redraw();
        }
        self.running.pull = self.hand.pull(pointing, world.view());
    }

    /// A picture of the room's size, once the room has kept it for a moment.
    fn follow_room(&mut self, room_px: [u32; 2]) {
        const STILL: std::time::Duration = std::time::Duration::from_millis(150);
        if room_px != self.room_px {
            self.room_px = room_px;
            self.room_since = Instant::now();
        }
        let Some(world) = &self.world else { return };
        let wanted_px = RUNGS[self.rung].picture_px(self.room_px);
        if self.loading.is_none() && world.view().size_px != wanted_px && self.room_since.elapsed() >= STILL {
            let (scene, start) = (world.scene.clone(), Start::Carry(world.session.particle_count()));
            self.load(scene, start, "picture size");
        }
    }

    fn hold_budget(&mut self) {
        if !self.auto || self.loading.is_some() || self.running.paused {
            return;
        }
        let Some(needed_ms) = self.running.take_needed_ms(self.world.as_ref(), self.governor.budget_ms) else { return };
        let rung = match self.governor.take(needed_ms) {
            Some(crate::ladder::Move::Down) => self.rung + 1,
            Some(crate::ladder::Move::Up) => self.rung.saturating_sub(1),
            None => return,
        };
        self.take_rung(rung);
    }

    fn advance(&mut self) -> Result<bool, WorldError> {
        let Some(world) = &mut self.world else { return Ok(false) };
        let advanced = self.running.advance(world, self.governor.budget_ms)?;
        // While the simulation stands nothing is moved by hand, nor later for it.
        if self.running.pull.is_none() || self.running.paused {
            self.hand.restart();
        }
        Ok(advanced)
    }

    /// Whether there is something to see in the next frame that is not in this one.
    fn is_moving(&self) -> bool {
        self.loading.is_some() || self.world.is_some() && self.running.is_moving() || self.settling()
    }

    fn settling(&self) -> bool {
        let wanted_px = RUNGS[self.rung].picture_px(self.room_px);
        self.world.as_ref().is_some_and(|world| world.view().size_px != wanted_px)
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        // What was never painted has nobody who misses it.
        self.textures.clear();
        self.end_capture();
        self.running.jobs.finish();
    }
}
