//! A scene as the f64 twin of the whole chain.

use crate::cases::{pbf_of, walls_of};
use crate::compare::vector;
use brooklet_fluid::Scene;
use brooklet_kernels::{Position, Velocity};
use brooklet_reference::params::{Smoothing, Step};
use brooklet_reference::particles::predict::Particle;
use brooklet_reference::shared::lattice;
use brooklet_reference::step::Fluid;
use glam::{BVec3, DVec3};

/// The twin of `scene` with these particles, in their order.
pub fn twin(scene: &Scene, positions: &[Position], velocities: &[Velocity]) -> Fluid {
    let domain = &scene.domain;
    let size_m = DVec3::from_array(domain.size_m());
    let walls = BVec3::from_array(std::array::from_fn(|axis| domain.has_walls_along(axis)));
    let period_m = DVec3::from_array(scene.period_m());
    let mut around = walls_of(&brooklet_fluid::kernel::params(scene), size_m);
    around.axes = walls;
    Fluid {
        particles: positions
            .iter()
            .zip(velocities)
            .map(|(position, velocity)| Particle {
                position_m: vector(position.position_m),
                velocity_m_s: vector(velocity.velocity_m_s),
                quarantined: false,
            })
            .collect(),
        step: Step {
            gravity_m_s2: DVec3::from_array(scene.gravity_m_s2),
            dt_s: scene.substep_s(),
            domain_size_m: size_m,
            walls,
            period_m,
            wall_offset_m: scene.spacing_m / 2.0,
            max_speed_m_s: scene.max_speed_m_s(),
        },
        smoothing: Smoothing {
            period_m,
            ..Smoothing::new(scene.support_m(), lattice::weight(domain.dimensions, scene.solver.support_ratio))
        },
        pbf: pbf_of(&brooklet_fluid::solver::pbf::params(scene)),
        iterations: scene.solver.iterations,
        walls: domain.has_walls().then_some(around),
        grid_ends_at_domain: true,
    }
}
