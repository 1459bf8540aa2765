//! What a measurement says, by name and unit: for captures, tables and plots.

use crate::measure::Stats;

/// One value of a measurement.
#[derive(Clone, Copy, Debug)]
pub struct StatField {
    /// Its name.
    pub name: &'static str,
    /// Its unit; `1`: none.
    pub unit: &'static str,
    /// What it is.
    pub description: &'static str,
    /// Where it is in a measurement.
    pub value: fn(&Stats) -> f64,
}

const fn field(
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    value: fn(&Stats) -> f64,
) -> StatField {
    StatField { name, unit, description, value }
}

/// Every value of a measurement.
pub const STAT_FIELDS: &[StatField] = &[
    field("density_error_mean", "1", "Mean of |rho/rho0 - 1|", |s| s.density_error.mean),
    field("density_error_p99", "1", "99th percentile of |rho/rho0 - 1|", |s| s.density_error.p99),
    field("density_error_max", "1", "Largest |rho/rho0 - 1|", |s| s.density_error.max),
    field("compression_mean", "1", "Mean of max(rho/rho0 - 1, 0)", |s| s.compression.mean),
    field("compression_p99", "1", "99th percentile of max(rho/rho0 - 1, 0)", |s| s.compression.p99),
    field("compression_max", "1", "Largest rho/rho0 - 1", |s| s.compression.max),
    field("max_speed_m_s", "m/s", "Largest speed", |s| s.max_speed_m_s),
    field("kinetic_j", "J", "Kinetic energy", |s| s.kinetic_j),
    field("potential_j", "J", "Energy against gravity, from the domain's lowest corner", |s| s.potential_j),
    field("energy_j", "J", "Kinetic and potential energy", |s| s.kinetic_j + s.potential_j),
    field("centre_of_mass_x_m", "m", "Centre of mass along x", |s| s.centre_of_mass_m[0]),
    field("centre_of_mass_y_m", "m", "Centre of mass along y, up", |s| s.centre_of_mass_m[1]),
    field("centre_of_mass_z_m", "m", "Centre of mass along z", |s| s.centre_of_mass_m[2]),
    field("momentum_x_kg_m_s", "kg m/s", "Momentum along x", |s| s.momentum_kg_m_s[0]),
    field("momentum_y_kg_m_s", "kg m/s", "Momentum along y", |s| s.momentum_kg_m_s[1]),
    field("momentum_z_kg_m_s", "kg m/s", "Momentum along z", |s| s.momentum_kg_m_s[2]),
    field("front_m", "m", "Largest x of the fluid", |s| s.front_m),
    field("particles", "1", "Particles measured", |s| f64::from(s.particles)),
    field("quarantined", "1", "Particles whose state was not finite", |s| f64::from(s.quarantined)),
    field("escaped", "1", "Particles outside an open domain", |s| f64::from(s.escaped)),
    field("neighbour_overflow", "1", "Neighbours without a slot since the last measurement", |s| {
        f64::from(s.counters.neighbour_overflow)
    }),
    field("speed_clamps", "1", "Speeds clamped since the last measurement", |s| f64::from(s.counters.speed_clamps)),
    field("correction_clamps", "1", "Corrections clamped since the last measurement", |s| {
        f64::from(s.counters.correction_clamps)
    }),
];
