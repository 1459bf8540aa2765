//! What a row of the table of settings says: its types.

use std::fmt::{Display, Formatter, Result};

use toml::Value;

use super::update::{Update, UpdateRule};

/// A field of scene files: a setting, or a table of settings.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its path, `*` for any item of an array: `fluid.*.velocity_m_s`.
    pub path: &'static str,
    /// What it takes.
    pub kind: Kind,
    /// What a running scene needs to take another value (of a table nothing: its fields say it).
    pub(super) update_rule: UpdateRule,
    /// The methods (`solver.method`) that have it; none named: all of them.
    pub methods: &'static [&'static str],
    /// How far a slider goes; see [`Field::slider_at`] for fields that do not say.
    pub(super) slider: Option<Slider>,
    /// The term that a value of it leaves out, if one does.
    pub term: Option<Term>,
    /// What a study turns it through, if it does.
    pub knob: Option<Knob>,
}

/// A slider's ends: what is useful, not what is allowed. Other values can be typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Lower end.
    pub least: f64,
    /// Upper end.
    pub most: f64,
    /// Whether equal ways multiply.
    pub logarithmic: bool,
}

/// A part of the simulation or the picture that a value leaves out: its passes, buffers and variants.
/// Values are texts, as `--set` takes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// The value that leaves it out.
    pub off: &'static str,
    /// One that brings it in.
    pub on: &'static str,
    /// Another field, and its values without one of which there is no such term.
    pub needs: Option<(&'static str, &'static [&'static str])>,
    /// What is missing without it, where the path does not say it; empty otherwise.
    pub meaning: &'static str,
}

/// What a study turns a field through, everything else staying.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knob {
    /// Its name on the command line and in legends.
    pub name: &'static str,
    /// What it is turned to.
    pub values: Values,
    /// Which of them are enough for a quick look.
    pub quick: &'static [usize],
    /// Another setting, `path=value`, without which turning it shows little.
    pub with: Option<&'static str>,
}

/// What a knob is turned to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// Multiples of what a case has.
    Times(&'static [f64]),
    /// Values, as `--set` takes them.
    To(&'static [&'static str]),
}

impl Field {
    pub(super) const fn new(path: &'static str, kind: Kind, update_rule: UpdateRule) -> Self {
        Self { path, kind, update_rule, methods: &[], slider: None, term: None, knob: None }
    }

    /// Only these methods have it.
    pub(super) const fn of(mut self, methods: &'static [&'static str]) -> Self {
        self.methods = methods;
        self
    }

    /// A slider goes from `least` to `most`.
    pub(super) const fn slider(mut self, least: f64, most: f64) -> Self {
        self.slider = Some(Slider { least, most, logarithmic: false });
        self
    }

    /// A slider goes from `least` to `most`, equal ways multiplying.
    pub(super) const fn logarithmic(mut self, least: f64, most: f64) -> Self {
        self.slider = Some(Slider { least, most, logarithmic: true });
        self
    }

    /// `off` leaves a term out, and `on` brings it in.
    pub(super) const fn term(mut self, off: &'static str, on: &'static str) -> Self {
        self.term = Some(Term { off, on, needs: None, meaning: "" });
        self
    }

    /// As [`Field::term`], of a term that is only there with another field's value.
    pub(super) const fn term_with(
        mut self,
        off: &'static str,
        on: &'static str,
        needs: (&'static str, &'static [&'static str]),
    ) -> Self {
        self.term = Some(Term { off, on, needs: Some(needs), meaning: "" });
        self
    }

    /// As [`Field::term`], with what is missing when it is out.
    pub(super) const fn term_called(mut self, off: &'static str, on: &'static str, meaning: &'static str) -> Self {
        self.term = Some(Term { off, on, needs: None, meaning });
        self
    }

    /// A study turns it, under a name, to values as `--set` takes them; `quick` of them are enough for a quick look.
    pub(super) const fn knob(
        mut self,
        name: &'static str,
        values: &'static [&'static str],
        quick: &'static [usize],
    ) -> Self {
        self.knob = Some(Knob { name, values: Values::To(values), quick, with: None });
        self
    }

    /// As [`Field::knob`], together with another setting.
    pub(super) const fn knob_with(
        mut self,
        name: &'static str,
        values: &'static [&'static str],
        quick: &'static [usize],
        with: &'static str,
    ) -> Self {
        self.knob = Some(Knob { name, values: Values::To(values), quick, with: Some(with) });
        self
    }

    /// As [`Field::knob`], to multiples of what a case has.
    pub(super) const fn knob_times(
        mut self,
        name: &'static str,
        factors: &'static [f64],
        quick: &'static [usize],
    ) -> Self {
        self.knob = Some(Knob { name, values: Values::Times(factors), quick, with: None });
        self
    }

    /// What a running scene needs that has `before` to have `after`.
    pub(super) fn update(&self, before: Option<&Value>, after: Option<&Value>) -> Update {
        let is_off = |value: Option<&Value>| value.is_some_and(|value| self.is_off(value));
        match self.update_rule {
            UpdateRule::Always(update) => update,
            UpdateRule::Term if is_off(before) == is_off(after) => Update::Live,
            UpdateRule::Term => Update::Rebuild,
        }
    }

    /// Whether scenes of a method have it.
    pub fn is_of(&self, method: &str) -> bool {
        self.methods.is_empty() || self.methods.contains(&method)
    }

    /// The ends of a slider that stands at `value`; none of what is no number. Fields without useful ends of their
    /// own are lengths and densities: some times larger or smaller, by powers of two, so that the ends stay while
    /// the slider moves.
    pub fn slider_at(&self, value: f64) -> Option<Slider> {
        let (Kind::Number(limits) | Kind::Whole(limits)) = self.kind else { return None };
        Some(self.slider.unwrap_or_else(|| {
            let middle = if value > 0.0 { 2f64.powf(value.log2().round()) } else { 1.0 };
            Slider { least: (middle / 8.0).max(limits.least), most: (8.0 * middle).min(limits.most), logarithmic: true }
        }))
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
    /// Any number of those.
    Vectors(Limits),
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
            Self::Vectors(limits) => write!(f, "must be points of three numbers, each from {limits}"),
            Self::Choice(names) => write!(f, "must be \"{}\"", names.join("\" or \"")),
            Self::Switch => f.write_str("must be true or false"),
            Self::Switches => f.write_str("must be three of true or false, along x, y and z"),
            Self::Text => f.write_str("must be a text in quotes"),
            Self::Table => f.write_str("must be a table of keys"),
            Self::Tables => f.write_str("must be tables, [[name]] once for each"),
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
        let (plain, short) = (self.0.to_string(), format!("{:e}", self.0));
        let is_far = size != 0.0 && size.is_finite() && !(1.0e-3..1.0e6).contains(&size);
        f.write_str(if is_far && short.len() < plain.len() { &short } else { &plain })
    }
}
