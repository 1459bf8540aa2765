//! Doing what was asked for.

use std::path::{Path, PathBuf};

use brooklet_capture::StateRow;
use brooklet_fluid::state::{self, State};
use brooklet_fluid::{Scene, SceneError};
use brooklet_gpu::tier_name;

use crate::action::Action;
use crate::files::free_name;
use crate::ladder::RUNGS;
use crate::messages::Kind;
use crate::recorder::Recorder;
use crate::viewer::Viewer;
use crate::viewer_scene::{Start, needs_reset, only_grows};

impl Viewer {
    /// Does what is asked for; gives back what only the window can do.
    pub fn handle_action(&mut self, action: Action) -> Option<Action> {
        match action {
            Action::Fullscreen | Action::Quit | Action::Tier(_) => return Some(action),
            Action::Pause => {
                self.playback.paused = !self.playback.paused;
                self.note(if self.playback.paused { "paused" } else { "goes on" });
            }
            Action::Step => self.playback.step_once(),
            Action::Reset => self.reset(),
            Action::Open(name) => self.open(&name),
            Action::Apply(scene) => self.apply(*scene),
            Action::Place(place) => self.hands.placing = place,
            Action::Speed(speed) => self.playback.clock.speed = speed,
            Action::Screenshot => {
                self.playback.screenshot = Some(free_name(&self.settings.folder, &self.name(), "png"));
            }
            Action::Capture => self.toggle_capture(),
            Action::SaveState => self.save_state(),
            Action::RestoreState(path) => {
                let path = path.unwrap_or_else(|| self.state_file());
                self.restore_state(&path);
            }
            Action::Rung(rung) => {
                self.auto = false;
                self.take_rung(rung);
            }
            Action::Auto(auto) => self.auto = auto,
            Action::Budget(budget_ms) => self.governor.set_budget(budget_ms),
            Action::ResetCamera => self.steered = false,
            Action::Panels => self.panels.shown = !self.panels.shown,
            Action::Overlay => self.panels.overlay = !self.panels.overlay,
            Action::Help => self.panels.help = !self.panels.help,
        }
        None
    }

    /// Opens a shipped scene by its name, or a file: a scene, or a saved state. An error is said, and the
    /// scene that runs goes on.
    pub fn open(&mut self, name_or_path: &str) {
        if State::is_file_name(name_or_path) {
            return self.restore_state(Path::new(name_or_path));
        }
        match Scene::load(name_or_path, &[]) {
            Ok(scene) => {
                (self.orbit, self.steered) = (None, false);
                self.begin(scene);
            }
            Err(error) => self.refuse(&error),
        }
    }

    fn refuse(&mut self, error: &SceneError) {
        self.messages.notify(Kind::Error, error.to_string());
    }

    fn reset(&mut self) {
        let draft = self.panels.draft.as_ref().map(|draft| draft.scene.clone());
        if let Some(scene) = draft.or_else(|| self.current.as_ref().map(|current| current.scene.clone())) {
            self.load(scene, Start::Scene, "reset");
        }
    }

    /// Takes other settings: at once where only numbers change, with another plan and the same
    /// particles where more does, and where the particles themselves would be others, at the next reset.
    pub fn apply(&mut self, scene: Scene) {
        let Some(current) = &mut self.current else { return };
        let grows = only_grows(&current.scene, &scene);
        if needs_reset(&current.scene, &scene) && !grows {
            let (running, wanted) = (&current.scene, &scene);
            let parts = [
                ("spacing", running.spacing_m != wanted.spacing_m),
                ("domain", running.domain != wanted.domain),
                ("fluids", running.fluids != wanted.fluids),
                ("room for particles", running.slot_capacity() != wanted.slot_capacity()),
            ];
            self.waiting = parts.iter().filter(|(_, waits)| *waits).map(|(name, _)| (*name).to_owned()).collect();
            return;
        }
        self.waiting.clear();
        let rung = &RUNGS[self.rung];
        let applied = if grows { Ok(false) } else { current.apply_live(&scene, rung) };
        let start = match applied {
            Ok(true) => return self.note("settings"),
            Ok(false) => current.start_in(&rung.scene(&scene)),
            Err(error) => Err(error),
        };
        match start {
            Ok(start) => self.load(scene, start, "settings"),
            Err(error) => self.messages.notify(Kind::Error, error.to_string()),
        }
    }

