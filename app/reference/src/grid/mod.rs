//! The counting sort into cells, and the neighbour list.

pub mod count_cells;
pub mod list_neighbours;
pub mod rank_by_id;
pub mod reorder;
pub mod scan;
