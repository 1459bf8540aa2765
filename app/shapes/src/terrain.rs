//! Ground: heights on a lattice, with all that is below.

use glam::DVec3;

use crate::mesh::Mesh;

/// Heights that ground may have along a side.
pub const MOST_HEIGHTS: usize = 512;

/// Heights on a lattice of two or more columns and rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    /// Along x.
    pub columns: usize,
    /// Along z.
    pub rows: usize,
    /// Row by row from the lowest z, m.
    pub heights_m: Vec<f64>,
}

impl Heights {
    /// The same with no more along a side than there is use for: each the mean of those that it stands for.
    pub fn resampled(self, most: [usize; 2]) -> Self {
        let counts = [self.columns.min(most[0].max(2)), self.rows.min(most[1].max(2))];
        if counts == [self.columns, self.rows] {
            return self;
        }
        // From half a step before each to half a step behind; the first and the last are at the ends.
        let part = |index: usize, count: usize, all: usize| {
            let step = (all - 1) as f64 / (count - 1) as f64;
            let end = |at: f64| at.round().clamp(0.0, (all - 1) as f64) as usize;
            (end((index as f64 - 0.5) * step + 0.5), end((index as f64 + 0.5) * step - 0.5))
        };
        let mut heights_m = Vec::with_capacity(counts[0] * counts[1]);
        for row in 0..counts[1] {
            let (first_row, last_row) = part(row, counts[1], self.rows);
            for column in 0..counts[0] {
                let (first, last) = part(column, counts[0], self.columns);
                let rows = first_row..=last_row.max(first_row);
                let of = |row: usize| &self.heights_m[row * self.columns..][first..=last.max(first)];
                let (sum, count) = rows
                    .map(of)
                    .fold((0.0, 0), |(sum, count), part| (sum + part.iter().sum::<f64>(), count + part.len()));
                heights_m.push(sum / count as f64);
            }
        }
        Self { columns: counts[0], rows: counts[1], heights_m }
    }
}

/// The ground's surface between the lattice's points, in two triangles each, with its sides and a floor at `bottom_m`; its
/// middle is at x = z = 0. It goes on level for `beyond_m` around `size_m`.
pub fn terrain(heights: &Heights, size_m: [f64; 2], beyond_m: f64, bottom_m: f64) -> Mesh {
    let ring = usize::from(beyond_m > 0.0);
    let [columns, rows] = [heights.columns + 2 * ring, heights.rows + 2 * ring];
    let along = |index: usize, count: usize, side_m: f64| {
        let inner = index.saturating_sub(ring).min(count - 1);
        let at_m = side_m * (inner as f64 / (count - 1) as f64 - 0.5);
        let beyond = (index as f64 - ring as f64 - inner as f64) * beyond_m;
        (inner, at_m + beyond)
    };
    let mut mesh = Mesh::default();
    for row in 0..rows {
        let (inner_row, z) = along(row, heights.rows, size_m[1]);
        for column in 0..columns {
            let (inner_column, x) = along(column, heights.columns, size_m[0]);
            let y = heights.heights_m[inner_row * heights.columns + inner_column];
            mesh.positions_m.push(DVec3::new(x, y, z));
        }
    }
    let at = |column: usize, row: usize| (row * columns + column) as u32;
    for row in 1..rows {
        for column in 1..columns {
            let [a, b, c, d] = [at(column - 1, row - 1), at(column, row - 1), at(column - 1, row), at(column, row)];
            mesh.triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    // Around, counter-clockwise as seen from above.
    let mut around: Vec<u32> = (0..rows).map(|row| at(0, row)).collect();
    around.extend((1..columns).map(|column| at(column, rows - 1)));
    around.extend((0..rows - 1).rev().map(|row| at(columns - 1, row)));
    around.extend((1..columns - 1).rev().map(|column| at(column, 0)));
    // The floor's triangles are as small as the surface's, or a tree over them would be poor.
    let below = mesh.positions_m.len() as u32;
    mesh.positions_m.extend(mesh.positions_m.clone().into_iter().map(|at_m| at_m.with_y(bottom_m)));
    mesh.triangles.extend(mesh.triangles.clone().into_iter().map(|[a, b, c]| [a + below, c + below, b + below]));
    for (index, &top) in around.iter().enumerate() {
        let next = around[(index + 1) % around.len()];
        mesh.triangles.extend([[top, top + below, next], [next, top + below, next + below]]);
    }
    mesh
}
