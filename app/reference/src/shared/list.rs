//! The neighbour list's encoding: ascending indices as 16-bit deltas. (Shader: `shared/list.hlsli`.)

use brooklet_kernels::{LIST_CHUNK, LIST_ESCAPE, LIST_ESCAPE_DELTA, LIST_SLICE, ListHead};

/// Where entry `entry` of particle `i` stands in lists of `chunks` runs: which run, and where in it.
pub fn entry_slot(i: usize, entry: usize, chunks: u32) -> (usize, usize) {
    let (slice, run) = (LIST_SLICE as usize, LIST_CHUNK as usize);
    ((i / slice * chunks as usize + entry / run) * slice + i % slice, entry % run)
}

/// The deltas of ascending `neighbours`, counted from `first` - 1: a delta wider than an escape's takes an
/// escape, which stands for nobody, for each time that one fits.
///
/// # Panics
/// When they do not ascend, or begin before `first`.
pub fn deltas(first: u32, neighbours: &[usize]) -> Vec<u32> {
    let mut deltas = Vec::new();
    let mut last = i64::from(first) - 1;
    for &j in neighbours {
        let mut delta = j as i64 - last;
        assert!(delta > 0, "{j} after {last}");
        while delta > i64::from(LIST_ESCAPE_DELTA) {
            deltas.push(LIST_ESCAPE);
            delta -= i64::from(LIST_ESCAPE_DELTA);
        }
        deltas.push(delta as u32);
        last = j as i64;
    }
    deltas
}

/// The neighbours that deltas stand for.
pub fn followed(first: u32, deltas: &[u32]) -> Vec<usize> {
    let mut last = i64::from(first) - 1;
    let mut neighbours = Vec::new();
    for &delta in deltas {
        if delta == LIST_ESCAPE {
            last += i64::from(LIST_ESCAPE_DELTA);
        } else {
            last += i64::from(delta);
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
    let mut lists = vec![[LIST_ESCAPE; 2]; slices * LIST_SLICE as usize * chunks as usize];
    let mut heads = Vec::with_capacity(neighbours.len());
    for (i, list) in neighbours.iter().enumerate() {
        let first = list.first().map_or(0, |&j| j as u32);
        let deltas = deltas(first, list);
        assert!(deltas.len() <= (chunks * LIST_CHUNK) as usize, "{} entries", deltas.len());
        for (entry, &delta) in deltas.iter().enumerate() {
            let (at, part) = entry_slot(i, entry, chunks);
            lists[at][part / 2] |= delta << (16 * (part % 2));
        }
        heads.push(ListHead { entries: deltas.len() as u32, first });
    }
    (lists, heads)
}

/// Entry `entry` of particle `i`.
pub fn entry(i: usize, entry: usize, lists: &[[u32; 2]], chunks: u32) -> u32 {
    let (at, part) = entry_slot(i, entry, chunks);
    lists[at][part / 2] >> (16 * (part % 2)) & 0xffff
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_lead_back_to_the_neighbours() {
        let wide = LIST_ESCAPE_DELTA as usize;
        for list in [
            vec![],
            vec![0],
            vec![5, 6, 9],
            vec![3, 3 + wide, 3 + 2 * wide + 1, 20_000_000],
            vec![0, wide - 1, 2 * wide, 4 * wide],
        ] {
            for first in [0, list.first().map_or(0, |&j| j as u32)] {
                let deltas = deltas(first, &list);
                assert!(deltas.iter().all(|&delta| delta <= LIST_ESCAPE_DELTA));
                assert_eq!(followed(first, &deltas), list);
            }
        }
        // As wide as it gets is one entry; one more is two.
        assert_eq!(deltas(0, &[0, wide]), [1, LIST_ESCAPE_DELTA]);
        assert_eq!(deltas(0, &[0, wide + 1]), [1, LIST_ESCAPE, 1]);
    }

    #[test]
    fn lists_hold_their_entries() {
        let neighbours: Vec<Vec<usize>> = (0..131).map(|i| (i..i + i % 12).collect()).collect();
        let (lists, heads) = encoded(&neighbours, 3);
        assert_eq!(lists.len(), 192 * 3);
        for (i, head) in heads.iter().enumerate() {
            let deltas: Vec<u32> = (0..head.entries as usize).map(|k| entry(i, k, &lists, 3)).collect();
            assert_eq!(followed(head.first, &deltas), neighbours[i]);
            assert!((deltas.len()..12).all(|k| entry(i, k, &lists, 3) == LIST_ESCAPE));
        }
    }
}
