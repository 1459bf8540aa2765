//! What acts on the fluid beside gravity and the solver.

use serde::{Deserialize, Serialize};

/// Forces that any solver's velocities get at a substep's end. A coefficient of 0 leaves its term out: no pass, no
/// buffer, no code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Forces {
    /// Body forces of place and time beside gravity, which add up; none: no pass, no buffer.
    #[serde(rename = "field", skip_serializing_if = "Vec::is_empty")]
    pub fields: Vec<FieldSettings>,
    /// XSPH viscosity c (Macklin & Müller 2013, eq. 17), 0 to 1; 0 leaves it out.
    pub xsph: f64,
    /// Vorticity confinement (Macklin & Müller 2013, eq. 16), m/s; 0 leaves it out.
    pub vorticity_m_s: f64,
}

/// A body force: an acceleration, a swirl around an axis, or both.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct FieldSettings {
    /// Acceleration everywhere alike, m/s².
    pub acceleration_m_s2: [f64; 3],
    /// Around which axis it swirls and how strongly, 1/s²: the acceleration is this × (x - centre_m).
    pub swirl_per_s2: [f64; 3],
    /// A point of the swirl's axis, m.
    pub centre_m: [f64; 3],
    /// How often it swings, Hz, as a cosine from when it begins; 0: steady.
    pub frequency_hz: f64,
    /// From when on it is there, s.
    pub begin_s: f64,
    /// Until when, s. Default: for ever.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_s: Option<f64>,
}

impl Default for Forces {
    fn default() -> Self {
        Self { fields: Vec::new(), xsph: 0.01, vorticity_m_s: 0.0 }
    }
}
