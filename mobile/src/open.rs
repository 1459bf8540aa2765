//! What lives as long as the device: the viewer, and what goes on beside it.

use std::path::Path;
use std::time::Duration;

use brooklet_fluid::Scene;
use brooklet_gpu::Gpu;
use brooklet_viewer::action::Action;
use brooklet_viewer::{Kind, Settings, Viewer};

use crate::app_paths::AppPaths;
use crate::canvas::Canvas;
use crate::kept;
use crate::report::{self, Report};
use crate::screen::{self, Down, Facts};
use crate::self_check::{self, Asked, Checked, Occasion};
use crate::worker::{Worker, stand_together};

/// The scene that the app begins with, and whose kernels are checked.
const FIRST_SCENE: &str = "phone-1k";

/// All that goes when the device goes.
pub struct Open {
    /// What is shown.
    pub viewer: Viewer,
    /// Of the surface that the viewer paints on.
    pub format: wgpu::TextureFormat,
    /// The device.
    pub gpu: Gpu,
    check: Option<Worker<Checked>>,
    report: Option<UnderWay>,
    /// What the last self-check found.
    pub checked: Option<Checked>,
}

/// A report in the making: the water stands, so that the GPU is its own.
struct UnderWay {
    worker: Worker<Report>,
    /// Whether the water went on before.
    goes_on: bool,
}

impl Open {
    /// A viewer on a device that was opened just now; what is known to be wrong there is refused before anything is loaded.
    pub fn new(gpu: Gpu, canvas: &Canvas, paths: &AppPaths, asked: &Asked) -> Self {
        let viewer = viewer(&gpu, canvas, paths);
        let mut open = Self { viewer, format: canvas.format(), gpu, check: None, report: None, checked: None };
        match Checked::load(&paths.files, &open.gpu) {
            Some(checked) => open.take_checked(checked),
            None => open.begin_check(asked, Occasion::FirstStart),
        }
        if open.check.is_none() {
            open.viewer.open(FIRST_SCENE);
        }
        open
    }

    /// A window came back with another format, for which nothing was built.
    pub fn change_format(&mut self, canvas: &Canvas, paths: &AppPaths) {
        let (state, rung, auto) = (self.viewer.take_state(), self.viewer.rung(), self.viewer.is_auto());
        (self.viewer, self.format) = (viewer(&self.gpu, canvas, paths), canvas.format());
        match state {
            Some(state) => self.viewer.resume(state, rung, auto),
            None if self.check.is_none() => self.viewer.open(FIRST_SCENE),
            None => {}
        }
    }

    /// Begins a self-check, unless something is under way.
    pub fn begin_check(&mut self, asked: &Asked, occasion: Occasion) {
        if self.is_at_work() {
            return;
        }
        let scene = Scene::load(FIRST_SCENE, &[]).map_err(|error| error.to_string());
        match scene.and_then(|scene| self_check::begin(&self.gpu, &scene, asked, occasion)) {
            Ok(check) => self.check = Some(check),
            Err(reason) => self.viewer.notify(Kind::Warning, reason),
        }
    }

    /// Begins a report, unless something is under way.
    pub fn begin_report(&mut self, picture_px: [u32; 2], time: Duration) {
        if self.is_at_work() {
            return;
        }
        match report::begin(&self.gpu, self.checked.as_ref(), picture_px, time) {
            Ok(worker) => {
                let goes_on = !self.viewer.is_paused();
                self.report = Some(UnderWay { worker, goes_on });
                if goes_on {
                    self.viewer.handle_action(Action::Pause);
                }
            }
            Err(reason) => self.viewer.notify(Kind::Warning, reason),
        }
    }

    /// Whether a self-check or a report is under way.
    pub fn is_at_work(&self) -> bool {
        self.check.is_some() || self.report.is_some()
    }

