//! `grid/scan.compute` against its twins.

use crate::bench::run_scan;
use crate::bench::{Bench, few_cases};
use crate::compare::{check_exact, report_exact};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::OrRaise as _;
use brooklet_kernels::{Kernel, ReduceGroups, SCAN_ITEMS, ScanGroups, ScanGroupsVariant};
use brooklet_reference::grid::scan;
use rand::{Rng, RngExt};

/// Values of a group.
const SCAN_GROUP: u32 = SCAN_ITEMS * ScanGroups::GROUP_SIZE[0];

fn run_reduce(device: &Device, values: &[u32]) -> Vec<u32> {
    let groups = values.len().div_ceil(SCAN_GROUP as usize);
    let mut bench = Bench::new(device);
    let input = bench.input("values", values);
    let mut sums = bench.output("group_sums", groups);
    let kernel = ReduceGroups { values: input.read(), group_sums: sums.write() };
    bench.dispatch(&kernel, values.len().div_ceil(SCAN_ITEMS as usize));
    bench.run().read(&sums, groups)
}

fn run_scan_groups(device: &Device, values: &[u32], offsets: Option<&[u32]>) -> Vec<u32> {
    let mut bench = Bench::new(device);
    let input = bench.input("values", values);
    let offsets = offsets.map(|offsets| bench.input("group_offsets", offsets));
    let mut scanned = bench.output("scanned", values.len());
    let kernel = ScanGroups {
        variant: ScanGroupsVariant { group_offsets: offsets.is_some() },
        values: input.read(),
        group_offsets: offsets.as_ref().map(|offsets| offsets.read()),
        scanned: scanned.write(),
    };
    bench.dispatch(&kernel, values.len().div_ceil(SCAN_ITEMS as usize));
    bench.run().read(&scanned, values.len())
}

fn numbers(rng: &mut impl Rng, count: usize) -> Vec<u32> {
    (0..count).map(|_| rng.random()).collect()
}

pub(crate) fn reduce_and_scan_groups_match_their_twins(device: &Device) {
    let mut rng = rng(22);
    let group = SCAN_GROUP as usize;
    let mut cases = 0;
    for size in [0, 1, 3, 4, 5, group - 1, group, group + 1, 3 * group, 7 * group + 333] {
        let values = numbers(&mut rng, size);
        check_exact(&run_reduce(device, &values), &scan::reduce_groups(&values, group)).or_raise();
        check_exact(&run_scan_groups(device, &values, None), &scan::scan_groups(&values, group, None)).or_raise();
        let offsets = numbers(&mut rng, size.div_ceil(group));
        let expected = scan::scan_groups(&values, group, Some(&offsets));
        check_exact(&run_scan_groups(device, &values, Some(&offsets)), &expected).or_raise();
        cases += size;
    }
    report_exact(device, ReduceGroups::STAGE, cases);
    report_exact(device, ScanGroups::STAGE, 2 * cases);
}

pub(crate) fn scan_of_several_levels_matches_its_twin(device: &Device) {
    let mut rng = rng(23);
    let group = SCAN_GROUP as usize;
    let mut sizes = vec![0, 1, group, group + 1, 20 * group + 77, group * group];
    if !device.small() {
        // A third level.
        sizes.extend([group * group + 1, 3 * group * group + 1234]);
    }
    let mut cases = 0;
    for size in sizes {
        let values = numbers(&mut rng, size);
        check_exact(&run_scan(device, &values), &scan::scan(&values)).or_raise();
        cases += size;
    }
    report_exact(device, "scan of several levels", cases);
}

pub(crate) fn scan_of_anything(device: &Device) {
    for mut rng in few_cases(device) {
        let count = rng.random_range(0..3000);
        let values = numbers(&mut rng, count);
        check_exact(&run_scan(device, &values), &scan::scan(&values)).or_raise();
    }
}
