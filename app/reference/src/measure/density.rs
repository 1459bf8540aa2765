//! Density over its rest value. (Shader: `measure/density.hlsli`.)

use crate::boundary::mirror::Mirrors;
use crate::boundary::sample_boundary;
use crate::boundary::walls::DomainWalls;
use crate::params::Smoothing;
use crate::shared::wendland;
use crate::solver::dfsph::factor_pressure::factor_pressure;
use glam::DVec3;

/// Density ratio of particle `i`: itself, its neighbours, the boundary.
pub fn density_ratio(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    walls: Option<&DomainWalls>,
) -> f64 {
    let near: f64 =
        neighbours.iter().map(|&j| wendland::kernel(smoothing.offset(positions_m[i], positions_m[j]).length())).sum();
    smoothing.weight * (wendland::kernel(0.0) + near) + sample_boundary(positions_m[i], walls).density
}

/// The same where walls mirror the fluid.
pub fn mirrored_density_ratio(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    walls: Option<&DomainWalls>,
) -> f64 {
    1.0 + factor_pressure(i, positions_m, neighbours, smoothing, Mirrors::at(positions_m[i], walls), true).excess
}
