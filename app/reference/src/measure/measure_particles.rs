//! Sums and extremes over particles.

use glam::DVec3;

/// What one particle tells.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Relative to the domain's lowest corner.
    pub position_m: DVec3,
    /// Velocity, m/s.
    pub velocity_m_s: DVec3,
    /// rho / rho0.
    pub density_ratio: f64,
    /// Counted, but not measured.
    pub quarantined: bool,
}

/// Sums and extremes; see `MeasureSums` of the shaders' layout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sums {
    /// Sum of |rho / rho0 - 1|.
    pub density_error_sum: f64,
    /// Largest |rho / rho0 - 1|.
    pub density_error_max: f64,
    /// Sum of max(rho / rho0 - 1, 0).
    pub compression_sum: f64,
    /// Largest of them.
    pub compression_max: f64,
    /// Sum of positions.
    pub position_sum_m: DVec3,
    /// Largest x; minus infinity without particles.
    pub front_m: f64,
    /// Sum of velocities.
    pub velocity_sum_m_s: DVec3,
    /// Largest speed.
    pub speed_max_m_s: f64,
    /// Sum of squared speeds.
    pub speed_squared_sum_m2_s2: f64,
    /// How many were measured.
    pub particles: u32,
    /// How many were not.
    pub quarantined: u32,
    /// How many of the measured are outside the domain.
    pub escaped: u32,
}

impl Default for Sums {
    fn default() -> Self {
        Self {
            density_error_sum: 0.0,
            density_error_max: 0.0,
            compression_sum: 0.0,
            compression_max: 0.0,
            position_sum_m: DVec3::ZERO,
            front_m: f64::NEG_INFINITY,
            velocity_sum_m_s: DVec3::ZERO,
            speed_max_m_s: 0.0,
            speed_squared_sum_m2_s2: 0.0,
            particles: 0,
            quarantined: 0,
            escaped: 0,
        }
    }
}

/// Adds up `samples` in a domain of `domain_size_m`.
pub fn measure_particles(samples: &[Sample], domain_size_m: DVec3) -> Sums {
    let mut sums = Sums::default();
    for sample in samples {
        if sample.quarantined {
            sums.quarantined += 1;
            continue;
        }
        let error = sample.density_ratio - 1.0;
        let speed_m_s = sample.velocity_m_s.length();
        sums.density_error_sum += error.abs();
        sums.density_error_max = sums.density_error_max.max(error.abs());
        sums.compression_sum += error.max(0.0);
        sums.compression_max = sums.compression_max.max(error);
        sums.position_sum_m += sample.position_m;
        sums.front_m = sums.front_m.max(sample.position_m.x);
        sums.velocity_sum_m_s += sample.velocity_m_s;
        sums.speed_max_m_s = sums.speed_max_m_s.max(speed_m_s);
        sums.speed_squared_sum_m2_s2 += speed_m_s * speed_m_s;
        sums.particles += 1;
        let inside = sample.position_m.clamp(DVec3::ZERO, domain_size_m) == sample.position_m;
        sums.escaped += u32::from(!inside);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_three() {
        let sample = |x: f64, density_ratio| Sample {
            position_m: DVec3::new(x, 0.5, 0.5),
            velocity_m_s: DVec3::new(3.0, 4.0, 0.0),
            density_ratio,
            quarantined: false,
        };
        let mut lost = sample(0.0, 7.0);
        lost.quarantined = true;
        let sums = measure_particles(&[sample(0.25, 0.5), sample(1.5, 1.25), lost], DVec3::ONE);
        assert_eq!((sums.particles, sums.quarantined, sums.escaped), (2, 1, 1));
        assert_eq!((sums.density_error_sum, sums.density_error_max), (0.75, 0.5));
        assert_eq!((sums.compression_sum, sums.compression_max), (0.25, 0.25));
        assert_eq!((sums.front_m, sums.speed_max_m_s), (1.5, 5.0));
        assert_eq!(sums.speed_squared_sum_m2_s2, 50.0);
        assert_eq!(sums.velocity_sum_m_s, DVec3::new(6.0, 8.0, 0.0));
    }
}
