//! What was said, at the picture's foot.

use egui::{Align2, Area, Color32, Context, Frame, Id, Order, RichText, vec2};

use super::PanelInput;
use crate::marks::mark;
use crate::messages::Kind;
use crate::style;

pub(super) fn show(context: &Context, shown: &PanelInput<'_>) {
    if shown.messages.latest().is_empty() {
        return;
    }
    Area::new(Id::unique("messages")).order(Order::Foreground).anchor(Align2::CENTER_BOTTOM, vec2(0.0, -14.0)).show(
        context,
        |ui| {
            ui.set_max_width(560.0);
            for message in shown.messages.latest() {
                let (sign, color) = style::sign_of(message.kind);
                let frame = Frame::new().fill(Color32::from_black_alpha(215)).corner_radius(5).inner_margin(8);
                let shown = frame.show(ui, |ui| {
                    ui.horizontal_top(|ui| {
                        ui.label(RichText::new(sign).color(color));
                        ui.label(&message.text);
                    });
                });
                mark(&shown.response, if message.kind == Kind::Error { "error" } else { "message" });
            }
        },
    );
}
