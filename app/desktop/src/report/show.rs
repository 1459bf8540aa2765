//! What each part found, as tables, plots and pictures.

use std::{fs, path::Path};

use base64::{Engine, prelude::BASE64_STANDARD};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

use super::{
    Part, Report, State,
    parts::{ERROR_PLOT, SURFACES},
};

/// The page's first figures.
pub fn cards(report: &Report) -> Markup {
    let figures = |name: &str| figures_of(report, name);
    let fastest = fastest(report);
    let check = figures("check").and_then(|figures| figures.get("check"));
    let alike = figures("runs").and_then(|figures| figures.get("deterministic")).map(|found| found["alike"] == true);
    let outcomes = figures("extremes").and_then(|figures| figures.get("extremes")).map(list).unwrap_or_default();
    let silent = outcomes.iter().filter(|outcome| is_silent(outcome)).count();
    html! {
        div.cards {
            @if let Some(check) = check {
                @let (right, all) = (of_verdict(check, "right"), list(&check["modules"]).len());
                div.card.alarm[check["right"] != true] { b { (right) " of " (all) } "kernels right" }
            }
            @if let Some(row) = fastest {
                div.card { b { (short(&row["particle_iterations_per_s"], 1e-6)) " M/s" } "particle iterations, at " (row["particles"]) }
            }
            @if let Some(alike) = alike {
                div.card.alarm[!alike] { b { @if alike { "alike" } @else { "differ" } } "two deterministic runs" }
            }
            @if !outcomes.is_empty() {
                div.card.alarm[silent > 0] { b { (silent) } "SILENT of " (outcomes.len()) " extreme runs" }
            }
        }
    }
}

fn figures_of<'a>(report: &'a Report, name: &str) -> Option<&'a serde_json::Map<String, Value>> {
    report.parts.iter().find(|part| part.name == name).map(|part| &part.figures)
}

/// The row of the scaling table with the most particle iterations a second.
fn fastest(report: &Report) -> Option<&Value> {
    let rate = |row: &&Value| row["particle_iterations_per_s"].as_f64().unwrap_or(0.0);
    let rows = list(&figures_of(report, "scaling")?.get("scaling")?["rows"]);
    rows.iter().max_by(|a, b| rate(a).total_cmp(&rate(b)))
}

/// Of the scaling table, as far as it came.
pub fn most_iterations_per_s(report: &Report) -> Option<f64> {
    fastest(report)?["particle_iterations_per_s"].as_f64()
}

fn of_verdict(check: &Value, verdict: &str) -> usize {
    list(&check["modules"]).iter().filter(|module| module["verdict"] == verdict).count()
}

/// A part's own figures.
pub fn body(part: &Part, out: &Path) -> Markup {
    if part.state != State::Done {
        return html! {};
    }
    let figures = |label: &str| part.figures.get(label).unwrap_or(&Value::Null);
    match part.name {
        "device" => device(figures("doctor"), figures("state")),
        "check" => check(figures("check")),
        "runs" => runs(figures("run"), figures("deterministic")),
        "scaling" => scaling(figures("scaling"), out),
        "pictures" => html! {
            div.pictures { @for method in SURFACES { (picture(method, &out.join("pictures").join(method))) } }
            @for method in SURFACES { (picture_passes(method, figures(method))) }
        },
        "sorting" => sorting(figures("sorting")),
        "submissions" => submissions(figures("submissions")),
        "errors" => html! { @if let Ok(svg) = fs::read_to_string(out.join(ERROR_PLOT)) { (PreEscaped(svg)) } },
        _ => extremes(figures("extremes")),
    }
}

fn device(doctor: &Value, state: &Value) -> Markup {
    html! {
        @for found in list(doctor) {
            h3 { (text(&found["name"])) }
            p.what { (text(&found["driver"])) " " (text(&found["driver_info"])) ", " (text(&found["device_type"])) ", tier " (text(&found["tier"])) }
            @for missing in list(&found["missing"]) { p { "missing: " (text(&missing["what"])) ": " (text(&missing["cost"])) } }
            details {
                summary { "limits" }
                table { tbody { @for (name, value) in pairs(&found["limits"]) { tr { td { (name) } td.number { (value) } } } } }
            }
        }
        @let told: Vec<_> = pairs(state).into_iter().filter(|(name, value)| *name != "wall_s" && !value.is_null()).collect();
        @if !told.is_empty() {
            p.what { "Heat, clocks and power as this began: " @for (name, value) in &told { (name) " " (value) "; " } }
        }
    }
}

