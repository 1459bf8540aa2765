//! The solvers that are studied. A new one is a line here; cases, studies and reports do not change.

/// A solver.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name, as scenes have it (`solver.method`).
    pub name: &'static str,
}

/// Every solver.
pub const METHODS: &[Method] = &[Method { name: "pbf" }, Method { name: "sph" }];

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
