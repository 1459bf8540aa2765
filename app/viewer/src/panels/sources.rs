//! What comes and goes while a scene runs, and the bodies in it: counts, and emitters to place, edit and remove.

use brooklet_fluid::scene::{EmitterSettings, body_count};
use egui::{DragValue, Grid, RichText, Ui};

use super::PanelInput;
use super::settings::Draft;
use crate::action::Action;
use crate::marks::mark;
use crate::place::Place;
use crate::style;

pub(super) fn show(ui: &mut Ui, shown: &PanelInput<'_>, draft: &mut Option<Draft>, actions: &mut Vec<Action>) {
    counts(ui, shown);
    ui.horizontal(|ui| {
        let tools = [
            (Place::Wall, "place hose", "+ hose", "Click on a wall or a solid: it flows away from there"),
            (Place::Air, "place faucet", "+ faucet", "Click in the picture: it flows down, in the middle of the depth"),
        ];
        for (place, name, text, tip) in tools {
            let is_chosen = shown.placing == Some(place);
            let response = ui.selectable_label(is_chosen, text).on_hover_text(tip);
            mark(&response, name);
            if response.clicked() {
                actions.push(Action::Place((!is_chosen).then_some(place)));
            }
        }
    });
    let Some(draft) = draft else { return };
    let mut edited = None;
    for (index, emitter) in draft.scene.emitters.iter().enumerate() {
        let mut changed = emitter.clone();
        match row(ui, index, &mut changed) {
            Edit::Nothing => {}
            Edit::Seen => edited = Some((index, Some(changed), false)),
            Edit::Final => edited = Some((index, Some(changed), true)),
            Edit::Remove => edited = Some((index, None, true)),
        }
    }
    if let Some((index, emitter, is_final)) = edited {
        let mut emitters = draft.scene.emitters.clone();
        emitters.splice(index..=index, emitter);
        draft.take_emitters(emitters, is_final, actions);
    }
}

/// What was done to an emitter.
enum Edit {
    Nothing,
    /// A number that is still being dragged.
    Seen,
    Final,
    Remove,
}

fn row(ui: &mut Ui, index: usize, emitter: &mut EmitterSettings) -> Edit {
    let mut edit = Edit::Nothing;
    ui.horizontal(|ui| {
        let what = if emitter.radius_m.is_some() || emitter.width_m.is_some() { "nozzle" } else { "fill" };
        ui.label(RichText::new(format!("{what} {index}")).small());
        let mut number = |ui: &mut Ui, value: &mut f64, name: &str, tip: &str, speed: f64| {
            let drag = DragValue::new(value).speed(speed).max_decimals(2);
            let response = ui.add_sized([40.0, 18.0], drag).on_hover_text(tip);
            mark(&response, &format!("emitter {index} {name}"));
            if response.drag_stopped() || response.changed() && !response.dragged() {
                edit = Edit::Final;
            } else if response.changed() {
                edit = Edit::Seen;
            }
        };
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            number(ui, &mut emitter.direction[axis], name, &format!("direction, {name}"), 0.02);
        }
        number(ui, &mut emitter.speed_m_s, "speed", "speed, m/s", 0.02);
        let response = ui.small_button("✖").on_hover_text("Remove it; what it emitted stays");
        mark(&response, &format!("emitter {index} remove"));
        if response.clicked() {
            edit = Edit::Remove;
        }
    });
    edit
}

fn counts(ui: &mut Ui, shown: &PanelInput<'_>) {
    let Some(current) = shown.current else { return };
    let slots = current.session.slot_count();
    let alive = shown.stats.map_or("…".to_owned(), |stats| stats.particles.to_string());
    let lost = shown.flow.lost;
    let mut rows = vec![
        ("particles, slots", format!("{alive} of {slots}")),
        ("emitted", shown.flow.emitted.to_string()),
        ("drained", shown.flow.drained.to_string()),
        ("bodies", body_count(&current.scene).to_string()),
    ];
    if lost > 0 {
        rows.push(("without a slot", lost.to_string()));
    }
    Grid::new("sources").num_columns(2).spacing([12.0, 2.0]).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(RichText::new(name).small().color(style::QUIET));
            let response = ui.label(RichText::new(value).small());
            mark(&response, &format!("count {name}"));
            ui.end_row();
        }
    });
}
