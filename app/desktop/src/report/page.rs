//! The page: one file that needs no other, with its plots and pictures inside.

use std::path::Path;

use brooklet_study::report::whole_page;
use maud::{Markup, html};

use super::{Part, Report, State, show};

/// What it has beside the study's page, and otherwise.
const STYLE: &str = "
h2 { margin-top: 40px; } h3 { margin: 24px 0 2px; font-size: 16px; } p.what { margin: 4px 0; }
th, td { padding: 3px 10px; } th.number { text-align: right; white-space: nowrap; } p.trouble { color: #be1e2d; } .pill { background: #eceef2; }
.bar { background: #eceef2; width: 220px; height: 12px; display: inline-block; border-radius: 3px; overflow: hidden; }
.bar i { display: block; height: 12px; } .memory { background: #0072b2; } .gathers { background: #56b4e9; }
.arithmetic { background: #d55e00; } .launches { background: #8a909b; }
.pictures { display: flex; flex-wrap: wrap; gap: 14px; } figure { margin: 0; flex: 1 1 340px; } img { width: 100%; border-radius: 6px; }
figcaption { color: #5a606b; font-size: 13px; }
";

/// The page of a report as far as it is; `out` holds the pictures that go into it.
pub fn page(report: &Report, out: &Path) -> String {
    let body = html! {
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
    };
    whole_page(&format!("Brooklet on {}", report.device), STYLE, &body)
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
