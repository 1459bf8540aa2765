//! Text in the window without a GPU.

use android_activity::{
    AndroidApp, InputStatus, MainEvent, PollEvent, input::InputEvent, input::KeyAction, input::Keycode,
};
use ndk::hardware_buffer_format::HardwareBufferFormat;
use ndk::native_window::NativeWindow;

use super::{activity, window};
use crate::screen::Screen;

/// Shows `text` until the activity ends; the back key ends it. Whatever drew in the window before is gone.
pub fn show(android: &AndroidApp, text: &str) {
    ::log::error!("{text}");
    let (mut ends, mut stale) = (false, true);
    while !ends {
        android.poll_events(None, |event| {
            let PollEvent::Main(event) = event else { return };
            match event {
                MainEvent::Destroy => ends = true,
                MainEvent::InputAvailable => ends |= goes_back(android),
                MainEvent::TerminateWindow { .. } => stale = false,
                MainEvent::InitWindow { .. }
                | MainEvent::WindowResized { .. }
                | MainEvent::RedrawNeeded { .. }
                | MainEvent::ConfigChanged { .. } => stale = true,
                _ => {}
            }
        });
        if stale && let Some(window) = android.native_window() {
            stale = false;
            paint(&window, text, activity::pixels_per_point(android));
        }
    }
}

/// Takes all input; whether the back key was let go.
fn goes_back(android: &AndroidApp) -> bool {
    let mut back = false;
    let Ok(mut events) = android.input_events_iter() else { return false };
    while events.next(|event| match event {
        InputEvent::KeyEvent(key) if key.key_code() == Keycode::Back => {
            back |= key.action() == KeyAction::Up;
            InputStatus::Handled
        }
        _ => InputStatus::Unhandled,
    }) {}
    back
}

/// One buffer of a point a pixel, which the system scales to the window.
fn paint(window: &NativeWindow, text: &str, pixels_per_point: f32) {
    let size = window::size_px(window).map(|px| (px as f32 / pixels_per_point).ceil() as i32);
    let prepared = window.set_buffers_geometry(size[0], size[1], Some(HardwareBufferFormat::R8G8B8X8_UNORM));
    let mut buffer = match prepared.and_then(|()| window.lock(None)) {
        Ok(buffer) => buffer,
        Err(error) => return ::log::error!("no text in the window: {error}"),
    };
    let screen = Screen::of_text(text, [buffer.width(), buffer.height()]);
    // The format that was asked for, in bytes a pixel: another one is left as it is.
    let Some(rows) = buffer.lines().filter(|_| true) else { return };
    for (to, from) in rows.zip(screen.rows()) {
        for (to, from) in to.iter_mut().zip(from.as_flattened()) {
            to.write(*from);
        }
    }
}
