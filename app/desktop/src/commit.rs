//! Which source the program was built from.

/// Version of the program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Commit it was built from, with `-dirty` behind it when the source differed; `unknown` when it
/// was not built from a git checkout.
pub const COMMIT: &str = env!("BROOKLET_COMMIT");
