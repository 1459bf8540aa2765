//! A hand that touches what is on the screen, by its name, and readings of a sensor from a file: for tests, and for the desktop
//! example without a window.

use std::path::Path;
use std::time::{Duration, Instant};

use brooklet_viewer::marks::{self, Marks};

use crate::app::BUSY;
use crate::{Acceleration, App, TouchEvent, TouchPhase, Wake};

/// An app without a window, and the hand that holds it.
pub struct Hand {
    /// The app.
    pub app: App,
    /// Where what is on the screen was in the last frame, points.
    pub marks: Marks,
    pixels_per_point: f32,
}

/// A finger that moves is seen so often on its way.
const STEPS: u32 = 8;

impl Hand {
    /// Holds it.
    pub fn new(app: App, pixels_per_point: f32) -> Self {
        Self { app, marks: Marks::new(), pixels_per_point }
    }

    /// A frame, and what the app then wants.
    pub fn frame(&mut self) -> Wake {
        let wake = self.app.frame();
        if let Some(viewer) = self.app.viewer() {
            let marks = marks::take(viewer.context());
            if !marks.is_empty() {
                self.marks = marks;
            }
        }
        wake
    }

    /// Frames until something is so; false if it is not within that time.
    pub fn until(&mut self, within: Duration, mut is_so: impl FnMut(&mut Self) -> bool) -> bool {
        let begun = Instant::now();
        while begun.elapsed() < within {
            if is_so(self) {
                return true;
            }
            if let Wake::After(wait) = self.frame() {
                std::thread::sleep(wait.min(Duration::from_millis(2)));
            }
        }
        is_so(self)
    }

    /// Frames until the scene made so many steps more; false if it does not within that time.
    pub fn steps(&mut self, steps: u64, within: Duration) -> bool {
        let done =
            |hand: &Self| hand.app.viewer().and_then(|viewer| viewer.current()).map_or(0, |run| run.session.steps());
        let before = done(self);
        self.until(within, |hand| done(hand) >= before + steps)
    }

    /// Paints at least one frame with what was touched.
    pub fn settle(&mut self) {
        for _ in 0..3 {
            self.app.viewer_mut();
            while self.frame() == Wake::After(BUSY) {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }

    /// A finger at a place, points.
    pub fn touch(&mut self, id: u64, phase: TouchPhase, [x, y]: [f32; 2]) {
        let (x_px, y_px) = (x * self.pixels_per_point, y * self.pixels_per_point);
        self.app.touch(TouchEvent { id, phase, x_px, y_px });
    }

    /// Touches the middle of what has that name.
    ///
    /// # Errors
    /// If nothing on the screen has it, with what there is.
    pub fn tap(&mut self, name: &str) -> Result<(), String> {
        self.settle();
        let Some(rect) = self.marks.get(name).copied() else {
            let there: Vec<&str> = self.marks.keys().map(String::as_str).collect();
            return Err(format!("no {name} on the screen, only {}", there.join(", ")));
        };
        let at = rect.center().into();
        self.touch(1, TouchPhase::Start, at);
        self.settle();
        self.touch(1, TouchPhase::End, at);
        self.settle();
        Ok(())
    }

    /// Fingers go from places to others, in points, frame by frame.
    pub fn drag(&mut self, ways: &[([f32; 2], [f32; 2])]) {
        for (id, (from, _)) in (1..).zip(ways) {
            self.touch(id, TouchPhase::Start, *from);
        }
        self.settle();
        for step in 1..=STEPS {
            let share = step as f32 / STEPS as f32;
            for (id, (from, to)) in (1..).zip(ways) {
                let at = [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
                self.touch(id, TouchPhase::Move, at);
            }
            self.settle();
        }
        for (id, (_, to)) in (1..).zip(ways) {
            self.touch(id, TouchPhase::End, *to);
        }
        self.settle();
    }
}

/// Readings of an accelerometer, each with its time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Readings(Vec<(f64, [f32; 3])>);

impl Readings {
    /// Reads lines of `t,x,y,z`: s since the start, and m/s² in the device's axes, as Android has them. Lines that are empty or
    /// begin with `#` are none.
    ///
    /// # Errors
    /// If the file cannot be read, or a line is not of that form or goes back in time: with its number.
    pub fn load(path: &Path) -> Result<Self, String> {
        let name = path.display();
        let text = std::fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
        Self::parse(&text).map_err(|(line, reason)| format!("{name}, line {line}: {reason}"))
    }

    fn parse(text: &str) -> Result<Self, (usize, String)> {
        let mut readings: Vec<(f64, [f32; 3])> = Vec::new();
        for (line, text) in (1..).zip(text.lines()) {
            let text = text.trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            let wrong = || (line, format!("{text:?} is not four numbers: t,x,y,z"));
            let numbers: Vec<f64> =
                text.split(',').map(|part| part.trim().parse()).collect::<Result<_, _>>().map_err(|_| wrong())?;
            let [time_s, x, y, z] = numbers[..] else { return Err(wrong()) };
            if !time_s.is_finite() || readings.last().is_some_and(|(before_s, _)| time_s < *before_s) {
                return Err((line, format!("{time_s} s is before the line above")));
            }
            readings.push((time_s, [x, y, z].map(|m_s2| m_s2 as f32)));
        }
        Ok(Self(readings))
    }

    /// The reading at a time, s: the last one up to then.
    pub fn at(&self, time_s: f64, rotation_degrees: u32) -> Option<Acceleration> {
        let (_, m_s2) = self.0.iter().rfind(|(reading_s, _)| *reading_s <= time_s)?;
        Some(Acceleration { m_s2: *m_s2, rotation_degrees })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readings_come_from_lines_and_the_last_one_holds() {
        let readings = Readings::parse("# t,x,y,z\n0, 0, 9.81, 0\n\n1.5,-9.81,0,0\n").unwrap();
        let at = |time_s: f64| readings.at(time_s, 90);
        assert_eq!(at(-1.0), None);
        assert_eq!(at(1.4), Some(Acceleration { m_s2: [0.0, 9.81, 0.0], rotation_degrees: 90 }));
        assert_eq!(at(7.0).unwrap().m_s2, [-9.81, 0.0, 0.0]);
    }

    #[test]
    fn a_line_that_is_none_is_named() {
        for (text, said) in
            [("0,1,2,3\n0,1,2\n", "four numbers"), ("0,1,2,x", "four numbers"), ("1,0,0,0\n0,0,0,0", "before")]
        {
            let (line, reason) = Readings::parse(text).unwrap_err();
            assert!(line == text.lines().count() && reason.contains(said), "{line}: {reason}");
        }
    }
}
