//! How a scene that runs takes another value of a field.

/// What has to be done for a running scene to take another value of a field; the worse the later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Update {
    /// Its uniforms are written (`Session::apply`), or only the host reads it.
    Live,
    /// A new plan is made, with other passes, buffers or modules; the particles are carried over.
    Rebuild,
    /// It starts anew: the particles there are do not fit.
    Reset,
}

/// How the table of fields says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UpdateRule {
    Always(Update),
    /// Live, but a term that is left out has no pass and no buffer: from or to the row's value that leaves it
    /// out it is a rebuild.
    Term,
}
