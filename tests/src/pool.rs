//! Water at rest, for long runs.

/// 1,000 particles that fill the floor of their box, corners included, and fall into their rest from the lattice.
pub const POOL: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [0.2, 0.3, 0.2]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.2, 0.2, 0.2] }
[outputs]
measure_every_steps = 1
";
