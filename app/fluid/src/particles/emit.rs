//! Fills the scene's fluids with lattices of particles.

use brooklet_kernels::{FLUID_SHIFT, Position, Velocity};

use crate::scene::{Fluid, Scene};

/// What a tag's bits below the fluid's number can tell apart.
pub const MAX_PARTICLES: u32 = 1 << FLUID_SHIFT;

/// The particles at the start, in the order of their ids.
#[derive(Clone, Debug, Default)]
pub struct Emitted {
    /// Relative to the domain's lowest corner.
    pub positions: Vec<Position>,
    /// As long as `positions`.
    pub velocities: Vec<Velocity>,
}

/// Puts a cubic lattice of spacing d into each fluid. A block's lattice starts half a spacing
/// inside it, so that fluid against a wall is where the wall expects it; a ball's is centred on
/// it. Where fluids overlap, the first has the place.
pub fn emit(scene: &Scene) -> Emitted {
    let mut emitted = Emitted::default();
    for (index, fluid) in scene.fluids.iter().enumerate() {
        let taken: Vec<&Fluid> = scene.fluids[..index].iter().collect();
        for place_m in lattice(fluid, scene.spacing_m) {
            if taken.iter().any(|earlier| earlier.contains(place_m)) {
                continue;
            }
            let id = emitted.positions.len() as u32;
            emitted.positions.push(Position {
                position_m: std::array::from_fn(|axis| (place_m[axis] - scene.domain.min_m[axis]) as f32),
                tag: id | (index as u32) << FLUID_SHIFT,
            });
            emitted.velocities.push(Velocity { velocity_m_s: fluid.velocity_m_s.map(|v| v as f32), reserved: 0.0 });
        }
    }
    emitted
}

/// Lattice points of one fluid, x fastest.
fn lattice(fluid: &Fluid, spacing_m: f64) -> Vec<[f64; 3]> {
    let (first_m, counts): ([f64; 3], [usize; 3]) = if let Some(block) = &fluid.block {
        // A side within a hundredth of a spacing of a whole number of spacings counts as that
        // number, so that 0.3 / 0.1 is 3.
        let counts: [usize; 3] =
            std::array::from_fn(|axis| ((block.max_m[axis] - block.min_m[axis]) / spacing_m + 0.01).floor() as usize);
        (block.min_m.map(|x| x + 0.5 * spacing_m), counts)
    } else if let Some(sphere) = &fluid.sphere {
        let half = (sphere.radius_m / spacing_m).floor();
        (sphere.centre_m.map(|x| x - half * spacing_m), [2 * half as usize + 1; 3])
    } else {
        return Vec::new();
    };
    let mut points = Vec::with_capacity(counts.iter().product());
    for z in 0..counts[2] {
        for y in 0..counts[1] {
            for x in 0..counts[0] {
                let place_m = std::array::from_fn(|axis| first_m[axis] + [x, y, z][axis] as f64 * spacing_m);
                if fluid.contains(place_m) {
                    points.push(place_m);
                }
            }
        }
    }
    points
}

impl Fluid {
    fn contains(&self, place_m: [f64; 3]) -> bool {
        if let Some(block) = &self.block {
            (0..3).all(|axis| (block.min_m[axis]..=block.max_m[axis]).contains(&place_m[axis]))
        } else if let Some(sphere) = &self.sphere {
            let squared_m2: f64 = (0..3).map(|axis| (place_m[axis] - sphere.centre_m[axis]).powi(2)).sum();
            squared_m2 <= sphere.radius_m.powi(2)
        } else {
            false
        }
    }
}
