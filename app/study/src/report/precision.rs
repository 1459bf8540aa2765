//! What lower precision and smaller tiers cost: each scene a row, each quantity a column, in the page and as Markdown.

use maud::{Markup, html};

use super::work_precision::class_of;
use crate::precision::{FULL, QUANTITIES, Quantity, SHAKEN, WAYS, tasks};
use crate::{Figure, Outcome, Store, Task, Verdict};

fn found(quick: bool, store: &Store) -> Vec<(Task, &Outcome)> {
    tasks(quick).into_iter().filter_map(|task| Some((task.clone(), store.get(&task)?))).collect()
}

/// What `full` has of a quantity, if it is told.
fn of_full<'a>(outcome: &'a Outcome, quantity: &Quantity) -> Option<&'a Figure> {
    outcome.figure(&quantity.figure_of(FULL))
}

/// How far each way is off it, none of a way that was not run; nothing where the scene has no such quantity.
fn differences<'a>(outcome: &'a Outcome, quantity: &Quantity) -> Option<Vec<Option<&'a Figure>>> {
    outcome.figure(&quantity.figure_of(SHAKEN))?;
    Some(names().map(|name| outcome.figure(&quantity.figure_of(name))).collect())
}

fn falls_short(figure: Option<&Figure>) -> bool {
    figure.is_some_and(|figure| figure.verdict() == Verdict::FallsShort)
}

/// Two digits; of ratios as per cent.
fn number(figure: Option<&Figure>) -> String {
    let scaled = figure.and_then(|figure| Some(figure.value? * if figure.unit.is_empty() { 100.0 } else { 1.0 }));
    scaled.map_or("–".into(), two_digits)
}

fn two_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let decimals = (1.0 - value.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{value:.decimals$}")
}

fn names() -> impl Iterator<Item = &'static str> {
    std::iter::once(SHAKEN).chain(WAYS.map(|way| way.name))
}

fn ways() -> String {
    names().collect::<Vec<_>>().join(" / ")
}

fn header(quantity: &Quantity) -> String {
    let unit = if quantity.unit.is_empty() { "%" } else { quantity.unit };
    format!("{}, {unit}", quantity.name)
}

/// The section.
pub fn section(quick: bool, store: &Store) -> Markup {
    let found = found(quick, store);
    html! {
        h2 id="precision" { "Precision" }
        p { "How far each way to run a scene is off " code { "full" } " on the desktop tier, as " (ways()) ". The first is the largest of three runs of full whose starts were shaken by what a packed position rounds: what the flow itself makes of a rounding. Where full has a value of its own, it stands before the colon." }
        table {
            thead { tr { th { "scene" } th { "particles" } @for quantity in &QUANTITIES { th title=(quantity.why()) { (header(quantity)) } } } }
            tbody {
                @for (task, outcome) in &found {
                    tr class=(class_of(outcome.state)) {
                        td { b { (task.case) } }
                        td.number { (outcome.particles) }
                        @if outcome.figures.is_empty() { td colspan=(QUANTITIES.len()) { (outcome.state.word()) ": " (outcome.reason) } }
                        @else { @for quantity in &QUANTITIES { td.number { (cell(outcome, quantity)) } } }
                    }
                }
            }
        }
    }
}

fn cell(outcome: &Outcome, quantity: &Quantity) -> Markup {
    let Some(differences) = differences(outcome, quantity) else { return html! {} };
    html! {
        @if let Some(full) = of_full(outcome, quantity) { (number(Some(full))) ": " }
        @for (index, figure) in differences.into_iter().enumerate() {
            @if index > 0 { " / " }
            @if falls_short(figure) { span.pill.bad { (number(figure)) } } @else { (number(figure)) }
        }
    }
}

/// The table for a page of somebody's own; what is beyond its limit is bold.
pub fn markdown(quick: bool, store: &Store) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = format!("Off `full`, as {}; before a colon what `full` has.\n\n", ways());
    let names = QUANTITIES.iter().map(header);
    text += &line(["scene".into(), "particles".into()].into_iter().chain(names).collect());
    text += &line(vec!["---".into(); 2 + QUANTITIES.len()]);
    for (task, outcome) in found(quick, store) {
        let mut cells = vec![task.case.clone(), outcome.particles.to_string()];
        if outcome.figures.is_empty() {
            cells.push(format!("{}: {}", outcome.state.word(), outcome.reason));
        }
        cells.extend(QUANTITIES.iter().map(|quantity| {
            let own = of_full(outcome, quantity).map_or(String::new(), |full| format!("{}: ", number(Some(full))));
            let each = |figure| if falls_short(figure) { format!("**{}**", number(figure)) } else { number(figure) };
            let all = differences(outcome, quantity).map(|figures| figures.into_iter().map(each).collect::<Vec<_>>());
            all.map_or(String::new(), |all| own + &all.join(" / "))
        }));
        text += &line(cells);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_two_digits_and_ratios_are_per_cent() {
        let of = |value: f64, unit: &str| number(Some(&Figure::told("", value, unit, "")));
        let shown = [of(0.012_34, ""), of(0.5, "d"), of(0.0, ""), of(f64::NAN, "d"), of(3.0e-6, ""), of(12.0, "")];
        assert_eq!(shown, ["1.2", "0.50", "0", "–", "0.00030", "1200"]);
    }

    #[test]
    fn what_is_beyond_its_limit_is_marked() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Store::open(folder.path(), "test").unwrap();
        let task = tasks(true).remove(0);
        let mut outcome = Outcome::empty(crate::State::Stable, "");
        for quantity in &QUANTITIES {
            for name in names() {
                outcome.figures.push(Figure::judged(&quantity.figure_of(name), 0.002, quantity.unit, 0.01, ""));
            }
        }
        store.put(&task, outcome.clone()).unwrap();
        assert!(markdown(true, &store).contains("0.20 / 0.20 / 0.20 / 0.20") && !markdown(true, &store).contains("**"));
        outcome.figures[1].value = Some(0.02);
        store.put(&task, outcome.clone()).unwrap();
        assert!(markdown(true, &store).contains("0.20 / **2.0** / 0.20 / 0.20"));
        outcome.figures.retain(|figure| !figure.name.starts_with("half"));
        store.put(&task, outcome).unwrap();
        assert!(markdown(true, &store).contains("0.20 / **2.0** / 0.20 / –"));
        assert!(section(true, &store).into_string().contains("pill bad"));
    }
}
