//! Where and how prefix sums are made: groupshared or global memory, and the layout of the former.

use brooklet_fluid::grid::{SCAN_GROUP, Scan};
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, SCAN_ITEMS, ScanGroups, ScanGroupsVariant};

use super::contest::{Names, Outcome, Ring, Ways};
use crate::{
    BenchError,
    kernels::{ScanGroupsDoubling, ScanGroupsDoublingVariant, ScanGroupsTree, ScanGroupsTreeVariant, ScanStep},
};

/// The whole scan of `values`: reduce-then-scan in groupshared memory, or a dispatch for each
/// doubling in global memory.
pub fn shared_memory(ring: &Ring<'_>, case: String, values: &[u32]) -> Result<Outcome, BenchError> {
    let count = values.len() as u32;
    let mut resources = Resources::new();
    let mut input = resources.persistent("values", count);
    let mut scanned = resources.persistent("scanned", count);
    let mut scan = Scan::declare(&mut resources, "baseline", count);
    let mut turns = [resources.persistent("even", count), resources.persistent("odd", count)];
    let Ways { mut init, mut baseline, mut alternative } = Ways::declare(&mut resources);
    init.upload(&mut input, values);
    scan.record(&mut baseline, &input, &mut scanned);

    let reaches =
        std::iter::once(0).chain((0..32).map(|bit| 1_u64 << bit).take_while(|reach| *reach < values.len() as u64));
    let mut last = 0;
    for (turn, reach) in reaches.enumerate() {
        let mut buffer = resources.persistent(&format!("reach_{reach}"), 1);
        init.upload(&mut buffer, &[reach as u32]);
        let (even, odd) = turns.split_at_mut(1);
        let (from, to) = if turn % 2 == 0 { (&odd[0], &mut even[0]) } else { (&even[0], &mut odd[0]) };
        let from: &Buffer<u32> = if turn == 0 { &input } else { from };
        alternative.dispatch(&ScanStep { values: from.read(), reach: buffer.read(), scanned: to.write() }, count);
        last = turn % 2;
    }
    let names = Names {
        optimisation: "shared-memory scan",
        case,
        baseline: "groupshared memory",
        alternative: "global memory",
    };
    ring.compare(names, resources, Ways { init, baseline, alternative }, |engine| {
        let [a, b] = [engine.read(&scanned), engine.read(&turns[last])];
        super::equal("sums", a.map_err(BenchError::stopped)?, b.map_err(BenchError::stopped)?)
    })
}

/// How the scan of a group's threads is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inner {
    /// Sums of blocks of threads, then of blocks: the product's.
    Blocks,
    /// Hillis & Steele's.
    Doubling,
    /// Blelloch's tree.
    Tree { padded: bool },
}

impl Inner {
    fn name(self) -> &'static str {
        match self {
            Inner::Blocks => "blocks of threads",
            Inner::Doubling => "doubling (Hillis & Steele)",
            Inner::Tree { padded: false } => "tree (Blelloch)",
            Inner::Tree { padded: true } => "tree, padded",
        }
    }

    fn dispatch(
        self,
        recording: &mut Recording,
        values: &Buffer<u32>,
        offsets: &Buffer<u32>,
        scanned: &mut Buffer<u32>,
    ) {
        let threads = values.len.div_ceil(SCAN_ITEMS);
        let (values, group_offsets, scanned) = (values.read(), Some(offsets.read()), scanned.write());
        match self {
            Inner::Blocks => {
                let variant = ScanGroupsVariant { group_offsets: true };
                recording.dispatch(&ScanGroups { variant, values, group_offsets, scanned }, threads);
            }
            Inner::Doubling => {
                let variant = ScanGroupsDoublingVariant { group_offsets: true };
                recording.dispatch(&ScanGroupsDoubling { variant, values, group_offsets, scanned }, threads);
            }
            Inner::Tree { padded } => {
                let variant = ScanGroupsTreeVariant { group_offsets: true, padded };
                recording.dispatch(&ScanGroupsTree { variant, values, group_offsets, scanned }, threads);
            }
        }
    }
}

/// The lowest level of the scan of `values` two ways, the groups' offsets given.
pub fn inner(
    ring: &Ring<'_>,
    optimisation: &'static str,
    case: String,
    values: &[u32],
    ways: [Inner; 2],
) -> Result<Outcome, BenchError> {
    let count = values.len() as u32;
    let offsets: Vec<u32> = values
        .chunks(SCAN_GROUP as usize)
        .scan(0_u32, |before, group| {
            let here = *before;
            *before += group.iter().sum::<u32>();
            Some(here)
        })
        .collect();
    let mut resources = Resources::new();
    let mut input = resources.persistent("values", count);
    let mut group_offsets = resources.persistent("group_offsets", offsets.len() as u32);
    let mut scanned = [resources.persistent("scanned_a", count), resources.persistent("scanned_b", count)];
    let Ways { mut init, mut baseline, mut alternative } = Ways::declare(&mut resources);
    init.upload(&mut input, values);
    init.upload(&mut group_offsets, &offsets);
    for ((way, recording), scanned) in ways.into_iter().zip([&mut baseline, &mut alternative]).zip(&mut scanned) {
        way.dispatch(recording, &input, &group_offsets, scanned);
    }
    let names = Names { optimisation, case, baseline: ways[0].name(), alternative: ways[1].name() };
    ring.compare(names, resources, Ways { init, baseline, alternative }, |engine| {
        let [a, b] = [engine.read(&scanned[0]), engine.read(&scanned[1])];
        super::equal("sums", a.map_err(BenchError::stopped)?, b.map_err(BenchError::stopped)?)
    })
}
