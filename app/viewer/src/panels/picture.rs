//! The picture of the fluid, and the pointer on it.

use egui::{CentralPanel, Color32, CursorIcon, Frame, ProgressBar, Rect, RichText, Sense, Stroke, Ui, pos2, vec2};

use super::{PanelInput, PanelOutput};
use crate::marks::mark;
use crate::pointer::{Pointing, Strokes};
use crate::style;

/// The picture in all the room that is left, and what the pointer does on it.
pub fn show(ui: &mut Ui, shown: &PanelInput<'_>, strokes: &mut Strokes, panel_output: &mut PanelOutput) {
    CentralPanel::default().frame(Frame::new().fill(Color32::from_rgb(10, 12, 15))).show(ui, |ui| {
        let room = ui.max_rect();
        let pixels_per_point = ui.ctx().pixels_per_point();
        panel_output.room_px =
            [room.width(), room.height()].map(|side| (side * pixels_per_point).round().max(1.0) as u32);
        if let Some((texture, size_px)) = shown.picture {
            ui.painter().with_clip_rect(room).image(texture, covering(room, size_px), whole(), Color32::WHITE);
        }
        let response = ui.interact(room, ui.scope_id().with("picture"), Sense::click_and_drag());
        mark(&response, "picture");
        panel_output.pointing = Pointing::on(&response, strokes);
        hand(ui, room, shown);
        if let Some((what, progress)) = shown.loading {
            loading(ui, room, what, progress, shown.picture.is_none());
        }
    });
}

/// What the hand holds or is about to place.
fn hand(ui: &Ui, room: Rect, shown: &PanelInput<'_>) {
    if shown.placing.is_some() && ui.rect_contains_pointer(room) {
        ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
    }
    let Some(tether) = shown.tether else { return };
    ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
    let [from, to] = tether.map(|at| room.min + vec2(at.x as f32, at.y as f32) * room.size());
    let painter = ui.painter().with_clip_rect(room);
    painter.line_segment([from, to], Stroke::new(1.5, Color32::from_white_alpha(170)));
    painter.circle_filled(from, 3.5, style::ACCENT);
}

/// Where a picture of another shape covers all of the room, its middle in the room's.
fn covering(room: Rect, [width_px, height_px]: [u32; 2]) -> Rect {
    let (width, height) = (width_px.max(1) as f32, height_px.max(1) as f32);
    let scale = (room.width() / width).max(room.height() / height);
    Rect::from_center_size(room.center(), vec2(width * scale, height * scale))
}

fn whole() -> Rect {
    Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0))
}

fn loading(ui: &mut Ui, room: Rect, what: &str, progress: &crate::loading::Progress, alone: bool) {
    // Over a running picture a small note, before the first one a large one.
    let size = if alone { vec2(320.0, 64.0) } else { vec2(240.0, 44.0) };
    let at = if alone { room.center() } else { room.center_top() + vec2(0.0, 12.0 + 0.5 * size.y) };
    let rect = Rect::from_center_size(at, size);
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    Frame::new().fill(Color32::from_black_alpha(190)).corner_radius(6).inner_margin(10).show(&mut inner, |ui| {
        ui.set_width(size.x - 20.0);
        let text = if progress.what.is_empty() { what } else { &progress.what };
        ui.label(RichText::new(format!("{what}: {text}")).color(style::QUIET));
        let bar = match progress.all {
            0 => ProgressBar::new(0.0).animate(true),
            all => ProgressBar::new(progress.done as f32 / all as f32),
        };
        let response = ui.add(bar.desired_height(6.0));
        mark(&response, "loading");
    });
}
