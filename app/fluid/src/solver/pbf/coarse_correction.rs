//! The coarse correction of a substep's first iteration: what varies slowly in the density constraint, solved for on
//! cells of 2 h. (Shaders: `solver/pbf/coarse_correction.hlsli`, `coarsen_constraint.compute`,
//! `relax_multiplier.compute`, `prolong_multiplier.compute`.)
//!
//! Levels halve the grid until one tile holds it, so a substep has 2 log2(longest side / tile) + 3 small dispatches.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, COARSE_OPEN, COARSE_PERIODIC, COARSE_TILE, COARSE_WALL, CoarseCell, CoarseGridParams, CoarsenConstraint,
    ProlongMultiplier, ProlongMultiplierVariant, RelaxMultiplier, RelaxMultiplierVariant,
};

use super::{IterationWeights, Lambdas};
use crate::grid::Sorted;
use crate::scene::{Block, Scene};
use crate::smoothing_kernel::{for_lattice, lattice, wendland_slope};
use crate::step_context::StepContext;

/// Support radii along an edge of a finest cell, at most: cells fit the domain.
const CELL_SUPPORTS: f64 = 2.0;
/// Finest cells that a scene may have: 32 MiB.
pub(crate) const MAX_CELLS: u64 = 1 << 21;
/// What a multiplier leaves of the constraint, over the lattice's |∇C|², where the scene's cfm is less. The answer of
/// the grid then reaches four cells; with a tenth of it a column of 200 layers already gains energy.
const LEAST_MIXING: f64 = 0.01;
/// A multiplier is no more: a pressure that is added at once pushes neighbours the further the larger it is, and from
/// some size on past each other. A periodic column of 200 layers at h = 2 d comes to rest with this one where the column
/// law of plain iterations says 10 % (0.4 % are left), and gains energy without it; where that says 20 % it swings, up to
/// 15 % compressed.
const MOST_MULTIPLIER: f64 = 0.25;
/// Sweeps of a level that starts from the one above it, and of the coarsest, which starts from nothing.
const SWEEPS: [u32; 2] = [4, 16];

/// The grid's levels with their buffers, finest first.
pub(in crate::solver) struct CoarseCorrection {
    levels: Vec<Level>,
}

struct Level {
    given: CoarseGridParams,
    params: Buffer<CoarseGridParams>,
    cells: Buffer<CoarseCell>,
    multipliers: Buffer<f32>,
    /// Along each axis.
    tiles: [u32; 3],
}

/// Each side of `scene`'s domain, m; a period along axes that have one.
fn sides_m(scene: &Scene) -> [f64; 3] {
    let (size_m, period_m) = (scene.domain.size_m(), scene.period_m());
    std::array::from_fn(|axis| if scene.domain.periodic[axis] { period_m[axis] } else { size_m[axis] })
}

/// The same in cells that are not fitted to it.
fn lengths(scene: &Scene) -> [f64; 3] {
    sides_m(scene).map(|side_m| side_m / (CELL_SUPPORTS * scene.support_m()))
}

/// Finest cells along each axis of `scene`.
pub(crate) fn finest_cells(scene: &Scene) -> [u64; 3] {
    let lengths = lengths(scene);
    std::array::from_fn(|axis| match axis < scene.domain.dimensions as usize {
        // A hair less: rounding makes no cell more.
        true => (lengths[axis] - 1e-6).ceil().max(1.0) as u64,
        false => 1,
    })
}

/// Whether there may be so many of them.
pub(crate) fn are_few_cells(finest_cells: [u64; 3]) -> bool {
    finest_cells.iter().map(|&n| u128::from(n)).product::<u128>() <= u128::from(MAX_CELLS)
}

/// The first axis that is narrower than a cell: all of the fluid there is beside walls, where a multiplier that varies
/// slowly does not do what the grid's equation says. (A row of single particles between walls then moves at 1 m/s.)
pub(crate) fn narrow_axis(scene: &Scene) -> Option<usize> {
    let lengths = lengths(scene);
    (0..scene.domain.dimensions as usize).find(|&axis| lengths[axis] < 1.0 - 1e-6)
}

