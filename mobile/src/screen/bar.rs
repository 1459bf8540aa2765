//! The bar at the foot: what is asked for most.

use brooklet_viewer::action::Action;
use brooklet_viewer::panels::PanelInput;
use brooklet_viewer::style;
use egui::{Align2, Area, Color32, Context, Id, Order, vec2};

use super::look::{self, TEXT};
use super::{Ask, Down, Facts, Sheet};

/// Width of a button, points; less where the screen is narrow.
const WIDTH: f32 = 62.0;
const BUTTONS: f32 = 6.0;

pub(super) fn show(
    context: &Context,
    shown: &PanelInput<'_>,
    facts: &Facts<'_>,
    sheet: &mut Option<Sheet>,
    actions: &mut Vec<Action>,
    asks: &mut Vec<Ask>,
) {
    let room = context.content_rect().width() - 16.0 - 12.0;
    let width = WIDTH.min(room / BUTTONS).max(look::FINGER);
    let bar = Area::new(Id::unique("bar"))
        .fade_in(false)
        .order(Order::Middle)
        .anchor(Align2::CENTER_BOTTOM, vec2(0.0, -10.0));
    bar.show(context, |ui| {
        look::glass().show(ui, |ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            ui.horizontal(|ui| {
                let has_scene = shown.current.is_some();
                let mut button = |name: &str, face: (&str, &str), color: Color32, enabled: bool| {
                    look::sign(ui, name, face, color, width, enabled).clicked()
                };
                if button("scenes", ("🌊", "scenes"), TEXT, true) {
                    *sheet = Some(Sheet::Scenes);
                }
                let pause = if shown.paused { ("▶", "go on") } else { ("⏸", "pause") };
                if button("pause", pause, TEXT, has_scene) {
                    actions.push(Action::Pause);
                }
                if button("reset", ("⟲", "again"), TEXT, has_scene) {
                    actions.push(Action::Reset);
                }
                if button("level", ("⚖", "level"), TEXT, facts.down == Down::Sensor) {
                    asks.push(Ask::Level);
                }
                let (word, color) = match shown.capture {
                    Some((_, bytes)) => (format!("{:.1} MB", bytes as f64 * 1e-6), style::RECORDING),
                    None => ("capture".to_owned(), TEXT),
                };
                if button("capture", ("⏺", &word), color, has_scene) {
                    actions.push(Action::Capture);
                }
                let color = if facts.is_wrong { style::WARNING } else { TEXT };
                if button("menu", ("☰", "menu"), color, true) {
                    *sheet = Some(Sheet::Menu);
                }
            });
        });
    });
}
