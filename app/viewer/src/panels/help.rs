//! Keys and mouse on one page.

use egui::{Align2, Context, Grid, RichText, Window, vec2};

use crate::action::keys;
use crate::marks::mark;
use crate::style;

const MOUSE: [(&str, &str); 7] = [
    ("drag", "push the fluid"),
    ("drag a body", "hold it, and take it along"),
    ("drag, right button", "turn the camera"),
    ("drag, middle button, or Shift and right", "move the camera sideways"),
    ("wheel, or pinch", "nearer and farther"),
    ("two fingers", "turn, nearer and farther"),
    ("drop a file", "open a scene or a saved state"),
];

pub(super) fn show(context: &Context, open: &mut bool) {
    let window = Window::new("Keys and mouse").open(open).collapsible(false).resizable(false);
    let shown = window.anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0)).show(context, |ui| {
        Grid::new("keys").num_columns(2).spacing([18.0, 4.0]).show(ui, |ui| {
            for (what, help) in MOUSE {
                ui.label(RichText::new(what).color(style::ACCENT));
                ui.label(help);
                ui.end_row();
            }
            for key in keys() {
                let name = if key.command { format!("Ctrl+{}", key.key.name()) } else { key.key.name().to_owned() };
                ui.label(RichText::new(name).color(style::ACCENT));
                ui.label(key.help);
                ui.end_row();
            }
        });
    });
    if let Some(shown) = shown {
        mark(&shown.response, "help window");
    }
}
