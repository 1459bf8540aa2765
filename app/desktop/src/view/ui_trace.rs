//! What the window shows, for a program that uses it as a person does.

use std::{
    fs::File,
    io::{BufWriter, Write},
    path::Path,
};

use brooklet_viewer::marks::Marks;
use serde_json::{Value, json};

use crate::failure::Failure;

/// Writes a line whenever what it tells of has changed.
pub struct UiTrace {
    file: BufWriter<File>,
    last: Value,
}

impl UiTrace {
    /// Begins the file.
    pub fn create(path: &Path) -> Result<Self, Failure> {
        let file = File::create(path)
            .map_err(|error| Failure::Input(format!("--tell {}: cannot create: {error}", path.display())))?;
        Ok(Self { file: BufWriter::new(file), last: Value::Null })
    }

    /// The controls' places in pixels, and facts of the running world.
    pub fn frame(&mut self, marks: &Marks, pixels_per_point: f32, facts: Value) {
        let places: serde_json::Map<String, Value> = marks
            .iter()
            .map(|(name, rect)| {
                let [left, top, right, bottom] = [rect.left(), rect.top(), rect.right(), rect.bottom()]
                    .map(|side| (side * pixels_per_point).round());
                (name.clone(), json!([left, top, right, bottom]))
            })
            .collect();
        let line = json!({ "controls": places, "facts": facts });
        if line != self.last {
            // Whoever reads it sees whole lines; a full disk costs the reader's view and nothing else.
            let _ = writeln!(self.file, "{line}").and_then(|()| self.file.flush());
            self.last = line;
        }
    }
}
