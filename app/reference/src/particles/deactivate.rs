//! Which particles a box deactivates. (Shader: `particles/deactivate.compute`.)

use glam::DVec3;

/// Whether the particle is in the box from `min_m` to `max_m`, its faces among it.
pub fn deactivates(position_m: DVec3, min_m: DVec3, max_m: DVec3) -> bool {
    position_m.cmpge(min_m).all() && position_m.cmple(max_m).all()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_are_among_the_box() {
        let (min_m, max_m) = (DVec3::ZERO, DVec3::ONE);
        assert!(deactivates(min_m, min_m, max_m) && deactivates(max_m, min_m, max_m));
        assert!(!deactivates(DVec3::new(0.5, 0.5, 1.01), min_m, max_m));
        assert!(!deactivates(min_m, max_m, min_m), "a box turned inside out has nothing in it");
    }
}