/// Whether a closed domain begins full of fluid: without a surface there is no depth that compresses it, and all that
/// the correction does is damp. (Taylor-Green's vortices keep .23 of their energy with it, .30 without.)
fn is_full(scene: &Scene) -> bool {
    let (domain, size_m) = (&scene.domain, scene.domain.size_m());
    let axes = 0..domain.dimensions as usize;
    let is_closed = axes.clone().all(|axis| domain.periodic[axis] || domain.has_walls_along(axis));
    let blocks = scene.fluids.iter().filter_map(|fluid| fluid.block.as_ref());
    let share = |block: &Block| {
        axes.clone().map(|axis| (block.max_m[axis] - block.min_m[axis]) / size_m[axis]).product::<f64>()
    };
    is_closed && blocks.map(share).sum::<f64>() > 1.0 - 1e-6
}

/// Whether `scene` has a coarse correction, with these weights.
pub fn has_coarse_correction(scene: &Scene, weights: &IterationWeights) -> bool {
    !coarse_grid_params(scene, weights).is_empty()
}

/// What the shaders are given of each level of `scene`, finest first; none if it has no coarse correction.
pub fn coarse_grid_params(scene: &Scene, weights: &IterationWeights) -> Vec<CoarseGridParams> {
    let is_wanted = scene.solver.pbf.coarse_correction.unwrap_or_else(|| !is_full(scene));
    match is_wanted && weights.chebyshev.is_some() {
        true => levels(scene, scene.solver.pbf.cfm.max(LEAST_MIXING), 0.0),
        false => Vec::new(),
    }
}

/// The levels of a grid over `scene`, finest first; none where it would have too many cells, or too wide ones. `mixing` is
/// over the lattice's |∇C|²; no multiplier is below `least`.
pub(in crate::solver) fn levels(scene: &Scene, mixing: f64, least: f64) -> Vec<CoarseGridParams> {
    let finest = finest_cells(scene);
    if !are_few_cells(finest) || narrow_axis(scene).is_some() {
        return Vec::new();
    }
    let finest = finest.map(|n| n as u32);
    let (dimensions, support_ratio) = (scene.domain.dimensions, scene.solver.support_ratio);
    let axes = 0..dimensions as usize;
    let sides_m = sides_m(scene);
    let cell_m: [f64; 3] = std::array::from_fn(|axis| sides_m[axis] / f64::from(finest[axis]));
    let moment = second_moment(dimensions, support_ratio);
    let spacing_m = scene.support_m() / support_ratio;
    let along = |axis: usize, value: f64| if axes.contains(&axis) { value as f32 } else { 0.0 };
    let mixing = mixing * lattice(dimensions, support_ratio).stiffness;
    let level = |halvings: u32| CoarseGridParams {
        cells: finest.map(|n| n.div_ceil(1 << halvings)),
        halvings,
        finest_cells: finest,
        sweeps: SWEEPS[0],
        inverse_cell_size_per_m: std::array::from_fn(|axis| along(axis, 1.0 / cell_m[axis])),
        mixing: mixing as f32,
        conductance: std::array::from_fn(|axis| along(axis, (moment * scene.support_m() / cell_m[axis]).powi(2))),
        particles_a_cell: axes.clone().map(|axis| cell_m[axis] / spacing_m).product::<f64>() as f32,
        ends: std::array::from_fn(|axis| match () {
            () if scene.domain.periodic[axis] => COARSE_PERIODIC,
            () if scene.domain.has_walls_along(axis) || !axes.contains(&axis) => COARSE_WALL,
            () => COARSE_OPEN,
        }),
        most: MOST_MULTIPLIER as f32,
        least: least as f32,
        ..CoarseGridParams::default()
    };
    let mut levels = vec![level(0)];
    while levels.last().is_some_and(|last| last.cells.iter().any(|&n| n > COARSE_TILE)) {
        levels.push(level(levels.len() as u32));
    }
    if let Some(coarsest) = levels.last_mut() {
        coarsest.sweeps = SWEEPS[1];
    }
    levels
}

