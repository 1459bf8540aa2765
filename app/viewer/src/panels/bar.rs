//! The bar at the top: which scene, what it does, what is written.

use brooklet_fluid::shipped_scenes;
use egui::{Align, Button, ComboBox, Layout, RichText, Slider, Ui};

use super::PanelInput;
use crate::action::Action;
use crate::marks::mark;
use crate::style;

pub(super) fn show(ui: &mut Ui, shown: &PanelInput<'_>, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        scenes(ui, shown, actions);
        ui.separator();
        let has_scene = shown.current.is_some();
        let mut button = |ui: &mut Ui, name: &str, text: RichText, tip: &str, action: Action| {
            let response = ui.add_enabled(has_scene, Button::new(text)).on_hover_text(tip);
            mark(&response, name);
            if response.clicked() {
                actions.push(action);
            }
        };
        let pause = if shown.paused { ("▶", "Go on (Space)") } else { ("⏸", "Pause (Space)") };
        button(ui, "pause", RichText::new(pause.0), pause.1, Action::Pause);
        button(ui, "step", RichText::new("⏭"), "One step (.)", Action::Step);
        button(ui, "reset", RichText::new("⟲"), "Begin again (R)", Action::Reset);
        let mut speed = shown.speed;
        let slider = Slider::new(&mut speed, 0.05..=2.0).logarithmic(true).fixed_decimals(2).suffix(" ×");
        let response = ui.add(slider).on_hover_text("Simulated seconds a second that are wanted");
        mark(&response, "speed");
        ui.separator();
        button(ui, "screenshot", RichText::new("📷"), "Screenshot of the fluid (S)", Action::Screenshot);
        let (text, tip) = match shown.capture {
            Some((path, bytes)) => (
                RichText::new(format!("⏺ {:.1} MB", bytes as f64 * 1e-6)).color(style::RECORDING),
                format!("Writing {} (C ends it)", path.display()),
            ),
            None => (RichText::new("⏺"), "Begin a timing capture (C)".to_owned()),
        };
        button(ui, "capture", text, &tip, Action::Capture);
        button(ui, "save", RichText::new("💾"), "Save the state (Ctrl+S)", Action::SaveState);
        button(ui, "restore", RichText::new("🗁"), "Restore the saved state (Ctrl+O)", Action::RestoreState(None));
        button(ui, "camera", RichText::new("🏠"), "The scene's own view (V)", Action::ResetCamera);
        button(ui, "fullscreen", RichText::new("⛶"), "Whole screen (F11)", Action::Fullscreen);
        button(ui, "help", RichText::new("?"), "Keys and mouse (F1)", Action::Help);
        if speed != shown.speed {
            actions.push(Action::Speed(speed));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| status(ui, shown));
    });
}

/// All scenes without scrolling.
const LIST_HEIGHT: f32 = 480.0;

fn scenes(ui: &mut Ui, shown: &PanelInput<'_>, actions: &mut Vec<Action>) {
    let open = shown.current.map_or("scene", |current| current.scene.name.as_str());
    let list =
        ComboBox::from_id_salt("scenes").selected_text(open).width(132.0).height(LIST_HEIGHT).show_ui(ui, |ui| {
            for (name, summary) in shipped_scenes() {
                let response = ui.selectable_label(name == open, name).on_hover_text(summary);
                mark(&response, &format!("scene {name}"));
                if response.clicked() {
                    actions.push(Action::Open(name.to_owned()));
                }
            }
            ui.label(RichText::new("or drop a scene file on the window").small().color(style::QUIET));
        });
    mark(&list.response, "scenes");
}

fn status(ui: &mut Ui, shown: &PanelInput<'_>) {
    let Some(current) = shown.current else { return };
    let speed = match (shown.paused, shown.times.speed.quantiles()) {
        (true, _) => "paused".to_owned(),
        (false, Some(speed)) => format!("{:.2} × real time", speed.p50),
        (false, None) => String::new(),
    };
    let frames = shown.times.frame_ms.quantiles().filter(|frame| frame.p50 > 0.0);
    let frames = frames.map_or(String::new(), |frame| {
        let rate = 1000.0 / frame.p50;
        if rate < 9.95 { format!("{rate:.1} frames/s") } else { format!("{rate:.0} frames/s") }
    });
    let text = format!("{:.2} s   {speed}   {frames}", current.session.simulated_s());
    ui.label(RichText::new(text).color(style::QUIET));
}
