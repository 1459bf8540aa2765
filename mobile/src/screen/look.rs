//! Sizes for fingers, and buttons of them.

use brooklet_viewer::style;
use egui::{
    Align2, Color32, Context, CornerRadius, FontId, Frame, Margin, Response, Sense, Stroke, TextStyle, Ui, vec2,
};

/// The least side of what a finger is to hit, points.
pub const FINGER: f32 = 48.0;
/// Behind what stands over the picture.
pub const GLASS: Color32 = Color32::from_rgba_premultiplied(12, 16, 21, 205);
/// Text on it.
pub const TEXT: Color32 = Color32::from_rgb(232, 237, 243);
/// A button on a sheet.
const KEY: Color32 = Color32::from_rgb(44, 53, 64);
const KEY_DOWN: Color32 = Color32::from_rgb(62, 76, 92);

/// Sets fonts and distances for a phone, over those of the window.
pub fn apply(context: &Context) {
    context.all_styles_mut(|style| {
        style.text_styles = [
            (TextStyle::Heading, FontId::proportional(20.0)),
            (TextStyle::Body, FontId::proportional(15.0)),
            (TextStyle::Button, FontId::proportional(16.0)),
            (TextStyle::Small, FontId::proportional(13.0)),
            (TextStyle::Monospace, FontId::monospace(13.0)),
        ]
        .into();
        style.spacing.interact_size = vec2(FINGER, FINGER);
        style.spacing.item_spacing = vec2(8.0, 8.0);
        style.interaction.selectable_labels = false;
    });
}

/// A frame over the picture.
pub fn glass() -> Frame {
    Frame::new().fill(GLASS).corner_radius(16).inner_margin(Margin::symmetric(6, 4))
}

/// A button of a sign and a word, `width` points wide.
pub fn sign(
    ui: &mut Ui,
    name: &str,
    (glyph, word): (&str, &str),
    color: Color32,
    width: f32,
    enabled: bool,
) -> Response {
    let sense = if enabled { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(vec2(width, 58.0), sense);
    let color = if enabled { color } else { style::QUIET.gamma_multiply(0.5) };
    let painter = ui.painter();
    if response.is_pointer_button_down_on() {
        painter.rect_filled(rect, CornerRadius::same(12), KEY_DOWN);
    }
    painter.text(rect.center_top() + vec2(0.0, 24.0), Align2::CENTER_CENTER, glyph, FontId::proportional(23.0), color);
    let word_at = rect.center_bottom() - vec2(0.0, 11.0);
    let word_color = if enabled { TEXT } else { color };
    painter.text(word_at, Align2::CENTER_CENTER, word, FontId::proportional(12.0), word_color);
    brooklet_viewer::marks::mark(&response, name);
    response
}

/// A button as wide as there is room, of a word and what explains it.
pub fn key(ui: &mut Ui, name: &str, (word, about): (&str, &str), chosen: bool) -> Response {
    let width = ui.available_width();
    let about = ui.painter().layout(about.to_owned(), FontId::proportional(13.0), style::QUIET, width - 28.0);
    let height = if about.text().is_empty() { FINGER + 4.0 } else { (34.0 + about.size().y + 10.0).max(FINGER + 8.0) };
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::click());
    let fill = if response.is_pointer_button_down_on() { KEY_DOWN } else { KEY };
    let painter = ui.painter();
    let edge = if chosen { Stroke::new(2.0, style::ACCENT) } else { Stroke::NONE };
    painter.rect(rect, CornerRadius::same(12), fill, edge, egui::StrokeKind::Inside);
    let alone = about.text().is_empty();
    let word_y = if alone { rect.center().y } else { rect.top() + 20.0 };
    let word_color = if chosen { style::ACCENT } else { TEXT };
    let word_at = egui::pos2(rect.left() + 14.0, word_y);
    painter.text(word_at, Align2::LEFT_CENTER, word, FontId::proportional(16.0), word_color);
    painter.galley(egui::pos2(rect.left() + 14.0, rect.top() + 34.0), about, style::QUIET);
    brooklet_viewer::marks::mark(&response, name);
    response
}
