//! The solvers that are studied. A new one is a line here; cases, studies and reports do not change.

/// A solver.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name, as scenes have it (`solver.method`).
    pub name: &'static str,
    /// Of one that takes several times as long: the knobs that studies turn which name no solver, at few positions each and
    /// once; a quick look takes the first of them, and no published case. Empty: all of them.
    pub few: &'static [&'static str],
}

/// Every solver.
pub const METHODS: &[Method] = &[
    Method { name: "pbf", few: &[] },
    Method { name: "sph", few: &["stiffness", "spacing", "artificial viscosity", "h/d"] },
    Method { name: "dfsph", few: &["density tolerance", "spacing"] },
];

/// The method of a name.
pub fn method(name: &str) -> Option<&'static Method> {
    METHODS.iter().find(|method| method.name == name)
}

impl Method {
    /// The setting that chooses it.
    pub fn setting(&self) -> String {
        format!("solver.method={}", self.name)
    }

    /// Whether a study that names no solver turns this knob of it.
    pub fn turns(&self, knob: &str, quick: bool) -> bool {
        let few = if quick { &self.few[..self.few.len().min(1)] } else { self.few };
        self.few.is_empty() || few.contains(&knob)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::knob::knobs;

    #[test]
    fn knobs_that_are_few_are_knobs_of_the_solver() {
        for method in METHODS {
            let all: Vec<&str> = knobs(method.name).map(|(_, knob)| knob.name).collect();
            assert!(method.few.iter().all(|few| all.contains(few)), "{}: {all:?}", method.name);
            let turned = |quick| all.iter().filter(|knob| method.turns(knob, quick)).count();
            assert!(turned(true) > 0 && turned(true) <= turned(false), "{}", method.name);
        }
    }
}
