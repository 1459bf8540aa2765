//! The solvers that are studied. A new one is a line here; cases, studies and reports do not change.

/// A solver.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name, as scenes have it (`solver.method`).
    pub name: &'static str,
    /// Whether studies take it that name none: one that takes several times as long is asked for.
    pub by_default: bool,
}

/// Every solver.
pub const METHODS: &[Method] = &[Method { name: "pbf", by_default: true }, Method { name: "sph", by_default: false }];

/// The method of a name.
pub fn method(name: &str) -> Option<&'static Method> {
    METHODS.iter().find(|method| method.name == name)
}

/// Those that are studied where nobody names any.
pub fn default_methods() -> impl Iterator<Item = &'static Method> {
    METHODS.iter().filter(|method| method.by_default)
}

impl Method {
    /// The setting that chooses it.
    pub fn setting(&self) -> String {
        format!("solver.method={}", self.name)
    }
}
