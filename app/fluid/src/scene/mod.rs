//! The scene: what a TOML file says, with defaults for everything optional. SI units throughout,
//! y up. Camera and picture settings live here too and are read by whoever needs them.

mod auto_step;
mod bodies;
mod change;
mod check;
mod dfsph;
mod diffuse;
mod domain;
mod emitter_shapes;
mod emitters;
mod error;
mod explain;
mod faces;
mod field;
mod fields;
mod fill;
mod forces;
mod forms;
mod lattice;
mod load;
mod mesh_shapes;
#[cfg(test)]
mod message_tests;
mod methods;
mod moved;
mod nearest;
mod none;
mod panel;
mod paths;
mod pbf;
mod poses;
mod reactions;
#[cfg(feature = "schema")]
mod schema;
mod settings;
mod shipped;
mod solid_shapes;
mod solids;
mod solver;
mod sph;
mod surface;
mod terms;
#[cfg(test)]
mod tests;
mod update;
mod wall;

pub use bodies::{bodies, body_mass_kg, first_body_states, surface_point_count, surface_points};
pub use change::Change;
pub use dfsph::DfsphSettings;
pub use diffuse::DiffuseSettings;
pub use domain::Domain;
pub use emitter_shapes::{EmitterTables, drains, emitter_states, emitters};
pub use emitters::{DrainSettings, EmitterSettings};
pub use error::SceneError;
pub(crate) use explain::shortened;
pub use faces::{Face, Faces, Slip};
pub use field::{Field, Kind, Knob, Limits, Slider, Term, Values};
pub use fields::FIELDS;
pub(crate) use fill::for_each_point;
pub use fill::{MAX_FLUIDS, MAX_PARTICLES};
pub use forces::{FieldSettings, Forces};
pub use forms::{Form, Triangles, field_nodes};
pub(crate) use lattice::{WHOLE, steps_m};
pub use mesh_shapes::{HullShape, MeshShape, Relief, TerrainShape, WheelShape};
pub use none::NoneSettings;
pub use panel::Setting;
pub use pbf::{Acceleration, PbfSettings};
pub use poses::poses_before;
pub use reactions::{body_count, measured_solids, reaction_count};
#[cfg(feature = "schema")]
pub use schema::schema;
pub use shipped::shipped_scenes;
pub use solid_shapes::{SolidSurface, solids};
pub use solids::{
    BoxShape, HingeSettings, KeyframeSettings, OpenFaces, RoundShape, Shape, SolidLook, SolidSettings, SphereShape,
};
pub use solver::{Method, Precision, Solver};
pub use sph::{Integrator, SmoothingKernel, SphSettings};
pub use surface::{AutoSettings, MeshSettings, PointColor, Smoothing, Surface, SurfaceMethod};
pub use update::Update;
pub use wall::{Wall, WallModel};

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

/// A whole scene. [`Scene::load`] reads one, [`shipped_scenes`] lists those that come along.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Name: the file's, without its ending.
    #[serde(skip)]
    pub name: String,
    /// One line that says what happens.
    #[serde(default)]
    pub summary: String,
    /// Particle spacing d of the initial lattice, m. Where a block reaches from wall to wall, the nearest of which a
    /// whole number fit is taken.
    pub spacing_m: f64,
    /// Acceleration of gravity, m/s².
    #[serde(default = "default_gravity")]
    pub gravity_m_s2: [f64; 3],
    /// Slots for particles, where their number changes while the scene runs; those that it does not begin with wait
    /// for particles that come. Left out: as many as it begins with, and its emitters emit in `outputs.seconds`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub capacity: Option<u32>,
    /// The box that holds the fluid, and what is at its faces.
    pub domain: Domain,
    /// The fluids at the start.
    #[serde(default, rename = "fluid")]
    pub fluids: Vec<Fluid>,
    /// Solids that it flows around; none: no pass, no buffer, no code.
    #[serde(default, rename = "solid", skip_serializing_if = "Vec::is_empty")]
    pub solids: Vec<SolidSettings>,
    /// What fluid comes from while it runs; none: no pass, no buffer.
    #[serde(default, rename = "emitter", skip_serializing_if = "Vec::is_empty")]
    pub emitters: Vec<EmitterSettings>,
    /// What fluid goes to; none: no pass, no buffer.
    #[serde(default, rename = "drain", skip_serializing_if = "Vec::is_empty")]
    pub drains: Vec<DrainSettings>,
    /// Solver settings.
    #[serde(default)]
    pub solver: Solver,
    /// What acts on the fluid beside gravity and the solver.
    #[serde(default)]
    pub forces: Forces,
    /// Spray, foam and bubbles; an empty table has them, without it there is no pass, no buffer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diffuse: Option<DiffuseSettings>,
    /// How the fluid is drawn.
    #[serde(default)]
    pub surface: Surface,
    /// Where the pictures are taken from; framed on the domain when left out.
    #[serde(default)]
    pub camera: Option<Camera>,
    /// What a run writes.
    #[serde(default)]
    pub outputs: Outputs,
}

