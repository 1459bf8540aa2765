//! Knobs: what one curve of a work-precision plot turns.

use crate::case::Case;

/// A setting that is turned while everything else stays.
#[derive(Clone, Copy, Debug)]
pub struct Knob {
    /// Its name on the command line and in legends.
    pub name: &'static str,
    /// The setting it turns.
    pub path: &'static str,
    /// What it is turned to.
    pub values: Values,
    /// Which of them are enough for a quick look.
    pub quick: &'static [usize],
}

/// What a knob is turned to.
#[derive(Clone, Copy, Debug)]
pub enum Values {
    /// Multiples of what the case has: of its spacing.
    OfSpacing(&'static [f64]),
    /// Numbers.
    Numbers(&'static [f64]),
    /// Words.
    Words(&'static [&'static str]),
}

/// A knob's position.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// As plots and tables say it.
    pub label: String,
    /// The settings, each `path=value`: the knob's own, and what it needs beside it.
    pub settings: Vec<String>,
}

/// PBF's. Kernel (Wendland C2), integrator (symplectic Euler), one list a substep and the neighbour
/// structure (a sorted grid, wrapped where the domain is large) are the only ones there are.
pub const PBF: &[Knob] = &[
    // A case shortens its step with its spacing. All of them fill the cases' bodies with whole lattices: a
    // column that is a third of a spacing short would show as an error of the solver.
    Knob {
        name: "spacing",
        path: "spacing_m",
        values: Values::OfSpacing(&[2.0, 4.0 / 3.0, 1.0, 2.0 / 3.0, 0.5]),
        quick: &[0, 2],
    },
    Knob {
        name: "substeps",
        path: "solver.substeps",
        values: Values::Numbers(&[1.0, 2.0, 3.0, 4.0, 8.0]),
        quick: &[0, 1, 3],
    },
    Knob {
        name: "iterations",
        path: "solver.pbf.iterations",
        values: Values::Numbers(&[1.0, 2.0, 4.0, 8.0, 16.0]),
        quick: &[1, 2, 3],
    },
    Knob {
        name: "relaxation",
        path: "solver.pbf.relaxation",
        values: Values::Numbers(&[0.2, 0.35, 0.5, 0.65, 0.8]),
        quick: &[1, 2],
    },
    Knob {
        name: "h/d",
        path: "solver.support_ratio",
        values: Values::Numbers(&[1.6, 2.0, 2.5, 3.0, 3.5]),
        quick: &[1, 3],
    },
    Knob { name: "XSPH", path: "forces.xsph", values: Values::Numbers(&[0.0, 0.01, 0.05, 0.2]), quick: &[0, 1] },
    Knob {
        name: "s_corr",
        path: "solver.pbf.s_corr_k",
        values: Values::Numbers(&[0.0, 0.001, 0.01, 0.1]),
        quick: &[0],
    },
    Knob {
        name: "precision",
        path: "solver.precision",
        values: Values::Words(&["full", "relaxed", "half"]),
        quick: &[0, 2],
    },
    Knob { name: "packed", path: "solver.packed_positions", values: Values::Words(&["false", "true"]), quick: &[0, 1] },
    Knob {
        name: "deterministic",
        path: "solver.deterministic",
        values: Values::Words(&["false", "true"]),
        quick: &[0, 1],
    },
];

impl Knob {
    /// Its positions for a case.
    pub fn positions(&self, case: &dyn Case, quick: bool) -> Vec<Position> {
        let at = |label: String, value: String| Position { label, settings: vec![format!("{}={value}", self.path)] };
        let all: Vec<Position> = match self.values {
            Values::OfSpacing(factors) => factors
                .iter()
                .map(|factor| factor * case.spacing_m())
                .map(|spacing_m| at(format!("{:.3} mm", 1e3 * spacing_m), format!("{spacing_m:?}")))
                .collect(),
            Values::Numbers(numbers) => {
                numbers.iter().map(|number| at(number.to_string(), number.to_string())).collect()
            }
            Values::Words(words) => words.iter().map(|word| at((*word).into(), (*word).into())).collect(),
        };
        if quick { self.quick.iter().filter_map(|&i| all.get(i).cloned()).collect() } else { all }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::CASES;

    #[test]
    fn every_number_has_four_positions_and_one_is_the_default() {
        for knob in PBF {
            let numeric = !matches!(knob.values, Values::Words(_));
            let positions = knob.positions(CASES[1], false);
            assert!(!numeric || positions.len() >= 4, "{}", knob.name);
            assert!(knob.quick.iter().all(|&i| i < positions.len()));
            assert_eq!(knob.positions(CASES[1], true).len(), knob.quick.len());
        }
    }
}
