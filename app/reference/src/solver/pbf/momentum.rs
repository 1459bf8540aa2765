//! Lambda with momentum: Chebyshev's semi-iteration (Golub & Varga 1961; Wang 2015) on the density constraint.

use super::constrain_density::DensityConstraint;

/// Compression above which steps become shorter, and from which on an iteration is plain Jacobi.
pub const GUARD: [f64; 2] = [0.04, 0.08];

/// One iteration's; see `PbfIteration`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Of the constraint.
    pub step: f64,
    /// Of the particle's lambda of the iteration before; 0 in the first.
    pub momentum: f64,
    /// Of the constraint where the fluid is very compressed.
    pub guarded_step: f64,
}

/// What an iteration adds to a particle's multiplier; `before` is what the one before added.
fn lambda_step(constraint: &DensityConstraint, weights: &Weights, before: f64) -> f64 {
    let ratio = constraint.excess / constraint.denominator;
    let guard = ((constraint.excess - GUARD[0]) / (GUARD[1] - GUARD[0])).clamp(0.0, 1.0);
    let lambda = weights.momentum * before - weights.step * ratio;
    (1.0 - guard) * lambda - guard * weights.guarded_step * ratio
}

/// Lambda of an iteration: none where nothing is compressed, and no momentum after that.
pub fn momentum_lambda(constraint: &DensityConstraint, weights: &Weights, before: f64) -> f64 {
    if constraint.excess > 0.0 { lambda_step(constraint, weights, before) } else { 0.0 }
}

/// Lambda of a particle whose lambdas until now add up to `total`, of which the last was `before`: their sum never
/// becomes positive.
pub fn accumulated_lambda(constraint: &DensityConstraint, weights: &Weights, before: f64, total: f64) -> f64 {
    (total + lambda_step(constraint, weights, before)).min(0.0) - total
}

#[cfg(test)]
mod tests {
    use super::*;

    const WEIGHTS: Weights = Weights { step: 0.9, momentum: 0.4, guarded_step: 0.5 };

    fn constraint(excess: f64) -> DensityConstraint {
        let constraint = excess.max(0.0);
        DensityConstraint { lambda: -constraint / 2.0, constraint, excess, denominator: 2.0 }
    }

    #[test]
    fn momentum_ends_where_nothing_is_compressed_and_where_too_much_is() {
        assert_eq!(momentum_lambda(&constraint(0.02), &WEIGHTS, -0.1), -0.9 * 0.01 - 0.4 * 0.1);
        assert_eq!(momentum_lambda(&constraint(-0.02), &WEIGHTS, -0.1), 0.0);
        assert_eq!(momentum_lambda(&constraint(0.1), &WEIGHTS, -0.1), -0.5 * 0.05);
        let between = momentum_lambda(&constraint(0.06), &WEIGHTS, -0.1);
        assert!((between - 0.5 * (-0.9 * 0.03 - 0.04 - 0.5 * 0.03)).abs() < 1e-15, "{between}");
    }

    #[test]
    fn an_accumulated_multiplier_gives_back_what_it_got_and_never_pulls() {
        let first = accumulated_lambda(&constraint(0.02), &Weights { momentum: 0.0, ..WEIGHTS }, 0.0, 0.0);
        assert_eq!(first, -0.9 * 0.01);
        let back = accumulated_lambda(&constraint(-0.02), &WEIGHTS, first, first);
        assert!(back > 0.0 && first + back < 0.0, "{first} {back}");
        let all = accumulated_lambda(&constraint(-0.5), &WEIGHTS, back, first + back);
        assert!((first + back + all).abs() < 1e-17, "{all}");
    }
}
