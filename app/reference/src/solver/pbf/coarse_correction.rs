//! The coarse correction of a substep's first iteration: mixing Λ − M² ∇²Λ = mean constraint of the particles of a
//! cell, on cells of 2 h, by nested iteration. (Shaders: `constrain_density`, RESTRICTED_MOMENTUM; `coarsen_constraint`,
//! `relax_multiplier`, `prolong_multiplier`.)

use brooklet_kernels::{COARSE_OPEN, COARSE_PERIODIC, CoarseGridParams};
use glam::DVec3;

/// Of the coarse multiplier, in the lambdas.
pub const WEIGHT: f64 = 0.3;
/// A particle's constraint counts within these.
pub const CONSTRAINTS: [f64; 2] = [-0.05, 0.25];
/// Compression above which a particle takes less of the multiplier, and from which on nothing.
pub const SHARES: [f64; 2] = [0.12, 0.24];
/// Cells that are less full belong to the surface.
pub const FULL_ENOUGH: f64 = 0.5;
/// Units of a constraint in one.
pub const UNITS: f64 = 32768.0;
/// Cells along each side of what is relaxed at a time, its surroundings being held.
pub const TILE: usize = 8;

/// What lies beyond the ends of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A wall: nothing flows.
    Wall,
    /// The other end.
    Periodic,
    /// Nothing: a cell whose multiplier is 0.
    Open,
}

/// The grid; see `CoarseGridParams`.
#[derive(Clone, Debug)]
pub struct CoarseGrid {
    /// Finest cells along each axis.
    pub finest_cells: [usize; 3],
    /// Edges of a finest cell, m; infinite along z in two dimensions.
    pub cell_m: DVec3,
    /// (M h / cell)² of the finest cells along each axis, 0 along z in two dimensions.
    pub conductance: DVec3,
    /// What a unit of the multiplier leaves of the constraint.
    pub mixing: f64,
    /// A multiplier is no more.
    pub most: f64,
    /// And no less.
    pub least: f64,
    /// Particles of a finest cell that is full.
    pub particles_a_cell: f64,
    /// Beyond the ends of each axis.
    pub ends: [End; 3],
    /// Sweeps of each level, finest first.
    pub sweeps: Vec<u32>,
}

impl CoarseGrid {
    /// The grid with the levels that the GPU gets, finest first; none of no levels.
    pub fn of(levels: &[CoarseGridParams]) -> Option<Self> {
        let finest = levels.first()?;
        Some(Self {
            finest_cells: finest.finest_cells.map(|n| n as usize),
            cell_m: 1.0 / DVec3::from_array(finest.inverse_cell_size_per_m.map(f64::from)),
            conductance: DVec3::from_array(finest.conductance.map(f64::from)),
            mixing: f64::from(finest.mixing),
            most: f64::from(finest.most),
            least: f64::from(finest.least),
            particles_a_cell: f64::from(finest.particles_a_cell),
            ends: finest.ends.map(|end| match end {
                COARSE_PERIODIC => End::Periodic,
                COARSE_OPEN => End::Open,
                _ => End::Wall,
            }),
            sweeps: levels.iter().map(|level| level.sweeps).collect(),
        })
    }
}

/// The particles of a cell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    /// Of their constraints, in 1/`UNITS`.
    pub constraint_sum: f64,
    /// Their number.
    pub particles: u32,
}

impl CoarseGrid {
    /// Cells along each axis after so many halvings.
    pub fn cells(&self, halvings: u32) -> [usize; 3] {
        self.finest_cells.map(|n| n.div_ceil(1 << halvings))
    }

    /// Finest cells that cell `at` of an axis is wide.
    fn width(&self, halvings: u32, axis: usize, at: usize) -> f64 {
        let wide = 1 << halvings;
        wide.min(self.finest_cells[axis] - at * wide) as f64
    }

