//! The counting sort into cells, and the neighbour list.

pub mod count_cells;
pub mod list_neighbours;
pub mod rank_members;
pub mod reorder;
pub mod scan;
