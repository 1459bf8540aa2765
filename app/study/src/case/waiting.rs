//! Published cases that wait for something that is not built yet.

/// A case, and what it waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Waiting {
    /// Its name.
    pub name: &'static str,
    /// What it needs.
    pub needs: &'static str,
}

/// All of them.
pub const WAITING: &[Waiting] = &[
    Waiting { name: "taylor-green at Re = 100", needs: "its case: of the solvers SPH has a viscosity in m²/s" },
    Waiting { name: "standing-wave decay", needs: "its case: of the solvers SPH has a viscosity in m²/s" },
];
