//! Android's events to the app, and its frames to the window.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use android_activity::input::{InputEvent, KeyAction, Keycode, MotionAction, MotionEvent};
use android_activity::{AndroidApp, InputStatus, MainEvent, PollEvent, WindowManagerFlags};

use super::activity;
use super::hints::Hints;
use super::sensors::Sensors;
use super::system::System;
use super::text;
use super::thermal::Thermal;
use super::window::{self, Window};
use crate::lifecycle::{Lifecycle, Said, Step};
use crate::touches::{Motion, Pointer, touches};
use brooklet_mobile::{Acceleration, App, AppPaths, Wake};

/// Runs a new app until its activity ends.
pub fn run(android: &AndroidApp) {
    // Must not be asked for inside of an event.
    let flags = WindowManagerFlags::KEEP_SCREEN_ON | WindowManagerFlags::FULLSCREEN;
    android.set_window_flags(flags, WindowManagerFlags::empty());
    let system = System::open();
    let mut running = Running {
        android,
        app: App::new(paths(android)),
        life: Lifecycle::default(),
        rotation_degrees: 0,
        sensors: None,
        thermal: system.as_ref().and_then(Thermal::open),
        hints: system.as_ref().and_then(Hints::open),
        ends: false,
    };
    let mut wake = Wake::OnEvent;
    while !running.ends && running.app.failure().is_none() {
        running.take_events(if running.life.is_shown() { wake } else { Wake::OnEvent });
        if !running.ends && running.life.is_shown() {
            wake = running.frame();
        }
    }
    let ends = running.ends;
    let problem = running.app.failure().map(str::to_owned);
    // Its surface goes with it: nothing else can draw in the window before.
    drop(running);
    if let (false, Some(problem)) = (ends, problem) {
        text::show(android, &format!("Brooklet cannot run on this device.\n\n{problem}\n\nGo back to close it."));
    }
}

/// The app's own files: those that its user may copy where there are any, else those that only the app sees.
fn paths(android: &AndroidApp) -> AppPaths {
    let own = android.internal_data_path().unwrap_or_else(|| PathBuf::from("."));
    // Android's cache stands beside its files.
    let cache = own.parent().unwrap_or(&own).join("cache");
    AppPaths { files: android.external_data_path().unwrap_or(own), cache }
}

struct Running<'a> {
    android: &'a AndroidApp,
    app: App,
    life: Lifecycle,
    rotation_degrees: u32,
    sensors: Option<Sensors>,
    thermal: Option<Thermal>,
    hints: Option<Hints>,
    ends: bool,
}

impl Running<'_> {
    /// Waits as long as `wake` allows, and takes everything there is.
    fn take_events(&mut self, wake: Wake) {
        let mut timeout = match wake {
            Wake::Now => Some(Duration::ZERO),
            Wake::After(time) => Some(time),
            Wake::OnEvent => None,
        };
        let mut more = true;
        while more && !self.ends {
            // A wake-up or nothing at all leaves it so.
            more = false;
            self.android.poll_events(timeout, |event| {
                if let PollEvent::Main(event) = event {
                    more = true;
                    self.take(&event);
                }
            });
            timeout = Some(Duration::ZERO);
        }
    }

    fn take(&mut self, event: &MainEvent<'_>) {
        let said = match event {
            MainEvent::InitWindow { .. } => Said::Window,
            MainEvent::TerminateWindow { .. } => Said::NoWindow,
            MainEvent::WindowResized { .. } | MainEvent::ConfigChanged { .. } => Said::Changed,
            MainEvent::Resume { .. } => Said::Resume,
            MainEvent::Pause => Said::Pause,
            MainEvent::InputAvailable => return self.take_input(),
            MainEvent::LowMemory => return self.app.low_memory(),
            MainEvent::Destroy => {
                self.ends = true;
                self.hide();
                return;
            }
            _ => return,
        };
        match self.life.on(said) {
            Some(Step::Show) => self.show(),
            Some(Step::Hide) => self.hide(),
            Some(Step::Rebuild) => {
                // A window has one surface at a time.
                self.suspend();
                self.show();
            }
            None => {}
        }
    }

    fn show(&mut self) {
        let Some(native) = self.android.native_window() else { return };
        let size_px = window::size_px(&native);
        self.rotation_degrees = activity::rotation_degrees(self.android);
        self.sensors.get_or_insert_with(|| Sensors::begin(crate::application_id()));
        self.app.resume(Box::new(Window(native)), size_px, activity::pixels_per_point(self.android));
    }

    fn hide(&mut self) {
        self.sensors = None;
        self.suspend();
    }

    fn suspend(&mut self) {
        if !self.app.suspend() {
            ::log::warn!("a part of the self-check or a report takes longer than a suspend waits");
        }
    }

    fn take_input(&mut self) {
        let mut events = match self.android.input_events_iter() {
            Ok(events) => events,
            Err(error) => return ::log::error!("no input: {error}"),
        };
        let (app, android) = (&mut self.app, self.android);
        while events.next(|event| match event {
            InputEvent::MotionEvent(event) => touch(app, event),
            InputEvent::KeyEvent(key) if key.key_code() == Keycode::Back => {
                if key.action() == KeyAction::Up && !app.back() {
                    activity::move_to_back(android);
                }
                InputStatus::Handled
            }
            // Volume and the like are the system's.
            _ => InputStatus::Unhandled,
        }) {}
    }

    fn frame(&mut self) -> Wake {
        if let Some(m_s2) = self.sensors.as_ref().and_then(Sensors::take) {
            self.app.acceleration(Acceleration { m_s2, rotation_degrees: self.rotation_degrees });
        }
        if let Some(headroom) = self.thermal.as_mut().and_then(Thermal::headroom) {
            self.app.thermal_headroom(headroom);
        }
        let began = Instant::now();
        let wake = self.app.frame();
        if let (Wake::Now, Some(hints)) = (wake, &mut self.hints) {
            hints.report(began.elapsed());
        }
        wake
    }
}

fn touch(app: &mut App, event: &MotionEvent<'_>) -> InputStatus {
    let motion = match event.action() {
        MotionAction::Down | MotionAction::PointerDown => Motion::Down(event.pointer_index()),
        MotionAction::Up | MotionAction::PointerUp => Motion::Up(event.pointer_index()),
        MotionAction::Move => Motion::Move,
        MotionAction::Cancel => Motion::Cancel,
        _ => return InputStatus::Unhandled,
    };
    let pointers: Vec<Pointer> = event
        .pointers()
        .map(|pointer| Pointer { id: pointer.pointer_id(), at_px: [pointer.x(), pointer.y()] })
        .collect();
    for touch in touches(motion, &pointers) {
        app.touch(touch);
    }
    InputStatus::Handled
}
