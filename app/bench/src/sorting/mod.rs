//! What each optimisation of the mobile deck's counting sort is worth
//! here, against the kernels of the product. What it was worth is in `app/fluid/SORTING.md`.

mod contest;
mod count;
mod locality;
mod scan;

use brooklet_fluid::grid;
use brooklet_gpu::{Gpu, tier_name};
use brooklet_kernels::{GridParams, Position};
use serde::Serialize;

use crate::{
    BenchError, Observer,
    workload::{EDGES, LOADS, jittered},
};
pub use contest::Outcome;
use contest::Ring;
use scan::Inner;

/// What is compared on how much, and how often.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Particles, rounded down to a size of the table.
    pub particles: u32,
    /// Pairs of runs of each comparison.
    pub pairs: usize,
}

/// Every comparison.
#[derive(Clone, Debug, Serialize)]
pub struct Sorting {
    /// What it ran on.
    pub device: String,
    /// `cpu` of a driver that runs on the processor.
    pub device_type: String,
    /// What the device was used as.
    pub tier: &'static str,
    /// Number of particles.
    pub particles: u32,
    /// In the order in which they ran.
    pub comparisons: Vec<Outcome>,
}

/// Runs every comparison.
///
/// # Errors
/// Every [`BenchError`]; two ways that give different results among them.
pub fn run(gpu: &Gpu, options: Options, observer: &dyn Observer) -> Result<Sorting, BenchError> {
    let ring = Ring { gpu, observer, pairs: options.pairs };
    let edge = EDGES.into_iter().filter(|edge| edge.pow(3) <= options.particles).max().unwrap_or(EDGES[0]);
    let scene = LOADS[0].scene(edge, &[])?;
    let particles = edge.pow(3);
    let fine = grid::params(&scene, particles);
    let emitted = jittered(&scene).positions;
    let shuffled = shuffled(emitted.clone());
    let sorted = in_cell_order(&shuffled, &fine);
    let mut outcomes = Vec::new();
    for (lie, positions) in [("where they began", &emitted), ("shuffled", &shuffled)] {
        let case = format!("sort, list, 4 lambdas; particles without locality lie {lie}");
        outcomes.push(locality::locality(&ring, case, &scene, &sorted, positions)?);
    }
    for (width, params) in [("h/2", fine), ("h", coarser(&fine))] {
        for (order, positions) in [("in cell order", in_cell_order(&shuffled, &params)), ("shuffled", shuffled.clone())]
        {
            let case = format!("cells of {width}, particles {order}");
            outcomes.push(count::aggregated_atomics(&ring, case, &positions, &params)?);
        }
    }
    let values = counts(&shuffled, &fine);
    let case = format!("{} cells", values.len());
    outcomes.push(scan::shared_memory(&ring, case.clone(), &values)?);
    let [tree, padded] = [false, true].map(|padded| Inner::Tree { padded });
    for (optimisation, ways) in [
        ("scan of a group", [Inner::Blocks, Inner::Doubling]),
        ("scan of a group", [Inner::Blocks, tree]),
        ("bank-conflict padding", [tree, padded]),
        ("bank-conflict padding", [Inner::Blocks, padded]),
    ] {
        outcomes.push(scan::inner(&ring, optimisation, case.clone(), &values, ways)?);
    }

    let info = gpu.info();
    Ok(Sorting {
        device: info.name.clone(),
        device_type: info.device_type.clone(),
        tier: tier_name(gpu.tier()),
        particles,
        comparisons: outcomes,
    })
}

/// Both ways have to give the same, or their times mean nothing.
fn equal(what: &str, baseline: Vec<u32>, alternative: Vec<u32>) -> Result<(), BenchError> {
    match baseline.iter().zip(&alternative).position(|(a, b)| a != b) {
        None if baseline.len() == alternative.len() => Ok(()),
        place => Err(BenchError::Stopped(format!("the two ways' {what} differ, first at {place:?}"))),
    }
}

/// The grid with cells twice as wide: the mobile deck's.
fn coarser(fine: &GridParams) -> GridParams {
    let cells = fine.cells.map(|count| count.div_ceil(2));
    GridParams {
        cells,
        domain_cells: cells,
        cell_count: cells.iter().product(),
        cell_size_m: 2.0 * fine.cell_size_m,
        inverse_cell_size_per_m: 0.5 * fine.inverse_cell_size_per_m,
        ..*fine
    }
}

fn cell_of(position: &Position, params: &GridParams) -> u32 {
    let [x, y, z] = position.position_m.map(|x_m| (x_m * params.inverse_cell_size_per_m) as u32);
    (z * params.cells[1] + y) * params.cells[0] + x
}

/// As the last step leaves them: particles keep their order where they keep their cell.
fn in_cell_order(positions: &[Position], params: &GridParams) -> Vec<Position> {
    let mut sorted = positions.to_vec();
    sorted.sort_by_key(|position| cell_of(position, params));
    sorted
}

/// Particles a cell, as the scan gets them.
fn counts(positions: &[Position], params: &GridParams) -> Vec<u32> {
    let mut counts = vec![0; params.cell_count as usize + 2];
    for position in positions {
        counts[cell_of(position, params) as usize] += 1;
    }
    counts
}

/// As after a long time without sorting what is known of a particle.
fn shuffled(mut positions: Vec<Position>) -> Vec<Position> {
    fastrand::Rng::with_seed(28).shuffle(&mut positions);
    positions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_between_the_ways_is_a_failure() {
        assert!(equal("sums", vec![1, 2], vec![1, 2]).is_ok());
        assert!(equal("sums", vec![1, 2], vec![1, 3]).is_err());
        assert!(equal("sums", vec![1, 2], vec![1]).is_err());
    }

    #[test]
    fn orders_keep_every_particle_and_cells_hold_them_all() {
        let scene = LOADS[0].scene(EDGES[0], &[]).unwrap();
        let fine = grid::params(&scene, 4096);
        let positions = jittered(&scene).positions;
        let mixed = shuffled(positions.clone());
        assert_ne!(mixed, positions);
        for params in [fine, coarser(&fine)] {
            assert_eq!(counts(&mixed, &params).iter().sum::<u32>(), 4096);
            let sorted = in_cell_order(&mixed, &params);
            assert!(sorted.is_sorted_by_key(|position| cell_of(position, &params)));
            let mut tags: Vec<u32> = sorted.iter().map(|position| position.tag).collect();
            tags.sort_unstable();
            assert!(tags.iter().enumerate().all(|(id, tag)| id as u32 == *tag));
        }
    }
}
