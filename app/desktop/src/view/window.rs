//! The window's events.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use brooklet_fluid::{Scene, state::State};
use brooklet_gpu::Tier;
use brooklet_viewer::Kind;
use brooklet_viewer::action::Action;
use brooklet_viewer::marks;
use serde_json::json;
use winit::{
    application::ApplicationHandler,
    dpi::LogicalSize,
    event::WindowEvent,
    event_loop::{ActiveEventLoop, ControlFlow},
    window::WindowId,
};

use super::{
    open::{Open, Went},
    reload::Reload,
    ui_trace::UiTrace,
};
use crate::{failure::Failure, view_options::ViewOptions};

/// A device that is lost again within this time is not opened a third time.
const LOST_AGAIN: Duration = Duration::from_secs(20);
/// A hidden window looks so often whether it is shown again.
const HIDDEN: Duration = Duration::from_millis(200);

/// A busy GPU is asked so often whether it is done.
const BUSY: Duration = Duration::from_millis(2);

/// A window in which nothing moves looks so often whether a shader changed.
const SHADERS: Duration = Duration::from_millis(500);

/// The program behind the window.
pub struct Window<'a> {
    options: &'a ViewOptions,
    scene: Scene,
    open: Option<Open>,
    ui_trace: Option<UiTrace>,
    reload: Option<Reload>,
    frames: u64,
    /// Whether the user did something since the last frame.
    touched: bool,
    lost: Option<Instant>,
    tier: Option<Tier>,
    failure: Option<Failure>,
}

impl<'a> Window<'a> {
    /// Not open yet.
    pub fn new(options: &'a ViewOptions, scene: Scene) -> Result<Self, Failure> {
        let ui_trace = options.tell.as_deref().map(UiTrace::create).transpose()?;
        Ok(Self {
            options,
            scene,
            open: None,
            ui_trace,
            reload: Reload::watch(&options.shaders),
            frames: 0,
            touched: true,
            lost: None,
            tier: options.device.tier.map(Into::into),
            failure: None,
        })
    }

    /// How it ended.
    pub fn end(self) -> Result<(), Failure> {
        self.failure.map_or(Ok(()), Err)
    }

    fn fail(&mut self, events: &ActiveEventLoop, failure: Failure) {
        self.failure.get_or_insert(failure);
        self.quit(events);
    }

    fn quit(&mut self, events: &ActiveEventLoop) {
        // Closes the capture.
        self.open = None;
        events.exit();
    }

    fn open_window(&mut self, events: &ActiveEventLoop) -> Result<Open, Failure> {
        let [width, height] = self.options.size.map(f64::from);
        let attributes = winit::window::Window::default_attributes()
            .with_title("Brooklet")
            .with_inner_size(LogicalSize::new(width, height))
            .with_min_inner_size(LogicalSize::new(320.0, 240.0));
        let window = events.create_window(attributes).map_err(|error| {
            Failure::Input(format!("no window can be opened here: {error}; `brooklet run` needs none"))
        })?;
        Open::new(Arc::new(window), self.options, self.tier, self.scene.clone())
    }

