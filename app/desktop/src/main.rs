//! The brooklet program.
fn main() {}
