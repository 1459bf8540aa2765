//! Every field of a scene file: what kind of value it takes and within which limits. The checks,
//! the messages and the editors' schema all come from this one table.

use std::fmt::{Display, Formatter, Result};

use super::applied::{Applied, Applies};

/// What a field takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Number(Limits),
    /// A number without a fraction.
    Whole(Limits),
    /// Three numbers along x, y and z; the limits are each one's.
    Vector(Limits),
    /// One of these texts.
    Choice(&'static [&'static str]),
    /// `true` or `false`.
    Switch,
    /// Three of those, along x, y and z.
    Switches,
    /// Any text.
    Text,
    /// `[field]` and keys below it, or `{ key = value }`.
    Table,
    /// `[[field]]`, once for each item.
    Tables,
}

/// Smallest and largest value, and the unit (empty: none).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Smallest value.
    pub least: f64,
    /// Largest value.
    pub most: f64,
    /// Unit, as a person writes it; empty: none.
    pub unit: &'static str,
}

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

/// Path of each field, `*` for any item of an array, with what it takes, and what a running scene needs
/// to take another value (of a table nothing: its fields say it).
///
/// The widest limits keep what the GPU derives (squares, inverses, sums) inside f32's range.
pub(crate) const FIELDS: &[(&str, Kind, Applies)] = &[
    ("summary", Kind::Text, LIVE),
    ("spacing_m", Kind::Number(within(1.0e-6, 1.0e3, "m")), RESET),
    ("gravity_m_s2", Kind::Vector(within(-1.0e6, 1.0e6, "m/s²")), LIVE),
    ("domain", Kind::Table, RESET),
    ("domain.min_m", PLACE, RESET),
    ("domain.max_m", PLACE, RESET),
    ("domain.walls", Kind::Switch, REBUILD),
    ("domain.periodic", Kind::Switches, RESET),
    ("domain.dimensions", Kind::Whole(within(2.0, 3.0, "")), RESET),
    ("fluid", Kind::Tables, RESET),
    ("fluid.*", Kind::Table, RESET),
    ("fluid.*.block", Kind::Table, RESET),
    ("fluid.*.block.min_m", PLACE, RESET),
    ("fluid.*.block.max_m", PLACE, RESET),
    ("fluid.*.sphere", Kind::Table, RESET),
    ("fluid.*.sphere.centre_m", PLACE, RESET),
    ("fluid.*.sphere.radius_m", Kind::Number(within(1.0e-6, 1.0e6, "m")), RESET),
    ("fluid.*.velocity_m_s", SPEED, RESET),
    ("fluid.*.rest_density_kg_m3", Kind::Number(within(1.0e-6, 1.0e6, "kg/m³")), LIVE),
    ("solver", Kind::Table, REBUILD),
    ("solver.method", Kind::Choice(&["pbf"]), RESET),
    ("solver.dt_s", Kind::Number(within(1.0e-9, 1.0e3, "s")), LIVE),
    ("solver.substeps", Kind::Whole(within(1.0, 1000.0, "")), REBUILD),
    ("solver.iterations", Kind::Whole(within(0.0, 1000.0, "")), REBUILD),
    ("solver.support_ratio", Kind::Number(within(1.2, 4.0, "")), REBUILD),
    ("solver.relaxation", Kind::Number(within(1.0e-3, 1.0, "")), LIVE),
    ("solver.cfm", Kind::Number(within(1.0e-6, 1.0e3, "")), LIVE),
    ("solver.s_corr_k", Kind::Number(within(0.0, 10.0, "")), TERM),
    ("solver.s_corr_distance_ratio", Kind::Number(within(0.0, 0.9, "")), LIVE),
    ("solver.xsph", Kind::Number(within(0.0, 1.0, "")), TERM),
    ("solver.vorticity_m_s", Kind::Number(within(0.0, 1.0e3, "m/s")), TERM),
    ("solver.max_speed_m_s", Kind::Number(within(1.0e-6, 1.0e9, "m/s")), LIVE),
    ("solver.neighbour_slots", Kind::Whole(within(1.0, 1024.0, "")), REBUILD),
    ("solver.deterministic", Kind::Switch, REBUILD),
    ("solver.precision", Kind::Choice(&["full", "relaxed", "half"]), REBUILD),
    ("solver.packed_positions", Kind::Switch, REBUILD),
    ("surface", Kind::Table, REBUILD),
    ("surface.method", Kind::Choice(&["screen-space", "points", "none"]), REBUILD),
    (
        "surface.smoothing",
        Kind::Choice(&["narrow-range", "curvature-flow", "bilateral", "bilateral-2d", "gaussian", "none"]),
        REBUILD,
    ),
    ("surface.iterations", Kind::Whole(within(0.0, 1000.0, "")), REBUILD),
    ("surface.smoothing_ratio", Kind::Number(within(0.0, 100.0, "")), REBUILD),
    ("surface.radius_ratio", Kind::Number(within(0.1, 10.0, "")), REBUILD),
    ("surface.anisotropic", Kind::Switch, REBUILD),
    ("surface.absorption_per_m", Kind::Vector(within(0.0, 1.0e6, "1/m")), REBUILD),
    ("surface.caustics", Kind::Switch, REBUILD),
    ("surface.refraction", Kind::Number(within(0.0, 2.0, "")), REBUILD),
    ("surface.color_by", Kind::Choice(&["speed", "fluid", "density"]), REBUILD),
    ("camera", Kind::Table, LIVE),
    ("camera.eye_m", PLACE, LIVE),
    ("camera.target_m", PLACE, LIVE),
    ("camera.fov_deg", Kind::Number(within(1.0, 150.0, "degrees")), LIVE),
    ("outputs", Kind::Table, LIVE),
    ("outputs.seconds", Kind::Number(within(0.0, 1.0e6, "s")), LIVE),
    ("outputs.images", Kind::Whole(within(0.0, 100_000.0, "")), LIVE),
    ("outputs.width_px", Kind::Whole(within(1.0, 8192.0, "pixels")), LIVE),
    ("outputs.height_px", Kind::Whole(within(1.0, 8192.0, "pixels")), LIVE),
    ("outputs.measure_every_steps", Kind::Whole(within(0.0, 1.0e9, "")), TERM),
];

