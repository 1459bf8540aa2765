//! Exclusive prefix sums of any length by reduce-then-scan. (Shader: `grid/scan.compute`.)

use std::mem::offset_of;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Kernel, ReduceGroups, SCAN_ITEMS, ScanGroups, ScanGroupsVariant, SearchGroups};

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
        self.record_if_due(recording, values, scanned, None);
    }

    /// The same with as many groups as the GPU says, of `values` and of the sums above them.
    pub(super) fn record_if_due(
        &mut self,
        recording: &mut Recording,
        values: &Buffer<u32>,
        scanned: &mut Buffer<u32>,
        due: Option<&Buffer<SearchGroups>>,
    ) {
        let mut below = values.alias();
        for (height, level) in self.levels.iter_mut().enumerate() {
            reduce(recording, &below, &mut level.sums, (due, height));
            below = level.sums.alias();
        }
        for index in (0..self.levels.len()).rev() {
            let (lower, upper) = self.levels.split_at_mut(index + 1);
            let level = &mut lower[index];
            let above = upper.first().map(|above| &above.offsets);
            scan(recording, &level.sums, above, &mut level.offsets, (due, index + 1));
        }
        scan(recording, values, self.levels.first().map(|above| &above.offsets), scanned, (due, 0));
    }
}

/// Groups that sum up and scan `count` values, of the groups' sums, and of sums of these.
pub(crate) fn scan_groups(count: u32) -> [u32; 3] {
    let groups = |values: u32| values.div_ceil(SCAN_GROUP);
    [groups(count), groups(groups(count)), groups(groups(groups(count)))]
}

/// A dispatch over `count` values that stand so many levels up, of as many groups as are due.
fn dispatch<K: Kernel>(recording: &mut Recording, kernel: &K, count: u32, (due, height): Due<'_>) {
    let items = count.div_ceil(SCAN_ITEMS);
    let offset = match height {
        0 => offset_of!(SearchGroups, cells),
        1 => offset_of!(SearchGroups, sums),
        _ => offset_of!(SearchGroups, sums_of_sums),
    };
    match due {
        Some(due) => recording.dispatch_indirect(kernel, due, offset as u32, items),
        None => recording.dispatch(kernel, items),
    }
}

/// Where the GPU says how many groups are due, if it does, and how many levels up they are.
type Due<'a> = (Option<&'a Buffer<SearchGroups>>, usize);

fn reduce(recording: &mut Recording, values: &Buffer<u32>, sums: &mut Buffer<u32>, due: Due<'_>) {
    let kernel = ReduceGroups { values: values.read(), group_sums: sums.write() };
    dispatch(recording, &kernel, values.len, due);
}

fn scan(
    recording: &mut Recording,
    values: &Buffer<u32>,
    offsets: Option<&Buffer<u32>>,
    scanned: &mut Buffer<u32>,
    due: Due<'_>,
) {
    let kernel = ScanGroups {
        variant: ScanGroupsVariant { group_offsets: offsets.is_some() },
        values: values.read(),
        group_offsets: offsets.map(Buffer::read),
        scanned: scanned.write(),
    };
    dispatch(recording, &kernel, values.len, due);
}
