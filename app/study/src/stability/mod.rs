//! Where it breaks: the extreme cases over precisions, tiers, layouts, accelerations, coarse corrections and warm starts,
//! and maps of where a solver holds, with theory's lines.

mod map;
mod pairwise;
mod rows;

pub use map::{Cell, Map, cell_cost, map_tasks, run_cell};
pub use pairwise::covering;
pub use rows::{ROWS, Row, row_cost, row_tasks, run_row};

/// Part of a study: extreme cases.
pub const ROWS_PART: &str = "stability";
/// Part of a study: cells of maps.
pub const MAP_PART: &str = "map";
