//! How a scene that runs takes another value of a field.

use toml::Value;

use super::field::Field;

/// What has to be done for a running scene to take another value of a field; the worse the later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Applied {
    /// Its uniforms are written (`Session::apply`), or only the host reads it.
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
    /// Live, but a term that is left out has no pass and no buffer: from or to the row's value that leaves it
    /// out it is a rebuild.
    Term,
}

impl Field {
    /// What a running scene needs that has `before` to have `after`.
    pub(super) fn applied(&self, before: Option<&Value>, after: Option<&Value>) -> Applied {
        let is_off = |value: Option<&Value>| value.is_some_and(|value| self.is_off(value));
        match self.applies {
            Applies::Always(applied) => applied,
            Applies::Term if is_off(before) == is_off(after) => Applied::Live,
            Applies::Term => Applied::Rebuild,
        }
    }
}
