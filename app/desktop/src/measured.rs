//! What was measured of the fluid over a run: the last state, the worst, and what was counted.

use brooklet_capture::StatField;
use brooklet_fluid::{Stats, measure};
use serde::Serialize;

/// Mean, 99th percentile and largest value over the particles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Largest.
    pub max: f64,
}

impl From<measure::Spread> for Spread {
    fn from(from: measure::Spread) -> Self {
        let measure::Spread { mean, p99, max } = from;
        Self { mean, p99, max }
    }
}

impl Spread {
    fn raise(&mut self, other: Self) {
        self.mean = self.mean.max(other.mean);
        self.p99 = self.p99.max(other.p99);
        self.max = self.max.max(other.max);
    }
}

/// The largest values of a run, each on its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    /// Of |rho/rho0 - 1|.
    pub density_error: Spread,
    /// Of max(rho/rho0 - 1, 0).
    pub compression: Spread,
    /// Largest speed.
    pub max_speed_m_s: f64,
}

/// Everything that was counted instead of hidden. The first three are sums over the run, the last
/// two are how many particles it was at the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counted {
    /// Neighbours that had no slot.
    pub neighbour_overflow: u64,
    /// Speeds that were clamped.
    pub speed_clamps: u64,
    /// Corrections that were clamped.
    pub correction_clamps: u64,
    /// Particles whose state was not finite.
    pub quarantined: u64,
    /// Particles outside an open domain.
    pub escaped: u64,
}

/// The measurements of a run.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// How many there were.
    pub count: u64,
    /// Step of the last one.
    pub last_step: u64,
    /// The last one.
    pub last: Option<Stats>,
    /// The worst of them.
    pub worst: Worst,
    /// What was counted.
    pub counted: Counted,
}

impl Measured {
    /// Takes the measurement after step `step`.
    pub fn add(&mut self, step: u64, stats: Stats) {
        self.count += 1;
        self.last_step = step;
        self.last = Some(stats);
        self.worst.density_error.raise(stats.density_error.into());
        self.worst.compression.raise(stats.compression.into());
        self.worst.max_speed_m_s = self.worst.max_speed_m_s.max(stats.max_speed_m_s);
        let counters = stats.counters;
        self.counted.neighbour_overflow += u64::from(counters.neighbour_overflow);
        self.counted.speed_clamps += u64::from(counters.speed_clamps);
        self.counted.correction_clamps += u64::from(counters.correction_clamps);
        self.counted.quarantined = u64::from(stats.quarantined);
        self.counted.escaped = u64::from(stats.escaped);
    }
}

/// What `/sim/stats` says: name, unit, description, and where it is in a measurement.
type Field = (&'static str, &'static str, &'static str, fn(&Stats) -> f64);

const FIELDS: &[Field] = &[
    ("density_error_mean", "1", "Mean of |rho/rho0 - 1|", |s| s.density_error.mean),
    ("density_error_p99", "1", "99th percentile of |rho/rho0 - 1|", |s| s.density_error.p99),
    ("density_error_max", "1", "Largest |rho/rho0 - 1|", |s| s.density_error.max),
    ("compression_mean", "1", "Mean of max(rho/rho0 - 1, 0)", |s| s.compression.mean),
    ("compression_p99", "1", "99th percentile of max(rho/rho0 - 1, 0)", |s| s.compression.p99),
    ("compression_max", "1", "Largest rho/rho0 - 1", |s| s.compression.max),
    ("max_speed_m_s", "m/s", "Largest speed", |s| s.max_speed_m_s),
    ("kinetic_j", "J", "Kinetic energy", |s| s.kinetic_j),
    ("potential_j", "J", "Energy against gravity, from the domain's lowest corner", |s| s.potential_j),
    ("energy_j", "J", "Kinetic and potential energy", |s| s.kinetic_j + s.potential_j),
    ("centre_of_mass_x_m", "m", "Centre of mass along x", |s| s.centre_of_mass_m[0]),
    ("centre_of_mass_y_m", "m", "Centre of mass along y, up", |s| s.centre_of_mass_m[1]),
    ("centre_of_mass_z_m", "m", "Centre of mass along z", |s| s.centre_of_mass_m[2]),
    ("momentum_x_kg_m_s", "kg m/s", "Momentum along x", |s| s.momentum_kg_m_s[0]),
    ("momentum_y_kg_m_s", "kg m/s", "Momentum along y", |s| s.momentum_kg_m_s[1]),
    ("momentum_z_kg_m_s", "kg m/s", "Momentum along z", |s| s.momentum_kg_m_s[2]),
    ("front_m", "m", "Largest x of the fluid", |s| s.front_m),
    ("particles", "1", "Particles measured", |s| f64::from(s.particles)),
    ("quarantined", "1", "Particles whose state was not finite", |s| f64::from(s.quarantined)),
    ("escaped", "1", "Particles outside an open domain", |s| f64::from(s.escaped)),
    ("neighbour_overflow", "1", "Neighbours without a slot since the last measurement", |s| {
        f64::from(s.counters.neighbour_overflow)
    }),
    ("speed_clamps", "1", "Speeds clamped since the last measurement", |s| f64::from(s.counters.speed_clamps)),
    ("correction_clamps", "1", "Corrections clamped since the last measurement", |s| {
        f64::from(s.counters.correction_clamps)
    }),
];

/// The fields of `/sim/stats`: which step it was, when in the simulation, and the measurement.
pub fn fields() -> Vec<StatField> {
    let clock = [
        StatField::new("step", "1", "Number of the step that was measured"),
        StatField::new("simulated_s", "s", "Simulated time"),
    ];
    let stats = FIELDS.iter().map(|(name, unit, description, _)| StatField::new(name, unit, description));
    clock.into_iter().chain(stats).collect()
}

/// The values of [`fields`], in their order.
pub fn values(step: u64, simulated_s: f64, stats: &Stats) -> Vec<f64> {
    let clock = [step as f64, simulated_s];
    let stats = FIELDS.iter().map(|(.., value)| value(stats));
    clock.into_iter().chain(stats).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stats(compression: f64, speed_clamps: u32, quarantined: u32) -> Stats {
        let mut stats = Stats { max_speed_m_s: 1.0 - compression, quarantined, ..Stats::default() };
        stats.compression.max = compression;
        stats.counters.speed_clamps = speed_clamps;
        stats
    }

    #[test]
    fn fields_and_values_go_together() {
        let mut measured = stats(0.25, 7, 0);
        measured.front_m = 1.5;
        let (fields, values) = (fields(), values(12, 0.05, &measured));
        assert_eq!(fields.len(), values.len());
        let value = |name: &str| values[fields.iter().position(|f| f.name == name).unwrap()];
        assert_eq!(value("step"), 12.0);
        assert_eq!(value("simulated_s"), 0.05);
        assert_eq!(value("compression_max"), 0.25);
        assert_eq!(value("front_m"), 1.5);
        assert_eq!(value("speed_clamps"), 7.0);
    }

    #[test]
    fn the_last_the_worst_and_the_sums() {
        let mut measured = Measured::default();
        for (step, compression) in [(4, 0.1), (8, 0.3), (12, 0.2)] {
            measured.add(step, stats(compression, 5, step as u32));
        }
        assert_eq!((measured.count, measured.last_step), (3, 12));
        assert_eq!(measured.last.unwrap().compression.max, 0.2);
        assert_eq!(measured.worst.compression.max, 0.3);
        assert_eq!(measured.worst.max_speed_m_s, 0.9);
        assert_eq!(measured.counted.speed_clamps, 15);
        assert_eq!(measured.counted.quarantined, 12, "a state, not a sum");
    }
}
