//! Aggregated atomics: one for each run of particles of a cell, or one for each particle.

use brooklet_fluid::visit_slots;
use brooklet_gpu::Resources;
use brooklet_kernels::{CountCells, CountCellsVariant, GridParams, Position};

use super::contest::{Names, Outcome, Ring, Ways};
use crate::{BenchError, kernels::CountCellsAggregated};

/// Counts `positions` both ways.
pub fn aggregated_atomics(
    ring: &Ring<'_>,
    case: String,
    positions: &[Position],
    params: &GridParams,
) -> Result<Outcome, BenchError> {
    let count = positions.len() as u32;
    let cells = params.cell_count + 2;
    let mut resources = Resources::new();
    let mut at = resources.persistent("positions", count);
    let mut grid = resources.persistent("grid", 1);
    let mut step_state = resources.persistent("step_state", 1);
    let mut counts = [resources.persistent("counts_a", cells), resources.persistent("counts_b", cells)];
    let mut slots = [resources.persistent("slots_a", count), resources.persistent("slots_b", count)];
    let Ways { mut init, mut baseline, mut alternative } = Ways::declare(&mut resources);
    init.upload(&mut at, positions);
    init.upload(&mut grid, &[*params]);
    init.upload(&mut step_state, &[visit_slots(count)]);

    baseline.clear(&mut counts[0]);
    baseline.dispatch(
        &CountCells {
            variant: CountCellsVariant::default(),
            positions: at.read(),
            cell_counts: counts[0].write(),
            cell_slots: slots[0].write(),
            step_state: step_state.uniform(),
            grid: grid.uniform(),
        },
        count,
    );
    alternative.clear(&mut counts[1]);
    alternative.dispatch(
        &CountCellsAggregated {
            positions: at.read(),
            cell_counts: counts[1].write(),
            cell_slots: slots[1].write(),
            step_state: step_state.uniform(),
            grid: grid.uniform(),
        },
        count,
    );
    let names = Names {
        optimisation: "aggregated atomics",
        case,
        baseline: "an atomic a particle",
        alternative: "an atomic a run",
    };
    ring.compare(names, resources, Ways { init, baseline, alternative }, |engine| {
        let [a, b] = [engine.read(&counts[0]), engine.read(&counts[1])];
        super::equal("counts", a.map_err(BenchError::stopped)?, b.map_err(BenchError::stopped)?)
    })
}