fn check(check: &Value) -> Markup {
    let wrong = |value: &&Value| value["verdict"] == "wrong";
    html! {
        @if !check.is_null() {
            p { (of_verdict(check, "right")) " of " (list(&check["modules"]).len()) " kernels and variants give their known answers, "
                (list(&check["cases"]).len()) " cases in " (short(&check["wall_s"], 1.0)) " s"
                @if check["small_inputs"] == true { ", on small inputs" } "." }
            @for case in list(&check["cases"]).iter().filter(wrong) {
                @let found = &case["wrong"];
                p.trouble {
                    (text(&case["room"])) ": " (text(&case["case"])) ": " (text(&found["of"])) ", " (found["modules"]) ", element "
                    (found["element"]) ": got " (found["got"]) ", expected " (found["expected"])
                }
            }
            details {
                summary { "every kernel" }
                table {
                    thead { tr { th { "kernel and variant" } th { "verdict" } th.number { "cases" } th.number { "compared" } } }
                    tbody { @for module in list(&check["modules"]) {
                        tr.red[wrong(&module)] { td { (text(&module["module"])) } td { (text(&module["verdict"])) } td.number { (module["cases"]) } td.number { (module["compared"]) } }
                    } }
                }
            }
        }
    }
}

fn runs(run: &Value, alike: &Value) -> Markup {
    html! {
        @if !run.is_null() {
            p { (run["steps"]) " steps of " (text(&run["scene"])) ", " (run["particles"]) " particles: " (short(&run["gpu_ms_per_step"]["median"], 1.0)) " ms a step (95 of 100: " (short(&run["gpu_ms_per_step"]["p95"], 1.0)) "). Its capture is run/capture.mcap." }
        }
        @if !alike.is_null() {
            p { "Two deterministic runs of " (alike["steps"]) " steps end " @if alike["alike"] == true { "alike" } @else { b { "differently" } } ", " (alike["bytes"]) " bytes." }
        }
    }
}

fn scaling(table: &Value, out: &Path) -> Markup {
    let rows = list(&table["rows"]);
    let first = rows.first().map(|row| text(&row["terms"]));
    let of_first: Vec<&Value> =
        rows.iter().filter(|row| Some(text(&row["terms"])) == first && row["iterations"] == 4).collect();
    let rates = &table["rates"];
    html! {
        @if let Ok(svg) = fs::read_to_string(out.join("scaling.svg")) { (PreEscaped(svg)) }
        @if !rates.is_null() {
            p.what {
                "The device's own rates: a copy of " (short(&rates["copy_bytes_per_s"], 1e-9)) " GB/s, "
                (short(&rates["gathers_per_s"], 1e-9)) " G elements of 8 bytes gathered a second, "
                (short(&rates["multiply_adds_per_s"], 1e-9)) " G multiplications with an addition, "
                (short(&rates["launch_s"], 1e6)) " µs for a dispatch behind another."
            }
        }
        table {
            thead { tr { th.number { "particles" } th { "terms" } th.number { "iterations" } th.number { "ms a step" } th.number { "95 of 100" } th.number { "M/s" } th.number { "G pairs/s" } th.number { "neighbours" } th.number { "B a particle" } } }
            tbody {
                @for row in rows {
                    tr {
                        td.number { (row["particles"]) } td { (text(&row["terms"])) } td.number { (row["iterations"]) }
                        td.number { (short(&row["step_ms"]["median"], 1.0)) } td.number { (short(&row["step_ms"]["p95"], 1.0)) }
                        td.number { (short(&row["particle_iterations_per_s"], 1e-6)) } td.number { (pairs_per_s(row)) }
                        td.number { (short(&row["neighbours_mean"], 1.0)) } td.number { (short(&row["bytes_per_particle"], 1.0)) }
                    }
                }
            }
        }
        p.what { "M/s: million particle iterations a second. G pairs/s: of lambda and correction alone, neighbours as counted in the lists." }
        @for row in of_first.first().into_iter().chain(of_first.get(1..).and_then(|rest| rest.last())) { (bounds(row)) }
        @for (reason, sizes) in by_reason(list(&table["left_out"])) { p { "Left out: " (sizes) " particles: " (reason) } }
    }
}

/// Each reason with the sizes that it left out.
fn by_reason(left_out: &[Value]) -> Vec<(&str, String)> {
    let mut reasons: Vec<(&str, String)> = Vec::new();
    for one in left_out {
        let (reason, size) = (text(&one["reason"]), one["particles"].to_string());
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, sizes)) => *sizes = format!("{sizes}, {size}"),
            None => reasons.push((reason, size)),
        }
    }
    reasons
}

/// Neighbour pairs that the iterations' passes look at in a second, 1e9.
fn pairs_per_s(row: &Value) -> String {
    let number = |value: &Value| value.as_f64().unwrap_or(0.0);
    let ms: f64 =
        ["constrain_density", "correct_positions"].iter().map(|pass| number(&row["passes"][pass]["median_ms"])).sum();
    let pairs = 2.0 * number(&row["iterations"]) * number(&row["particles"]) * number(&row["neighbours_mean"]);
    if ms > 0.0 { format!("{:.2}", pairs / (ms * 1e-3) * 1e-9) } else { "–".into() }
}

