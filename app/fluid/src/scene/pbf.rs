//! What Position Based Fluids takes (Macklin & Müller 2013, the paper's equations).

use serde::{Deserialize, Serialize};

/// Settings of `method = "pbf"`. A coefficient of 0 leaves its term out: no pass, no buffer, no code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct PbfSettings {
    /// Jacobi iterations a substep.
    pub iterations: u32,
    /// Jacobi under-relaxation ω. Plain Jacobi (1) is unstable at ordinary neighbour counts:
    /// at h = 2d the limit is about 0.7.
    pub relaxation: f64,
    /// Constraint force mixing ε (Macklin & Müller 2013, eq. 11) over the lattice's |∇C|².
    pub cfm: f64,
    /// Artificial pressure k (eq. 13), no unit; 0 leaves it out. Wendland's kernel does not
    /// pair particles, so it is not needed for stability.
    pub s_corr_k: f64,
    /// Distance at which the artificial pressure is k, over h.
    pub s_corr_distance_ratio: f64,
}

impl Default for PbfSettings {
    fn default() -> Self {
        Self { iterations: 4, relaxation: 0.5, cfm: 0.01, s_corr_k: 0.0, s_corr_distance_ratio: 0.2 }
    }
}
