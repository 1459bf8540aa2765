//! Weights of a pressure solve's iterations: the second-order Richardson iteration that Chebyshev's semi-iteration tends to
//! (Golub & Varga 1961). It needs no number of iterations beforehand, which only the GPU knows.

use crate::spectrum::lambda_max;

/// The upper end of the interval over λmax of the lattice: fluid that is compressed has up to 9 % more.
const MARGIN: f64 = 1.16;
/// Plain Jacobi's weight times λmax: what is left of the fastest and of slow modes is then alike.
const PLAIN: f64 = 1.3;

/// Of the iterations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Of the first one's residual.
    pub first_step: f64,
    /// Of the others' residuals.
    pub step: f64,
    /// Of what the iteration before added.
    pub momentum: f64,
    /// Of a residual where the weights above are not safe: plain Jacobi's.
    pub plain: f64,
}

impl Weights {
    /// For a lattice of so many `dimensions`, h/d = `support_ratio`. Modes between λ/κ and λ, with
    /// κ = ((1 + √momentum)/(1 − √momentum))², fall by √momentum an iteration.
    pub fn new(dimensions: u32, support_ratio: f64, momentum: f64) -> Self {
        let lambda_max = lambda_max(dimensions, support_ratio, 0.0);
        let plain = PLAIN / lambda_max;
        if momentum <= 0.0 {
            return Self { first_step: plain, step: plain, momentum: 0.0, plain };
        }
        let high = MARGIN * lambda_max;
        let rate = momentum.sqrt();
        let low = high * ((1.0 - rate) / (1.0 + rate)).powi(2);
        let first_step = 2.0 / (high + low);
        Self { first_step, step: (1.0 + momentum) * first_step, momentum, plain }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left of a mode of eigenvalue `mu` after so many iterations.
    fn left(weights: &Weights, mu: f64, iterations: u32) -> f64 {
        let (mut left, mut added) = (1.0, 0.0);
        for iteration in 0..iterations {
            added = match iteration {
                0 => weights.first_step * left,
                _ => weights.step * left + weights.momentum * added,
            };
            left -= mu * added;
        }
        left
    }

    #[test]
    fn all_modes_up_to_the_margin_fall_and_those_inside_the_interval_as_fast_as_is_said() {
        let lambda_max = lambda_max(3, 2.0, 0.0);
        for momentum in [0.0, 0.1, 0.3, 0.5, 0.8] {
            let weights = Weights::new(3, 2.0, momentum);
            let rate = momentum.sqrt();
            let low = MARGIN * ((1.0 - rate) / (1.0 + rate)).powi(2);
            for share in (1..=116).map(|percent| 0.01 * f64::from(percent)) {
                let after = left(&weights, share * lambda_max, 40).abs();
                assert!(after < 1.0, "{momentum} {share}: {after}");
                // Both roots are complex inside: as momentum^(n/2), times at most 1 + n.
                let bound = 41.0 * momentum.powi(20);
                assert!(momentum == 0.0 || share < low || after <= bound + 1e-12, "{momentum} {share}: {after}");
            }
        }
        assert!(left(&Weights { step: 0.8, ..Weights::new(3, 2.0, 0.0) }, lambda_max, 40).abs() > 1.0);
    }
}