    /// Where a position is, in finest cells; none if that is outside.
    fn place(&self, position_m: DVec3) -> Option<DVec3> {
        let mut place = position_m / self.cell_m;
        if self.cell_m.z.is_infinite() {
            place.z = 0.5;
        }
        let inside = (0..3).all(|axis| place[axis] >= 0.0 && place[axis] <= self.finest_cells[axis] as f64);
        inside.then_some(place)
    }

    /// Whether a cell is no part of the surface.
    fn is_full(&self, halvings: u32, at: [usize; 3], cell: &Cell) -> bool {
        let full: f64 = (0..3).map(|axis| self.width(halvings, axis, at[axis])).product();
        cell.particles > 0 && f64::from(cell.particles) >= FULL_ENOUGH * full * self.particles_a_cell
    }

    /// The neighbour of cell `at` of an axis, one further on a side; none behind an end that is not periodic.
    fn next(&self, cells: &[usize; 3], axis: usize, at: usize, side: isize) -> Option<usize> {
        let (n, to) = (cells[axis] as isize, at as isize + side);
        match self.ends[axis] {
            End::Periodic => Some(to.rem_euclid(n) as usize),
            _ => (0..n).contains(&to).then_some(to as usize),
        }
    }
}

fn index(at: [usize; 3], cells: &[usize; 3]) -> usize {
    (at[2] * cells[1] + at[1]) * cells[0] + at[0]
}

