//! What stands round the picture.

mod bar;
mod help;
mod messages;
pub mod picture;
mod quality;
pub mod settings;
mod side;
mod sources;
mod times;

use std::path::Path;

use brooklet_fluid::Stats;
use brooklet_gpu::Gpu;
use brooklet_render::left_out::Absent;
use egui::{Context, Panel, TextureId};
use glam::DVec2;

use crate::action::Action;
use crate::flow::Flow;
use crate::governor::Governor;
use crate::loading::Progress;
use crate::messages::Messages;
use crate::place::Place;
use crate::pointer::{Pointing, Strokes};
use crate::style;
use crate::times::Times;
use crate::viewer_scene::ViewerScene;

/// What the panels show.
pub struct PanelInput<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// The running scene.
    pub current: Option<&'a ViewerScene>,
    /// The newest measurement of it.
    pub stats: Option<&'a Stats>,
    /// What is being loaded, and how far it is.
    pub loading: Option<(&'a str, &'a Progress)>,
    /// The picture, and its size in pixels.
    pub picture: Option<(TextureId, [u32; 2])>,
    /// Whether the simulation stands.
    pub paused: bool,
    /// Simulated seconds a second that are wanted.
    pub speed: f64,
    /// Rung of the quality ladder.
    pub rung: usize,
    /// Whether the ladder moves by itself.
    pub auto: bool,
    /// What holds the budget.
    pub governor: &'a Governor,
    /// What frames took.
    pub times: &'a Times,
    /// What the plan does without.
    pub left_out: &'a [Absent],
    /// The capture being written, and its bytes so far.
    pub capture: Option<(&'a Path, u64)>,
    /// What there is to say.
    pub messages: &'a Messages,
    /// Settings that wait for the next reset.
    pub waiting: &'a [String],
    /// What came and went.
    pub flow: &'a Flow,
    /// What the next touch of the picture places.
    pub placing: Option<Place>,
    /// From where a body is held to where the hand is, in parts of the picture's width and height.
    pub tether: Option<[DVec2; 2]>,
}

/// What a program shows in place of the panels: over the picture ([`picture::show`]), or without one.
pub type Face<'a> = dyn FnMut(&mut egui::Ui, &PanelInput<'_>, &mut PanelOutput) + 'a;

/// What of the panels is open, and what is being edited.
pub struct Panels {
    /// Whether there are any.
    pub shown: bool,
    /// Whether times and plots are among them.
    pub overlay: bool,
    /// Whether the help is.
    pub help: bool,
    /// The settings as they are being edited.
    pub draft: Option<settings::Draft>,
    strokes: Strokes,
}

impl Default for Panels {
    fn default() -> Self {
        Self { shown: true, overlay: true, help: false, draft: None, strokes: Strokes::default() }
    }
}

/// What a frame of the panels asks for.
#[derive(Default)]
pub struct PanelOutput {
    /// Buttons and fields.
    pub actions: Vec<Action>,
    /// The pointer on the picture.
    pub pointing: Pointing,
    /// Room for the picture, pixels.
    pub room_px: [u32; 2],
}

impl Panels {
    /// One frame.
    pub fn show(&mut self, ui: &mut egui::Ui, shown: &PanelInput<'_>) -> PanelOutput {
        let mut panel_output = PanelOutput::default();
        let context: Context = ui.ctx().clone();
        if self.shown {
            Panel::top("bar").frame(style::bar()).show(ui, |ui| bar::show(ui, shown, &mut panel_output.actions));
            if self.overlay {
                Panel::left("times")
                    .frame(style::panel())
                    .resizable(false)
                    .exact_size(286.0)
                    .show(ui, |ui| times::show(ui, shown));
            }
            Panel::right("settings")
                .frame(style::panel())
                .resizable(false)
                .exact_size(322.0)
                .show(ui, |ui| side::show(ui, shown, &mut self.draft, &mut panel_output.actions));
        }
        picture::show(ui, shown, &mut self.strokes, &mut panel_output);
        messages::show(&context, shown);
        if self.help {
            help::show(&context, &mut self.help);
        }
        panel_output
    }
}
