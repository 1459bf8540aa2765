//! Triangle meshes that solids are made of: read from files or made of points, heights and formulas; checked and, where that
//! can be said, repaired; weighed; and turned into distance fields, which is what the shaders are given of one.
//!
//! Lengths are metres in a solid's own frame. Everything is f64 but the nodes of a field.

mod bvh;
mod check;
mod field;
#[cfg(all(test, feature = "import"))]
mod file_tests;
mod grid;
mod hull;
#[cfg(feature = "import")]
pub mod import;
mod mass;
mod mesh;
mod normals;
mod relief;
mod shares;
mod terrain;
#[cfg(test)]
mod tests;
mod threads;
mod wheel;

pub use bvh::{Bvh, nearest_on_triangle};
pub use check::{Flaw, Repairs, checked};
pub use field::{Field, FieldOptions, MOST_NODES, MOST_NODES_A_SIDE};
pub use hull::{MOST_HULL_POINTS, hull};
pub use mass::MassProperties;
pub use mesh::{MOST_SIZE_M, MOST_TRIANGLES, Mesh};
pub use normals::corner_normals;
pub use relief::{Relief, ReliefKind, noise};
pub use shares::{plane_distance, plane_share};
pub use terrain::{Heights, MOST_HEIGHTS, terrain};
pub use wheel::Wheel;
