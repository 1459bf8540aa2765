//! What a person can ask for: by button, key or touch, all the same.

use std::path::PathBuf;

use brooklet_fluid::Scene;
use brooklet_gpu::Tier;

use crate::place::Place;

/// Something asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Stop the simulation, or let it go on.
    Pause,
    /// One step, and stay paused.
    Step,
    /// The scene from its start, with all settings as they are.
    Reset,
    /// Another scene: a shipped one's name, or a file.
    Open(String),
    /// The scene with other settings.
    Apply(Box<Scene>),
    /// What the next touch of the picture places, or nothing.
    Place(Option<Place>),
    /// Simulated seconds a second.
    Speed(f64),
    /// A picture of the fluid, without what stands over it.
    Screenshot,
    /// Begin or end a capture.
    Capture,
    /// The state to a file.
    SaveState,
    /// The state last saved, or that of a file.
    RestoreState(Option<PathBuf>),
    /// A rung of the quality ladder.
    Rung(usize),
    /// Let the ladder hold the budget by itself, or not.
    Auto(bool),
    /// What a frame may take, ms.
    Budget(f64),
    /// The device as one of another tier.
    Tier(Tier),
    /// The camera as the scene has it.
    ResetCamera,
    /// The whole screen, or a window.
    Fullscreen,
    /// Show or hide everything that stands over the picture.
    Panels,
    /// Show or hide times and plots.
    Overlay,
    /// Show or hide the help.
    Help,
    /// End.
    Quit,
}

/// A key, what it asks for, and how the help calls it.
pub struct Key {
    /// The key.
    pub key: egui::Key,
    /// With Ctrl (on a Mac: Command).
    pub command: bool,
    /// What it asks for.
    pub action: Action,
    /// For the help.
    pub help: &'static str,
}

/// Every key.
pub fn keys() -> Vec<Key> {
    use egui::Key as K;
    let plain = |key, action, help| Key { key, command: false, action, help };
    let with_command = |key, action, help| Key { key, command: true, action, help };
    vec![
        plain(K::Space, Action::Pause, "pause, or go on"),
        plain(K::Period, Action::Step, "one step, paused"),
        plain(K::R, Action::Reset, "begin again"),
        plain(K::V, Action::ResetCamera, "the scene's own view"),
        plain(K::Tab, Action::Panels, "hide or show the panels"),
        plain(K::T, Action::Overlay, "times and plots"),
        plain(K::S, Action::Screenshot, "screenshot"),
        plain(K::C, Action::Capture, "begin or end a capture"),
        with_command(K::S, Action::SaveState, "save the state"),
        with_command(K::O, Action::RestoreState(None), "restore the state"),
        plain(K::F11, Action::Fullscreen, "whole screen"),
        plain(K::F1, Action::Help, "this help"),
        with_command(K::Q, Action::Quit, "quit"),
    ]
}

/// What the keys pressed since the last frame ask for; nothing while a text is typed.
pub fn pressed(context: &egui::Context) -> Vec<Action> {
    if context.egui_wants_keyboard_input() {
        return Vec::new();
    }
    context.input_mut(|input| {
        let wanted = |key: &Key| {
            let modifiers = if key.command { egui::Modifiers::COMMAND } else { egui::Modifiers::NONE };
            input.consume_key(modifiers, key.key)
        };
        // With Ctrl first: a key alone would take those, too.
        let mut all = keys();
        all.sort_by_key(|key| !key.command);
        let mut wanted = wanted;
        all.into_iter().filter_map(|key| wanted(&key).then_some(key.action)).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_has_two_meanings() {
        let all = keys();
        for (index, key) in all.iter().enumerate() {
            assert!(
                !all[..index].iter().any(|other| other.key == key.key && other.command == key.command),
                "{}",
                key.help
            );
        }
    }

    #[test]
    fn a_key_asks_for_its_action_alone() {
        let context = egui::Context::default();
        let press =
            |key, modifiers| egui::Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers };
        let ask = |key, modifiers| {
            let input = egui::RawInput { events: vec![press(key, modifiers)], ..Default::default() };
            let mut asked = Vec::new();
            let mut output = context.run_ui(input, |ui| asked.extend(pressed(ui.ctx())));
            // Nobody paints: egui insists on being told so.
            output.textures_delta.clear();
            asked
        };
        assert_eq!(ask(egui::Key::S, egui::Modifiers::NONE), [Action::Screenshot]);
        assert_eq!(ask(egui::Key::S, egui::Modifiers::COMMAND), [Action::SaveState]);
        assert_eq!(ask(egui::Key::Z, egui::Modifiers::NONE), []);
    }
}
