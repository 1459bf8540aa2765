//! `grid/scan.compute` against its twins.

use brooklet_kernels::{Kernel, ReduceGroups, SCAN_ITEMS, ScanGroups, ScanGroupsVariant};
use brooklet_reference::grid::scan;
use brooklet_tests::compare::{check_exact, report_exact};
use brooklet_tests::harness::{Bench, few_cases, small};
use brooklet_tests::rng;
use brooklet_tests::scan::run_scan;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use rand::{Rng, RngExt};

/// Values of a group.
const SCAN_GROUP: u32 = SCAN_ITEMS * ScanGroups::GROUP_SIZE[0];

fn run_reduce(values: &[u32]) -> Vec<u32> {
    let groups = values.len().div_ceil(SCAN_GROUP as usize);
    let mut bench = Bench::new();
    let input = bench.input("values", values);
    let mut sums = bench.output("group_sums", groups);
    let kernel = ReduceGroups { values: input.read(), group_sums: sums.write() };
    bench.dispatch(&kernel, values.len().div_ceil(SCAN_ITEMS as usize));
    bench.run().read(&sums, groups)
}

fn run_scan_groups(values: &[u32], offsets: Option<&[u32]>) -> Vec<u32> {
    let mut bench = Bench::new();
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

#[test]
fn reduce_and_scan_groups_match_their_twins() {
    let mut rng = rng(22);
    let group = SCAN_GROUP as usize;
    let mut cases = 0;
    for size in [0, 1, 3, 4, 5, group - 1, group, group + 1, 3 * group, 7 * group + 333] {
        let values = numbers(&mut rng, size);
        check_exact(&run_reduce(&values), &scan::reduce_groups(&values, group)).unwrap();
        check_exact(&run_scan_groups(&values, None), &scan::scan_groups(&values, group, None)).unwrap();
        let offsets = numbers(&mut rng, size.div_ceil(group));
        let expected = scan::scan_groups(&values, group, Some(&offsets));
        check_exact(&run_scan_groups(&values, Some(&offsets)), &expected).unwrap();
        cases += size;
    }
    report_exact(ReduceGroups::STAGE, cases);
    report_exact(ScanGroups::STAGE, 2 * cases);
}

#[test]
fn scan_of_several_levels_matches_its_twin() {
    let mut rng = rng(23);
    let group = SCAN_GROUP as usize;
    let mut sizes = vec![0, 1, group, group + 1, 20 * group + 77, group * group];
    if !small() {
        // A third level.
        sizes.extend([group * group + 1, 3 * group * group + 1234]);
    }
    let mut cases = 0;
    for size in sizes {
        let values = numbers(&mut rng, size);
        check_exact(&run_scan(&values), &scan::scan(&values)).unwrap();
        cases += size;
    }
    report_exact("scan of several levels", cases);
}

#[test]
fn scan_of_anything() {
    let lengths = 0..3000_usize;
    let values = proptest::collection::vec(any::<u32>(), lengths);
    few_cases()
        .run(&values, |values| check_exact(&run_scan(&values), &scan::scan(&values)).map_err(TestCaseError::fail))
        .unwrap();
}
