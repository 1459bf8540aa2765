//! The page: one file that needs no other, with its plots and pictures inside.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::{Part, Report, State, show};

const STYLE: &str = "
body { font: 15px/1.45 system-ui, sans-serif; color: #282c34; max-width: 1180px; margin: 0 auto; padding: 28px; }
h1 { font-size: 26px; margin: 0 0 4px; } h2 { margin-top: 40px; border-bottom: 2px solid #0072b2; padding-bottom: 4px; }
h3 { margin: 24px 0 2px; font-size: 16px; } p.what { color: #5a606b; margin: 4px 0; }
table { border-collapse: collapse; margin: 12px 0; } th, td { text-align: left; padding: 3px 10px; vertical-align: top; }
thead th { border-bottom: 1px solid #c8ccd4; font-size: 13px; } tbody tr { border-bottom: 1px solid #eceef2; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.red td { background: #fdecee; } p.trouble { color: #be1e2d; }
.pill { border-radius: 9px; padding: 1px 9px; font-size: 13px; white-space: nowrap; background: #eceef2; }
.cards { display: flex; gap: 14px; flex-wrap: wrap; margin: 18px 0; }
.card { border: 1px solid #dfe2e8; border-radius: 10px; padding: 10px 18px; } .card b { font-size: 24px; display: block; }
.card.alarm { border-color: #be1e2d; color: #be1e2d; }
.bar { background: #eceef2; width: 220px; height: 12px; display: inline-block; border-radius: 3px; overflow: hidden; }
.bar i { display: block; height: 12px; } .memory { background: #0072b2; } .gathers { background: #56b4e9; }
.arithmetic { background: #d55e00; } .launches { background: #8a909b; }
.pictures { display: flex; flex-wrap: wrap; gap: 14px; } figure { margin: 0; flex: 1 1 340px; } img { width: 100%; border-radius: 6px; }
figcaption { color: #5a606b; font-size: 13px; } svg { max-width: 100%; height: auto; }
details { margin: 6px 0 18px; } summary { cursor: pointer; color: #0072b2; }
";

/// The page of a report as far as it is; `out` holds the pictures that go into it.
pub fn page(report: &Report, out: &Path) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "Brooklet on " (report.device) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (report.device) }
                p.what {
                    (report.driver) ", used as " (report.tier) ". Brooklet " (report.version) " (" (report.commit) "), "
                    (report.minutes) " minutes."
                }
                @if report.is_processor {
                    p { b { "This driver runs on the processor: its times are the processor's." } }
                }
                (show::cards(report))
                @for part in &report.parts { (section(part, out)) }
            }
        }
    };
    page.into_string()
}

fn section(part: &Part, out: &Path) -> Markup {
    html! {
        h2 id=(part.name) {
            (title(part.name)) " "
            @match part.state {
                State::Waiting => span.pill { "not begun" },
                State::UnderWay => span.pill { "under way when this was written" },
                State::LeftOut => span.pill { "left out" },
                State::Done => span.pill { (format!("{:.0} s", part.seconds)) },
            }
        }
        @for trouble in &part.troubles { p.trouble { (trouble) } }
        (show::body(part, out))
    }
}

fn title(name: &str) -> &'static str {
    match name {
        "device" => "The device",
        "check" => "Known answers",
        "runs" => "Runs",
        "scaling" => "Time of every pass",
        "pictures" => "Pictures",
        "sorting" => "Ways to sort",
        "submissions" => "Submissions and timestamps",
        "errors" => "Error against time",
        _ => "Extreme cases",
    }
}
