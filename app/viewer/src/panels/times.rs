//! Where the time goes: the frame, each pass; the density error and the energy; and what is not there at all.

use brooklet_fluid::Stats;
use egui::{Color32, Grid, Rect, RichText, ScrollArea, Sense, Stroke, StrokeKind, Ui, vec2};
use egui_plot::{HLine, Line, Plot, PlotPoints};

use super::PanelInput;
use crate::history::History;
use crate::marks::mark;
use crate::style;
use crate::times::PassTimes;

pub(super) fn show(ui: &mut Ui, shown: &PanelInput<'_>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let times = shown.times;
        heading(ui, "GPU", times.gpu_ms.quantiles().map(|ms| format!("{:.1} ms, p95 {:.1}", ms.p50, ms.p95)));
        plot(ui, "gpu plot", &[(&times.gpu_ms, style::ACCENT)], Some(shown.governor.budget_ms));
        bars(ui, &times.passes);
        if times.flagged_spans > 0 {
            let text =
                format!("{} spans cannot be right (zero, negative, overlapping or behind a gap)", times.flagged_spans);
            ui.label(RichText::new(text).small().color(style::WARNING));
        }
        ui.add_space(4.0);
        heading(ui, "Density error", times.density_error.last().map(|error| format!("{error:.2} %")));
        plot(ui, "density plot", &[(&times.density_error, Color32::from_rgb(150, 210, 130))], None);
        ui.add_space(4.0);
        let [kinetic_j, energy_j] = &times.energy_j;
        let now_j = energy_j.last().zip(kinetic_j.last());
        heading(ui, "Energy", now_j.map(|(all, kinetic)| format!("{all:.3} J, {kinetic:.3} kinetic")));
        let lines = [(energy_j, Color32::from_rgb(230, 190, 110)), (kinetic_j, Color32::from_rgb(130, 180, 230))];
        plot(ui, "energy plot", &lines, None);
        ui.add_space(4.0);
        facts(ui, shown);
        left_out(ui, shown);
    });
}

fn heading(ui: &mut Ui, name: &str, value: Option<String>) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).strong());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(value.unwrap_or_default()).color(style::QUIET));
        });
    });
}

fn plot(ui: &mut Ui, name: &str, histories: &[(&History, Color32)], limit: Option<f64>) {
    let plot = Plot::new(name)
        .height(58.0)
        .include_y(0.0)
        .show_axes([false, true])
        .show_grid([false, true])
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .show_x(false);
    let shown = plot.show(ui, |plot| {
        if let Some(limit) = limit {
            plot.hline(HLine::new("budget", limit).color(style::WARNING.gamma_multiply(0.6)).width(1.0));
        }
        for (index, (history, color)) in histories.iter().enumerate() {
            let points: PlotPoints<'_> = history.points().collect();
            plot.line(Line::new(format!("{name} {index}"), points).color(*color).width(1.5));
        }
    });
    mark(&shown.response, name);
}

/// A bar a pass: filled to the median, a tick at the 95th percentile.
fn bars(ui: &mut Ui, passes: &[PassTimes]) {
    let quantiles = || passes.iter().filter_map(|pass| Some((pass.stage, pass.quantiles?)));
    let most = quantiles().map(|(_, quantiles)| quantiles.p95).fold(1e-6, f64::max);
    for (stage, quantiles) in quantiles() {
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 15.0), Sense::hover());
        let bar = Rect::from_min_max(rect.min + vec2(142.0, 2.0), rect.max - vec2(40.0, 2.0));
        let at = |ms: f64| bar.left() + bar.width() * (ms / most) as f32;
        let painter = ui.painter();
        let small = egui::TextStyle::Small.resolve(ui.style());
        let text = ui.visuals().text_color();
        painter.text(rect.left_center(), egui::Align2::LEFT_CENTER, stage, small.clone(), text);
        painter.rect_filled(bar, 2, ui.visuals().extreme_bg_color);
        painter.rect_filled(Rect::from_min_max(bar.min, egui::pos2(at(quantiles.p50), bar.bottom())), 2, style::ACCENT);
        let p95 = at(quantiles.p95).min(bar.right() - 1.0);
        painter.vline(p95, bar.y_range(), Stroke::new(1.5, style::WARNING));
        painter.rect_stroke(bar, 2, Stroke::new(0.5, style::QUIET.gamma_multiply(0.3)), StrokeKind::Outside);
        let ms = if quantiles.p50 < 10.0 { format!("{:.2}", quantiles.p50) } else { format!("{:.1}", quantiles.p50) };
        painter.text(rect.right_center(), egui::Align2::RIGHT_CENTER, ms, small, style::QUIET);
        mark(&response, &format!("pass {stage}"));
        response.on_hover_text(format!("{stage}: p50 {:.3} ms, p95 {:.3} ms a frame", quantiles.p50, quantiles.p95));
    }
}

/// Where some slots are empty, how many hold a particle.
fn particles(slots: u32, stats: Option<&Stats>) -> String {
    match stats.map(|stats| stats.particles) {
        Some(particles) if particles != slots => format!("{particles} in {slots} slots"),
        _ => slots.to_string(),
    }
}

fn facts(ui: &mut Ui, shown: &PanelInput<'_>) {
    let Some(current) = shown.current else { return };
    let megabytes = |bytes: u64| format!("{:.1} MB", bytes as f64 * 1e-6);
    let [width_px, height_px] = current.view().size_px;
    let rows = [
        ("particles", particles(current.session.slot_count(), shown.stats)),
        ("spacing", format!("{:.4} m", current.session.scene().fitted_spacing_m())),
        ("steps", current.session.steps().to_string()),
        ("GPU memory", megabytes(current.session.engine().allocated_bytes())),
        ("picture", format!("{width_px} × {height_px}")),
        ("tier", brooklet_gpu::tier_name(shown.gpu.tier()).to_owned()),
        ("device", shown.gpu.info().name.clone()),
    ];
    Grid::new("facts").num_columns(2).spacing([12.0, 2.0]).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(RichText::new(name).small().color(style::QUIET));
            ui.add(egui::Label::new(RichText::new(value).small()).truncate());
            ui.end_row();
        }
    });
}

fn left_out(ui: &mut Ui, shown: &PanelInput<'_>) {
    let bytes: u64 = shown.left_out.iter().map(|absent| absent.bytes).sum();
    let title = format!("Left out: {} things, {:.1} MB", shown.left_out.len(), bytes as f64 * 1e-6);
    let header = egui::CollapsingHeader::new(title).id_salt("left out").show(ui, |ui| {
        for absent in shown.left_out {
            let text = format!("{} ({})", absent.name, absent.kind);
            ui.label(RichText::new(text).small()).on_hover_text(&absent.reason);
        }
    });
    mark(&header.header_response, "left out");
}
