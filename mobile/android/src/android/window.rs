//! Android's window as what a surface is made of.

use ndk::native_window::NativeWindow;
use raw_window_handle::{DisplayHandle, HandleError, HasDisplayHandle, HasWindowHandle, WindowHandle};

use brooklet_mobile::WindowSource;

/// A window, kept for as long as this is.
#[derive(Debug)]
pub struct Window(pub NativeWindow);

impl HasWindowHandle for Window {
    fn window_handle(&self) -> Result<WindowHandle<'_>, HandleError> {
        self.0.window_handle()
    }
}

impl HasDisplayHandle for Window {
    fn display_handle(&self) -> Result<DisplayHandle<'_>, HandleError> {
        Ok(DisplayHandle::android())
    }
}

impl WindowSource for Window {}

/// Its size, pixels. A window that is about to go may say less than nothing.
pub fn size_px(window: &NativeWindow) -> [u32; 2] {
    [window.width(), window.height()].map(|px| u32::try_from(px).unwrap_or(0).max(1))
}
