//! The box that holds the fluid: how large it is, what is at its faces, how many dimensions it has.

use serde::{Deserialize, Serialize};

use super::faces::{Faces, Slip};
use super::wall::Wall;

/// An axis-aligned box.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Domain {
    /// Lowest corner, m. The GPU's positions are relative to it.
    pub min_m: [f64; 3],
    /// Highest corner, m.
    pub max_m: [f64; 3],
    /// Whether the box has walls. Without them a particle that leaves the box is counted as
    /// escaped and flies on alone. Safe to drop where no fluid reaches the box's faces.
    #[serde(default = "yes")]
    pub walls: bool,
    /// Along which of x, y and z the box repeats itself without end: what leaves it there comes in on
    /// the other side, and there are no walls. Such a side is a whole multiple of 4 h
    /// (h = spacing_m * solver.support_ratio). Safe to leave out where no fluid reaches those faces.
    #[serde(default)]
    pub periodic: [bool; 3],
    /// 3, or 2: one layer of particles in the plane z = middle of the box, each a unit of area, and no
    /// walls along z. How deep the box is then changes nothing; one spacing is enough.
    #[serde(default = "three")]
    pub dimensions: u32,
    /// How single walls drag the fluid along them; free-slip where left out.
    #[serde(default, skip_serializing_if = "Faces::is_empty")]
    pub faces: Faces,
    /// By what walls keep the fluid: its pressure, if left out.
    #[serde(default, skip_serializing_if = "Wall::is_default")]
    pub wall: Wall,
}

impl Domain {
    /// Extent along each axis, m.
    pub fn size_m(&self) -> [f64; 3] {
        std::array::from_fn(|axis| self.max_m[axis] - self.min_m[axis])
    }

    /// Whether a wall stands at both ends of an axis.
    pub fn has_walls_along(&self, axis: usize) -> bool {
        self.walls && !self.periodic[axis] && axis < self.dimensions as usize
    }

    /// Whether any wall stands.
    pub fn has_walls(&self) -> bool {
        (0..3).any(|axis| self.has_walls_along(axis))
    }

    /// Lowest and highest corner of the box of walls, relative to the domain's lowest; infinite along axes
    /// without walls, m.
    pub fn wall_bounds_m(&self) -> [[f64; 3]; 2] {
        let size_m = self.size_m();
        let at = |face_m: [f64; 3], beyond_m: f64| {
            std::array::from_fn(|axis| if self.has_walls_along(axis) { face_m[axis] } else { beyond_m })
        };
        [at([0.0; 3], f64::NEG_INFINITY), at(size_m, f64::INFINITY)]
    }

    /// Whether any wall drags.
    pub fn has_dragging_walls(&self) -> bool {
        self.faces.all().iter().flatten().any(|face| face.slip != Slip::FreeSlip)
    }

    /// Whether any axis is periodic.
    pub fn is_periodic(&self) -> bool {
        self.periodic.contains(&true)
    }

    /// Whether all particles are in one plane z = const.
    pub fn is_flat(&self) -> bool {
        self.dimensions == 2
    }

    /// The plane of a flat domain, m.
    pub fn plane_z_m(&self) -> f64 {
        0.5 * (self.min_m[2] + self.max_m[2])
    }
}

fn yes() -> bool {
    true
}

fn three() -> u32 {
    3
}
