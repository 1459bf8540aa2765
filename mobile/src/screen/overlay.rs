//! What stands over the picture and is read: the scene and its frames, where the time goes, what was said.

use brooklet_viewer::panels::PanelInput;
use brooklet_viewer::{Kind, Message, style};
use egui::{
    Align2, Area, Color32, Context, FontId, Id, Order, Pos2, ProgressBar, Rect, RichText, Sense, Stroke, Ui, pos2, vec2,
};

use super::look;
use crate::report::SCENES;
use crate::self_check::LIMIT;

/// Passes that are listed: those that take most.
const MOST_PASSES: usize = 7;
const WIDTH: f32 = 248.0;

/// Scene and frames at the top; touched, it shows times or hides them.
pub(super) fn head(context: &Context, shown: &PanelInput<'_>, times: &mut bool) {
    let Some(current) = shown.current else { return };
    let area =
        Area::new(Id::unique("head")).fade_in(false).order(Order::Middle).anchor(Align2::LEFT_TOP, vec2(10.0, 10.0));
    area.show(context, |ui| {
        look::glass().show(ui, |ui| {
            let frames = shown.times.frame_ms.quantiles().filter(|ms| ms.p50 > 0.0).map(|ms| 1000.0 / ms.p50);
            let frames = match frames {
                Some(rate) if rate < 9.95 => format!("{rate:.1} frames/s"),
                Some(rate) => format!("{rate:.0} frames/s"),
                None => "…".to_owned(),
            };
            let particles = shown.stats.map_or(current.session.slot_count(), |stats| stats.particles);
            let (rect, response) = ui.allocate_exact_size(vec2(WIDTH - 12.0, look::FINGER), Sense::click());
            brooklet_viewer::marks::mark(&response, "times");
            let painter = ui.painter();
            let name_at = rect.left_top() + vec2(8.0, 15.0);
            painter.text(name_at, Align2::LEFT_CENTER, &current.scene.name, FontId::proportional(16.0), look::TEXT);
            let about = format!("{particles} particles, {frames}");
            let about_at = rect.left_bottom() + vec2(8.0, -13.0);
            painter.text(about_at, Align2::LEFT_CENTER, about, FontId::proportional(13.0), style::QUIET);
            let turned = if *times { "⏶" } else { "⏷" };
            let at = rect.right_center() - vec2(14.0, 0.0);
            painter.text(at, Align2::CENTER_CENTER, turned, FontId::proportional(16.0), style::QUIET);
            if response.clicked() {
                *times = !*times;
            }
        });
    });
}

/// Where the time goes.
pub(super) fn times(context: &Context, screen: Rect, shown: &PanelInput<'_>) {
    let area = Area::new(Id::unique("overlay")).fade_in(false).order(Order::Middle).interactable(false);
    area.fixed_pos(screen.min + vec2(10.0, 74.0)).show(context, |ui| {
        let frame = look::glass().inner_margin(12);
        let shown = frame.show(ui, |ui| {
            ui.set_width(WIDTH - 24.0);
            ui.spacing_mut().item_spacing.y = 3.0;
            let times = shown.times;
            let gpu = times.gpu_ms.quantiles().map_or("no GPU times here".to_owned(), |ms| {
                format!("GPU {:.1} ms, 95 of 100 within {:.1}", ms.p50, ms.p95)
            });
            ui.label(RichText::new(gpu).small());
            chart(ui, &times.gpu_ms, shown.governor.budget_ms);
            let mut passes: Vec<(&str, f64)> =
                times.passes.iter().filter_map(|pass| Some((pass.stage, pass.quantiles?.p50))).collect();
            passes.sort_by(|a, b| b.1.total_cmp(&a.1));
            let most_ms = passes.first().map_or(1.0, |(_, ms)| ms.max(1e-6));
            for (stage, ms) in passes.into_iter().take(MOST_PASSES) {
                bar(ui, stage, ms, ms / most_ms);
            }
            if let Some(error) = times.density_error.last() {
                ui.label(RichText::new(format!("density error {error:.2} %")).small().color(style::QUIET));
            }
            if times.flagged_spans > 0 {
                let text = format!("{} times cannot be right", times.flagged_spans);
                ui.label(RichText::new(text).small().color(style::WARNING));
            }
        });
        brooklet_viewer::marks::mark(&shown.response, "overlay");
    });
}

