//! The neighbour list's encoding: ascending indices as 16-bit gaps. (Shader: `shared/list.hlsl`.)

use brooklet_kernels::{LIST_CHUNK, LIST_NOBODY, LIST_SLICE, LIST_WIDEST_GAP, ListHead};

/// Where entry `entry` of particle `i` stands in lists of `chunks` runs: which run, and where in it.
pub fn place(i: usize, entry: usize, chunks: u32) -> (usize, usize) {
    let (slice, run) = (LIST_SLICE as usize, LIST_CHUNK as usize);
    ((i / slice * chunks as usize + entry / run) * slice + i % slice, entry % run)
}

/// The gaps of ascending `neighbours`, counted from `first` - 1: too wide a gap takes an entry of its
/// own, which stands for nobody, for each time that the widest one fits.
///
/// # Panics
/// When they do not ascend, or begin before `first`.
pub fn gaps(first: u32, neighbours: &[usize]) -> Vec<u32> {
    let mut gaps = Vec::new();
    let mut last = i64::from(first) - 1;
    for &j in neighbours {
        let mut gap = j as i64 - last;
        assert!(gap > 0, "{j} after {last}");
        while gap > i64::from(LIST_WIDEST_GAP) {
            gaps.push(LIST_NOBODY);
            gap -= i64::from(LIST_WIDEST_GAP);
        }
        gaps.push(gap as u32);
        last = j as i64;
    }
    gaps
}

/// The neighbours that gaps stand for.
pub fn followed(first: u32, gaps: &[u32]) -> Vec<usize> {
    let mut last = i64::from(first) - 1;
    let mut neighbours = Vec::new();
    for &gap in gaps {
        if gap == LIST_NOBODY {
            last += i64::from(LIST_WIDEST_GAP);
        } else {
            last += i64::from(gap);
            neighbours.push(last as usize);
        }
    }
    neighbours
}

/// The lists of all particles, in `chunks` runs a particle, as the shaders have them; what no list
/// uses stands for nobody.
///
/// # Panics
/// When a list does not fit.
pub fn encoded(neighbours: &[Vec<usize>], chunks: u32) -> (Vec<[u32; 2]>, Vec<ListHead>) {
    let slices = neighbours.len().div_ceil(LIST_SLICE as usize);
    let mut lists = vec![[LIST_NOBODY; 2]; slices * LIST_SLICE as usize * chunks as usize];
    let mut heads = Vec::with_capacity(neighbours.len());
    for (i, list) in neighbours.iter().enumerate() {
        let first = list.first().map_or(0, |&j| j as u32);
        let gaps = gaps(first, list);
        assert!(gaps.len() <= (chunks * LIST_CHUNK) as usize, "{} entries", gaps.len());
        for (entry, &gap) in gaps.iter().enumerate() {
            let (at, part) = place(i, entry, chunks);
            lists[at][part / 2] |= gap << (16 * (part % 2));
        }
        heads.push(ListHead { entries: gaps.len() as u32, first });
    }
    (lists, heads)
}

/// Entry `entry` of particle `i`.
pub fn entry(i: usize, entry: usize, lists: &[[u32; 2]], chunks: u32) -> u32 {
    let (at, part) = place(i, entry, chunks);
    lists[at][part / 2] >> (16 * (part % 2)) & 0xffff
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_lead_back_to_the_neighbours() {
        let wide = LIST_WIDEST_GAP as usize;
        for list in [
            vec![],
            vec![0],
            vec![5, 6, 9],
            vec![3, 3 + wide, 3 + 2 * wide + 1, 20_000_000],
            vec![0, wide - 1, 2 * wide, 4 * wide],
        ] {
            for first in [0, list.first().map_or(0, |&j| j as u32)] {
                let gaps = gaps(first, &list);
                assert!(gaps.iter().all(|&gap| gap <= LIST_WIDEST_GAP));
                assert_eq!(followed(first, &gaps), list);
            }
        }
        // As wide as it gets is one entry; one more is two.
        assert_eq!(gaps(0, &[0, wide]), [1, LIST_WIDEST_GAP]);
        assert_eq!(gaps(0, &[0, wide + 1]), [1, LIST_NOBODY, 1]);
    }

    #[test]
    fn lists_hold_their_entries() {
        let neighbours: Vec<Vec<usize>> = (0..131).map(|i| (i..i + i % 12).collect()).collect();
        let (lists, heads) = encoded(&neighbours, 3);
        assert_eq!(lists.len(), 192 * 3);
        for (i, head) in heads.iter().enumerate() {
            let gaps: Vec<u32> = (0..head.entries as usize).map(|k| entry(i, k, &lists, 3)).collect();
            assert_eq!(followed(head.first, &gaps), neighbours[i]);
            assert!((gaps.len()..12).all(|k| entry(i, k, &lists, 3) == LIST_NOBODY));
        }
    }
}