    fn frame(&mut self, events: &ActiveEventLoop) {
        let Some(open) = &mut self.open else { return };
        if let Some(news) = self.reload.as_ref().and_then(Reload::poll) {
            self.touched = true;
            open.viewer.reload(news);
        }
        // A frame that shows nothing new would only keep the GPU from the next one that does.
        match open.viewer.has_news() {
            Ok(false) if !std::mem::take(&mut self.touched) => {
                events.set_control_flow(ControlFlow::WaitUntil(Instant::now() + BUSY));
                return;
            }
            Ok(_) => {}
            Err(error) => return self.reopen(events, &error.to_string()),
        }
        self.touched = false;
        self.frames += 1;
        if self.options.lose_device == Some(self.frames) {
            open.lose_device();
        }
        match open.frame(self.options.lose_surface == Some(self.frames)) {
            Ok(Went::Painted(painted)) => {
                for action in &painted.for_window {
                    match action {
                        Action::Fullscreen => open.toggle_fullscreen(),
                        Action::Quit => return self.quit(events),
                        Action::Tier(tier) => return self.change_tier(events, *tier),
                        _ => {}
                    }
                }
                if painted.again {
                    events.set_control_flow(ControlFlow::Poll);
                    open.window.request_redraw();
                } else {
                    // A shader may change while nothing moves.
                    let most = if self.reload.is_some() { SHADERS } else { Duration::from_secs(3600) };
                    let at = Instant::now().checked_add(painted.within.min(most));
                    events.set_control_flow(at.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
                }
                self.trace_ui();
            }
            Ok(Went::Hidden) => {
                events.set_control_flow(ControlFlow::WaitUntil(Instant::now() + HIDDEN));
            }
            Ok(Went::DeviceLost(reason)) => self.reopen(events, &reason),
            Err(failure) => self.fail(events, failure),
        }
    }

    /// Another device in the same window: what ran is gone with the first, and begins again.
    fn reopen(&mut self, events: &ActiveEventLoop, reason: &str) {
        let lost_before = self.lost.replace(Instant::now());
        let Some(open) = self.open.take() else { return };
        let scene = open.viewer.current().map_or_else(|| self.scene.clone(), |current| current.scene.clone());
        let window = Arc::clone(&open.window);
        drop(open);
        if lost_before.is_some_and(|before| before.elapsed() < LOST_AGAIN) {
            let failure = Failure::Stopped(format!("the graphics device was lost twice: {reason}"));
            return self.fail(events, failure);
        }
        match Open::new(window, self.options, self.tier, scene) {
            Ok(mut open) => {
                let text =
                    format!("The graphics device was lost ({reason}). It is open again, and the scene begins anew.");
                open.viewer.notify(Kind::Error, text);
                open.window.request_redraw();
                self.open = Some(open);
            }
            Err(failure) => {
                let text =
                    format!("the graphics device was lost ({reason}) and cannot be opened again: {}", failure.text());
                self.fail(events, Failure::Stopped(text));
            }
        }
    }

    /// The same scene and particles on the same device, used as one of another tier.
    fn change_tier(&mut self, events: &ActiveEventLoop, tier: Tier) {
        let Some(mut open) = self.open.take() else { return };
        let (state, rung, auto) = (open.viewer.take_state(), open.viewer.rung(), open.viewer.is_auto());
        let scene = state.as_ref().map_or_else(|| self.scene.clone(), |state| state.scene.clone());
        let window = Arc::clone(&open.window);
        // A window has one surface, and the first device has it: it goes first.
        drop(open);
        let used = self.tier.replace(tier);
        let opened = Open::new(Arc::clone(&window), self.options, self.tier, scene.clone()).or_else(|failure| {
            self.tier = used;
            let mut open = Open::new(window, self.options, used, scene)?;
            open.viewer.notify(Kind::Error, failure.text());
            Ok(open)
        });
        match opened {
            Ok(mut open) => {
                if let Some(state) = state {
                    open.viewer.resume(state, rung, auto);
                }
                open.window.request_redraw();
                self.open = Some(open);
            }
            Err(failure) => self.fail(events, failure),
        }
    }

    fn trace_ui(&mut self) {
        let (Some(trace), Some(open)) = (&mut self.ui_trace, &self.open) else { return };
        let marks = marks::take(open.viewer.context());
        let facts = open.viewer.current().map(|current| {
            json!({
                "scene": current.scene.name,
                "toml": current.session.scene().to_toml(),
                "particles": current.session.slot_count(),
                "steps": current.session.steps(),
                "paused": open.viewer.is_paused(),
                "rung": open.viewer.rung(),
                "tier": brooklet_gpu::tier_name(current.session.engine().gpu().tier()),
                "kinetic_j": open.viewer.stats().map(|stats| stats.kinetic_j),
                "capture": open.viewer.capture(),
                "messages": open.viewer.messages().collect::<Vec<_>>(),
                "distance_m": (current.view().camera.eye_m - current.view().camera.target_m).length(),
                "picture_px": current.view().size_px,
                "eye_m": current.view().camera.eye_m.to_array(),
                "bodies_seen": current.bodies_seen().map(|at| [at.x, at.y]).collect::<Vec<_>>(),
                "emitted": open.viewer.flow().emitted,
            })
        });
        trace.frame(&marks, open.viewer.context().pixels_per_point(), json!(facts));
    }
}

impl ApplicationHandler for Window<'_> {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.open.is_none() {
            match self.open_window(events) {
                Ok(mut open) => {
                    let name = &self.options.scene.scene;
                    if State::is_file_name(name) {
                        open.viewer.open(name);
                    }
                    open.window.request_redraw();
                    self.open = Some(open);
                }
                Err(failure) => self.fail(events, failure),
            }
        }
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(open) = &mut self.open else { return };
        let repaint = open.take(&event);
        match event {
            WindowEvent::CloseRequested => return self.quit(events),
            WindowEvent::Resized(size) => open.resize(size.into()),
            WindowEvent::ScaleFactorChanged { .. } => open.resize(open.window.inner_size().into()),
            WindowEvent::DroppedFile(path) => open.drop_file(&path),
            WindowEvent::RedrawRequested => return self.frame(events),
            _ => {}
        }
        if repaint {
            self.touched = true;
            open.window.request_redraw();
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        // A time to wait until has come, or frames follow one another.
        let is_due = match events.control_flow() {
            ControlFlow::Poll => true,
            ControlFlow::WaitUntil(at) => at <= Instant::now(),
            ControlFlow::Wait => false,
        };
        if let Some(open) = self.open.as_ref().filter(|_| is_due) {
            open.window.request_redraw();
        }
    }
}
