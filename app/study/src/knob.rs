//! Knobs: what one curve of a work-precision plot turns. The table of settings says which field of a scene is one,
//! and what it is turned to.

use brooklet_fluid::scene::{FIELDS, Field, Knob, Values};

use crate::case::Case;

/// A knob's position.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// As plots and tables say it.
    pub label: String,
    /// The settings, each `path=value`.
    pub settings: Vec<String>,
}

/// The knobs of a method (`solver.method`), each with the field it turns.
pub fn knobs(method: &str) -> impl Iterator<Item = (&'static Field, Knob)> {
    FIELDS.iter().filter(move |field| field.is_of(method)).filter_map(|field| Some((field, field.knob?)))
}

/// The positions of a field's knob for a case.
pub fn positions(field: &Field, knob: &Knob, case: &dyn Case, quick: bool) -> Vec<Position> {
    let at = |label: String, value: String| {
        let with = knob.with.map(str::to_owned);
        Position { label, settings: with.into_iter().chain([format!("{}={value}", field.path)]).collect() }
    };
    let all: Vec<Position> = match knob.values {
        // The spacing is all that a case has of its own.
        Values::Times(factors) => factors
            .iter()
            .map(|factor| factor * case.spacing_m())
            .map(|spacing_m| at(format!("{:.3} mm", 1e3 * spacing_m), format!("{spacing_m:?}")))
            .collect(),
        Values::To(texts) => texts.iter().map(|text| at((*text).into(), (*text).into())).collect(),
    };
    if quick { knob.quick.iter().filter_map(|&i| all.get(i).cloned()).collect() } else { all }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::CASES;
    use crate::method::METHODS;

    #[test]
    fn a_quick_look_takes_some_of_the_positions() {
        let all: Vec<_> = knobs("pbf").collect();
        let mut names: Vec<&str> =
            METHODS.iter().flat_map(|method| knobs(method.name)).map(|(_, knob)| knob.name).collect();
        names.sort_unstable();
        names.dedup();
        assert!(all.len() > 8 && names.len() <= crate::report::PALETTE.len(), "two knobs of one colour: {names:?}");
        for (field, knob) in all {
            let [whole, quick] = [false, true].map(|quick| positions(field, &knob, CASES[1], quick));
            assert!(quick.len() == knob.quick.len() && quick.iter().all(|at| whole.contains(at)), "{}", knob.name);
        }
        // A method has the knobs of the fields that it has.
        let none: Vec<&str> = knobs("none").map(|(field, _)| field.path).collect();
        assert!(none.contains(&"spacing_m") && none.iter().all(|path| !path.starts_with("solver.pbf.")), "{none:?}");
    }

    #[test]
    fn a_spacing_is_a_multiple_of_the_cases() {
        let (field, knob) = knobs("pbf").find(|(_, knob)| knob.name == "spacing").unwrap();
        let at = positions(field, &knob, CASES[1], true);
        let spacing_m = CASES[1].spacing_m();
        let expected = [2.0, 1.0].map(|factor| vec![format!("spacing_m={:?}", factor * spacing_m)]);
        assert_eq!(at.iter().map(|at| at.settings.clone()).collect::<Vec<_>>(), expected);
    }
}
