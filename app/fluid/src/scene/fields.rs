//! The only list of settings: every field of a scene file, with what it takes and within which limits, the methods
//! that have it, what a running scene needs to take another value, how far a slider goes, which value leaves a term
//! out, and what a study turns it through. The checks and their messages, the editors' schema, the window's sliders, the
//! reasons of `brooklet plan` and the study's knobs are made from it.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::faces::Slip;
use super::field::{Field, Kind, Limits};
use super::mesh_shapes::Relief;
use super::pbf::Acceleration;
use super::solids::{OpenFaces, SolidLook};
use super::solver::{Method, Precision};
use super::sph::{Integrator, SmoothingKernel};
use super::update::{Update, UpdateRule};
use super::wall::WallModel;

const fn within(least: f64, most: f64, unit: &'static str) -> Limits {
    Limits { least, most, unit }
}

const fn number(least: f64, most: f64, unit: &'static str) -> Kind {
    Kind::Number(within(least, most, unit))
}

const fn whole(least: f64, most: f64, unit: &'static str) -> Kind {
    Kind::Whole(within(least, most, unit))
}

/// Far enough for any scene, near enough that f64 still tells micrometres apart there.
const PLACE: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "m"));
const TURN: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "degrees"));
const SPEED: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "m/s"));

const LIVE: UpdateRule = UpdateRule::Always(Update::Live);
const TERM: UpdateRule = UpdateRule::Term;
const REBUILD: UpdateRule = UpdateRule::Always(Update::Rebuild);
const RESET: UpdateRule = UpdateRule::Always(Update::Reset);

const PBF: &[&str] = &["pbf"];
const SPH: &[&str] = &["sph"];
const DFSPH: &[&str] = &["dfsph"];
const NONE: &[&str] = &["none"];
/// Methods whose particles know their neighbours.
const WITH_NEIGHBOURS: &[&str] = &["pbf", "sph", "dfsph"];
/// Those whose walls need not answer to pressure. A solve that ends where nothing is compressed has to know its walls: with
/// penalties or deflections in their place DFSPH's pool of ten layers lost 18 and 47 % of its height.
const WITH_WALL_MODELS: &[&str] = &["pbf", "sph"];
/// Those whose velocities get forces of their own in a substep.
const WITH_FORCES: &[&str] = &["pbf", "dfsph"];

const fn face(path: &'static str) -> Field {
    Field::new(path, Kind::Table, REBUILD).of(WITH_NEIGHBOURS)
}

const fn slip(path: &'static str) -> Field {
    Field::new(path, Kind::Choice(Slip::NAMES), REBUILD).of(WITH_NEIGHBOURS)
}

