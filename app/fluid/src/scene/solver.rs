//! Which solver moves the fluid, and what all of them take.

use serde::{Deserialize, Serialize};

use super::{DfsphSettings, NoneSettings, PbfSettings, SphSettings};

/// Which solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Position Based Fluids (Macklin & Müller 2013).
    #[default]
    Pbf,
    /// Smoothed particle hydrodynamics with an equation of state (Müller, Charypar & Gross 2003).
    Sph,
    /// Divergence-free SPH (Bender & Koschier 2015).
    Dfsph,
    /// None: particles that do not interact, as sparks or dust.
    None,
}

impl Method {
    /// Every method by its name.
    pub const NAMES: &[&str] = &["pbf", "sph", "dfsph", "none"];

    /// Its name in scenes and summaries.
    pub fn name(self) -> &'static str {
        match self {
            Method::Pbf => "pbf",
            Method::Sph => "sph",
            Method::Dfsph => "dfsph",
            Method::None => "none",
        }
    }

    /// Whether particles know their neighbours: what has lists, densities and a surface that they shape.
    pub fn interacts(self) -> bool {
        match self {
            Method::Pbf | Method::Sph | Method::Dfsph => true,
            Method::None => false,
        }
    }

    /// Whether walls count as mirrors of the fluid, and not by their wall-weight function.
    pub fn mirrors_walls(self) -> bool {
        match self {
            Method::Dfsph => true,
            Method::Pbf | Method::Sph | Method::None => false,
        }
    }

    /// Whether compression that a start or a change of settings leaves over is taken out while time stands: where
    /// corrections would make it velocity. An equation of state makes pressure of it, a density solve moves
    /// positions alone.
    pub fn relaxes(self) -> bool {
        match self {
            Method::Pbf => true,
            Method::Sph | Method::Dfsph | Method::None => false,
        }
    }
}

/// How the arithmetic for a pair of particles is rounded, and the positions that it gathers. Measured errors:
/// `app/fluid/PRECISION.md`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Precision {
    /// f32; positions of 21 bits an axis and an f32 lambda, 16 bytes.
    #[default]
    Full,
    /// f16 where the driver chooses to (SPIR-V's RelaxedPrecision), f32 where not; positions packed into 16 bits an
    /// axis with an f16 lambda, 8 bytes.
    Relaxed,
    /// f16, and packed positions: what `relaxed` does at worst. Only on devices of the desktop tier that have f16.
    Half,
}

impl Precision {
    /// Every precision by its name.
    pub const NAMES: &[&str] = &["full", "relaxed", "half"];

    /// Its name in scenes and captures.
    pub fn name(self) -> &'static str {
        match self {
            Precision::Full => "full",
            Precision::Relaxed => "relaxed",
            Precision::Half => "half",
        }
    }

    /// Whether it packs the positions that are gathered.
    pub fn packs_positions(self) -> bool {
        match self {
            Precision::Full => false,
            Precision::Relaxed | Precision::Half => true,
        }
    }
}

/// What every solver takes, and a table for each method of what it alone does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Solver {
    /// Which solver.
    pub method: Method,
    /// Time a step advances, s.
    pub dt_s: f64,
    /// Equal parts a step is advanced in. Each sorts and lists neighbours anew; at the same
    /// total of iterations, substeps buy more accuracy than iterations.
    pub substeps: u32,
    /// Support radius of the kernel over the spacing, h/d. Default: 2, and 2.5 with SPH where bodies move: with 2 its calm
    /// water stays on a lattice, which holds them as a soft solid would.
    pub support_ratio: f64,
    /// No particle goes faster; clamps are counted. Default: 0.6 h a substep; above
    /// about 0.7 h two bodies are inside each other before four iterations can part them.
    pub max_speed_m_s: Option<f64>,
    /// Room for neighbours a particle, rounded up to fours; what does not fit is counted. Default: 1.43 times
    /// what the support holds at rest, 48 at h = 2 d, 164 at h = 3 d, 44 at h = 3 d in two dimensions; 24 at least.
    pub neighbour_slots: Option<u32>,
    /// Sorts the particles of a cell by id, so that runs repeat bit for bit on a device; else they
    /// come in the order that atomics give.
    pub deterministic: bool,
    /// How what is computed for each pair of particles is rounded, and the positions that are gathered for it. Stored
    /// positions, sums and everything outside the pairs stay f32.
    pub precision: Precision,
    /// What Position Based Fluids takes.
    pub pbf: PbfSettings,
    /// What SPH takes.
    pub sph: SphSettings,
    /// What divergence-free SPH takes.
    pub dfsph: DfsphSettings,
    /// What `method = "none"` takes.
    pub none: NoneSettings,
}

impl Solver {
    /// Iterations a substep, of methods that iterate.
    pub fn iterations(&self) -> Option<u32> {
        match self.method {
            Method::Pbf => Some(self.pbf.iterations),
            Method::Sph | Method::Dfsph | Method::None => None,
        }
    }
}

impl Default for Solver {
    fn default() -> Self {
        Self {
            method: Method::Pbf,
            dt_s: 1.0 / 240.0,
            substeps: 1,
            support_ratio: 2.0,
            max_speed_m_s: None,
            neighbour_slots: None,
            deterministic: false,
            precision: Precision::Full,
            pbf: PbfSettings::default(),
            sph: SphSettings::default(),
            dfsph: DfsphSettings::default(),
            none: NoneSettings::default(),
        }
    }
}
