//! `brooklet view`: the desktop window.

mod open;
mod reload;
mod ui_trace;
mod window;

use std::panic;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use brooklet_fluid::{Scene, state::State};
use winit::error::EventLoopError;
use winit::event_loop::EventLoop;

use crate::{failure::Failure, job, view_options::ViewOptions};
use window::Window;

/// Opens a window, and comes back when it is closed.
pub fn view(options: &ViewOptions) -> Result<(), Failure> {
    // What is wrong with the scene is said before there is a window.
    let scene = match State::is_file_name(&options.scene.scene) {
        true => saved(options)?,
        false => job::scene(&options.scene, None)?,
    };
    let events = event_loop()?;
    let mut window = Window::new(options, scene)?;
    events.run_app(&mut window).map_err(|error| Failure::Stopped(format!("the window system ended: {error}")))?;
    window.end()
}

/// The scene of a saved state.
fn saved(options: &ViewOptions) -> Result<Scene, Failure> {
    let name = &options.scene.scene;
    if let Some(setting) = options.scene.settings.first() {
        return Err(Failure::Input(format!("--set {setting}: {name} is a saved state, which has settings of its own")));
    }
    State::load(Path::new(name)).map(|state| state.scene).map_err(Failure::input)
}

/// The window system. Where one of its libraries is missing, winit panics: that is no fault of the program's.
fn event_loop() -> Result<EventLoop<()>, Failure> {
    let said = Arc::new(Mutex::new(String::new()));
    let heard = Arc::clone(&said);
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |panicked| {
        let text = panicked.payload_as_str().unwrap_or("a library of it is missing");
        text.clone_into(&mut heard.lock().unwrap_or_else(PoisonError::into_inner));
    }));
    let made = panic::catch_unwind(EventLoop::new);
    panic::set_hook(before);
    let reason = match made {
        Ok(Ok(events)) => return Ok(events),
        Ok(Err(EventLoopError::Os(error))) => without_place(&error.to_string()).to_owned(),
        Ok(Err(error)) => error.to_string(),
        Err(_) => said.lock().unwrap_or_else(PoisonError::into_inner).clone(),
    };
    Err(Failure::Input(format!(
        "no window can be opened here: {reason}; `brooklet run` simulates and writes pictures without one"
    )))
}

/// winit begins with where in its own source it noticed: `os error at mod.rs:788: no connection`.
fn without_place(text: &str) -> &str {
    let reason = text.strip_prefix("os error at ").and_then(|rest| rest.split_once(": "));
    reason.map_or(text, |(_, reason)| reason)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reason_comes_without_winits_own_lines() {
        assert_eq!(without_place("os error at /x/winit/mod.rs:788: Failed to open: no"), "Failed to open: no");
        assert_eq!(without_place("Exit Failure: 1"), "Exit Failure: 1");
    }
}
