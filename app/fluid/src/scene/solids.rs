//! Solids that the fluid flows around.

use serde::{Deserialize, Serialize};

use super::forms::Form;
use super::mesh_shapes::{HullShape, MeshShape, TerrainShape, WheelShape};
use super::solid_shapes::motion;

/// A solid: a shape, where it stands, and how it moves.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct SolidSettings {
    /// A box; exactly one shape is given.
    #[serde(rename = "box", skip_serializing_if = "Option::is_none")]
    pub cuboid: Option<BoxShape>,
    /// A ball.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sphere: Option<SphereShape>,
    /// A cylinder with round ends, along y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub capsule: Option<RoundShape>,
    /// A cylinder along y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cylinder: Option<RoundShape>,
    /// The triangles of a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshShape>,
    /// The smallest convex solid with some points in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hull: Option<HullShape>,
    /// A wheel with paddles.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<WheelShape>,
    /// Ground: heights, and all that is below.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub terrain: Option<TerrainShape>,
    /// How thick the wall of a hollow one is, m; of a mesh, that it is a sheet. Default: neither.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thickness_m: Option<f64>,
    /// Which faces a hollow one lacks, in its own frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub open: Option<OpenFaces>,
    /// Its middle, m.
    pub centre_m: [f64; 3],
    /// How it is turned: around this axis, by this length in degrees.
    pub turned_deg: [f64; 3],
    /// What it is made of, kg/m³: the fluid moves it, and it the fluid. Default: it moves as it is told.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub density_kg_m3: Option<f64>,
    /// What holds one with a density: it turns around that, and goes nowhere. Default: it is free.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hinge: Option<HingeSettings>,
    /// Its velocity, m/s, without end; of a solid with a density that with which it begins.
    pub velocity_m_s: [f64; 3],
    /// How it turns around its middle, without end: around this axis, degrees a second; of a solid with a density how it begins
    /// to turn around its centre of mass.
    pub spin_deg_s: [f64; 3],
    /// Where it is at times; between two it moves and turns evenly. In place of `centre_m` and `turned_deg`.
    #[serde(rename = "keyframe", skip_serializing_if = "Vec::is_empty")]
    pub keyframes: Vec<KeyframeSettings>,
    /// Whether keyframes begin again after the last.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub repeat: bool,
    /// Whether it is told what the fluid pushes it with; not of one with a density, whose motion tells. A particle near two
    /// solids pushes the nearer.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub measure_force: bool,
    /// Coulomb friction of particles that touch it: share of the push across it that acts along it.
    pub friction: f64,
    /// Share of the speed across it that particles which run into it keep.
    pub restitution: f64,
    /// What it is drawn as.
    pub look: SolidLook,
    /// Its color: red, green and blue as displays take them (sRGB), 0 to 1. Default: of a few by its number; of glass a pale
    /// green.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<[f64; 3]>,
    /// The triangles that it is, where its shape is not one of the plain ones.
    #[serde(skip)]
    pub(crate) form: Form,
}

/// What a solid is drawn as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SolidLook {
    /// Opaque, with a shadow.
    #[default]
    Solid,
    /// Thin and clear, without a shadow: what is in it and behind it is seen.
    Glass,
}

impl SolidLook {
    /// Every choice by its name.
    pub const NAMES: &[&str] = &["solid", "glass"];
}

/// A box.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct BoxShape {
    /// Its sides, m.
    pub size_m: [f64; 3],
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SphereShape {
    /// Its radius, m.
    pub radius_m: f64,
}

/// A cylinder or a capsule.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RoundShape {
    /// Its radius, m.
    pub radius_m: f64,
    /// Its length along y, with a capsule's ends, m.
    pub length_m: f64,
}

/// Faces that a hollow solid lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum OpenFaces {
    /// That at its lowest x.
    XMin,
    /// At its highest x.
    XMax,
    /// Its floor.
    YMin,
    /// Its lid.
    YMax,
    /// That at its lowest z.
    ZMin,
    /// At its highest z.
    ZMax,
    /// Floor and lid: a pipe.
    Ends,
}

impl OpenFaces {
    /// Every choice by its name.
    pub const NAMES: &[&str] = &["x_min", "x_max", "y_min", "y_max", "z_min", "z_max", "ends"];

    /// Whether the face at an end of an axis is open.
    pub fn has(self, axis: usize, highest: bool) -> bool {
        match self {
            Self::Ends => axis == 1,
            face => face as usize == 2 * axis + usize::from(highest),
        }
    }
}

/// A line that a body turns around without friction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HingeSettings {
    /// Along it; of any length.
    pub axis: [f64; 3],
    /// A place on it, m. Default: the solid's middle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_m: Option<[f64; 3]>,
}

/// Where a solid is at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct KeyframeSettings {
    /// When, s.
    pub time_s: f64,
    /// Its middle, m.
    pub centre_m: [f64; 3],
    /// How it is turned: around this axis, by this length in degrees.
    pub turned_deg: [f64; 3],
}

/// The one shape of a solid, with its sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A box with half its sides, m.
    Box([f64; 3]),
    /// A radius, and half of what is straight of its length, m; a ball has none.
    Capsule(f64, f64),
    /// A radius and half a length, m.
    Cylinder(f64, f64),
    /// A mesh, a hull, a wheel or ground.
    Triangles,
}

impl SolidSettings {
    /// Its shape: the first that is given; a check sees to it that there is one.
    pub fn shape(&self) -> Shape {
        if self.has_triangles() {
            return Shape::Triangles;
        }
        match (self.cuboid, self.sphere, self.capsule, self.cylinder) {
            (Some(cuboid), ..) => Shape::Box(cuboid.size_m.map(|side_m| 0.5 * side_m)),
            (_, Some(sphere), ..) => Shape::Capsule(sphere.radius_m, 0.0),
            (_, _, Some(capsule), _) => {
                Shape::Capsule(capsule.radius_m, (0.5 * capsule.length_m - capsule.radius_m).max(0.0))
            }
            (.., Some(cylinder)) => Shape::Cylinder(cylinder.radius_m, 0.5 * cylinder.length_m),
            (None, None, None, None) => Shape::Box([0.0; 3]),
        }
    }

    /// How many shapes are given.
    pub(crate) fn shapes_given(&self) -> usize {
        let plain = [self.cuboid.is_some(), self.sphere.is_some(), self.capsule.is_some(), self.cylinder.is_some()];
        let triangles = [self.mesh.is_some(), self.hull.is_some(), self.wheel.is_some(), self.terrain.is_some()];
        plain.into_iter().chain(triangles).filter(|&given| given).count()
    }

    /// Whether it moves as it is told, whatever is in its way: it does work on the fluid.
    pub fn is_driven(&self) -> bool {
        motion(self).0.len() > 1
    }

    /// Whether it is a mesh, a hull, a wheel or ground.
    pub fn has_triangles(&self) -> bool {
        self.mesh.is_some() || self.hull.is_some() || self.wheel.is_some() || self.terrain.is_some()
    }
}
