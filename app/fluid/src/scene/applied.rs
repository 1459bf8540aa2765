//! How a scene that runs takes another value of a field.

use toml::Value;

/// What has to be done for a running scene to take another value of a field; the worse the later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Applied {
    /// Its uniforms are written (`Parameters::write`), or only the host reads it.
    Live,
    /// A new plan is made, with other passes, buffers or modules; the particles are carried over.
    Rebuild,
    /// It starts anew: the particles there are do not fit.
    Reset,
}

/// How the table of fields says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Applies {
    Always(Applied),
    /// Live, but at 0 the term has no pass and no buffer: from or to 0 it is a rebuild.
    Term,
}

impl Applies {
    pub(crate) fn between(self, before: Option<&Value>, after: Option<&Value>) -> Applied {
        let is_on = |value: Option<&Value>| match value {
            Some(Value::Float(number)) => *number > 0.0,
            Some(Value::Integer(number)) => *number > 0,
            _ => false,
        };
        match self {
            Self::Always(applied) => applied,
            Self::Term if is_on(before) == is_on(after) => Applied::Live,
            Self::Term => Applied::Rebuild,
        }
    }
}
