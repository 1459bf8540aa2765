//! Percentiles, and the sum of sums.

use super::measure_particles::Sums;

/// Adds up sums of parts.
pub fn measure_totals(parts: &[Sums]) -> Sums {
    let mut total = Sums::default();
    for part in parts {
        total.density_error_sum += part.density_error_sum;
        total.density_error_max = total.density_error_max.max(part.density_error_max);
        total.compression_sum += part.compression_sum;
        total.compression_max = total.compression_max.max(part.compression_max);
        total.position_sum_m += part.position_sum_m;
        total.front_m = total.front_m.max(part.front_m);
        total.velocity_sum_m_s += part.velocity_sum_m_s;
        total.speed_max_m_s = total.speed_max_m_s.max(part.speed_max_m_s);
        total.speed_squared_sum_m2_s2 += part.speed_squared_sum_m2_s2;
        total.particles += part.particles;
        total.quarantined += part.quarantined;
        total.escaped += part.escaped;
    }
    total
}

/// The smallest of `values` that at most one in a hundred exceeds; zero of none.
pub fn percentile_99(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => 0.0,
        n => sorted[n - 1 - n / 100],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_in_a_hundred() {
        let values: Vec<f64> = (1..=200).map(f64::from).rev().collect();
        assert_eq!(percentile_99(&values), 198.0);
        assert_eq!(percentile_99(&values[..99]), 200.0);
        assert_eq!(percentile_99(&[]), 0.0);
    }
}