const fn friction(path: &'static str) -> Field {
    Field::new(path, number(0.0, 10.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 0.05)
}

const fn face_speed(path: &'static str) -> Field {
    Field::new(path, SPEED, REBUILD).of(WITH_NEIGHBOURS)
}

/// What terms of water as a surface need, those of one that is smoothed, and those of one that is meshed.
const WATER: (&str, &[&str]) = ("surface.method", &["screen-space", "marching-cubes", "auto"]);
const SMOOTHED: (&str, &[&str]) = ("surface.method", &["screen-space", "auto"]);
const MESHED: (&str, &[&str]) = ("surface.method", &["marching-cubes", "auto"]);

/// Every field, in the order of scene files.
///
/// The widest limits keep what the GPU derives (squares, inverses, sums) inside f32's range. A case of a study
/// shortens its step with its spacing, and all spacings of the knob fill the cases' bodies with whole lattices: a
/// column that is a third of a spacing short would show as an error of the solver.
pub const FIELDS: &[Field] = &[
    Field::new("summary", Kind::Text, LIVE),
    Field::new("spacing_m", number(1.0e-6, 1.0e3, "m"), RESET).knob_times(
        "spacing",
        &[2.0, 4.0 / 3.0, 1.0, 2.0 / 3.0, 0.5],
        &[0, 2],
    ),
    Field::new("gravity_m_s2", Kind::Vector(within(-1.0e6, 1.0e6, "m/s²")), LIVE),
    Field::new("capacity", whole(1.0, 16_777_216.0, ""), RESET),
    Field::new("domain", Kind::Table, RESET),
    Field::new("domain.min_m", PLACE, RESET),
    Field::new("domain.max_m", PLACE, RESET),
    Field::new("domain.walls", Kind::Switch, REBUILD).term("false", "true"),
    Field::new("domain.periodic", Kind::Switches, RESET).term("[false, false, false]", "[true, false, false]"),
    Field::new("domain.dimensions", whole(2.0, 3.0, ""), RESET).slider(2.0, 3.0),
    Field::new("domain.faces", Kind::Table, REBUILD).of(WITH_NEIGHBOURS),
    face("domain.faces.x_min"),
    slip("domain.faces.x_min.slip"),
    friction("domain.faces.x_min.friction"),
    face_speed("domain.faces.x_min.velocity_m_s"),
    face("domain.faces.x_max"),
    slip("domain.faces.x_max.slip"),
    friction("domain.faces.x_max.friction"),
    face_speed("domain.faces.x_max.velocity_m_s"),
    face("domain.faces.y_min"),
    slip("domain.faces.y_min.slip"),
    friction("domain.faces.y_min.friction"),
    face_speed("domain.faces.y_min.velocity_m_s"),
    face("domain.faces.y_max"),
    slip("domain.faces.y_max.slip"),
    friction("domain.faces.y_max.friction"),
    face_speed("domain.faces.y_max.velocity_m_s"),
    face("domain.faces.z_min"),
    slip("domain.faces.z_min.slip"),
    friction("domain.faces.z_min.friction"),
    face_speed("domain.faces.z_min.velocity_m_s"),
    face("domain.faces.z_max"),
    slip("domain.faces.z_max.slip"),
    friction("domain.faces.z_max.friction"),
    face_speed("domain.faces.z_max.velocity_m_s"),
    Field::new("domain.wall", Kind::Table, REBUILD).of(WITH_WALL_MODELS),
    Field::new("domain.wall.model", Kind::Choice(WallModel::NAMES), REBUILD).of(WITH_WALL_MODELS),
    Field::new("domain.wall.stiffness_per_s2", number(1.0e-9, 1.0e18, "1/s²"), REBUILD)
        .of(WITH_WALL_MODELS)
        .logarithmic(1.0e3, 1.0e9),
    Field::new("domain.wall.damping_per_s", number(0.0, 1.0e12, "1/s"), REBUILD)
        .of(WITH_WALL_MODELS)
        .logarithmic(1.0, 1.0e5),
    Field::new("domain.wall.restitution", number(0.0, 1.0, ""), REBUILD).of(WITH_WALL_MODELS).slider(0.0, 1.0),
    Field::new("fluid", Kind::Tables, RESET),
    Field::new("fluid.*", Kind::Table, RESET),
    Field::new("fluid.*.block", Kind::Table, RESET),
    Field::new("fluid.*.block.min_m", PLACE, RESET),
    Field::new("fluid.*.block.max_m", PLACE, RESET),
    Field::new("fluid.*.sphere", Kind::Table, RESET),
    Field::new("fluid.*.sphere.centre_m", PLACE, RESET),
    Field::new("fluid.*.sphere.radius_m", number(1.0e-6, 1.0e6, "m"), RESET),
    Field::new("fluid.*.cylinder", Kind::Table, RESET),
    Field::new("fluid.*.cylinder.centre_m", PLACE, RESET),
    Field::new("fluid.*.cylinder.radius_m", number(1.0e-6, 1.0e6, "m"), RESET),
    Field::new("fluid.*.cylinder.length_m", number(1.0e-6, 1.0e6, "m"), RESET),
    Field::new("fluid.*.velocity_m_s", SPEED, RESET),
    Field::new("fluid.*.velocity_spread_m_s", Kind::Vector(within(0.0, 1.0e6, "m/s")), RESET),
    Field::new("fluid.*.rest_density_kg_m3", number(1.0e-6, 1.0e6, "kg/m³"), LIVE),
    Field::new("solid", Kind::Tables, REBUILD),
    Field::new("solid.*", Kind::Table, REBUILD),
    Field::new("solid.*.box", Kind::Table, REBUILD),
    Field::new("solid.*.box.size_m", Kind::Vector(within(1.0e-6, 1.0e6, "m")), REBUILD),
    Field::new("solid.*.sphere", Kind::Table, REBUILD),
    Field::new("solid.*.sphere.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.capsule", Kind::Table, REBUILD),
    Field::new("solid.*.capsule.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.capsule.length_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.cylinder", Kind::Table, REBUILD),
    Field::new("solid.*.cylinder.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.cylinder.length_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.mesh", Kind::Table, REBUILD),
    Field::new("solid.*.mesh.file", Kind::Text, REBUILD),
    Field::new("solid.*.mesh.scale_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.mesh.cell_m", number(1.0e-6, 1.0e3, "m"), REBUILD),
    Field::new("solid.*.hull", Kind::Table, REBUILD),
    Field::new("solid.*.hull.points_m", Kind::Vectors(within(-1.0e6, 1.0e6, "m")), REBUILD),
    Field::new("solid.*.hull.file", Kind::Text, REBUILD),
    Field::new("solid.*.hull.scale_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.hull.cell_m", number(1.0e-6, 1.0e3, "m"), REBUILD),
    Field::new("solid.*.wheel", Kind::Table, REBUILD),
    Field::new("solid.*.wheel.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.wheel.width_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.wheel.paddles", whole(2.0, 64.0, ""), REBUILD),
    Field::new("solid.*.wheel.hub_radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.wheel.paddle_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.wheel.cell_m", number(1.0e-6, 1.0e3, "m"), REBUILD),
    Field::new("solid.*.terrain", Kind::Table, REBUILD),
    Field::new("solid.*.terrain.size_m", Kind::Vector(within(1.0e-6, 1.0e6, "m")), REBUILD),
    Field::new("solid.*.terrain.file", Kind::Text, REBUILD),
    Field::new("solid.*.terrain.relief", Kind::Choice(Relief::NAMES), REBUILD),
    Field::new("solid.*.terrain.seed", whole(0.0, 4_294_967_295.0, ""), REBUILD),
    Field::new("solid.*.terrain.feature_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.terrain.channel_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.terrain.fall_m", number(0.0, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.terrain.cell_m", number(1.0e-6, 1.0e3, "m"), REBUILD),
    Field::new("solid.*.thickness_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("solid.*.open", Kind::Choice(OpenFaces::NAMES), REBUILD),
    Field::new("solid.*.centre_m", PLACE, REBUILD),
    Field::new("solid.*.density_kg_m3", number(1.0e-3, 1.0e5, "kg/m³"), REBUILD).slider(100.0, 3000.0),
    Field::new("solid.*.hinge", Kind::Table, REBUILD),
    Field::new("solid.*.hinge.axis", Kind::Vector(within(-1.0e6, 1.0e6, "")), REBUILD),
    Field::new("solid.*.hinge.at_m", PLACE, REBUILD),
    Field::new("solid.*.turned_deg", TURN, REBUILD),
    Field::new("solid.*.velocity_m_s", SPEED, REBUILD),
    Field::new("solid.*.spin_deg_s", Kind::Vector(within(-1.0e6, 1.0e6, "degrees/s")), REBUILD),
    Field::new("solid.*.keyframe", Kind::Tables, REBUILD),
    Field::new("solid.*.keyframe.*", Kind::Table, REBUILD),
    Field::new("solid.*.keyframe.*.time_s", number(0.0, 1.0e6, "s"), REBUILD),
    Field::new("solid.*.keyframe.*.centre_m", PLACE, REBUILD),
    Field::new("solid.*.keyframe.*.turned_deg", TURN, REBUILD),
    Field::new("solid.*.repeat", Kind::Switch, REBUILD),
    Field::new("solid.*.measure_force", Kind::Switch, REBUILD),
    Field::new("solid.*.friction", number(0.0, 10.0, ""), REBUILD).slider(0.0, 1.0),
    Field::new("solid.*.restitution", number(0.0, 1.0, ""), REBUILD).slider(0.0, 1.0),
    Field::new("solid.*.look", Kind::Choice(SolidLook::NAMES), REBUILD),
    Field::new("solid.*.color", Kind::Vector(within(0.0, 1.0, "")), REBUILD),
    Field::new("emitter", Kind::Tables, REBUILD),
    Field::new("emitter.*", Kind::Table, REBUILD),
    Field::new("emitter.*.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("emitter.*.width_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("emitter.*.height_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("emitter.*.block", Kind::Table, REBUILD),
    Field::new("emitter.*.block.min_m", PLACE, REBUILD),
    Field::new("emitter.*.block.max_m", PLACE, REBUILD),
    Field::new("emitter.*.sphere", Kind::Table, REBUILD),
    Field::new("emitter.*.sphere.centre_m", PLACE, REBUILD),
    Field::new("emitter.*.sphere.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("emitter.*.centre_m", PLACE, REBUILD),
    Field::new("emitter.*.direction", Kind::Vector(within(-1.0e6, 1.0e6, "")), REBUILD),
    Field::new("emitter.*.speed_m_s", number(0.0, 1.0e6, "m/s"), REBUILD).slider(0.0, 5.0),
    Field::new("emitter.*.fluid", whole(0.0, 126.0, ""), REBUILD),
    Field::new("emitter.*.start_s", number(0.0, 1.0e6, "s"), REBUILD).slider(0.0, 10.0),
    Field::new("emitter.*.end_s", number(0.0, 1.0e6, "s"), REBUILD).slider(0.0, 10.0),
    Field::new("emitter.*.lifetime_s", number(1.0e-6, 1.0e6, "s"), REBUILD).logarithmic(0.1, 10.0),
    Field::new("emitter.*.turned_deg", TURN, REBUILD),
    Field::new("emitter.*.velocity_m_s", SPEED, REBUILD),
    Field::new("emitter.*.spin_deg_s", Kind::Vector(within(-1.0e6, 1.0e6, "degrees/s")), REBUILD),
    Field::new("emitter.*.keyframe", Kind::Tables, REBUILD),
    Field::new("emitter.*.keyframe.*", Kind::Table, REBUILD),
    Field::new("emitter.*.keyframe.*.time_s", number(0.0, 1.0e6, "s"), REBUILD),
    Field::new("emitter.*.keyframe.*.centre_m", PLACE, REBUILD),
    Field::new("emitter.*.keyframe.*.turned_deg", TURN, REBUILD),
    Field::new("emitter.*.repeat", Kind::Switch, REBUILD),
    Field::new("drain", Kind::Tables, REBUILD),
    Field::new("drain.*", Kind::Table, REBUILD),
    Field::new("drain.*.block", Kind::Table, REBUILD),
    Field::new("drain.*.block.min_m", PLACE, REBUILD),
    Field::new("drain.*.block.max_m", PLACE, REBUILD),
    Field::new("drain.*.sphere", Kind::Table, REBUILD),
    Field::new("drain.*.sphere.centre_m", PLACE, REBUILD),
    Field::new("drain.*.sphere.radius_m", number(1.0e-6, 1.0e6, "m"), REBUILD),
    Field::new("drain.*.domain_exit", Kind::Switch, REBUILD),
    Field::new("drain.*.most_m3_s", number(1.0e-12, 1.0e12, "m³/s"), REBUILD),
    Field::new("solver", Kind::Table, REBUILD),
    Field::new("solver.method", Kind::Choice(Method::NAMES), RESET),
    Field::new("solver.dt_s", number(1.0e-9, 1.0e3, "s"), LIVE).logarithmic(5e-4, 0.02),
    Field::new("solver.substeps", whole(1.0, 1000.0, ""), REBUILD).slider(1.0, 8.0).knob(
        "substeps",
        &["1", "2", "3", "4", "8"],
        &[0, 1, 3],
    ),
    Field::new("solver.support_ratio", number(1.2, 4.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(1.5, 3.0).knob(
        "h/d",
        &["1.6", "2", "2.5", "3", "3.5"],
        &[1, 3],
    ),
    Field::new("solver.max_speed_m_s", number(1.0e-6, 1.0e9, "m/s"), LIVE).logarithmic(0.1, 100.0),
    Field::new("solver.neighbour_slots", whole(1.0, 1024.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(8.0, 256.0),
    Field::new("solver.deterministic", Kind::Switch, REBUILD).term("false", "true").knob(
        "deterministic",
        &["false", "true"],
        &[0, 1],
    ),
    Field::new("solver.precision", Kind::Choice(Precision::NAMES), REBUILD).of(WITH_NEIGHBOURS).knob(
        "precision",
        Precision::NAMES,
        &[0, 2],
    ),
    Field::new("solver.pbf", Kind::Table, REBUILD).of(PBF),
    Field::new("solver.pbf.iterations", whole(0.0, 1000.0, ""), REBUILD).of(PBF).slider(0.0, 16.0).knob(
        "iterations",
        &["1", "2", "4", "8", "16"],
        &[1, 2, 3],
    ),
    Field::new("solver.pbf.acceleration", Kind::Choice(Acceleration::NAMES), REBUILD)
        .of(PBF)
        .term("none", "chebyshev")
        .knob("acceleration", Acceleration::NAMES, &[0, 1]),
    Field::new("solver.pbf.coarse_correction", Kind::Switch, REBUILD).of(PBF).term("false", "true").knob(
        "coarse correction",
        &["false", "true"],
        &[0, 1],
    ),
    Field::new("solver.pbf.warm_start", number(0.0, 1.0, ""), TERM).of(PBF).slider(0.0, 0.3).term("0", "0.3").knob(
        "warm start",
        &["0", "0.1", "0.2", "0.3"],
        &[0, 3],
    ),
    Field::new("solver.pbf.relaxation", number(1.0e-3, 1.0, ""), LIVE).of(PBF).slider(0.05, 1.0).knob_with(
        "relaxation",
        &["0.2", "0.35", "0.5", "0.65", "0.8"],
        &[1, 2],
        // An acceleration leaves little of it, and refuses what is not stable.
        "solver.pbf.acceleration=none",
    ),
    Field::new("solver.pbf.cfm", number(1.0e-6, 1.0e3, ""), LIVE).of(PBF).logarithmic(1e-4, 1.0),
    Field::new("solver.pbf.s_corr_k", number(0.0, 10.0, ""), TERM).of(PBF).slider(0.0, 0.5).term("0", "0.1").knob(
        "s_corr",
        &["0", "0.001", "0.01", "0.1"],
        &[0],
    ),
    Field::new("solver.pbf.s_corr_distance_ratio", number(0.0, 0.9, ""), LIVE).of(PBF).slider(0.0, 0.9),
    Field::new("solver.sph", Kind::Table, REBUILD).of(SPH),
    Field::new("solver.sph.stiffness_m2_s2", number(1.0e-9, 1.0e12, "m²/s²"), REBUILD)
        .of(SPH)
        .logarithmic(1.0, 1.0e4)
        .knob("stiffness", &["30", "100", "300", "1000", "3000"], &[1, 3]),
    Field::new("solver.sph.exponent", number(1.0, 20.0, ""), LIVE).of(SPH).slider(1.0, 10.0),
    Field::new("solver.sph.clamp_pressure", Kind::Switch, LIVE).of(SPH),
    Field::new("solver.sph.viscosity_m2_s", number(0.0, 1.0e6, "m²/s"), REBUILD).of(SPH).logarithmic(1e-6, 1.0),
    Field::new("solver.sph.artificial_viscosity", number(0.0, 10.0, ""), REBUILD).of(SPH).slider(0.0, 1.0).knob(
        "artificial viscosity",
        &["0.02", "0.05", "0.1", "0.3"],
        &[0, 2],
    ),
    Field::new("solver.sph.surface_tension_n_m", number(0.0, 1.0e6, "N/m"), REBUILD)
        .of(SPH)
        .slider(0.0, 1.0)
        .term("0", "0.073"),
    Field::new("solver.sph.density_kernel", Kind::Choice(SmoothingKernel::FINITE_NAMES), REBUILD).of(SPH),
    Field::new("solver.sph.pressure_kernel", Kind::Choice(SmoothingKernel::FINITE_NAMES), REBUILD).of(SPH),
    Field::new("solver.sph.viscosity_kernel", Kind::Choice(SmoothingKernel::NAMES), REBUILD).of(SPH),
    Field::new("solver.sph.integrator", Kind::Choice(Integrator::NAMES), LIVE).of(SPH).knob(
        "integrator",
        Integrator::NAMES,
        &[0, 1],
    ),
    Field::new("solver.sph.adaptive_substeps", Kind::Switch, REBUILD).of(SPH),
    Field::new("solver.dfsph", Kind::Table, REBUILD).of(DFSPH),
    Field::new("solver.dfsph.density_tolerance", number(0.0, 1.0, ""), LIVE).of(DFSPH).logarithmic(1e-5, 0.01).knob(
        "density tolerance",
        &["0.0001", "0.0003", "0.001", "0.003"],
        &[0, 2],
    ),
    Field::new("solver.dfsph.divergence_tolerance", number(0.0, 1.0, ""), LIVE).of(DFSPH).logarithmic(1e-5, 0.01).knob(
        "divergence tolerance",
        &["0.0001", "0.0003", "0.001", "0.003"],
        &[0, 1],
    ),
    Field::new("solver.dfsph.max_divergence_iterations", whole(1.0, 1000.0, ""), REBUILD).of(DFSPH).slider(1.0, 50.0),
    Field::new("solver.dfsph.max_density_iterations", whole(0.0, 1000.0, ""), REBUILD)
        .of(DFSPH)
        .slider(0.0, 50.0)
        .term_called("0", "20", "no density solve"),
    Field::new("solver.dfsph.warm_start", Kind::Switch, REBUILD).of(DFSPH).term("false", "true"),
    Field::new("solver.dfsph.fixed_iterations", Kind::Switch, REBUILD).of(DFSPH),
    Field::new("solver.dfsph.coarse_correction", Kind::Switch, REBUILD).of(DFSPH).term("false", "true"),
    Field::new("solver.dfsph.momentum", number(0.0, 0.95, ""), LIVE).of(DFSPH).slider(0.0, 0.9),
    Field::new("solver.none", Kind::Table, REBUILD).of(NONE),
    Field::new("solver.none.lifetime_s", number(0.0, 1.0e6, "s"), LIVE).of(NONE).slider(0.0, 10.0),
    Field::new("solver.none.lifetime_variation", number(0.0, 1.0, ""), LIVE).of(NONE).slider(0.0, 1.0),
    Field::new("solver.none.drag_per_s", number(0.0, 1.0e3, "1/s"), LIVE).of(NONE).slider(0.0, 5.0),
    Field::new("solver.none.restitution", number(0.0, 1.0, ""), LIVE).of(NONE).slider(0.0, 1.0),
    Field::new("forces", Kind::Table, REBUILD),
    Field::new("forces.field", Kind::Tables, REBUILD),
    Field::new("forces.field.*", Kind::Table, REBUILD),
    Field::new("forces.field.*.acceleration_m_s2", Kind::Vector(within(-1.0e6, 1.0e6, "m/s²")), LIVE),
    Field::new("forces.field.*.swirl_per_s2", Kind::Vector(within(-1.0e9, 1.0e9, "1/s²")), LIVE),
    Field::new("forces.field.*.centre_m", PLACE, LIVE),
    Field::new("forces.field.*.frequency_hz", number(0.0, 1.0e6, "Hz"), LIVE).slider(0.0, 10.0),
    Field::new("forces.field.*.begin_s", number(0.0, 1.0e6, "s"), LIVE).slider(0.0, 10.0),
    Field::new("forces.field.*.end_s", number(0.0, 1.0e6, "s"), LIVE).slider(0.0, 10.0),
    Field::new("forces.xsph", number(0.0, 1.0, ""), TERM).of(WITH_FORCES).slider(0.0, 0.5).term("0", "0.01").knob(
        "XSPH",
        &["0", "0.01", "0.05", "0.2"],
        &[0, 1],
    ),
    Field::new("forces.vorticity_m_s", number(0.0, 1.0e3, "m/s"), TERM)
        .of(WITH_FORCES)
        .slider(0.0, 1.0)
        .term("0", "0.1"),
    Field::new("diffuse", Kind::Table, REBUILD).of(WITH_NEIGHBOURS),
    Field::new("diffuse.max_particles", whole(0.0, 16_777_216.0, ""), REBUILD)
        .of(WITH_NEIGHBOURS)
        .logarithmic(1000.0, 1.0e6)
        .term("0", "200000"),
    Field::new("diffuse.trapped_air_per_s", number(0.0, 1.0e6, "1/s"), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 1000.0),
    Field::new("diffuse.wave_crest_per_s", number(0.0, 1.0e6, "1/s"), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 1000.0),
    Field::new("diffuse.lifetime_s", number(1.0e-3, 1.0e6, "s"), REBUILD).of(WITH_NEIGHBOURS).slider(0.1, 10.0),
    Field::new("diffuse.buoyancy", number(0.0, 100.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 10.0),
    Field::new("diffuse.drag", number(0.0, 1.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 1.0),
    Field::new("diffuse.trapped_air_min_m_s", number(0.0, 1.0e6, "m/s"), REBUILD).of(WITH_NEIGHBOURS),
    Field::new("diffuse.trapped_air_max_m_s", number(0.0, 1.0e6, "m/s"), REBUILD).of(WITH_NEIGHBOURS),
    Field::new("diffuse.wave_crest_min", number(0.0, 2.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 0.5),
    Field::new("diffuse.wave_crest_max", number(0.0, 2.0, ""), REBUILD).of(WITH_NEIGHBOURS).slider(0.0, 1.0),
    Field::new("diffuse.energy_min_j_kg", number(0.0, 1.0e9, "J/kg"), REBUILD).of(WITH_NEIGHBOURS),
    Field::new("diffuse.energy_max_j_kg", number(0.0, 1.0e9, "J/kg"), REBUILD).of(WITH_NEIGHBOURS),
    Field::new("surface", Kind::Table, REBUILD),
    Field::new("surface.method", Kind::Choice(&["screen-space", "marching-cubes", "auto", "points", "none"]), REBUILD)
        .term("none", "screen-space"),
    Field::new(
        "surface.smoothing",
        Kind::Choice(&["narrow-range", "curvature-flow", "bilateral", "bilateral-2d", "gaussian", "none"]),
        REBUILD,
    )
    .term_with("none", "narrow-range", SMOOTHED),
    Field::new("surface.iterations", whole(0.0, 1000.0, ""), REBUILD).slider(0.0, 100.0),
    Field::new("surface.smoothing_ratio", number(0.0, 100.0, ""), REBUILD).slider(0.0, 6.0),
    Field::new("surface.radius_ratio", number(0.1, 10.0, ""), REBUILD).slider(0.3, 1.5),
    Field::new("surface.anisotropic", Kind::Switch, REBUILD).term_with("false", "true", WATER),
    Field::new("surface.absorption_per_m", Kind::Vector(within(0.0, 1.0e6, "1/m")), REBUILD),
    Field::new("surface.caustics", Kind::Switch, REBUILD).term_with("false", "true", WATER),
    Field::new("surface.self_shadow", Kind::Switch, REBUILD).term_with("false", "true", WATER),
    Field::new("surface.refraction", number(0.0, 2.0, ""), REBUILD).slider(0.0, 2.0),
    Field::new("surface.metal_reflectance", Kind::Vector(within(0.0, 1.0, "")), REBUILD),
    Field::new("surface.color_by", Kind::Choice(&["speed", "fluid", "density"]), REBUILD),
    Field::new("surface.mesh", Kind::Table, REBUILD),
    Field::new("surface.mesh.cell_ratio", number(0.25, 2.0, ""), REBUILD).slider(0.25, 1.0),
    Field::new("surface.mesh.dense_cells", whole(0.0, 256.0, ""), REBUILD).slider(0.0, 160.0),
    Field::new("surface.mesh.anisotropic", Kind::Switch, REBUILD).term_with("false", "true", MESHED),
    Field::new("surface.mesh.smooth_normals", whole(0.0, 16.0, ""), REBUILD)
        .slider(0.0, 8.0)
        .term_with("0", "4", MESHED),
    Field::new("surface.mesh.subdivide", whole(1.0, 3.0, ""), REBUILD).slider(1.0, 3.0).term_with("1", "2", MESHED),
    Field::new("surface.auto", Kind::Table, REBUILD),
    Field::new("surface.auto.least_px", number(0.0, 1.0e9, "px"), REBUILD),
    Field::new("surface.auto.px_per_particle", number(0.0, 1.0e6, "px"), REBUILD),
    Field::new("camera", Kind::Table, LIVE),
    Field::new("camera.eye_m", PLACE, LIVE),
    Field::new("camera.target_m", PLACE, LIVE),
    Field::new("camera.fov_deg", number(1.0, 150.0, "degrees"), LIVE),
    Field::new("outputs", Kind::Table, LIVE),
    Field::new("outputs.seconds", number(0.0, 1.0e6, "s"), LIVE),
    Field::new("outputs.images", whole(0.0, 100_000.0, ""), LIVE).term_called("0", "1", "no pictures"),
    Field::new("outputs.width_px", whole(1.0, 8192.0, "pixels"), LIVE),
    Field::new("outputs.height_px", whole(1.0, 8192.0, "pixels"), LIVE),
    Field::new("outputs.measure_every_steps", whole(0.0, 1.0e9, ""), TERM).slider(0.0, 32.0).term("0", "1"),
];

/// What the field at `path` takes (`fluid.0.block`); none if there is no such field.
pub(crate) fn kind_of(path: &str) -> Option<Kind> {
    field_of(path).map(|field| field.kind)
}

/// The row of the field at `path`; none if there is no such field. Each check of a scene asks for all of them.
pub(crate) fn field_of(path: &str) -> Option<&'static Field> {
    static ROWS: LazyLock<HashMap<&str, &Field>> =
        LazyLock::new(|| FIELDS.iter().rev().map(|field| (field.path, field)).collect());
    let any = |step| if str::parse::<usize>(step).is_ok() { "*" } else { step };
    ROWS.get(path).or_else(|| ROWS.get(&*path.split('.').map(any).collect::<Vec<_>>().join("."))).copied()
}
