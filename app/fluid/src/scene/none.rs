//! What particles that do not interact take.

use serde::{Deserialize, Serialize};

/// Settings of `method = "none"`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct NoneSettings {
    /// How long a particle lives, s; 0: for ever.
    pub lifetime_s: f64,
    /// Share of the lifetime by which the shortest lives less; the others lie evenly between.
    pub lifetime_variation: f64,
    /// Drag, 1/s: a particle left alone keeps exp(-drag t) of its velocity.
    pub drag_per_s: f64,
    /// Share of the speed across a wall that a bounce gives back.
    pub restitution: f64,
}

impl Default for NoneSettings {
    fn default() -> Self {
        Self { lifetime_s: 0.0, lifetime_variation: 0.5, drag_per_s: 0.0, restitution: 0.5 }
    }
}
