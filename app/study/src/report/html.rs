//! The page.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::{Facts, deck, precision, stability, validation, work_precision};
use crate::session::StudyError;
use crate::{State, Store, Study, Task};

const STYLE: &str = "
body { font: 15px/1.45 system-ui, sans-serif; color: #282c34; max-width: 1180px; margin: 0 auto; padding: 28px; }
h1 { font-size: 26px; margin: 0 0 4px; } h2 { margin-top: 44px; border-bottom: 2px solid #0072b2; padding-bottom: 4px; }
h3 { margin-top: 30px; } h4 { margin: 22px 0 2px; } p.what, td.why { color: #5a606b; } td.why { font-size: 13px; }
table { border-collapse: collapse; margin: 12px 0; } th, td { text-align: left; padding: 4px 10px; vertical-align: top; }
thead th { border-bottom: 1px solid #c8ccd4; font-size: 13px; } tbody tr { border-bottom: 1px solid #eceef2; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.grey td { color: #8a909b; } tr.red td { background: #fdecee; }
.pill { border-radius: 9px; padding: 1px 9px; font-size: 13px; white-space: nowrap; } .good { background: #dff3ea; } .bad { background: #fbdfe2; }
.cards { display: flex; gap: 14px; flex-wrap: wrap; margin: 18px 0; }
.card { border: 1px solid #dfe2e8; border-radius: 10px; padding: 10px 18px; } .card b { font-size: 24px; display: block; }
.card.alarm { border-color: #be1e2d; color: #be1e2d; }
.plots { display: flex; flex-wrap: wrap; gap: 10px; } svg { max-width: 100%; height: auto; }
details { margin: 6px 0 18px; } summary { cursor: pointer; color: #0072b2; } nav a { margin-right: 16px; color: #0072b2; }
";

/// A page that needs no other file, in the style of the project's; `more_style` is CSS of its own.
pub fn whole_page(title: &str, more_style: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) (PreEscaped(more_style)) }
            }
            body { (body) }
        }
    };
    page.into_string()
}

/// The study's page.
///
/// # Errors
/// If the study names what there is not.
pub fn page(study: &Study, tasks: &[Task], store: &Store, facts: &Facts) -> Result<String, StudyError> {
    let work = match &study.error {
        Some(choice) => work_precision::section(choice, store)?,
        None => html! {},
    };
    let done = tasks.iter().filter(|task| store.get(task).is_some()).count();
    let body = html! {
        h1 { "How much error does a millisecond buy, and where does it break?" }
        p.what { "Brooklet " (facts.program) " on " (facts.devices.join("; ")) ". " (done) " of " (tasks.len()) " runs" @if study.quick { ", a quick look" } "." }
        @for note in &facts.notes { p { b { (note) } } }
        nav {
            @if study.validation { a href="#validation" { "Validation" } }
            @if study.error.is_some() { a href="#error" { "Error against run time" } }
            @if study.precision { a href="#precision" { "Precision" } }
            @if study.stability { a href="#stability" { "Stability" } }
            a href="#method" { "How it was measured" }
        }
        (cards(study, store))
        @if study.validation { (validation::section(study.quick, store)) }
        (work)
        @if study.error.is_some() { (deck::section(study.quick, store)) }
        @if study.precision { (precision::section(study.quick, store)) }
        @if study.stability { (stability::section(study.quick, store)) }
        (method())
    };
    Ok(whole_page("Brooklet: error, validation, stability", "", &body))
}

fn cards(study: &Study, store: &Store) -> Markup {
    let (meet, short) = validation::counts(study.quick, store);
    html! {
        div.cards {
            @if study.validation {
                div.card { b { (meet) } "figures meet their limit" }
                div.card.alarm[short > 0] { b { (short) } "fall short" }
            }
            @if study.stability {
                @for (state, count) in stability::counts(study.quick, store) {
                    div.card.alarm[state == State::Silent] { b { (count) } (state.word()) }
                }
                @if !stability::counts(study.quick, store).iter().any(|(state, _)| *state == State::Silent) {
                    div.card { b { "0" } "SILENT" }
                }
            }
        }
    }
}

fn method() -> Markup {
    html! {
        h2 id="method" { "How it was measured" }
        ul {
            li { "Time: GPU timestamps from a step's first pass to its last, steps after the first ten; the median and the 95th percentile over all repeats, divided by the step's length. Where a device has no timestamps, the host's clock, and the table says so." }
            li { "Errors are of the first run, evaluated on the processor in f64 from its particles, outside the times. Each case's first figure is its error; a length, height or area is always among its figures." }
            li { "Three kinds of reference: a closed form, an experiment, and an f64 run of the twins with half the spacing, a quarter of the substep and six times the iterations, kept by the hash of its content. They are never merged in one number." }
            li { "The density is the program's own: max(density ratio − 1, 0), mean, 99 of 100 particles, largest." }
            li { "Sources: Martin & Moyce 1952 (dam break), Kleefsman et al. 2005 (SPHERIC 2), Monaghan 1994 (elliptical drop), Colagrossi 2005 (square patch), Airy 1845 (standing wave), Taylor & Green 1937, Macklin & Müller 2013 (PBF)." }
        }
    }
}
