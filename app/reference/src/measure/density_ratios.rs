//! Density ratios of all particles.

use crate::boundary::walls::DomainWalls;
use crate::measure::density::{density_ratio, mirrored_density_ratio};
use crate::params::Smoothing;
use glam::DVec3;

/// The ratio of each particle, 0 where `quarantined` says so; `mirror`: where walls mirror the fluid. (Shader: `measure/density_ratios.compute`.)
pub fn density_ratios(
    positions_m: &[DVec3],
    neighbours: &[Vec<usize>],
    quarantined: impl Fn(usize) -> bool,
    smoothing: &Smoothing,
    walls: Option<&DomainWalls>,
    mirror: bool,
) -> Vec<f64> {
    let ratio = if mirror { mirrored_density_ratio } else { density_ratio };
    (0..positions_m.len())
        .map(|i| match quarantined(i) {
            true => 0.0,
            false => ratio(i, positions_m, &neighbours[i], smoothing, walls),
        })
        .collect()
}
