//! The quality ladder.

use brooklet_gpu::{TIERS, tier_name};
use egui::{RichText, Slider, Ui};

use super::PanelInput;
use crate::action::Action;
use crate::ladder::RUNGS;
use crate::marks::mark;
use crate::style;

pub(super) fn show(ui: &mut Ui, shown: &PanelInput<'_>, actions: &mut Vec<Action>) {
    let mut auto = shown.auto;
    let response = ui.checkbox(&mut auto, "Hold the budget by itself");
    mark(&response, "auto quality");
    if auto != shown.auto {
        actions.push(Action::Auto(auto));
    }
    let mut budget_ms = shown.governor.budget_ms;
    let slider = Slider::new(&mut budget_ms, 4.0..=500.0).logarithmic(true).fixed_decimals(0).suffix(" ms");
    let response = ui.add(slider.text("a frame"));
    mark(&response, "budget");
    if budget_ms != shown.governor.budget_ms {
        actions.push(Action::Budget(budget_ms));
    }
    tiers(ui, shown, actions);
    for (index, rung) in RUNGS.iter().enumerate() {
        let text = if index == 0 { rung.name.to_owned() } else { format!("− {}", rung.name) };
        let given_up = index > 0 && index <= shown.rung;
        let text = if given_up { RichText::new(text).color(style::WARNING) } else { RichText::new(text) };
        let response = ui.radio(index == shown.rung, text);
        mark(&response, &format!("rung {index}"));
        if response.clicked() && index != shown.rung {
            actions.push(Action::Rung(index));
        }
    }
}

/// As what the device is used. One that does not reach a tier says so when it is asked.
fn tiers(ui: &mut Ui, shown: &PanelInput<'_>, actions: &mut Vec<Action>) {
    let used = shown.gpu.tier();
    ui.horizontal(|ui| {
        ui.label("tier");
        for tier in TIERS {
            let response = ui.selectable_label(tier == used, tier_name(tier));
            mark(&response, &format!("tier {}", tier_name(tier)));
            if response.clicked() && tier != used {
                actions.push(Action::Tier(tier));
            }
        }
    });
}
