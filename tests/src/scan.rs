//! Prefix sums on the GPU, as the fluid records them.

use crate::harness::Bench;
use brooklet_fluid::grid::Scan;

/// All levels, as the fluid records them.
pub fn run_scan(values: &[u32]) -> Vec<u32> {
    let mut bench = Bench::new();
    let input = bench.input("values", values);
    let mut scanned = bench.output("scanned", values.len());
    let (resources, recording) = bench.parts();
    if !values.is_empty() {
        Scan::declare(resources, "test", values.len() as u32).record(recording, &input, &mut scanned);
    }
    bench.run().read(&scanned, values.len())
}
