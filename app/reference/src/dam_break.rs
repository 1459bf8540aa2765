//! Comparison with Martin & Moyce 1952's collapsing column: front Z = x/a against T = t sqrt(2 g/a)
//! (n^2 = 2). The gate's release shifts the experiment's clock, so an error is also given after the
//! best constant shift, and the slope dZ/dT needs no clock at all.

/// A sample of a series: time, value.
pub type Sample = (f64, f64);

/// Reads a series: two comma-separated columns, `#` comments, one heading. Errors name the line.
pub fn parse_series(text: &str) -> Result<Vec<Sample>, String> {
    let rows = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    let mut series = Vec::new();
    for (number, line) in rows.skip(1) {
        let parse = |text: &str| text.trim().parse::<f64>().ok();
        let sample = line.split_once(',').and_then(|(t, value)| parse(t).zip(parse(value)));
        match sample {
            Some(sample) => series.push(sample),
            None => return Err(format!("line {}: not two numbers: {line}", number + 1)),
        }
    }
    Ok(series)
}

/// The series at `t`, linear between samples in ascending time; `None` outside them.
pub fn interpolate(series: &[Sample], t: f64) -> Option<f64> {
    let after = series.partition_point(|sample| sample.0 < t);
    let &(t1, v1) = series.get(after)?;
    if t1 == t {
        return Some(v1);
    }
    let &(t0, v0) = series.get(after.checked_sub(1)?)?;
    Some(v0 + (v1 - v0) * (t - t0) / (t1 - t0))
}

/// Root-mean-square difference at the experiment's times, the simulation's clock set back by
/// `shift`: simulation at T + shift against experiment at T. `None` unless at least half of the
/// experiment's samples lie inside the simulation.
pub fn rmse(simulation: &[Sample], experiment: &[Sample], shift: f64) -> Option<f64> {
    let squares: Vec<f64> =
        experiment.iter().filter_map(|&(t, z)| Some((interpolate(simulation, t + shift)? - z).powi(2))).collect();
    if squares.is_empty() || 2 * squares.len() < experiment.len() {
        return None;
    }
    Some((squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

/// The shift of at most `limit` with the least [`rmse`], and that error.
pub fn best_shift(simulation: &[Sample], experiment: &[Sample], limit: f64) -> Option<(f64, f64)> {
    let steps = 400;
    (-steps..=steps)
        .filter_map(|k| {
            let shift = limit * f64::from(k) / f64::from(steps);
            Some((shift, rmse(simulation, experiment, shift)?))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Mean slope dZ/dT from `from` to `to`: the least-squares line through the samples there. `None`
/// with fewer than two.
pub fn mean_slope(series: &[Sample], from: f64, to: f64) -> Option<f64> {
    let inside: Vec<Sample> = series.iter().copied().filter(|sample| (from..=to).contains(&sample.0)).collect();
    if inside.len() < 2 {
        return None;
    }
    let n = inside.len() as f64;
    let mean_t = inside.iter().map(|s| s.0).sum::<f64>() / n;
    let mean_z = inside.iter().map(|s| s.1).sum::<f64>() / n;
    let spread: f64 = inside.iter().map(|s| (s.0 - mean_t).powi(2)).sum();
    let together: f64 = inside.iter().map(|s| (s.0 - mean_t) * (s.1 - mean_z)).sum();
    Some(together / spread)
}

/// The three numbers that a dam break is reported with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// RMSE in Z on the clock as it is.
    pub rmse: f64,
    /// The best constant shift in T, at most 0.2 either way.
    pub shift: f64,
    /// RMSE after it.
    pub shifted_rmse: f64,
    /// Mean slope of the simulation over the experiment's shift-free span.
    pub slope: f64,
    /// The experiment's.
    pub expected_slope: f64,
}

/// Span of T over which the n^2 = 2 experiment's slope is even.
pub const SLOPE_SPAN: (f64, f64) = (2.5, 9.25);

/// Compares a simulated front with the experiment; `None` where they hardly overlap.
pub fn compare(simulation: &[Sample], experiment: &[Sample]) -> Option<Comparison> {
    let (shift, shifted_rmse) = best_shift(simulation, experiment, 0.2)?;
    let (from, to) = SLOPE_SPAN;
    let last = simulation.last()?.0;
    Some(Comparison {
        rmse: rmse(simulation, experiment, 0.0)?,
        shift,
        shifted_rmse,
        slope: mean_slope(simulation, from, to.min(last))?,
        expected_slope: mean_slope(experiment, from, to.min(last))?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(slope: f64, shift: f64) -> Vec<Sample> {
        (0..100).map(|i| f64::from(i) / 10.0).map(|t| (t, 1.0 + slope * (t - shift))).collect()
    }

    #[test]
    fn a_shift_is_found_and_a_slope_is_not_hidden_by_it() {
        let experiment: Vec<Sample> = line(1.65, 0.0)[5..90].to_vec();
        let late = compare(&line(1.65, 0.13), &experiment).unwrap();
        assert!((late.shift - 0.13).abs() < 1e-9 && late.shifted_rmse < 1e-9);
        assert!((late.rmse - 0.13 * 1.65).abs() < 1e-9);
        assert!((late.slope - late.expected_slope).abs() < 1e-9);

        let fast = compare(&line(2.0, 0.0), &experiment).unwrap();
        assert!(fast.shifted_rmse > 0.5);
        assert!((fast.slope - 2.0).abs() < 1e-9);
    }

    #[test]
    fn too_little_overlap_is_no_result() {
        let experiment = line(1.65, 0.0);
        assert_eq!(compare(&experiment[..30], &experiment), None);
        assert_eq!(compare(&[], &experiment), None);
        assert_eq!(compare(&experiment, &[]), None);
    }

    #[test]
    fn reads_what_the_data_look_like() {
        let series = parse_series("# Martin & Moyce\nT,Z\n0.41,1.11\n0.84,1.22\n").unwrap();
        assert_eq!(series, [(0.41, 1.11), (0.84, 1.22)]);
        assert_eq!(interpolate(&series, 0.41), Some(1.11));
        assert_eq!(interpolate(&series, 0.40), None);
        assert!((interpolate(&series, 0.625).unwrap() - 1.165).abs() < 1e-12);
        let error = parse_series("T,Z\n1,2\n3;4\n").unwrap_err();
        assert!(error.starts_with("line 3"), "{error}");
    }
}