/// One body of fluid: a block or a sphere, filled with a cubic lattice of particles. In two dimensions
/// a layer of it at the middle of the domain's depth, where the body is cut: a sphere there is a disc.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Fluid {
    /// A box of fluid; exactly one of `block`, `sphere` and `cylinder` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub block: Option<Block>,
    /// A ball of fluid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sphere: Option<Sphere>,
    /// An upright cylinder of fluid, as in a glass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cylinder: Option<Cylinder>,
    /// Velocity at the start, m/s.
    #[serde(default)]
    pub velocity_m_s: [f64; 3],
    /// How much more or less than that a particle may have along each axis, m/s: drawn evenly, the same in every run.
    #[serde(default)]
    pub velocity_spread_m_s: [f64; 3],
    /// Density at rest, kg/m³. It scales energies; all fluids of a scene share one value.
    #[serde(default = "default_rest_density")]
    pub rest_density_kg_m3: f64,
}

/// An axis-aligned box of fluid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Block {
    /// Lowest corner, m.
    pub min_m: [f64; 3],
    /// Highest corner, m.
    pub max_m: [f64; 3],
}

/// A ball of fluid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Its middle, m.
    pub centre_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
}

/// An upright cylinder of fluid; in two dimensions a block as wide as it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Its middle, m.
    pub centre_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
    /// Its length along y, m.
    pub length_m: f64,
}

impl Cylinder {
    /// The box around it, m.
    pub(crate) fn block(&self) -> Block {
        let half_m = [self.radius_m, 0.5 * self.length_m, self.radius_m];
        let at = |side: f64| std::array::from_fn(|axis| self.centre_m[axis] + side * half_m[axis]);
        Block { min_m: at(-1.0), max_m: at(1.0) }
    }
}

/// Where pictures are taken from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// The eye, m.
    pub eye_m: [f64; 3],
    /// What it looks at, m.
    pub target_m: [f64; 3],
    /// Vertical angle of view, degrees.
    #[serde(default = "default_fov")]
    pub fov_deg: f64,
}

/// What a run writes and measures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Outputs {
    /// Simulated time, s.
    pub seconds: f64,
    /// Pictures, spread evenly over the run; 0: none, and nothing that draws is there.
    pub images: u32,
    /// Width of a picture, pixels.
    pub width_px: u32,
    /// Height of a picture, pixels.
    pub height_px: u32,
    /// Steps between two measurements; 0: none, and nothing that measures is there.
    pub measure_every_steps: u32,
}

impl Default for Outputs {
    fn default() -> Self {
        Self { seconds: 2.0, images: 5, width_px: 960, height_px: 540, measure_every_steps: 4 }
    }
}

impl Scene {
    /// The spacing that its particles have, m: `spacing_m`, or the nearest of which a whole number fit where a block
    /// reaches from wall to wall, so that it is at rest there.
    pub fn fitted_spacing_m(&self) -> f64 {
        fill::fitted_spacing_m(self)
    }

    /// How many particles it begins with, without making them.
    pub fn particle_count(&self) -> u64 {
        fill::count(self)
    }

    /// How near a wall a particle's middle may come, m: half a spacing, as the lattice starts. Nearer, the layer there would
    /// make room for more fluid than there is; what comes nearer the walls' density alone did not hold back. Fluid mirrored in
    /// walls holds itself back, and a stop at a half would bear what its lowest layer swings by; so are walls that repel, whose
    /// own stop a half is.
    pub fn wall_offset_m(&self) -> f64 {
        let is_held = self.solver.method.mirrors_walls() || self.repels_at_walls();
        let spacings = if is_held { 0.25 } else { 0.5 };
        spacings * self.fitted_spacing_m()
    }

