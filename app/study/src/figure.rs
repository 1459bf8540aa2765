//! What a run is judged by.

use serde::{Deserialize, Serialize};

/// A number with a name, and, where it is judged, the limit that was fixed before the run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// What it is.
    pub name: String,
    /// How much; none where it is not finite or cannot be had from the run.
    pub value: Option<f64>,
    /// Its unit; empty for ratios.
    pub unit: String,
    /// The size it may have; none where it is told and not judged.
    pub limit: Option<f64>,
    /// Why the limit is what it is, or what the figure says.
    pub why: String,
}

/// What a limit says of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within its limit.
    Meets,
    /// Beyond it, or not to be had.
    FallsShort,
    /// There is no limit.
    Told,
}

impl Figure {
    /// A figure that is told.
    pub fn told(name: &str, value: f64, unit: &str, what: &str) -> Self {
        let value = value.is_finite().then_some(value);
        Self { name: name.into(), value, unit: unit.into(), limit: None, why: what.into() }
    }

    /// A figure whose size may be at most `limit`.
    pub fn judged(name: &str, value: f64, unit: &str, limit: f64, why: &str) -> Self {
        Self { limit: Some(limit), ..Self::told(name, value, unit, why) }
    }

    /// A figure that must reach `least`: how far it falls short, which must be nothing.
    pub fn at_least(name: &str, value: f64, unit: &str, least: f64, why: &str) -> Self {
        Self::judged(name, if value >= least { 0.0 } else { least - value }, unit, 0.0, why)
    }

    /// Whether it meets its limit.
    pub fn verdict(&self) -> Verdict {
        match (self.limit, self.value) {
            (None, _) => Verdict::Told,
            (Some(limit), Some(value)) if value.abs() <= limit => Verdict::Meets,
            (Some(_), _) => Verdict::FallsShort,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_must_be_reached_is() {
        let of = |value: f64| Figure::at_least("pairs", value, "", 0.4, "").verdict() == Verdict::Meets;
        assert_eq!([of(0.4), of(7.0), of(0.39), of(f64::NAN)], [true, true, false, false]);
    }

    #[test]
    fn what_is_not_a_number_meets_no_limit() {
        let of = |value: f64| Figure::judged("error", value, "", 0.1, "").verdict();
        assert_eq!([of(0.1), of(-0.1), of(0.11), of(-0.2)].map(|v| v == Verdict::Meets), [true, true, false, false]);
        assert_eq!([of(f64::NAN), of(f64::INFINITY)], [Verdict::FallsShort; 2]);
        assert_eq!(Figure::told("height", f64::NAN, "m", "").verdict(), Verdict::Told);
    }
}