/// What the field at `path` takes (`fluid.0.block`); none if there is no such field.
pub(crate) fn kind_of(path: &str) -> Option<Kind> {
    field_of(path).map(|(_, kind, _)| *kind)
}

/// The row of the field at `path`; none if there is no such field.
pub(crate) fn field_of(path: &str) -> Option<&'static (&'static str, Kind, Applies)> {
    let matches = |field: &str| {
        let mut steps = path.split('.');
        let same = field.split('.').all(|wanted| {
            steps.next().is_some_and(|step| step == wanted || (wanted == "*" && step.parse::<usize>().is_ok()))
        });
        same && steps.next().is_none()
    };
    FIELDS.iter().find(|(field, ..)| matches(field))
}

impl Limits {
    /// Whether a value is within them.
    pub fn hold(&self, value: f64) -> bool {
        (self.least..=self.most).contains(&value)
    }
}

impl Display for Limits {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} to {}", Short(self.least), Short(self.most))?;
        if self.unit.is_empty() { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}

/// "must be ...".
impl Display for Kind {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Number(limits) => write!(f, "must be a number from {limits}"),
            Self::Whole(limits) => write!(f, "must be a whole number from {limits}"),
            Self::Vector(limits) => write!(f, "must be three numbers, each from {limits}"),
            Self::Choice(names) => write!(f, "must be \"{}\"", names.join("\" or \"")),
            Self::Switch => f.write_str("must be true or false"),
            Self::Switches => f.write_str("must be three of true or false, along x, y and z"),
            Self::Text => f.write_str("must be a text in quotes"),
            Self::Table => f.write_str("must be a table of keys"),
            Self::Tables => f.write_str("must be tables, [[fluid]] once for each"),
        }
    }
}

/// A number as a person writes it: 1e-6 and nan, not 0.000001 and NaN.
pub(crate) struct Short(pub f64);

impl Display for Short {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let size = self.0.abs();
        if size.is_nan() {
            return f.write_str("nan");
        }
        if size != 0.0 && size.is_finite() && !(1.0e-3..1.0e6).contains(&size) {
            write!(f, "{:e}", self.0)
        } else {
            write!(f, "{}", self.0)
        }
    }
}
