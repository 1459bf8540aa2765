//! How the walls of the domain drag the fluid along them.

use serde::{Deserialize, Serialize};

/// What a wall does to the velocity along it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Slip {
    /// Nothing.
    #[default]
    FreeSlip,
    /// Fluid that touches it has its velocity: viscosity drags what is near.
    NoSlip,
    /// A shear stress of half the density times `friction` times the square of the velocity along it.
    Friction,
}

impl Slip {
    /// Every slip by its name.
    pub const NAMES: &[&str] = &["free-slip", "no-slip", "friction"];
}

/// One wall.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Face {
    /// What the wall does to the velocity along it.
    pub slip: Slip,
    /// Coefficient c_f of the wall's friction: a shear stress of c_f/2 ρ v².
    pub friction: f64,
    /// The wall's own velocity, along it, m/s.
    pub velocity_m_s: [f64; 3],
}

/// The six walls, by the axis that they stand across and the end of it; each may be left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Faces {
    /// The wall at the lowest x.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_min: Option<Face>,
    /// The wall at the highest x.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_max: Option<Face>,
    /// The floor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y_min: Option<Face>,
    /// The lid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y_max: Option<Face>,
    /// The wall at the lowest z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z_min: Option<Face>,
    /// The wall at the highest z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z_max: Option<Face>,
}

/// Their names, in the order of [`Faces::all`].
pub(crate) const FACE_NAMES: [&str; 6] = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"];

impl Faces {
    /// All, lowest end of each axis first; face `f` stands across axis `f / 2`.
    pub fn all(&self) -> [Option<Face>; 6] {
        [self.x_min, self.x_max, self.y_min, self.y_max, self.z_min, self.z_max]
    }

    /// Whether none is named.
    pub fn is_empty(&self) -> bool {
        self.all().iter().all(Option::is_none)
    }
}
