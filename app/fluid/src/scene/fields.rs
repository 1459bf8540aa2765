//! Every setting of a scene file, once: what it takes and within which limits, which methods have it, and
//! what a running scene needs to take another value. The checks, the messages and the editors' schema are made from it.

use super::applied::{Applied, Applies};
use super::field::{Field, Kind, Limits};
use super::solver::Method;

const fn within(least: f64, most: f64, unit: &'static str) -> Limits {
    Limits { least, most, unit }
}

/// Far enough for any scene, near enough that f64 still tells micrometres apart there.
const PLACE: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "m"));
const SPEED: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "m/s"));

const LIVE: Applies = Applies::Always(Applied::Live);
const TERM: Applies = Applies::Term;
const REBUILD: Applies = Applies::Always(Applied::Rebuild);
const RESET: Applies = Applies::Always(Applied::Reset);

const PBF: &[&str] = &["pbf"];
/// Methods whose particles know their neighbours.
const WITH_NEIGHBOURS: &[&str] = &["pbf"];

/// Path of each field, `*` for any item of an array, with what it takes, and what a running scene needs
/// to take another value (of a table nothing: its fields say it).
///
/// The widest limits keep what the GPU derives (squares, inverses, sums) inside f32's range.
pub(crate) const FIELDS: &[Field] = &[
    Field::new("summary", Kind::Text, LIVE),
    Field::new("spacing_m", Kind::Number(within(1.0e-6, 1.0e3, "m")), RESET),
    Field::new("gravity_m_s2", Kind::Vector(within(-1.0e6, 1.0e6, "m/s²")), LIVE),
    Field::new("domain", Kind::Table, RESET),
    Field::new("domain.min_m", PLACE, RESET),
    Field::new("domain.max_m", PLACE, RESET),
    Field::new("domain.walls", Kind::Switch, REBUILD),
    Field::new("domain.periodic", Kind::Switches, RESET),
    Field::new("domain.dimensions", Kind::Whole(within(2.0, 3.0, "")), RESET),
    Field::new("fluid", Kind::Tables, RESET),
    Field::new("fluid.*", Kind::Table, RESET),
    Field::new("fluid.*.block", Kind::Table, RESET),
    Field::new("fluid.*.block.min_m", PLACE, RESET),
    Field::new("fluid.*.block.max_m", PLACE, RESET),
    Field::new("fluid.*.sphere", Kind::Table, RESET),
    Field::new("fluid.*.sphere.centre_m", PLACE, RESET),
    Field::new("fluid.*.sphere.radius_m", Kind::Number(within(1.0e-6, 1.0e6, "m")), RESET),
    Field::new("fluid.*.velocity_m_s", SPEED, RESET),
    Field::new("fluid.*.rest_density_kg_m3", Kind::Number(within(1.0e-6, 1.0e6, "kg/m³")), LIVE),
    Field::new("solver", Kind::Table, REBUILD),
    Field::new("solver.method", Kind::Choice(Method::NAMES), RESET),
    Field::new("solver.dt_s", Kind::Number(within(1.0e-9, 1.0e3, "s")), LIVE),
    Field::new("solver.substeps", Kind::Whole(within(1.0, 1000.0, "")), REBUILD),
    Field::new("solver.support_ratio", Kind::Number(within(1.2, 4.0, "")), REBUILD),
    Field::new("solver.max_speed_m_s", Kind::Number(within(1.0e-6, 1.0e9, "m/s")), LIVE),
    Field::new("solver.neighbour_slots", Kind::Whole(within(1.0, 1024.0, "")), REBUILD),
    Field::new("solver.deterministic", Kind::Switch, REBUILD),
    Field::new("solver.precision", Kind::Choice(&["full", "relaxed", "half"]), REBUILD),
    Field::new("solver.packed_positions", Kind::Switch, REBUILD),
    Field::new("solver.pbf", Kind::Table, REBUILD).of(PBF),
    Field::new("solver.pbf.iterations", Kind::Whole(within(0.0, 1000.0, "")), REBUILD).of(PBF),
    Field::new("solver.pbf.relaxation", Kind::Number(within(1.0e-3, 1.0, "")), LIVE).of(PBF),
    Field::new("solver.pbf.cfm", Kind::Number(within(1.0e-6, 1.0e3, "")), LIVE).of(PBF),
    Field::new("solver.pbf.s_corr_k", Kind::Number(within(0.0, 10.0, "")), TERM).of(PBF),
    Field::new("solver.pbf.s_corr_distance_ratio", Kind::Number(within(0.0, 0.9, "")), LIVE).of(PBF),
    Field::new("forces", Kind::Table, REBUILD),
    Field::new("forces.xsph", Kind::Number(within(0.0, 1.0, "")), TERM).of(WITH_NEIGHBOURS),
    Field::new("forces.vorticity_m_s", Kind::Number(within(0.0, 1.0e3, "m/s")), TERM).of(WITH_NEIGHBOURS),
    Field::new("surface", Kind::Table, REBUILD),
    Field::new("surface.method", Kind::Choice(&["screen-space", "points", "none"]), REBUILD),
    Field::new(
        "surface.smoothing",
        Kind::Choice(&["narrow-range", "curvature-flow", "bilateral", "bilateral-2d", "gaussian", "none"]),
        REBUILD,
    ),
    Field::new("surface.iterations", Kind::Whole(within(0.0, 1000.0, "")), REBUILD),
    Field::new("surface.smoothing_ratio", Kind::Number(within(0.0, 100.0, "")), REBUILD),
    Field::new("surface.radius_ratio", Kind::Number(within(0.1, 10.0, "")), REBUILD),
    Field::new("surface.anisotropic", Kind::Switch, REBUILD),
    Field::new("surface.absorption_per_m", Kind::Vector(within(0.0, 1.0e6, "1/m")), REBUILD),
    Field::new("surface.caustics", Kind::Switch, REBUILD),
    Field::new("surface.refraction", Kind::Number(within(0.0, 2.0, "")), REBUILD),
    Field::new("surface.color_by", Kind::Choice(&["speed", "fluid", "density"]), REBUILD),
    Field::new("camera", Kind::Table, LIVE),
    Field::new("camera.eye_m", PLACE, LIVE),
    Field::new("camera.target_m", PLACE, LIVE),
    Field::new("camera.fov_deg", Kind::Number(within(1.0, 150.0, "degrees")), LIVE),
    Field::new("outputs", Kind::Table, LIVE),
    Field::new("outputs.seconds", Kind::Number(within(0.0, 1.0e6, "s")), LIVE),
    Field::new("outputs.images", Kind::Whole(within(0.0, 100_000.0, "")), LIVE),
    Field::new("outputs.width_px", Kind::Whole(within(1.0, 8192.0, "pixels")), LIVE),
    Field::new("outputs.height_px", Kind::Whole(within(1.0, 8192.0, "pixels")), LIVE),
    Field::new("outputs.measure_every_steps", Kind::Whole(within(0.0, 1.0e9, "")), TERM),
];

/// What the field at `path` takes (`fluid.0.block`); none if there is no such field.
pub(crate) fn kind_of(path: &str) -> Option<Kind> {
    field_of(path).map(|field| field.kind)
}

/// The row of the field at `path`; none if there is no such field.
pub(crate) fn field_of(path: &str) -> Option<&'static Field> {
    let matches = |field: &str| {
        let mut steps = path.split('.');
        let same = field.split('.').all(|wanted| {
            steps.next().is_some_and(|step| step == wanted || (wanted == "*" && step.parse::<usize>().is_ok()))
        });
        same && steps.next().is_none()
    };
    FIELDS.iter().find(|field| matches(field.path))
}