    /// Lets what goes on beside the frames stand, and waits for the parts that are under way, for all together no longer than
    /// `limit`; whether nothing is under way then.
    pub fn stand(&self, limit: Duration) -> bool {
        let report = self.report.as_ref().map(|report| report.worker.pace());
        let paces: Vec<_> = self.check.as_ref().map(Worker::pace).into_iter().chain(report).collect();
        stand_together(&paces, limit)
    }

    /// Lets it go on.
    pub fn go_on(&self) {
        self.check.iter().for_each(Worker::go_on);
        self.report.iter().for_each(|report| report.worker.go_on());
    }

    /// Takes what the self-check or the report came to, if one is under way; whether one was.
    pub fn follow(&mut self, files: &Path) -> bool {
        let was_at_work = self.is_at_work();
        if let Some(found) = self.check.as_mut().and_then(Worker::poll) {
            self.check = None;
            self.end_check(found, files);
        }
        if let Some(made) = self.report.as_mut().and_then(|report| report.worker.poll()) {
            self.end_report(made, files);
        }
        was_at_work
    }

    /// Keeps what was found, refuses what is wrong, and goes on without.
    fn end_check(&mut self, found: Result<Checked, String>, files: &Path) {
        match found {
            Ok(checked) => {
                if let Err(reason) = checked.save(files) {
                    self.viewer.notify(Kind::Warning, format!("the self-check's result is not kept: {reason}"));
                }
                self.take_checked(checked);
            }
            Err(reason) => self.viewer.notify(Kind::Warning, reason),
        }
        match self.viewer.current() {
            None => self.viewer.open(FIRST_SCENE),
            Some(_) if self.gpu.refused().is_empty() => {}
            Some(_) => drop(self.viewer.handle_action(Action::Reset)),
        }
    }

    fn end_report(&mut self, made: Result<Report, String>, files: &Path) {
        if self.report.take().is_some_and(|report| report.goes_on) && self.viewer.is_paused() {
            self.viewer.handle_action(Action::Pause);
        }
        let written = made.and_then(|report| kept::save(files, report::FILE, &report).map(|()| report));
        match written {
            Ok(report) => {
                let path = files.join(report::FILE);
                self.viewer.notify(Kind::Done, format!("report {}: {}", path.display(), report.summary()));
            }
            Err(reason) => self.viewer.notify(Kind::Error, format!("there is no report: {reason}")),
        }
    }

    fn take_checked(&mut self, checked: Checked) {
        checked.refuse_wrong(&self.gpu);
        self.viewer.set_about("self_check", checked.fields());
        let kind = if checked.wrong.is_empty() { Kind::Done } else { Kind::Error };
        self.viewer.notify(kind, format!("self-check: {}", checked.summary()));
        self.checked = Some(checked);
    }

    /// What the screen is told beside what the viewer tells it.
    pub fn facts<'a>(&self, has_sensor: bool, files: &'a str) -> Facts<'a> {
        Facts {
            down: match self.viewer.current() {
                Some(current) if is_weightless(&current.scene) => Down::Nowhere,
                _ if has_sensor => Down::Sensor,
                _ => Down::Scene,
            },
            checking: self.check.as_ref().map(|check| check.progress),
            reporting: self.report.as_ref().map(|report| report.worker.progress),
            checked: self.checked.as_ref().map(Checked::summary),
            is_wrong: self.checked.as_ref().is_some_and(|checked| !checked.wrong.is_empty()),
            files,
        }
    }
}

/// Whether a scene is in free space.
pub fn is_weightless(scene: &Scene) -> bool {
    scene.gravity_m_s2 == [0.0; 3]
}

fn viewer(gpu: &Gpu, canvas: &Canvas, paths: &AppPaths) -> Viewer {
    let settings = Settings { folder: paths.files.clone(), budget_ms: None, rung: None };
    let mut viewer = Viewer::without_scene(gpu, canvas.format(), settings, canvas.size_px());
    screen::apply(viewer.context());
    viewer.set_program("brooklet mobile");
    viewer
}
