//! The sheets: scenes, and the menu.

use brooklet_fluid::shipped_scenes;
use brooklet_gpu::tier_name;
use brooklet_viewer::action::Action;
use brooklet_viewer::ladder::RUNGS;
use brooklet_viewer::panels::PanelInput;
use brooklet_viewer::style;
use egui::{Area, Color32, Context, CornerRadius, Frame, Id, Margin, Order, Rect, RichText, ScrollArea, Ui, vec2};

use super::look;
use super::{Ask, Down, Facts};

const SHEET: Color32 = Color32::from_rgb(22, 27, 33);

/// A sheet from the foot, or from the right where the screen is wide. Returns what `content` returns, and whether the cross was
/// touched.
fn sheet<T>(context: &Context, screen: Rect, title: &str, content: impl FnOnce(&mut Ui) -> T) -> (T, bool) {
    let is_wide = screen.width() > screen.height();
    let size = if is_wide {
        vec2(400f32.min(screen.width()), screen.height())
    } else {
        vec2(screen.width(), 0.68 * screen.height())
    };
    let rect = Rect::from_min_size(screen.max - size, size);
    let round = CornerRadius { nw: 20, ne: if is_wide { 0 } else { 20 }, sw: if is_wide { 20 } else { 0 }, se: 0 };
    let frame = Frame::new().fill(SHEET).corner_radius(round).inner_margin(Margin::symmetric(16, 10));
    let area =
        Area::new(Id::unique("sheet")).fade_in(false).order(Order::Foreground).fixed_pos(rect.min).constrain(false);
    area.show(context, |ui| {
        frame
            .show(ui, |ui| {
                ui.set_min_size(rect.size() - vec2(32.0, 20.0));
                ui.set_max_size(rect.size() - vec2(32.0, 20.0));
                let closes = ui
                    .horizontal(|ui| {
                        ui.label(RichText::new(title).heading());
                        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                            look::sign(ui, "close", ("✖", ""), style::QUIET, look::FINGER, true).clicked()
                        })
                        .inner
                    })
                    .inner;
                let inner = ScrollArea::vertical().auto_shrink(false).show(ui, content).inner;
                (inner, closes)
            })
            .inner
    })
    .inner
}

/// Whether it is to be closed.
pub(super) fn scenes(context: &Context, screen: Rect, shown: &PanelInput<'_>, actions: &mut Vec<Action>) -> bool {
    let open = shown.current.map_or("", |current| current.scene.name.as_str());
    let (chosen, closes) = sheet(context, screen, "Scenes", |ui| {
        let mut chosen = false;
        // What was made for phones comes first.
        let mut all: Vec<(&str, &str)> = shipped_scenes().collect();
        all.sort_by_key(|(name, _)| !name.starts_with("phone"));
        for (name, summary) in all {
            if look::key(ui, &format!("scene {name}"), (name, summary), name == open).clicked() {
                actions.push(Action::Open(name.to_owned()));
                chosen = true;
            }
        }
        chosen
    });
    chosen || closes
}

/// Whether it is to be closed.
pub(super) fn menu(
    context: &Context,
    screen: Rect,
    shown: &PanelInput<'_>,
    facts: &Facts<'_>,
    actions: &mut Vec<Action>,
    asks: &mut Vec<Ask>,
) -> bool {
    let mut closes_by_itself = false;
    let ((), closes) = sheet(context, screen, "Menu", |ui| {
        quality(ui, shown, actions);
        ui.add_space(6.0);
        let about = match (facts.checking, &facts.checked) {
            (Some([done, all]), _) => format!("{done} of {all} known answers"),
            (None, Some(checked)) => checked.clone(),
            (None, None) => "not checked yet".to_owned(),
        };
        if look::key(ui, "check", ("Check this device", &about), facts.is_wrong).clicked()
            && facts.checking.is_none()
            && facts.reporting.is_none()
        {
            asks.push(Ask::Check);
        }
        let about = "device, self-check and times of two scenes, as one file in the folder below: half a minute";
        let is_made = look::key(ui, "report", ("Make a report to send", about), facts.reporting.is_some()).clicked();
        if is_made && facts.checking.is_none() && facts.reporting.is_none() {
            asks.push(Ask::Report);
            closes_by_itself = true;
        }
        if look::key(ui, "screenshot", ("Keep a picture", "of the fluid alone, in the folder below"), false).clicked() {
            actions.push(Action::Screenshot);
        }
        if look::key(ui, "camera", ("The scene's own view", ""), false).clicked() {
            actions.push(Action::ResetCamera);
        }
        ui.add_space(6.0);
        facts_of(ui, shown, facts);
    });
    closes || closes_by_itself
}

fn quality(ui: &mut Ui, shown: &PanelInput<'_>, actions: &mut Vec<Action>) {
    let given_up = shown.current.map(|current| RUNGS[shown.rung].given_up(&current.scene)).unwrap_or_default();
    let given_up = match given_up {
        all if all.is_empty() => "nothing is given up".to_owned(),
        given_up => format!("given up: {given_up}"),
    };
    let budget = format!("{:.0} ms a frame are held by themselves; {given_up}", shown.governor.budget_ms);
    if look::key(ui, "auto quality", ("Quality by itself", &budget), shown.auto).clicked() {
        actions.push(Action::Auto(!shown.auto));
    }
    ui.horizontal(|ui| {
        let half = 0.5 * (ui.available_width() - 8.0);
        let (better, plainer) = (shown.rung.checked_sub(1), shown.rung + 1);
        let mut step = |name: &str, word: &str, rung: Option<usize>| {
            ui.allocate_ui(vec2(half, look::FINGER + 4.0), |ui| {
                if look::key(ui, name, (word, ""), false).clicked()
                    && let Some(rung) = rung
                {
                    actions.push(Action::Rung(rung));
                }
            });
        };
        step("plainer", "−  plainer", (plainer < RUNGS.len()).then_some(plainer));
        step("finer", "+  finer", better);
    });
}

fn facts_of(ui: &mut Ui, shown: &PanelInput<'_>, facts: &Facts<'_>) {
    let gpu = shown.gpu.info();
    let gravity = match facts.down {
        Down::Sensor => "from the accelerometer",
        Down::Scene => "the scene's own",
        Down::Nowhere => "none: the scene is in free space",
    };
    let mut rows = vec![
        ("device", format!("{} ({} tier)", gpu.name, tier_name(shown.gpu.tier()))),
        ("driver", format!("{} {}", gpu.driver, gpu.driver_info)),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("captures", facts.files.to_owned()),
        ("gravity", gravity.to_owned()),
    ];
    if let Some(current) = shown.current {
        rows.extend(current.concessions.iter().map(|concession| ("does without", concession.to_string())));
    }
    for (name, value) in rows {
        ui.label(RichText::new(format!("{name}: {value}")).small().color(style::QUIET));
    }
}
