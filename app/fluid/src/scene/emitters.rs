//! What fluid comes from while a scene runs, and what it goes to.

use serde::{Deserialize, Serialize};

use super::{Block, KeyframeSettings, Scene, SceneError, SolidSettings, Sphere};

/// A nozzle that fluid flows from, or a body of fluid that comes all at once: a faucet, a fountain, a hose, a fill.
///
/// A nozzle emits a layer of lattice points each time its flow moved a spacing, so that fluid comes at its density at rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct EmitterSettings {
    /// Radius of a round nozzle, m; or `width_m` and `height_m` are given, or a `block` or a `sphere`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_m: Option<f64>,
    /// Width of a rectangular nozzle, m: level, unless it is turned. In two dimensions its one side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub width_m: Option<f64>,
    /// Height of a rectangular nozzle, across its width, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_m: Option<f64>,
    /// A box that is filled once, at `start_s`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block: Option<Block>,
    /// A ball that is filled once.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sphere: Option<Sphere>,
    /// Middle of the nozzle, m.
    pub centre_m: [f64; 3],
    /// Where it flows to, of any length. What fills at once begins with this direction, too.
    pub direction: [f64; 3],
    /// How fast, m/s.
    pub speed_m_s: f64,
    /// The number of the fluid, as the scene's fluids are numbered from 0 on: what it is colored by.
    pub fluid: u32,
    /// From when on it flows, s.
    pub start_s: f64,
    /// Until when, s. Default: for ever.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_s: Option<f64>,
    /// How long a particle lives, s. Default: for ever.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lifetime_s: Option<f64>,
    /// How the nozzle is turned, its direction with it: around this axis, by this length in degrees.
    pub turned_deg: [f64; 3],
    /// The nozzle's own velocity, m/s, without end. What leaves it has that too.
    pub velocity_m_s: [f64; 3],
    /// How it turns around its middle, without end: around this axis, degrees a second.
    pub spin_deg_s: [f64; 3],
    /// Where it is at times; between two it moves and turns evenly. In place of `centre_m` and `turned_deg`.
    #[serde(rename = "keyframe", skip_serializing_if = "Vec::is_empty")]
    pub keyframes: Vec<KeyframeSettings>,
    /// Whether keyframes begin again after the last.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub repeat: bool,
}

impl Default for EmitterSettings {
    fn default() -> Self {
        Self {
            radius_m: None,
            width_m: None,
            height_m: None,
            block: None,
            sphere: None,
            centre_m: [0.0; 3],
            direction: [0.0, -1.0, 0.0],
            speed_m_s: 0.0,
            fluid: 0,
            start_s: 0.0,
            end_s: None,
            lifetime_s: None,
            turned_deg: [0.0; 3],
            velocity_m_s: [0.0; 3],
            spin_deg_s: [0.0; 3],
            keyframes: Vec::new(),
            repeat: false,
        }
    }
}

impl EmitterSettings {
    /// Whether it fills a body at once.
    pub(crate) fn fills(&self) -> bool {
        self.block.is_some() || self.sphere.is_some()
    }

    /// What moves as its nozzle does.
    pub(super) fn frame(&self) -> SolidSettings {
        SolidSettings {
            centre_m: self.centre_m,
            turned_deg: self.turned_deg,
            velocity_m_s: self.velocity_m_s,
            spin_deg_s: self.spin_deg_s,
            keyframes: self.keyframes.clone(),
            repeat: self.repeat,
            ..SolidSettings::default()
        }
    }
}

/// A region whose particles are taken out of the scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct DrainSettings {
    /// A box; exactly one of `block`, `sphere` and `domain_exit` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block: Option<Block>,
    /// A ball.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sphere: Option<Sphere>,
    /// All that is outside the domain.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub domain_exit: bool,
    /// Volume that it takes in a second at most, m³; in two dimensions m². Default: all that enters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub most_m3_s: Option<f64>,
}

impl Scene {
    /// The scene with other emitters, and slots for so many particles.
    ///
    /// # Errors
    /// If one of them is not allowed in it.
    pub fn with_emitters(&self, emitters: Vec<EmitterSettings>, capacity: Option<u32>) -> Result<Scene, SceneError> {
        let scene = Scene { emitters, capacity, ..self.clone() };
        scene.check(&self.name)?;
        Ok(scene)
    }
}
