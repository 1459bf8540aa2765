//! The panel at the right: everything that can be set.

use egui::{CollapsingHeader, RichText, ScrollArea, Ui};

use super::settings::Draft;
use super::{PanelInput, quality, sources};
use crate::action::Action;
use crate::marks::mark;
use crate::style;

pub(super) fn show(ui: &mut Ui, shown: &PanelInput<'_>, draft: &mut Option<Draft>, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        // Whatever is too wide is cut, and nothing moves aside for it.
        ui.set_max_width(ui.available_width());
        if let Some(current) = shown.current {
            ui.label(RichText::new(&current.scene.summary).color(style::QUIET));
        }
        if !shown.waiting.is_empty() {
            ui.horizontal_wrapped(|ui| {
                let text = format!("{} from the next reset on", shown.waiting.join(", "));
                ui.label(RichText::new(text).color(style::WARNING));
                let response = ui.button("Reset now");
                mark(&response, "reset now");
                if response.clicked() {
                    actions.push(Action::Reset);
                }
            });
        }
        let header = CollapsingHeader::new("Quality").show(ui, |ui| quality::show(ui, shown, actions));
        mark(&header.header_response, "section quality");
        let header =
            CollapsingHeader::new("Emitters and bodies").show(ui, |ui| sources::show(ui, shown, draft, actions));
        mark(&header.header_response, "section sources");
        if let Some(draft) = draft {
            draft.show(ui, actions);
        }
    });
}