/// M = w Σ y² |W'|/r over the lattice: what a multiplier's slope moves a particle by, in h. Near 1: by parts it is
/// the integral of W.
fn second_moment(dimensions: u32, support_ratio: f64) -> f64 {
    let mut sum = 0.0;
    for_lattice(dimensions, support_ratio, |steps, q| {
        if steps != [0; 3] {
            sum += wendland_slope(q) / q * (f64::from(steps[1]) / support_ratio).powi(2);
        }
    });
    sum * lattice(dimensions, support_ratio).weight
}

impl CoarseCorrection {
    /// Declares the levels' buffers; none of no levels.
    pub(in crate::solver) fn declare(resources: &mut Resources, levels: Vec<CoarseGridParams>) -> Option<Self> {
        let levels: Vec<Level> = levels
            .into_iter()
            .enumerate()
            .map(|(level, given)| {
                let count = given.cells.iter().product();
                Level {
                    given,
                    params: resources.persistent(&format!("coarse_grid_{level}"), 1),
                    cells: resources.buffer(&format!("coarse_cells_{level}"), count),
                    multipliers: resources.buffer(&format!("coarse_multipliers_{level}"), count),
                    tiles: given.cells.map(|n| n.div_ceil(COARSE_TILE)),
                }
            })
            .collect();
        (!levels.is_empty()).then_some(Self { levels })
    }

    pub(in crate::solver) fn record_init(&mut self, init: &mut Recording) {
        for Level { given, params, .. } in &mut self.levels {
            init.upload(params, &[*given]);
        }
    }

    /// Empties the finest cells, to which the first iteration adds.
    pub(in crate::solver) fn clear(&mut self, recording: &mut Recording) {
        recording.clear(&mut self.levels[0].cells);
    }

    /// The finest level, for the iteration that adds to its cells.
    pub(in crate::solver) fn finest(&mut self) -> (&mut Buffer<CoarseCell>, &Buffer<CoarseGridParams>) {
        let Level { params, cells, .. } = &mut self.levels[0];
        (cells, params)
    }

    /// Solves for the multipliers of what is in the finest cells; those of the finest level.
    pub(in crate::solver) fn solve(&mut self, recording: &mut Recording) -> (&Buffer<f32>, &Buffer<CoarseGridParams>) {
        for n in 1..self.levels.len() {
            let (finer, coarser) = self.levels.split_at_mut(n);
            let Level { params, cells, .. } = &mut coarser[0];
            let count = cells.len;
            let kernel = CoarsenConstraint {
                finer_cells: finer[n - 1].cells.read(),
                coarse_cells: cells.write(),
                coarse: params.uniform(),
            };
            recording.dispatch(&kernel, count);
        }
        for n in (0..self.levels.len()).rev() {
            let (finer, coarser) = self.levels.split_at_mut(n + 1);
            let Level { params, cells, multipliers, tiles, .. } = &mut finer[n];
            let kernel = RelaxMultiplier {
                variant: RelaxMultiplierVariant { prolonged: !coarser.is_empty() },
                coarse_cells: cells.read(),
                coarser_multipliers: coarser.first().map(|level| level.multipliers.read()),
                multipliers: multipliers.write(),
                coarse: params.uniform(),
            };
            recording.dispatch_groups(&kernel, *tiles);
        }
        let Level { params, multipliers, .. } = &self.levels[0];
        (multipliers, params)
    }

    /// Solves for the multiplier, and adds it to the lambdas of the iteration that filled the cells.
    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        context: &StepContext,
        sorted: &Sorted,
        lambdas: &mut Lambdas,
        totals: Option<&mut Buffer<f32>>,
    ) {
        let (position_lambdas, packed_position_lambdas) = lambdas.write();
        let (multipliers, params) = self.solve(recording);
        context.slots.dispatch(
            recording,
            &ProlongMultiplier {
                variant: ProlongMultiplierVariant { precision: sorted.precision },
                sorted_positions: sorted.positions.read(),
                multipliers: multipliers.read(),
                position_lambdas,
                packed_position_lambdas,
                lambda_totals: totals.map(|totals| totals.write()),
                step_state: context.slots.state.uniform(),
                coarse: params.uniform(),
            },
        );
    }
}
