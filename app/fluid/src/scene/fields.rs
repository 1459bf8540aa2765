//! Every field of a scene file: what kind of value it takes and within which limits. The checks,
//! the messages and the editors' schema all come from this one table.

use std::fmt::{Display, Formatter, Result};

/// What a field takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
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
pub(crate) struct Limits {
    pub least: f64,
    pub most: f64,
    pub unit: &'static str,
}

const fn within(least: f64, most: f64, unit: &'static str) -> Limits {
    Limits { least, most, unit }
}

/// Far enough for any scene, near enough that f64 still tells micrometres apart there.
const PLACE: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "m"));
const SPEED: Kind = Kind::Vector(within(-1.0e6, 1.0e6, "m/s"));

/// Path of each field, `*` for any item of an array, with what it takes.
///
/// The widest limits keep what the GPU derives (squares, inverses, sums) inside f32's range.
pub(crate) const FIELDS: &[(&str, Kind)] = &[
    ("summary", Kind::Text),
    ("spacing_m", Kind::Number(within(1.0e-6, 1.0e3, "m"))),
    ("gravity_m_s2", Kind::Vector(within(-1.0e6, 1.0e6, "m/s²"))),
    ("domain", Kind::Table),
    ("domain.min_m", PLACE),
    ("domain.max_m", PLACE),
    ("domain.walls", Kind::Switch),
    ("domain.periodic", Kind::Switches),
    ("domain.dimensions", Kind::Whole(within(2.0, 3.0, ""))),
    ("fluid", Kind::Tables),
    ("fluid.*", Kind::Table),
    ("fluid.*.block", Kind::Table),
    ("fluid.*.block.min_m", PLACE),
    ("fluid.*.block.max_m", PLACE),
    ("fluid.*.sphere", Kind::Table),
    ("fluid.*.sphere.centre_m", PLACE),
    ("fluid.*.sphere.radius_m", Kind::Number(within(1.0e-6, 1.0e6, "m"))),
    ("fluid.*.velocity_m_s", SPEED),
    ("fluid.*.rest_density_kg_m3", Kind::Number(within(1.0e-6, 1.0e6, "kg/m³"))),
    ("solver", Kind::Table),
    ("solver.method", Kind::Choice(&["pbf"])),
    ("solver.dt_s", Kind::Number(within(1.0e-9, 1.0e3, "s"))),
    ("solver.substeps", Kind::Whole(within(1.0, 1000.0, ""))),
    ("solver.iterations", Kind::Whole(within(0.0, 1000.0, ""))),
    ("solver.support_ratio", Kind::Number(within(1.2, 4.0, ""))),
    ("solver.relaxation", Kind::Number(within(1.0e-3, 1.0, ""))),
    ("solver.cfm", Kind::Number(within(1.0e-6, 1.0e3, ""))),
    ("solver.s_corr_k", Kind::Number(within(0.0, 10.0, ""))),
    ("solver.s_corr_distance_ratio", Kind::Number(within(0.0, 0.9, ""))),
    ("solver.xsph", Kind::Number(within(0.0, 1.0, ""))),
    ("solver.vorticity_m_s", Kind::Number(within(0.0, 1.0e3, "m/s"))),
    ("solver.max_speed_m_s", Kind::Number(within(1.0e-6, 1.0e9, "m/s"))),
    ("solver.neighbour_slots", Kind::Whole(within(1.0, 1024.0, ""))),
    ("solver.deterministic", Kind::Switch),
    ("solver.precision", Kind::Choice(&["full", "relaxed", "half"])),
    ("solver.packed_positions", Kind::Switch),
    ("surface", Kind::Table),
    ("surface.method", Kind::Choice(&["screen-space", "points", "none"])),
    (
        "surface.smoothing",
        Kind::Choice(&["narrow-range", "curvature-flow", "bilateral", "bilateral-2d", "gaussian", "none"]),
    ),
    ("surface.iterations", Kind::Whole(within(0.0, 1000.0, ""))),
    ("surface.smoothing_ratio", Kind::Number(within(0.0, 100.0, ""))),
    ("surface.radius_ratio", Kind::Number(within(0.1, 10.0, ""))),
    ("surface.anisotropic", Kind::Switch),
    ("surface.absorption_per_m", Kind::Vector(within(0.0, 1.0e6, "1/m"))),
    ("surface.caustics", Kind::Switch),
    ("surface.refraction", Kind::Number(within(0.0, 2.0, ""))),
    ("surface.color_by", Kind::Choice(&["speed", "fluid", "density"])),
    ("camera", Kind::Table),
    ("camera.eye_m", PLACE),
    ("camera.target_m", PLACE),
    ("camera.fov_deg", Kind::Number(within(1.0, 150.0, "degrees"))),
    ("outputs", Kind::Table),
    ("outputs.seconds", Kind::Number(within(0.0, 1.0e6, "s"))),
    ("outputs.images", Kind::Whole(within(0.0, 100_000.0, ""))),
    ("outputs.width_px", Kind::Whole(within(1.0, 8192.0, "pixels"))),
    ("outputs.height_px", Kind::Whole(within(1.0, 8192.0, "pixels"))),
    ("outputs.measure_every_steps", Kind::Whole(within(0.0, 1.0e9, ""))),
];

/// What the field at `path` takes (`fluid.0.block`); none if there is no such field.
pub(crate) fn kind_of(path: &str) -> Option<Kind> {
    let matches = |field: &str| {
        let mut steps = path.split('.');
        let same = field.split('.').all(|wanted| {
            steps.next().is_some_and(|step| step == wanted || (wanted == "*" && step.parse::<usize>().is_ok()))
        });
        same && steps.next().is_none()
    };
    FIELDS.iter().find(|(field, _)| matches(field)).map(|(_, kind)| *kind)
}

impl Limits {
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
