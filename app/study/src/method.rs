//! The solvers there are, and the knobs of each. A new solver is a line here; cases, studies and reports
//! do not change.

use crate::knob::{self, Knob};

/// A solver.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name, as scenes have it (`solver.method`).
    pub name: &'static str,
    /// What can be turned of it.
    pub knobs: &'static [Knob],
}

/// Every solver.
pub const METHODS: &[Method] = &[Method { name: "pbf", knobs: knob::PBF }];

/// The method of a name.
pub fn method(name: &str) -> Option<&'static Method> {
    METHODS.iter().find(|method| method.name == name)
}

impl Method {
    /// The setting that chooses it.
    pub fn setting(&self) -> String {
        format!("solver.method={}", self.name)
    }
}
