//! How the window looks.

use egui::epaint::text::{FontInsert, FontPriority, FontTweak, InsertFontFamily};
use egui::{Color32, Context, CornerRadius, FontData, FontFamily, FontId, Frame, Margin, Stroke, TextStyle, Theme};

use crate::messages::Kind;

/// What is chosen, what moves, what is good.
pub const ACCENT: Color32 = Color32::from_rgb(86, 176, 232);
/// What asks for a look.
pub const WARNING: Color32 = Color32::from_rgb(240, 180, 70);
/// What went wrong.
pub const ERROR: Color32 = Color32::from_rgb(240, 105, 95);
/// What runs.
pub const RECORDING: Color32 = Color32::from_rgb(235, 80, 75);
/// What explains.
pub const QUIET: Color32 = Color32::from_rgb(146, 158, 172);

const PANEL: Color32 = Color32::from_rgb(22, 26, 32);
const FIELD: Color32 = Color32::from_rgb(13, 16, 21);
const BUTTON: Color32 = Color32::from_rgb(42, 50, 60);
const TEXT: Color32 = Color32::from_rgb(222, 228, 235);

/// Signs on buttons, after the letters.
fn icons() -> FontInsert {
    let tweak = FontTweak { scale: 0.9, ..FontTweak::default() };
    let families = [FontFamily::Proportional, FontFamily::Monospace]
        .map(|family| InsertFontFamily { family, priority: FontPriority::Lowest });
    FontInsert::new("icons", FontData::from_static(epaint_default_fonts::EMOJI_ICON).tweak(tweak), families.into())
}

/// Sets fonts, their sizes, colours and distances, once.
pub fn apply(context: &Context) {
    context.add_font(icons());
    context.set_theme(Theme::Dark);
    context.all_styles_mut(|style| {
        style.text_styles = [
            (TextStyle::Heading, FontId::proportional(15.0)),
            (TextStyle::Body, FontId::proportional(13.0)),
            (TextStyle::Button, FontId::proportional(13.0)),
            (TextStyle::Small, FontId::proportional(11.0)),
            (TextStyle::Monospace, FontId::monospace(12.0)),
        ]
        .into();
        style.spacing.item_spacing = egui::vec2(6.0, 5.0);
        style.spacing.button_padding = egui::vec2(7.0, 3.0);
        style.spacing.slider_width = 80.0;
        let visuals = &mut style.visuals;
        visuals.panel_fill = PANEL;
        visuals.window_fill = PANEL;
        visuals.extreme_bg_color = FIELD;
        visuals.faint_bg_color = Color32::from_rgb(28, 33, 40);
        visuals.override_text_color = Some(TEXT);
        visuals.selection.bg_fill = ACCENT.gamma_multiply(0.55);
        visuals.selection.stroke = Stroke::new(1.0, Color32::WHITE);
        visuals.hyperlink_color = ACCENT;
        visuals.slider_trailing_fill = true;
        visuals.window_corner_radius = CornerRadius::same(6);
        let corner = CornerRadius::same(4);
        for widget in [
            &mut visuals.widgets.noninteractive,
            &mut visuals.widgets.inactive,
            &mut visuals.widgets.hovered,
            &mut visuals.widgets.active,
            &mut visuals.widgets.open,
        ] {
            widget.corner_radius = corner;
        }
        visuals.widgets.inactive.bg_fill = BUTTON;
        visuals.widgets.inactive.weak_bg_fill = BUTTON;
        visuals.widgets.hovered.weak_bg_fill = Color32::from_rgb(56, 67, 80);
        visuals.widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(40, 46, 55));
    });
}

/// The sign and the colour of what is said.
pub fn sign_of(kind: Kind) -> (&'static str, Color32) {
    match kind {
        Kind::Done => ("✔", ACCENT),
        Kind::Warning => ("⚠", WARNING),
        Kind::Error => ("✖", ERROR),
    }
}

/// A side panel's frame.
pub fn panel() -> Frame {
    Frame::new().fill(PANEL).inner_margin(Margin::symmetric(10, 8))
}

/// A bar's frame.
pub fn bar() -> Frame {
    Frame::new().fill(PANEL).inner_margin(Margin::symmetric(10, 5))
}
