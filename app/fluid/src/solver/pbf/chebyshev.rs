//! Weights of Chebyshev's semi-iteration (Golub & Varga 1961; as an acceleration of projective solvers: Wang 2015).
//!
//! The residual of a mode with eigenvalue μ after n iterations is p(μ) = T_n((hi + lo − 2 μ)/(hi − lo)) / T, of all
//! polynomials with p(0) = 1 the one that is least over [lo, hi]: 1/T there. Velocities take what the corrections
//! moved, so a mode obeys z² − 2 (1 − a) z + (1 − a) = 0 from substep to substep with a = 1 − p, and is stable for p
//! above −1/3: T must exceed 3. One iteration of weight ω has p = 1 − ω μ, and is stable up to 4/(3 λmax).

/// The upper end of the interval over λmax of the lattice: fluid that is compressed has up to 9 % more.
const MARGIN: f64 = 1.16;
/// 1/T is what is left of every mode inside of the interval. More is a narrower interval: slow modes are faster, and
/// the margin below 3, where energy rises, is less.
const REDUCTION: f64 = 5.0;
/// A cycle has no more iterations; more are so many cycles, each from where the one before ended. Beyond the interval a
/// mode grows as T_n: 5 % beyond it 24 iterations in one cycle multiply it by some 4,000, and three cycles of 8 by 47. A
/// drop that is stretched at half its case's spacing has such modes: 16 iterations in one cycle gained it energy, and 24 let
/// it fly apart.
const CYCLE: usize = 8;
/// From so many iterations on what a particle gets is accumulated; fewer have too little momentum to need it.
const ACCUMULATED_FROM: usize = 6;

/// The weights of the iterations of a substep.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chebyshev {
    /// In order.
    pub iterations: Vec<Weights>,
    /// What they do to a field that varies slowly, as n ω is what n Jacobi iterations of weight ω do.
    pub response: f64,
}

/// One iteration's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Of the constraint.
    pub step: f64,
    /// Of what the iteration before added.
    pub momentum: f64,
}

impl Chebyshev {
    /// For `count` iterations of a lattice with `lambda_max`; at least one.
    pub fn new(count: u32, lambda_max: f64) -> Self {
        let count = count.max(1) as usize;
        let cycles = count.div_ceil(CYCLE);
        // As even as they can be.
        let lengths = (0..cycles).map(|cycle| (count + cycle) / cycles);
        lengths.map(|length| Self::cycle(length, lambda_max)).fold(Self::default(), |all, cycle| Self {
            iterations: [all.iterations, cycle.iterations].concat(),
            // Of a product of residuals, each 1 of the slowest mode.
            response: all.response + cycle.response,
        })
    }

    fn cycle(count: usize, lambda_max: f64) -> Self {
        let n = count as f64;
        let sigma = (REDUCTION.acosh() / n).cosh();
        let high = MARGIN * lambda_max;
        let low = high * (sigma - 1.0) / (sigma + 1.0);
        let [middle, half] = [0.5 * (high + low), 0.5 * (high - low)];
        let mut ratio = 1.0 / sigma;
        let mut iterations = vec![Weights { step: 1.0 / middle, momentum: 0.0 }];
        for _ in 1..count {
            let next = 1.0 / (2.0 * sigma - ratio);
            iterations.push(Weights { step: 2.0 * next / half, momentum: next * ratio });
            ratio = next;
        }
        // -p'(0), with T_n' = n sinh(n acosh) / sinh(acosh).
        let response = n * (1.0 - REDUCTION.powi(-2)).sqrt() / ((sigma * sigma - 1.0).sqrt() * half);
        Self { iterations, response }
    }

