//! A display of the test's own, a user with mouse and keyboard on it, and pictures of what is seen.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use x11rb::connection::Connection;
use x11rb::protocol::xproto::{self, AtomEnum, ConfigureWindowAux, ConnectionExt as _, InputFocus, Window};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

/// Left and right button, and the wheel's two directions.
pub const LEFT: u8 = 1;
pub const RIGHT: u8 = 3;
pub const WHEEL_UP: u8 = 4;

/// Keys by the symbols of X11.
pub const SPACE: u32 = 0x20;
pub const F1: u32 = 0xffbe;
pub const CONTROL: u32 = 0xffe3;

/// An X server that draws to memory. Ends with the test.
pub struct Screen {
    server: Child,
    /// What `DISPLAY` has to be.
    pub display: String,
    pub connection: RustConnection,
    pub root: Window,
}

impl Screen {
    /// Starts one of a size.
    pub fn start(width_px: u16, height_px: u16) -> Self {
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-nolisten", "tcp", "-screen", "0"])
            .arg(format!("{width_px}x{height_px}x24"))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| panic!("Xvfb, which tools/setup --tests installs, does not start: {error}"));
        let mut line = String::new();
        let out = server.stdout.take().expect("it is piped");
        BufReader::new(out).read_line(&mut line).expect("the display's number");
        let display = format!(":{}", line.trim());
        let (connection, screen) = x11rb::connect(Some(&display)).expect("the server listens");
        let root = connection.setup().roots[screen].root;
        Self { server, display, connection, root }
    }

    /// Ends the server: whoever shows a window there loses it.
    pub fn end(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }

    /// The window with a title, once it is there.
    pub fn window(&self, title: &str) -> Option<Window> {
        let tree = self.connection.query_tree(self.root).ok()?.reply().ok()?;
        tree.children.into_iter().find(|window| {
            let cookie = self.connection.get_property(false, *window, AtomEnum::WM_NAME, AtomEnum::ANY, 0, 64);
            cookie.ok().and_then(|cookie| cookie.reply().ok()).is_some_and(|name| name.value == title.as_bytes())
        })
    }

    /// Gives a window the keyboard, as a window manager does.
    pub fn focus(&self, window: Window) {
        self.connection.set_input_focus(InputFocus::PARENT, window, x11rb::CURRENT_TIME).unwrap();
        self.connection.flush().unwrap();
    }

    /// Gives a window another size.
    pub fn resize(&self, window: Window, width_px: u32, height_px: u32) {
        let size = ConfigureWindowAux::new().width(width_px).height(height_px);
        self.connection.configure_window(window, &size).unwrap();
        self.connection.flush().unwrap();
    }

    fn fake(&self, kind: u8, detail: u8, at: [i16; 2]) {
        self.connection.xtest_fake_input(kind, detail, 0, self.root, at[0], at[1], 0).unwrap();
        self.connection.flush().unwrap();
    }

    /// Moves the pointer.
    pub fn point(&self, at: [i16; 2]) {
        self.fake(xproto::MOTION_NOTIFY_EVENT, 0, at);
        sleep(Duration::from_millis(30));
    }

    /// Presses or lets go of a mouse button.
    pub fn button(&self, button: u8, down: bool) {
        let kind = if down { xproto::BUTTON_PRESS_EVENT } else { xproto::BUTTON_RELEASE_EVENT };
        self.fake(kind, button, [0, 0]);
        sleep(Duration::from_millis(60));
    }

    /// A click.
    pub fn click(&self, at: [i16; 2]) {
        self.point(at);
        sleep(Duration::from_millis(120));
        self.button(LEFT, true);
        self.button(LEFT, false);
    }

    /// Presses a key, with Ctrl or without.
    pub fn key(&self, symbol: u32, control: bool) {
        let code = |symbol: u32| {
            let setup = self.connection.setup();
            let (first, last) = (setup.min_keycode, setup.max_keycode);
            let map = self.connection.get_keyboard_mapping(first, last - first + 1).unwrap().reply().unwrap();
            let width = usize::from(map.keysyms_per_keycode);
            let place = map.keysyms.iter().position(|known| *known == symbol).expect("a key of this keyboard");
            first + (place / width) as u8
        };
        if control {
            self.fake(xproto::KEY_PRESS_EVENT, code(CONTROL), [0, 0]);
        }
        self.fake(xproto::KEY_PRESS_EVENT, code(symbol), [0, 0]);
        sleep(Duration::from_millis(60));
        self.fake(xproto::KEY_RELEASE_EVENT, code(symbol), [0, 0]);
        if control {
            self.fake(xproto::KEY_RELEASE_EVENT, code(CONTROL), [0, 0]);
        }
        sleep(Duration::from_millis(60));
    }

    /// What is seen, as rows of RGBA.
    pub fn picture(&self) -> (u32, u32, Vec<u8>) {
        let shape = self.connection.get_geometry(self.root).unwrap().reply().unwrap();
        let (width, height) = (shape.width, shape.height);
        let whole = u32::MAX;
        let format = xproto::ImageFormat::Z_PIXMAP;
        let image = self.connection.get_image(format, self.root, 0, 0, width, height, whole).unwrap().reply().unwrap();
        let rgba = image.data.chunks_exact(4).flat_map(|bgrx| [bgrx[2], bgrx[1], bgrx[0], 255]).collect();
        (u32::from(width), u32::from(height), rgba)
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        self.end();
    }
}