    /// Tells the capture what is computed and drawn from now on, and what changed.
    pub(crate) fn note(&mut self, event: &str) {
        let Some(current) = &self.current else { return };
        let scene = current.session.scene();
        let solver = &scene.solver;
        let name = |value: &dyn std::fmt::Debug| format!("{value:?}").to_lowercase();
        // With the kernel or format, and why: a capture is what is sent from a phone that nobody else has.
        let concessions = current.concessions.iter().map(|concession| format!("; {concession}"));
        let event = concessions.fold(event.to_owned(), |event, concession| event + &concession);
        let state = StateRow {
            event,
            scene: Some(current.scene.name.clone()),
            tier: tier_name(self.gpu.tier()).to_owned(),
            precision: name(&solver.precision),
            surface: name(&scene.surface.method),
            rung: self.rung as i32,
            rung_name: RUNGS[self.rung].name.to_owned(),
            paused: self.playback.paused,
            particles: Some(u64::from(current.session.slot_count())),
            substeps: Some(solver.substeps),
            iterations: solver.iterations(),
            ..StateRow::default()
        };
        self.playback.note(&state, &mut self.messages);
    }

    /// A name for files of the running scene.
    fn name(&self) -> String {
        self.current.as_ref().map_or_else(|| "brooklet".to_owned(), |current| current.scene.name.clone())
    }

    fn toggle_capture(&mut self) {
        if self.playback.recorder.is_some() {
            self.end_capture();
            return;
        }
        let Some(current) = &self.current else { return };
        let path = free_name(&self.settings.folder, &self.name(), "mcap");
        let begun = std::fs::create_dir_all(&self.settings.folder)
            .map_err(|error| format!("{}: {error}", self.settings.folder.display()))
            .and_then(|()| Recorder::begin(path, &self.gpu, current, &self.about).map_err(|error| error.to_string()));
        match begun {
            Ok(recorder) => {
                self.playback.recorder = Some(recorder);
                self.note("the capture begins");
            }
            Err(reason) => self.messages.notify(Kind::Error, reason),
        }
    }

    /// Writes the capture's end, if there is one.
    pub fn end_capture(&mut self) {
        let Some(recorder) = self.playback.recorder.take() else { return };
        let path = recorder.path().display().to_string();
        match recorder.finish() {
            Ok(totals) => self.messages.notify(Kind::Done, format!("capture {path}: {} frames", totals.frames)),
            Err(error) => self.messages.notify(Kind::Error, error.to_string()),
        }
    }

    fn state_file(&self) -> PathBuf {
        self.settings.folder.join(format!("state.{}", state::EXTENSION))
    }

    fn save_state(&mut self) {
        let path = self.state_file();
        let Some(current) = &mut self.current else { return };
        let state = match current.read_state() {
            Ok(state) => state,
            Err(error) => return self.messages.notify(Kind::Error, error.to_string()),
        };
        self.playback.jobs.begin(&mut self.messages, move || {
            let folder = path.parent().unwrap_or(&path);
            std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
            state.save(&path).map_err(|error| error.to_string())?;
            Ok(format!("state {}", path.display()))
        });
    }

    /// The running scene with its particles, to go on on another device; none before there is one.
    pub fn take_state(&mut self) -> Option<State> {
        let current = self.current.as_mut()?;
        Some(State { scene: current.scene.clone(), ..current.read_state().ok()? })
    }

    fn restore_state(&mut self, path: &Path) {
        match State::load(path) {
            Ok(state) => {
                // The state is of the scene as the ladder had it: on top of that nothing is given up.
                self.rung = 0;
                (self.orbit, self.steered) = (None, false);
                self.load(state.scene.clone(), Start::State(Box::new(state)), "state restored");
            }
            Err(error) => self.messages.notify(Kind::Error, error.to_string()),
        }
    }
}