    /// Length of gravity's acceleration, m/s².
    pub fn gravity_length_m_s2(&self) -> f64 {
        self.gravity_m_s2.iter().map(|g| g * g).sum::<f64>().sqrt()
    }

    /// Support radius h of the kernel, m.
    pub fn support_m(&self) -> f64 {
        self.fitted_spacing_m() * self.solver.support_ratio
    }

    /// Time a substep advances, s.
    pub fn substep_s(&self) -> f64 {
        self.solver.dt_s / f64::from(self.substeps())
    }

    /// Substeps of a step: where the GPU chooses them, as many as it may take.
    pub fn substeps(&self) -> u32 {
        match self.adapts_substeps() {
            true => self.most_substeps() as u32,
            false => self.solver.substeps,
        }
    }

    /// Rounds over the pairs of particles that a step takes: iterations, and one a substep of a solver without any.
    pub fn iterations_a_step(&self) -> u32 {
        self.substeps() * self.solver.iterations().unwrap_or(1)
    }

    /// Whether the GPU chooses how many substeps a step takes.
    pub fn adapts_substeps(&self) -> bool {
        self.solver.method == Method::Sph && self.solver.sph.adaptive_substeps
    }

    /// Whether some substeps keep the lists of one before: SPH's, which are short; not where particles come and go, nor where
    /// spray looks for others in the cells.
    pub fn keeps_lists(&self) -> bool {
        let has_short_ones = self.solver.method == Method::Sph && self.substeps() > 1;
        has_short_ones && self.slot_capacity().is_none() && self.diffuse.is_none()
    }

    /// Speed no particle exceeds, m/s: what the scene says, else 0.6 h a substep; particles that meet nobody have
    /// no limit but that of numbers.
    pub fn max_speed_m_s(&self) -> f64 {
        let default_m_s = match self.solver.method.interacts() {
            true => 0.6 * self.support_m() / self.substep_s(),
            false => 1.0e9,
        };
        self.solver.max_speed_m_s.unwrap_or(default_m_s)
    }

    /// Room for neighbours a particle: what the scene says, else half as many again, nearly, as lattice points
    /// lie within the support: compressed fluid, and fluid that is crowded at an impact, has more.
    pub fn neighbour_slots(&self) -> u32 {
        let ratio = self.solver.support_ratio;
        let within = match self.domain.is_flat() {
            true => PI * ratio.powi(2),
            false => 4.0 / 3.0 * PI * ratio.powi(3),
        };
        self.solver.neighbour_slots.unwrap_or_else(|| ((1.43 * within).ceil() as u32).next_multiple_of(4).max(24))
    }

    /// Density at rest of the scene's fluids, kg/m³.
    pub fn rest_density_kg_m3(&self) -> f64 {
        self.fluids.first().map_or_else(default_rest_density, |fluid| fluid.rest_density_kg_m3)
    }

    /// Mass of a particle, kg: what its lattice cell holds. In two dimensions kg per metre along z, and
    /// so are the energies and momenta made of it.
    pub fn particle_mass_kg(&self) -> f64 {
        self.rest_density_kg_m3() * self.fitted_spacing_m().powi(self.domain.dimensions as i32)
    }

    /// Side of the domain along each axis that is periodic, m; 0 along others. A whole number of
    /// [`Scene::period_unit_m`].
    pub fn period_m(&self) -> [f64; 3] {
        let unit_m = self.period_unit_m();
        let size_m = self.domain.size_m();
        std::array::from_fn(|axis| match self.domain.periodic[axis] {
            true => (size_m[axis] / unit_m).round().max(1.0) * unit_m,
            false => 0.0,
        })
    }

    /// What the side of a periodic axis is a whole number of, m: 4 h, after which quantized positions repeat
    /// (shader: `shared/quantized_position.hlsli`).
    pub fn period_unit_m(&self) -> f64 {
        4.0 * self.support_m()
    }
}

fn default_gravity() -> [f64; 3] {
    [0.0, -9.81, 0.0]
}

fn default_rest_density() -> f64 {
    1000.0
}

fn default_fov() -> f64 {
    40.0
}
