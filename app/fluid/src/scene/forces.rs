//! What acts on the fluid beside gravity and the solver.

use serde::{Deserialize, Serialize};

/// Forces that any solver's velocities get at a substep's end. A coefficient of 0 leaves its term out: no pass, no
/// buffer, no code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Forces {
    /// XSPH viscosity c (Macklin & Müller 2013, eq. 17), 0 to 1; 0 leaves it out.
    pub xsph: f64,
    /// Vorticity confinement (Macklin & Müller 2013, eq. 16), m/s; 0 leaves it out.
    pub vorticity_m_s: f64,
}

impl Default for Forces {
    fn default() -> Self {
        Self { xsph: 0.01, vorticity_m_s: 0.0 }
    }
}
