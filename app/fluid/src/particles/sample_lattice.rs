//! Fills the scene's fluids with lattices of particles.

use brooklet_kernels::{FLUID_SHIFT, INACTIVE_FLUID, Position, Velocity};

use crate::scene::{Fluid, Scene, for_each_point};

/// Where particles are, and how they move. A start has them in the order of their ids, a running fluid in
/// that of its cells; any will do.
#[derive(Clone, Debug, Default)]
pub struct ParticleSet {
    /// Relative to the domain's lowest corner.
    pub positions: Vec<Position>,
    /// As long as `positions`.
    pub velocities: Vec<Velocity>,
}

impl ParticleSet {
    /// Appends inactive slots until there are `capacity`. Ids so far are those below the number of slots so far.
    pub fn fill_slots(&mut self, capacity: u32) {
        let slots = self.positions.len() as u32..capacity;
        let tag = |id| id | INACTIVE_FLUID << FLUID_SHIFT;
        self.velocities.extend(slots.clone().map(|_| Velocity::default()));
        self.positions.extend(slots.map(|id| Position { position_m: [0.0; 3], tag: tag(id) }));
    }
}

/// Puts a cubic lattice of spacing d into each fluid. A block's lattice starts half a spacing inside it, so that fluid
/// against a wall is where the wall expects it, and fills it from wall to wall (`scene/lattice.rs`); a ball's is centred on it.
/// Where fluids overlap, the first has the particle. In two dimensions the lattice is one layer, in the domain's plane.
pub fn sample_lattice(scene: &Scene) -> ParticleSet {
    let mut particles = ParticleSet::default();
    for_each_point(scene, |index, fluid, place_m| {
        let id = particles.positions.len() as u32;
        particles.positions.push(Position {
            position_m: std::array::from_fn(|axis| (place_m[axis] - scene.domain.min_m[axis]) as f32),
            tag: id | (index as u32) << FLUID_SHIFT,
        });
        particles.velocities.push(Velocity { velocity_m_s: velocity_m_s(fluid, id).map(|v| v as f32), age_s: 0.0 });
    });
    particles
}

/// The velocity that the particle of an id begins with.
fn velocity_m_s(fluid: &Fluid, id: u32) -> [f64; 3] {
    let mut rng = fastrand::Rng::with_seed(u64::from(id));
    std::array::from_fn(|axis| match fluid.velocity_spread_m_s[axis] {
        0.0 => fluid.velocity_m_s[axis],
        spread_m_s => fluid.velocity_m_s[axis] + spread_m_s * (2.0 * rng.f64() - 1.0),
    })
}
