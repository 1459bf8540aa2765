//! The shader compiler.
fn main() {}
