//! Exclusive prefix sums of any length by reduce-then-scan. (Shader: `grid/scan.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Kernel, ReduceGroups, SCAN_ITEMS, ScanGroups, ScanGroupsVariant};

/// Values a group scans.
pub const SCAN_GROUP: u32 = ScanGroups::GROUP_SIZE[0] * SCAN_ITEMS;

/// The buffers between the levels of a scan.
pub struct Scan {
    levels: Vec<Level>,
}

/// One level up: the groups' sums of the level below, and what they scan to.
struct Level {
    sums: Buffer<u32>,
    offsets: Buffer<u32>,
}

impl Scan {
    /// Declares what a scan of `count` values needs besides its input and output.
    pub fn declare(resources: &mut Resources, label: &str, count: u32) -> Self {
        let mut levels = Vec::new();
        let mut count = count;
        while count > SCAN_GROUP {
            count = count.div_ceil(SCAN_GROUP);
            let level = levels.len() + 1;
            levels.push(Level {
                sums: resources.buffer(&format!("{label}_sums_{level}"), count),
                offsets: resources.buffer(&format!("{label}_offsets_{level}"), count),
            });
        }
        Self { levels }
    }

    /// Scans `values` into `scanned`, both of the declared length.
    pub fn record(&mut self, recording: &mut Recording, values: &Buffer<u32>, scanned: &mut Buffer<u32>) {
        let mut below = values.alias();
        for level in &mut self.levels {
            reduce(recording, &below, &mut level.sums);
            below = level.sums.alias();
        }
        for index in (0..self.levels.len()).rev() {
            let (lower, upper) = self.levels.split_at_mut(index + 1);
            let level = &mut lower[index];
            scan(recording, &level.sums, upper.first().map(|above| &above.offsets), &mut level.offsets);
        }
        scan(recording, values, self.levels.first().map(|above| &above.offsets), scanned);
    }
}

fn reduce(recording: &mut Recording, values: &Buffer<u32>, sums: &mut Buffer<u32>) {
    let kernel = ReduceGroups { values: values.read(), group_sums: sums.write() };
    recording.dispatch(&kernel, values.len.div_ceil(SCAN_ITEMS));
}

fn scan(recording: &mut Recording, values: &Buffer<u32>, offsets: Option<&Buffer<u32>>, scanned: &mut Buffer<u32>) {
    let kernel = ScanGroups {
        variant: ScanGroupsVariant { group_offsets: offsets.is_some() },
        values: values.read(),
        group_offsets: offsets.map(Buffer::read),
        scanned: scanned.write(),
    };
    recording.dispatch(&kernel, values.len.div_ceil(SCAN_ITEMS));
}
