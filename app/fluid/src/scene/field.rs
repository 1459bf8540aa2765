//! What a row of the table of settings says: its types.

use std::fmt::{Display, Formatter, Result};

use super::applied::Applies;

/// A field of scene files: a setting, or a table of settings.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its path, `*` for any item of an array: `fluid.*.velocity_m_s`.
    pub path: &'static str,
    /// What it takes.
    pub kind: Kind,
    /// What a running scene needs to take another value (of a table nothing: its fields say it).
    pub(super) applies: Applies,
    /// The methods (`solver.method`) that have it; none named: all of them.
    pub methods: &'static [&'static str],
}

impl Field {
    pub(super) const fn new(path: &'static str, kind: Kind, applies: Applies) -> Self {
        Self { path, kind, applies, methods: &[] }
    }

    /// Only these methods have it.
    pub(super) const fn of(mut self, methods: &'static [&'static str]) -> Self {
        self.methods = methods;
        self
    }

    /// Whether scenes of a method have it.
    pub fn is_of(&self, method: &str) -> bool {
        self.methods.is_empty() || self.methods.contains(&method)
    }
}

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
