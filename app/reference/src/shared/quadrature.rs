//! Gauss-Legendre quadrature: exact for polynomials of degree 2n - 1.

/// Nodes and weights on [-1, 1].
pub struct Gauss {
    nodes: Vec<(f64, f64)>,
}

impl Gauss {
    /// The rule of `points` points; Newton's method on the Legendre polynomial, from Chebyshev's
    /// guess (Press et al., Numerical Recipes, 4.6).
    pub fn new(points: usize) -> Self {
        let n = points as f64;
        let nodes = (0..points)
            .map(|i| {
                let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
                loop {
                    let (p, derivative) = legendre(points, x);
                    let step = p / derivative;
                    x -= step;
                    if step.abs() < 1e-15 {
                        break;
                    }
                }
                let (_, derivative) = legendre(points, x);
                (x, 2.0 / ((1.0 - x * x) * derivative * derivative))
            })
            .collect();
        Self { nodes }
    }

    /// The integral of `f` from `a` to `b`; zero where the interval is empty.
    pub fn integrate(&self, a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
        if b <= a {
            return 0.0;
        }
        let (middle, half) = ((a + b) / 2.0, (b - a) / 2.0);
        half * self.nodes.iter().map(|&(x, w)| w * f(middle + half * x)).sum::<f64>()
    }
}

/// The Legendre polynomial of degree `n` at `x`, and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut p, mut before) = (1.0, 0.0);
    for k in 0..n {
        let k = k as f64;
        let next = ((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0);
        before = p;
        p = next;
    }
    (p, n as f64 * (x * p - before) / (x * x - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_for_polynomials() {
        for points in [1, 2, 5, 16, 48] {
            let degree = 2 * points as i32 - 1;
            let rule = Gauss::new(points);
            let integral = rule.integrate(0.0, 2.0, |x| (x / 2.0).powi(degree));
            let exact = 2.0 / f64::from(degree + 1);
            assert!((integral - exact).abs() < 1e-13, "{points} points");
        }
    }
}