fn all_cells(cells: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    let [nx, ny, nz] = cells;
    (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
}

/// The finest cells' particles, of which each has a position and a constraint.
pub fn restrict_constraint(grid: &CoarseGrid, particles: impl Iterator<Item = (DVec3, f64)>) -> Vec<Cell> {
    let cells = grid.finest_cells;
    let mut sums = vec![Cell::default(); cells.iter().product()];
    for (position_m, constraint) in particles {
        let Some(place) = grid.place(position_m) else { continue };
        let at = std::array::from_fn(|axis| (place[axis] as usize).min(cells[axis] - 1));
        let sum = &mut sums[index(at, &cells)];
        sum.constraint_sum += (constraint.clamp(CONSTRAINTS[0], CONSTRAINTS[1]) * UNITS).round();
        sum.particles += 1;
    }
    sums
}

/// The cells of a level, of those of the level below it.
pub fn coarsen_constraint(grid: &CoarseGrid, halvings: u32, finer: &[Cell]) -> Vec<Cell> {
    let (cells, below) = (grid.cells(halvings), grid.cells(halvings - 1));
    let mut sums = vec![Cell::default(); cells.iter().product()];
    for at in all_cells(below) {
        let (sum, part) = (&mut sums[index(at.map(|n| n / 2), &cells)], finer[index(at, &below)]);
        sum.constraint_sum += part.constraint_sum;
        sum.particles += part.particles;
    }
    sums
}

/// Multipliers at a place, linear between the centres of `cells`.
fn interpolated(grid: &CoarseGrid, multipliers: &[f64], cells: [usize; 3], place: DVec3) -> f64 {
    let low = (place - 0.5).floor();
    let part = place - 0.5 - low;
    let mut sum = 0.0;
    for corner in all_cells([2; 3]) {
        let at = std::array::from_fn(|axis| {
            let (at, n) = (low[axis] as isize + corner[axis] as isize, cells[axis] as isize);
            match grid.ends[axis] {
                End::Periodic => at.rem_euclid(n) as usize,
                _ => at.clamp(0, n - 1) as usize,
            }
        });
        let weight: f64 = (0..3).map(|axis| if corner[axis] == 1 { part[axis] } else { 1.0 - part[axis] }).product();
        sum += weight * multipliers[index(at, &cells)];
    }
    sum
}

/// The multipliers of a level, relaxed from those of the level above it, or at the coarsest from nothing.
pub fn relax_multiplier(grid: &CoarseGrid, halvings: u32, sums: &[Cell], coarser: Option<&[f64]>) -> Vec<f64> {
    let cells = grid.cells(halvings);
    let is_full = |at: [usize; 3]| grid.is_full(halvings, at, &sums[index(at, &cells)]);
    let start: Vec<f64> = all_cells(cells)
        .map(|at| match coarser {
            Some(coarser) if is_full(at) => {
                let place = 0.5 * (DVec3::from_array(at.map(|n| n as f64)) + 0.5);
                interpolated(grid, coarser, grid.cells(halvings + 1), place)
            }
            _ => 0.0,
        })
        .collect();
    let tile_of = |at: [usize; 3]| at.map(|n| n / TILE);
    // Tiles do not see each other's sweeps, so all of them can be swept side by side.
    let mut values = start.clone();
    for _ in 0..grid.sweeps[halvings as usize] {
        let before = values.clone();
        for color in 0..2 {
            for at in all_cells(cells).filter(|at| at.iter().sum::<usize>() % 2 == color && is_full(*at)) {
                let cell = &sums[index(at, &cells)];
                let mut sum = cell.constraint_sum / (UNITS * f64::from(cell.particles));
                let mut total = grid.mixing;
                for (axis, side) in (0..3).flat_map(|axis| [(axis, -1), (axis, 1)]) {
                    let own = grid.width(halvings, axis, at[axis]);
                    let Some(next) = grid.next(&cells, axis, at[axis], side) else {
                        if grid.ends[axis] == End::Open {
                            total += grid.conductance[axis] / own.powi(2);
                        }
                        continue;
                    };
                    if next == at[axis] {
                        continue;
                    }
                    let mut to = at;
                    to[axis] = next;
                    let between = 0.5 * (own + grid.width(halvings, axis, next));
                    let conductance = grid.conductance[axis] / (own * between);
                    let is_across = next as isize != at[axis] as isize + side;
                    let value = match () {
                        // Copies of the other end's cells are made between sweeps.
                        () if is_across && cells[axis] <= TILE => before[index(to, &cells)],
                        () if is_across || tile_of(to) != tile_of(at) => start[index(to, &cells)],
                        () => values[index(to, &cells)],
                    };
                    sum += conductance * value;
                    total += conductance;
                }
                values[index(at, &cells)] = (sum / total).clamp(grid.least, grid.most);
            }
        }
    }
    values
}

/// What a particle takes of the multiplier, by its constraint.
pub fn share(constraint: f64) -> f64 {
    ((SHARES[1] - constraint) / (SHARES[1] - SHARES[0])).clamp(0.0, 1.0)
}

/// What a particle's lambda gets of the finest level's multipliers.
pub fn prolong_multiplier(grid: &CoarseGrid, multipliers: &[f64], position_m: DVec3) -> f64 {
    grid.place(position_m).map_or(0.0, |place| -WEIGHT * interpolated(grid, multipliers, grid.finest_cells, place))
}

/// The finest level's multipliers of particles with these constraints.
pub fn coarse_multipliers(grid: &CoarseGrid, particles: impl Iterator<Item = (DVec3, f64)>) -> Vec<f64> {
    let mut levels = vec![restrict_constraint(grid, particles)];
    for halvings in 1..grid.sweeps.len() as u32 {
        levels.push(coarsen_constraint(grid, halvings, &levels[halvings as usize - 1]));
    }
    let mut multipliers: Option<Vec<f64>> = None;
    for (halvings, sums) in levels.iter().enumerate().rev() {
        multipliers = Some(relax_multiplier(grid, halvings as u32, sums, multipliers.as_deref()));
    }
    multipliers.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A column of cells along y that are all `constraint` compressed up to a height, with one particle each.
    fn column(height: usize, full: usize, mixing: f64, end: End) -> (CoarseGrid, Vec<f64>) {
        let grid = CoarseGrid {
            finest_cells: [1, height, 1],
            cell_m: DVec3::new(1.0, 1.0, f64::INFINITY),
            conductance: DVec3::new(1.0, 1.0, 0.0),
            mixing,
            most: f64::INFINITY,
            least: 0.0,
            particles_a_cell: 1.0,
            ends: [End::Wall, end, End::Wall],
            sweeps: vec![1000],
        };
        let particles = (0..full).map(|y| (DVec3::new(0.5, y as f64 + 0.5, 0.0), 0.125));
        let multipliers = coarse_multipliers(&grid, particles);
        (grid, multipliers)
    }

    #[test]
    fn a_column_has_the_pressure_of_poissons_equation() {
        // -L'' = s, L' = 0 at the floor, L = 0 in the first cell that is not full.
        let (_, multipliers) = column(8, 7, 0.0, End::Wall);
        for (y, multiplier) in multipliers.iter().enumerate() {
            let exact = 0.125 * (7 * 8 - y * (y + 1)) as f64 / 2.0;
            assert!((multiplier - exact).abs() < 1e-9, "{y}: {multiplier} {exact}");
        }
    }

    #[test]
    fn a_closed_box_and_a_periodic_one_have_what_mixing_bears() {
        for end in [End::Wall, End::Periodic] {
            let (_, multipliers) = column(7, 7, 0.05, end);
            for multiplier in multipliers {
                assert!((multiplier - 0.125 / 0.05).abs() < 1e-6, "{end:?} {multiplier}");
            }
        }
        // What is open on both sides is less.
        let (_, open) = column(7, 7, 0.05, End::Open);
        assert!(open.iter().all(|&multiplier| multiplier < 1.2), "{open:?}");
    }

    #[test]
    fn nested_levels_come_near_to_what_sweeps_over_all_cells_would() {
        let nested = CoarseGrid {
            finest_cells: [16, 29, 1],
            cell_m: DVec3::new(1.0, 1.0, f64::INFINITY),
            conductance: DVec3::new(0.25, 0.25, 0.0),
            mixing: 0.018,
            most: f64::INFINITY,
            least: 0.0,
            particles_a_cell: 1.0,
            ends: [End::Periodic, End::Wall, End::Wall],
            sweeps: vec![4, 4, 16],
        };
        let particles = || (0..16 * 23).map(|i| (DVec3::new((i % 16) as f64 + 0.5, (i / 16) as f64 + 0.5, 0.0), 0.01));
        let got = coarse_multipliers(&nested, particles());
        let column: Vec<f64> = (0..29).map(|y| got[16 * y + 7]).collect();
        // L = s/mixing (1 - cosh(y/l)/cosh(Y/l)) with l^2 = conductance/mixing: the surface is half a cell beyond.
        let range = (0.25f64 / 0.018).sqrt();
        let off = |column: &[f64]| {
            let exact = |y: usize| 1.0 - ((y as f64 + 0.5) / range).cosh() / (23.5 / range).cosh();
            let errors = column.iter().enumerate().take(23).map(|(y, found)| (found * 0.018 / 0.01 - exact(y)).abs());
            errors.fold(0.0, f64::max)
        };
        // The levels above have the surface up to some cells off, which a few sweeps leave some of. 1.45 times what was found.
        assert!(off(&column) < 0.2, "{}", off(&column));
        let unswept = coarse_multipliers(&CoarseGrid { sweeps: vec![0, 0, 16], ..nested.clone() }, particles());
        let unswept: Vec<f64> = (0..29).map(|y| unswept[16 * y + 7]).collect();
        assert!(off(&unswept) > 0.2, "{}", off(&unswept));
        assert!(column[23..].iter().all(|&multiplier| multiplier == 0.0));
        // A particle between two cells gets what is between theirs.
        let between = prolong_multiplier(&nested, &got, DVec3::new(7.5, 10.0, 0.3));
        assert!((between + WEIGHT * 0.5 * (column[9] + column[10])).abs() < 1e-12, "{between}");
    }
}