    /// Whether what a particle gets is accumulated over the iterations.
    pub fn accumulates(&self) -> bool {
        self.iterations.len() >= ACCUMULATED_FROM
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left of a mode after all iterations.
    fn residual(weights: &Chebyshev, mu: f64) -> f64 {
        let (mut left, mut moved) = (1.0, 0.0);
        for Weights { step, momentum } in &weights.iterations {
            moved = step * left + momentum * moved;
            left -= mu * moved;
        }
        left
    }

    #[test]
    fn weights_are_the_published_ones() {
        // `hi` = 3, T = 5: a table of three, four and eight iterations.
        let of = |count| Chebyshev::new(count, 3.0 / MARGIN);
        let [three, four, eight] = [3, 4, 8].map(of);
        let near = |weights: &Chebyshev, steps: &[f64], momenta: &[f64]| {
            let pairs = steps.iter().zip(momenta).zip(&weights.iterations);
            for ((step, momentum), found) in pairs {
                assert!((found.step - step).abs() < 6e-4 && (found.momentum - momentum).abs() < 6e-4, "{weights:?}");
            }
            assert_eq!(weights.iterations.len(), steps.len());
        };
        near(&three, &[0.588, 0.832, 0.742], &[0.0, 0.414, 0.261]);
        near(&four, &[0.619, 0.976, 0.870, 0.833], &[0.0, 0.577, 0.406, 0.346]);
        near(
            &eight,
            &[0.653, 1.213, 1.142, 1.094, 1.064, 1.046, 1.036, 1.030],
            &[0.0, 0.856, 0.748, 0.675, 0.629, 0.601, 0.585, 0.576],
        );
        assert_eq!([&three, &four, &eight].map(Chebyshev::accumulates), [false, false, true]);
    }

    #[test]
    fn a_fifth_is_left_inside_and_slow_modes_answer_as_said() {
        for (count, cycles) in [(1, 1), (2, 1), (3, 1), (4, 1), (5, 1), (8, 1), (16, 2), (24, 3)] {
            let (lambda_max, mu) = (2.58, 1e-6);
            let weights = Chebyshev::new(count, lambda_max);
            let is_begin = |weights: &&Weights| weights.momentum == 0.0;
            assert_eq!(weights.iterations.iter().filter(is_begin).count(), cycles as usize);
            let (sigma, reduction) =
                ((REDUCTION.acosh() * f64::from(cycles) / f64::from(count)).cosh(), REDUCTION.powi(cycles));
            let high = MARGIN * lambda_max;
            let low = high * (sigma - 1.0) / (sigma + 1.0);
            for k in 0..=100 {
                let left = residual(&weights, low + (high - low) * f64::from(k) / 100.0);
                assert!(left.abs() < 1.0 / reduction + 1e-12 && left > -1.0 / 3.0, "{count}: {left}");
            }
            assert!((residual(&weights, low).abs() * reduction - 1.0).abs() < 1e-9, "{count}");
            let slope = (1.0 - residual(&weights, mu)) / mu;
            assert!((slope / weights.response - 1.0).abs() < 1e-4, "{count}: {slope} {}", weights.response);
            // Beyond the interval it grows.
            assert!(residual(&weights, 1.3 * high).abs() > 1.0 / reduction, "{count}");
        }
    }

    #[test]
    fn what_lies_beyond_the_interval_grows_by_cycles_alone() {
        let lambda_max = 2.58;
        let beyond = |weights: &Chebyshev| residual(weights, 1.05 * MARGIN * lambda_max).abs();
        let three = beyond(&Chebyshev::new(24, lambda_max));
        assert!((three / beyond(&Chebyshev::new(8, lambda_max)).powi(3) - 1.0).abs() < 1e-9 && three < 50.0, "{three}");
        assert!(beyond(&Chebyshev::cycle(24, lambda_max)) > 3000.0);
        // As even as they can be.
        let twenty = Chebyshev::new(20, lambda_max);
        let begins: Vec<usize> = (0..20).filter(|&n| twenty.iterations[n].momentum == 0.0).collect();
        assert_eq!((begins, twenty.iterations.len()), (vec![0, 6, 13], 20));
    }
}
