//! Solids that are triangles: what a scene says of them.

use brooklet_shapes::{ReliefKind, Wheel};
use serde::{Deserialize, Serialize};

/// A closed mesh of a file; with a `thickness_m` of its solid a sheet, which may be open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeshShape {
    /// Its path from the scene's folder: .obj, .gltf or .glb.
    pub file: String,
    /// Length of the file's unit, m.
    #[serde(default = "one")]
    pub scale_m: f64,
    /// Between two nodes of its distance field, m. Default: half a spacing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_m: Option<f64>,
}

/// A convex hull: of points, or of the corners of a file's mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HullShape {
    /// The points, m.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points_m: Vec<[f64; 3]>,
    /// In place of points a file's path from the scene's folder: .obj, .gltf or .glb.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Length of the file's unit, m.
    #[serde(default = "one")]
    pub scale_m: f64,
    /// Between two nodes of its distance field, m. Default: half a spacing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_m: Option<f64>,
}

/// A wheel with paddles around z.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct WheelShape {
    /// To the ends of its paddles, m.
    pub radius_m: f64,
    /// Along z, m.
    pub width_m: f64,
    /// How many paddles.
    #[serde(default = "eight")]
    pub paddles: u32,
    /// Of its hub, m. Default: a third of its radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hub_radius_m: Option<f64>,
    /// How thick a paddle is, m. Default: a tenth of its radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub paddle_m: Option<f64>,
    /// Between two nodes of its distance field, m. Default: half a spacing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_m: Option<f64>,
}

impl WheelShape {
    /// What its triangles are made of.
    pub(super) fn wheel(&self) -> Wheel {
        Wheel {
            radius_m: self.radius_m,
            width_m: self.width_m,
            paddles: self.paddles,
            hub_radius_m: self.hub_radius_m.unwrap_or(self.radius_m / 3.0),
            paddle_m: self.paddle_m.unwrap_or(0.1 * self.radius_m),
        }
    }
}

/// Ground around the solid's `centre_m`, which is at its lowest height: of a file, or by a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TerrainShape {
    /// Its sides along x and z, and along y how much higher white is than black, or the highest hill than the lowest dale, m.
    pub size_m: [f64; 3],
    /// A gray PNG of 8 or 16 bits, by its path from the scene's folder: rows along x, from the lowest z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// What it looks like without a file.
    #[serde(default)]
    pub relief: Relief,
    /// Another one, another ground.
    #[serde(default)]
    pub seed: u32,
    /// From hill to hill, or from bend to bend of a valley, m. Default: half of its side along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feature_m: Option<f64>,
    /// Width of a valley's channel, m. Default: a third of its side along z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub channel_m: Option<f64>,
    /// How much higher it is at its lowest x than at its highest besides, m.
    #[serde(default)]
    pub fall_m: f64,
    /// Between two nodes of its distance field, and without a file between two heights, m. Default: a spacing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_m: Option<f64>,
}

/// What ground without a file looks like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Relief {
    /// Hills.
    #[default]
    Hills,
    /// A channel that winds along x, between banks.
    Valley,
}

impl Relief {
    /// Every choice by its name.
    pub const NAMES: &[&str] = &["hills", "valley"];
}

impl From<Relief> for ReliefKind {
    fn from(relief: Relief) -> Self {
        match relief {
            Relief::Hills => Self::Hills,
            Relief::Valley => Self::Valley,
        }
    }
}

fn one() -> f64 {
    1.0
}

fn eight() -> u32 {
    8
}