fn bounds(row: &Value) -> Markup {
    html! {
        h3 { "What bounds the passes at " (row["particles"]) " particles" }
        table {
            thead { tr { th { "pass" } th.number { "ms" } th.number { "GB/s" } th { "nearest bound" } th { "how near" } th {} } }
            tbody {
                @for (stage, pass) in pairs(&row["passes"]) {
                    @let share = 100.0 * pass["share_of_bound"].as_f64().unwrap_or(0.0);
                    tr {
                        td { (stage) } td.number { (short(&pass["median_ms"], 1.0)) } td.number { (short(&pass["gb_per_s"], 1.0)) }
                        td { (text(&pass["nearest"])) }
                        td { span.bar { i class=(text(&pass["nearest"])) style=(format!("width:{:.0}%", share.min(100.0))) {} } }
                        td.number { (format!("{share:.0} %")) }
                    }
                }
            }
        }
        p.what { "100 % is as fast as the device can; above, a pass finds in caches what counts as memory's." }
    }
}

/// A picture inside the page.
fn picture(method: &str, folder: &Path) -> Markup {
    let pictures = fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
    let last = pictures.filter(|path| path.extension().is_some_and(|extension| extension == "png")).max();
    html! {
        @if let Some(Ok(bytes)) = last.map(fs::read) {
            figure {
                img alt=(method) src=(format!("data:image/png;base64,{}", BASE64_STANDARD.encode(bytes)));
                figcaption { "dam-break, " (method) }
            }
        }
    }
}

fn picture_passes(method: &str, cost: &Value) -> Markup {
    let picture = &cost["picture"];
    html! {
        @if !picture.is_null() {
            h3 { (method) ": " (short(&picture["picture_ms"]["median"], 1.0)) " ms at " (picture["size_px"][0]) " x " (picture["size_px"][1]) }
            table {
                thead { tr { th { "pass" } th.number { "ms" } th.number { "share" } } }
                tbody { @for (stage, pass) in pairs(&picture["passes"]) {
                    tr { td { (stage) } td.number { (short(&pass["median_ms"], 1.0)) } td.number { (short(&pass["share"], 100.0)) " %" } }
                } }
            }
        }
    }
}

fn sorting(sorting: &Value) -> Markup {
    html! {
        @if !sorting.is_null() {
            p.what { "At " (sorting["particles"]) " particles; b/a above 1: the product's way (a) is the faster one. In brackets what 10 and 90 of 100 pairs stay below." }
            table {
                thead { tr { th { "optimisation" } th { "case" } th { "a" } th { "b" } th.number { "b/a" } } }
                tbody { @for one in list(&sorting["comparisons"]) {
                    tr {
                        td { (text(&one["optimisation"])) } td { (text(&one["case"])) } td { (text(&one["baseline"])) } td { (text(&one["alternative"])) }
                        td.number { (short(&one["ratio"], 1.0)) " (" (short(&one["ratio_p10"], 1.0)) "–" (short(&one["ratio_p90"], 1.0)) ")" }
                    }
                } }
            }
        }
    }
}

fn submissions(found: &Value) -> Markup {
    html! {
        @if !found.is_null() {
            p.what { (text(&found["scene"])) ", " (found["particles"]) " particles, by the host's clock; over the first way of the same round." }
            table {
                thead { tr { th.number { "steps a submission" } th { "timestamps" } th.number { "ms a step" } th.number { "ratio" } } }
                tbody { @for way in list(&found["ways"]) {
                    tr {
                        td.number { (way["steps_a_submission"]) } td { @if way["timestamps"] == true { "yes" } @else { "no" } }
                        td.number { (short(&way["wall_ms"], 1.0)) }
                        td.number { (short(&way["ratio"][0], 1.0)) " (" (short(&way["ratio"][1], 1.0)) "–" (short(&way["ratio"][2], 1.0)) ")" }
                    }
                } }
            }
        }
    }
}

fn extremes(outcomes: &Value) -> Markup {
    html! {
        table {
            thead { tr { th { "case" } th { "tier" } th { "outcome" } th { "why" } } }
            tbody { @for outcome in list(outcomes) {
                tr.red[is_silent(outcome)] { td { (text(&outcome["case"])) } td { (text(&outcome["tier"])) } td { (text(&outcome["state"])) } td { (text(&outcome["reason"])) } }
            } }
        }
    }
}

fn is_silent(outcome: &Value) -> bool {
    outcome["state"].as_str().is_some_and(|state| state.eq_ignore_ascii_case("silent"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn pairs(value: &Value) -> Vec<(&String, &Value)> {
    value.as_object().into_iter().flatten().collect()
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or("–")
}

/// Three digits of a number times `scale`.
fn short(value: &Value, scale: f64) -> String {
    let Some(value) = value.as_f64().map(|value| value * scale) else { return "–".into() };
    match value.abs() {
        v if v >= 100.0 => format!("{value:.0}"),
        v if v >= 10.0 => format!("{value:.1}"),
        v if v >= 0.01 || v == 0.0 => format!("{value:.2}"),
        _ => format!("{value:.1e}"),
    }
}