/// The last frames, with the budget as a line.
fn chart(ui: &mut Ui, history: &brooklet_viewer::History, budget_ms: f64) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 44.0), Sense::hover());
    let points: Vec<[f64; 2]> = history.points().collect();
    let Some([last_s, _]) = points.last().copied() else { return };
    let most_ms = points.iter().map(|[_, ms]| *ms).fold(1.2 * budget_ms, f64::max);
    let first_s = points.first().map_or(last_s, |[s, _]| *s);
    let at = |[s, ms]: [f64; 2]| -> Pos2 {
        let along = if last_s > first_s { (s - first_s) / (last_s - first_s) } else { 1.0 };
        pos2(rect.left() + rect.width() * along as f32, rect.bottom() - rect.height() * (ms / most_ms) as f32)
    };
    let painter = ui.painter();
    let budget_y = at([last_s, budget_ms]).y;
    painter.hline(rect.x_range(), budget_y, Stroke::new(1.0, style::WARNING.gamma_multiply(0.7)));
    painter.line(points.into_iter().map(at).collect(), Stroke::new(1.5, style::ACCENT));
}

fn bar(ui: &mut Ui, stage: &str, ms: f64, share: f64) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 17.0), Sense::hover());
    let painter = ui.painter();
    let filled = Rect::from_min_size(rect.min, vec2(rect.width() * share as f32, rect.height()));
    painter.rect_filled(filled, 3.0, style::ACCENT.gamma_multiply(0.35));
    let text = FontId::proportional(12.0);
    painter.text(rect.left_center() + vec2(4.0, 0.0), Align2::LEFT_CENTER, stage, text.clone(), look::TEXT);
    painter.text(rect.right_center() - vec2(4.0, 0.0), Align2::RIGHT_CENTER, format!("{ms:.2} ms"), text, look::TEXT);
}

/// How far the first self-check is.
pub(super) fn checking(context: &Context, [done, all]: [usize; 2]) {
    let limit_s = LIMIT.as_secs();
    let text = format!("Known answers of every kernel, for {limit_s} s at most: {done} of {all}");
    under_way(context, "checking", "Checking this device", &text, [done, all]);
}

/// How far a report is.
pub(super) fn reporting(context: &Context, progress: [usize; 2]) {
    let text = format!("Times of {}, while the water stands", SCENES.join(" and "));
    under_way(context, "reporting", "Making a report", &text, progress);
}

fn under_way(context: &Context, name: &str, title: &str, text: &str, [done, all]: [usize; 2]) {
    let area = Area::new(Id::unique(name))
        .fade_in(false)
        .order(Order::Foreground)
        .anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0));
    area.show(context, |ui| {
        look::glass().inner_margin(18).show(ui, |ui| {
            ui.set_width(270.0);
            ui.label(RichText::new(title).heading());
            ui.label(RichText::new(text).color(style::QUIET));
            let share = if all > 0 { done as f32 / all as f32 } else { 0.0 };
            let response = ui.add(ProgressBar::new(share).desired_height(8.0));
            brooklet_viewer::marks::mark(&response, name);
        });
    });
}

/// What was said, above the bar.
pub(super) fn messages(context: &Context, screen: Rect, said: &[Message]) {
    if said.is_empty() {
        return;
    }
    let width = (screen.width() - 32.0).min(520.0);
    let area = Area::new(Id::unique("messages")).fade_in(false).order(Order::Foreground).interactable(false);
    area.anchor(Align2::CENTER_BOTTOM, vec2(0.0, -90.0)).show(context, |ui| {
        for message in said {
            let (sign, color) = style::sign_of(message.kind);
            let frame = egui::Frame::new().fill(Color32::from_black_alpha(220)).corner_radius(10).inner_margin(10);
            let shown = frame.show(ui, |ui| {
                ui.set_max_width(width);
                ui.horizontal_top(|ui| {
                    ui.label(RichText::new(sign).color(color));
                    ui.add(egui::Label::new(&message.text).wrap());
                });
            });
            let is_error = message.kind == Kind::Error;
            brooklet_viewer::marks::mark(&shown.response, if is_error { "error" } else { "message" });
        }
    });
}
