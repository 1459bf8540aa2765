//! The program's window under a display of its own, used as a person uses it.

pub mod dropping;
pub mod screen;

use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;
use x11rb::protocol::xproto::Window;

use screen::Screen;

/// The window, and who sits before it.
pub struct User {
    pub screen: Screen,
    pub window: Window,
    program: Child,
    tell: PathBuf,
    said: PathBuf,
}

/// A software driver draws a frame in a good part of a second, and builds its programs in a minute.
const PATIENCE: Duration = Duration::from_secs(240);

impl User {
    /// Opens the window on a new screen.
    pub fn open(command: &mut Command, folder: &Path) -> Self {
        let screen = Screen::start(1100, 720);
        let (tell, said) = (folder.join("tell.jsonl"), folder.join("said.txt"));
        let errors = std::fs::File::create(&said).unwrap();
        let program = command
            .env("DISPLAY", &screen.display)
            .env_remove("WAYLAND_DISPLAY")
            .args(["--size", "1100x720", "--tell"])
            .arg(&tell)
            .stdout(Stdio::null())
            .stderr(errors)
            .spawn()
            .expect("the program starts");
        let mut user = Self { screen, window: 0, program, tell, said };
        user.window = user.wait("a window", |user| user.screen.window("Brooklet"));
        user.screen.focus(user.window);
        user
    }

    /// What the window told last.
    pub fn told(&self) -> Value {
        let text = std::fs::read_to_string(&self.tell).unwrap_or_default();
        let whole = text.rfind('\n').map_or("", |end| &text[..end]);
        whole.lines().next_back().and_then(|line| serde_json::from_str(line).ok()).unwrap_or_default()
    }

    /// A fact of the running world.
    pub fn fact(&self, name: &str) -> Value {
        self.told()["facts"][name].clone()
    }

    /// How often the window told something.
    pub fn lines(&self) -> usize {
        std::fs::read_to_string(&self.tell).unwrap_or_default().lines().count()
    }

    /// The largest value that a fact had since then.
    pub fn most(&self, name: &str, since: usize) -> f64 {
        let text = std::fs::read_to_string(&self.tell).unwrap_or_default();
        let lines = text.lines().skip(since).filter_map(|line| serde_json::from_str::<Value>(line).ok());
        lines.filter_map(|told| told["facts"][name].as_f64()).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The middle of a control, once it is there.
    pub fn control(&mut self, name: &str) -> [i16; 2] {
        let [left, top, right, bottom] = self.rect(name);
        [(left + right) / 2, (top + bottom) / 2]
    }

    /// Left, top, right and bottom of a control, once it is there.
    pub fn rect(&mut self, name: &str) -> [i16; 4] {
        self.wait(&format!("the control {name:?}"), |user| {
            let told = user.told();
            let place = told["controls"][name].as_array()?;
            Some(std::array::from_fn(|side| place[side].as_f64().unwrap() as i16))
        })
    }

    /// Drags on a running scene, slowly enough for a driver that draws a few frames a second: what is pressed
    /// and let go between two frames is no drag.
    pub fn drag(&mut self, button: u8, from: [i16; 2], to: [i16; 2], moves: i16) {
        let frame = |user: &mut Self| {
            let steps = user.fact("steps").as_u64();
            user.wait("a frame", |user| (user.fact("steps").as_u64() > steps).then_some(()));
        };
        self.screen.point(from);
        self.screen.button(button, true);
        frame(self);
        for number in 1..=moves {
            self.screen.point([0, 1].map(|axis: usize| from[axis] + (to[axis] - from[axis]) * number / moves));
            frame(self);
        }
        frame(self);
        self.screen.button(button, false);
        frame(self);
    }

    /// Drags on a running scene as a person does, who waits for no frame; then for two, which show what came of it.
    pub fn flick(&mut self, button: u8, from: [i16; 2], to: [i16; 2]) {
        self.screen.point(from);
        self.screen.button(button, true);
        for number in 1..=4 {
            self.screen.point([0, 1].map(|axis: usize| from[axis] + (to[axis] - from[axis]) * number / 4));
        }
        self.screen.button(button, false);
        for _ in 0..2 {
            let steps = self.fact("steps").as_u64();
            self.wait("a frame", |user| (user.fact("steps").as_u64() > steps).then_some(()));
        }
    }

    /// Clicks on a control.
    pub fn click(&mut self, name: &str) {
        let at = self.control(name);
        self.screen.click(at);
        // Some frames: what it moves on the screen is told by then.
        sleep(Duration::from_millis(1200));
    }

    /// Waits until there is something; panics with what the program said where it never comes.
    pub fn wait<T>(&mut self, what: &str, look: impl Fn(&Self) -> Option<T>) -> T {
        let until = Instant::now() + PATIENCE;
        while Instant::now() < until {
            if let Some(found) = look(self) {
                return found;
            }
            if let Some(status) = self.program.try_wait().unwrap() {
                panic!("waiting for {what}: the program ended with {status}: {}", self.words());
            }
            sleep(Duration::from_millis(50));
        }
        panic!("{what} does not come; the window tells {}; the program said {:?}", self.told(), self.words());
    }

    /// What the program said on its standard error.
    pub fn words(&self) -> String {
        std::fs::read_to_string(&self.said).unwrap_or_default()
    }

    /// Memory of the program that is really there, MB.
    pub fn memory_mb(&self) -> f64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.program.id())).expect("it runs");
        let line = status.lines().find(|line| line.starts_with("VmRSS:")).expect("Linux tells it");
        let kilobytes: f64 = line.split_whitespace().nth(1).and_then(|number| number.parse().ok()).expect("a number");
        kilobytes / 1024.0
    }

    /// A picture of the screen, also kept as a file.
    pub fn look(&self, path: &Path) -> (u32, u32, Vec<u8>) {
        // What was told last is painted some frames later.
        sleep(Duration::from_millis(2500));
        let (width, height, rgba) = self.screen.picture();
        brooklet_render::png::save(path, [width, height], &rgba).expect("the picture is kept");
        (width, height, rgba)
    }

    /// Waits for the program's end.
    pub fn ended(&mut self) -> ExitStatus {
        let until = Instant::now() + PATIENCE;
        while Instant::now() < until {
            if let Some(status) = self.program.try_wait().unwrap() {
                return status;
            }
            sleep(Duration::from_millis(50));
        }
        panic!("the program does not end");
    }
}

impl Drop for User {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}
