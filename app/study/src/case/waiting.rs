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
    Waiting { name: "spheric-2-h2", needs: "solids: the box in the tank decides what gauge H2 sees" },
    Waiting { name: "spheric-10", needs: "moving walls: a tank that rolls; and a pressure at the wall" },
    Waiting { name: "poiseuille", needs: "walls without slip, and a solver with a viscosity in m²/s" },
    Waiting { name: "couette", needs: "walls without slip that move, and a solver with a viscosity in m²/s" },
    Waiting { name: "taylor-green at Re = 100", needs: "a solver with a viscosity in m²/s" },
    Waiting { name: "standing-wave decay", needs: "a solver with a viscosity in m²/s: PBF's own damping is told" },
    Waiting {
        name: "hydrostatic pressure",
        needs: "a solver with a pressure: PBF has lambdas, held against the column law",
    },
    Waiting { name: "capillary-drop", needs: "surface tension: artificial pressure is none" },
    Waiting { name: "floating-box", needs: "solids" },
];
