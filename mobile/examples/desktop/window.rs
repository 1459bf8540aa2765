//! The app in a window.

use std::sync::Arc;
use std::time::Instant;

use brooklet_mobile::script::Readings;
use brooklet_mobile::{App, TouchEvent, TouchPhase, Wake, WindowSource};
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{ElementState, MouseButton, Touch, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::{Key, NamedKey};
use winit::raw_window_handle::{DisplayHandle, HandleError, HasDisplayHandle, HasWindowHandle, WindowHandle};
use winit::window::{Window, WindowId};

use crate::Options;

pub fn run(app: App, options: &Options, readings: Readings) -> Result<(), String> {
    let events = EventLoop::new().map_err(|error| format!("no window can be opened here: {error}; try --headless"))?;
    let size_px = [options.size[0], options.size[1]].map(|points| (points * options.scale).round() as u32);
    let mut phone = Phone {
        app,
        scale: options.scale,
        rotation: options.rotation,
        size_px,
        readings,
        window: None,
        begun: Instant::now(),
        mouse: [0.0; 2],
        down: None,
        is_control: false,
        failure: None,
    };
    events.run_app(&mut phone).map_err(|error| format!("the window system ended: {error}"))?;
    phone.failure.map_or(Ok(()), Err)
}

struct Phone {
    app: App,
    scale: f32,
    rotation: u32,
    size_px: [u32; 2],
    readings: Readings,
    window: Option<Arc<Window>>,
    begun: Instant,
    mouse: [f32; 2],
    /// Whether the button is down, and whether with a second finger.
    down: Option<bool>,
    is_control: bool,
    failure: Option<String>,
}

struct Source(Arc<Window>);

impl HasWindowHandle for Source {
    fn window_handle(&self) -> Result<WindowHandle<'_>, HandleError> {
        self.0.window_handle()
    }
}

impl HasDisplayHandle for Source {
    fn display_handle(&self) -> Result<DisplayHandle<'_>, HandleError> {
        self.0.display_handle()
    }
}

impl WindowSource for Source {}

impl Phone {
    fn show(&mut self) {
        let Some(window) = &self.window else { return };
        self.app.resume(Box::new(Source(Arc::clone(window))), window.inner_size().into(), self.scale);
        window.request_redraw();
    }

    fn finger(&mut self, phase: TouchPhase) {
        let Some(has_two) = self.down else { return };
        let [x_px, y_px] = self.mouse;
        self.app.touch(TouchEvent { id: 1, phase, x_px, y_px });
        if has_two && let Some(window) = &self.window {
            let size: [u32; 2] = window.inner_size().into();
            let [x_px, y_px] = [size[0] as f32 - x_px, size[1] as f32 - y_px];
            self.app.touch(TouchEvent { id: 2, phase, x_px, y_px });
        }
    }

    fn frame(&mut self, events: &ActiveEventLoop) {
        if let Some(reading) = self.readings.at(self.begun.elapsed().as_secs_f64(), self.rotation) {
            self.app.acceleration(reading);
        }
        match self.app.frame() {
            Wake::Now => events.set_control_flow(ControlFlow::Poll),
            Wake::After(wait) => match Instant::now().checked_add(wait) {
                Some(at) => events.set_control_flow(ControlFlow::WaitUntil(at)),
                None => events.set_control_flow(ControlFlow::Wait),
            },
            Wake::OnEvent => events.set_control_flow(ControlFlow::Wait),
        }
        if let Some(reason) = self.app.failure() {
            self.failure = Some(reason.to_owned());
            events.exit();
        }
    }
}

impl ApplicationHandler for Phone {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        let [width, height] = self.size_px;
        let wanted =
            Window::default_attributes().with_title("Brooklet").with_inner_size(PhysicalSize::new(width, height));
        match events.create_window(wanted) {
            Ok(window) => self.window = Some(Arc::new(window)),
            Err(error) => {
                self.failure = Some(format!("no window can be opened here: {error}; try --headless"));
                return events.exit();
            }
        }
        self.show();
    }

    fn suspended(&mut self, _events: &ActiveEventLoop) {
        self.app.suspend();
        self.window = None;
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _window: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => {
                self.app.suspend();
                return events.exit();
            }
            WindowEvent::Resized(_) => {
                self.app.suspend();
                self.show();
            }
            WindowEvent::CursorMoved { position, .. } => {
                self.mouse = [position.x as f32, position.y as f32];
                self.finger(TouchPhase::Move);
            }
            WindowEvent::MouseInput { state: ElementState::Pressed, button: MouseButton::Left, .. } => {
                self.down = Some(self.is_control);
                self.finger(TouchPhase::Start);
            }
            WindowEvent::MouseInput { state: ElementState::Released, button: MouseButton::Left, .. } => {
                self.finger(TouchPhase::End);
                self.down = None;
            }
            WindowEvent::Touch(Touch { phase, location, id, .. }) => {
                let phase = match phase {
                    winit::event::TouchPhase::Started => TouchPhase::Start,
                    winit::event::TouchPhase::Moved => TouchPhase::Move,
                    winit::event::TouchPhase::Ended => TouchPhase::End,
                    winit::event::TouchPhase::Cancelled => TouchPhase::Cancel,
                };
                let (x_px, y_px) = (location.x as f32, location.y as f32);
                self.app.touch(TouchEvent { id: id + 10, phase, x_px, y_px });
            }
            WindowEvent::ModifiersChanged(modifiers) => self.is_control = modifiers.state().control_key(),
            WindowEvent::KeyboardInput { event, .. } if event.state == ElementState::Pressed => {
                if event.logical_key == Key::Named(NamedKey::Escape) && !self.app.back() {
                    self.app.suspend();
                    return events.exit();
                }
            }
            WindowEvent::RedrawRequested => return self.frame(events),
            _ => return,
        }
        if let Some(window) = &self.window {
            window.request_redraw();
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        let is_due = match events.control_flow() {
            ControlFlow::Poll => true,
            ControlFlow::WaitUntil(at) => at <= Instant::now(),
            ControlFlow::Wait => false,
        };
        if let Some(window) = self.window.as_ref().filter(|_| is_due) {
            window.request_redraw();
        }
    }
}
