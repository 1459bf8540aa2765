//! Brings inactive slots behind all particles. (Shader: `emitters/compact.compute`.)

/// Which slot's particle moves where: the k-th behind as many slots as there are particles into the k-th empty one before; and
/// how many particles there are.
pub fn compact(is_active: &[bool]) -> (Vec<[usize; 2]>, usize) {
    let active = is_active.iter().filter(|active| **active).count();
    let holes = (0..active).filter(|slot| !is_active[*slot]);
    let movers = (active..is_active.len()).filter(|slot| is_active[*slot]);
    (movers.zip(holes).map(|(from, to)| [from, to]).collect(), active)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_move_as_there_are_holes() {
        let is_active = [true, false, true, false, false, true, true];
        assert_eq!(compact(&is_active), (vec![[5, 1], [6, 3]], 4));
        assert_eq!(compact(&[false; 3]), (vec![], 0));
        assert_eq!(compact(&[true; 3]), (vec![], 3));
    }
}
