//! The nodes of a field.

use glam::{DVec3, IVec3};

/// Where nodes are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    pub min_m: DVec3,
    pub cell_m: f64,
    pub nodes: [u32; 3],
}

impl Grid {
    pub fn place(&self, index: usize) -> IVec3 {
        let [x, y, _] = self.nodes.map(|side| side as usize);
        IVec3::new((index % x) as i32, (index / x % y) as i32, (index / (x * y)) as i32)
    }

    pub fn index(&self, at: IVec3) -> Option<usize> {
        let [x, y, z] = self.nodes.map(|side| side as i32);
        let is_in = at.cmpge(IVec3::ZERO).all() && at.cmplt(IVec3::new(x, y, z)).all();
        is_in.then(|| (at.x as usize) + (x as usize) * (at.y as usize + y as usize * at.z as usize))
    }

    pub fn position_m(&self, at: IVec3) -> DVec3 {
        self.min_m + at.as_dvec3() * self.cell_m
    }
}
