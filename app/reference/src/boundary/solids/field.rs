//! Distances on a grid, interpolated linearly along each axis. (Shader: `boundary/solids/field.hlsli`.)

use glam::DVec3;

/// How fast an interpolated distance may change at most.
pub const FIELD_STEEPNESS: f64 = 1.7320508;

/// A mesh's field, with nodes of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The lowest node, m.
    pub min_m: DVec3,
    /// Between two, m.
    pub cell_m: f64,
    /// Along each side.
    pub nodes: [usize; 3],
    /// Of each node, x fastest: its distance from the surface, m, and that of the plane beyond which as much of the kernel
    /// lies as in the solid, in h.
    pub values: Vec<[f64; 2]>,
}

/// What it says at a place.
pub struct Sample {
    /// Distance, m, and plane, in h: of the nearest place in the grid.
    pub values: [f64; 2],
    /// Their slopes there, per metre.
    pub slopes: [DVec3; 2],
    /// From the grid to the place.
    pub outside_m: DVec3,
}

impl Field {
    /// That of a solid, among the nodes of all fields.
    pub fn of(solid: &brooklet_kernels::Solid, nodes: &[[f32; 2]]) -> Self {
        let sides = solid.field_nodes.map(|side| side as usize);
        let first = solid.first_field_node as usize;
        Self {
            min_m: DVec3::from_array(solid.field_min_m.map(f64::from)),
            cell_m: solid.field_cell_m.into(),
            nodes: sides,
            values: nodes[first..first + sides.iter().product::<usize>()]
                .iter()
                .map(|node| node.map(f64::from))
                .collect(),
        }
    }

    /// At a place: each value is the sum of its eight nodes', by products of three weights.
    pub fn sample(&self, place_m: DVec3) -> Sample {
        let last = DVec3::from_array(self.nodes.map(|side| side as f64 - 1.0));
        let in_grid_m = place_m.clamp(self.min_m, self.min_m + last * self.cell_m);
        let at = (in_grid_m - self.min_m) / self.cell_m;
        let cell = at.floor().clamp(DVec3::ZERO, last - 1.0);
        let part = at - cell;
        let mut sample = Sample { values: [0.0; 2], slopes: [DVec3::ZERO; 2], outside_m: place_m - in_grid_m };
        for corner in 0..8_usize {
            let step = [0, 1, 2].map(|axis| corner >> axis & 1);
            let [x, y, z] = [0, 1, 2].map(|axis| cell[axis] as usize + step[axis]);
            let node = self.values[x + self.nodes[0] * (y + self.nodes[1] * z)];
            let weight = |axis: usize| if step[axis] == 1 { part[axis] } else { 1.0 - part[axis] };
            for (k, value) in node.into_iter().enumerate() {
                sample.values[k] += value * weight(0) * weight(1) * weight(2);
                for (axis, step) in step.into_iter().enumerate() {
                    let sign = if step == 1 { 1.0 } else { -1.0 };
                    sample.slopes[k][axis] +=
                        value * sign * weight((axis + 1) % 3) * weight((axis + 2) % 3) / self.cell_m;
                }
            }
        }
        sample
    }

    /// How far a place is from the surface, m, and which way is out.
    pub fn surface(&self, place_m: DVec3) -> (f64, DVec3) {
        let Sample { values: [distance_m, _], slopes: [slope, _], outside_m } = self.sample(place_m);
        let normal = slope.try_normalize().unwrap_or(DVec3::Y);
        if outside_m == DVec3::ZERO {
            return (distance_m, normal);
        }
        let away_m = distance_m.max(0.0) * normal + outside_m;
        (distance_m.max(0.0).hypot(outside_m.length()), away_m.try_normalize().unwrap_or(normal))
    }
}
