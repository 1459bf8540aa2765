//! Seeded random numbers, and sizes around block edges.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Generator whose numbers are the same in every run and on every machine.
pub fn rng(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// Element counts at which a kernel of `group` threads a group may go wrong, in rising order:
/// nothing, one, and either side of one group, of several groups, and of a group of groups
/// (where the second phase of a reduce-then-scan needs a second group itself).
pub fn edge_sizes(group: usize) -> Vec<usize> {
    let blocks = [1, 2, 3, group, 2 * group];
    let mut sizes = vec![0, 1, 2, 3];
    for items in blocks.map(|blocks| blocks * group) {
        sizes.extend([items - 1, items, items + 1]);
    }
    sizes.sort_unstable();
    sizes.dedup();
    sizes
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    #[test]
    fn the_same_seed_gives_the_same_numbers() {
        assert_eq!(rng(7).next_u64(), rng(7).next_u64());
        assert_ne!(rng(7).next_u64(), rng(8).next_u64());
    }

    #[test]
    fn edge_sizes_rise_and_surround_each_block_edge() {
        for group in [1, 2, 64, 256] {
            let sizes = edge_sizes(group);
            assert!(sizes.is_sorted_by(|a, b| a < b), "{sizes:?}");
            for edge in [group, group * group] {
                for size in [edge - 1, edge, edge + 1] {
                    assert!(sizes.contains(&size), "{size} of group {group}");
                }
            }
        }
    }
}
