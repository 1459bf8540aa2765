//! The smoothing kernel Wendland C2 (Wendland 1995) in the dimensionless distance q = r/h, where h
//! is the support radius, scaled so that W(0) = 1.

use glam::DVec3;

/// W(q) = (1 - q)^4 (4q + 1) inside the support, zero beyond.
pub fn kernel(q: f64) -> f64 {
    if q >= 1.0 {
        return 0.0;
    }
    (1.0 - q).powi(4) * (4.0 * q + 1.0)
}

/// dW/dq = -20 q (1 - q)^3 inside the support, zero beyond.
pub fn slope(q: f64) -> f64 {
    if q >= 1.0 {
        return 0.0;
    }
    -20.0 * q * (1.0 - q).powi(3)
}

/// Gradient of W with respect to the first point, at `offset` = (first - second) / h. The kernel is
/// flat at q = 0, so two particles at one point have none.
pub fn gradient(offset: DVec3) -> DVec3 {
    let q = offset.length();
    if q == 0.0 {
        return DVec3::ZERO;
    }
    offset * (slope(q) / q)
}

/// Integral of W over space, in units of h^3: 2 pi / 21.
pub const VOLUME: f64 = 2.0 * std::f64::consts::PI / 21.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::quadrature::Gauss;

    #[test]
    fn integrates_to_its_volume() {
        let integral = Gauss::new(16).integrate(0.0, 1.0, |q| 4.0 * std::f64::consts::PI * q * q * kernel(q));
        assert!((integral - VOLUME).abs() < 1e-14, "{integral}");
    }

    #[test]
    fn slope_is_the_derivative() {
        for i in 1..20 {
            let q = f64::from(i) / 20.0;
            let e = 1e-6;
            let difference = (kernel(q + e) - kernel(q - e)) / (2.0 * e);
            assert!((slope(q) - difference).abs() < 1e-8, "q = {q}");
        }
    }

    #[test]
    fn gradient_points_towards_the_other() {
        let offset = DVec3::new(0.3, -0.1, 0.2);
        assert!(gradient(offset).dot(offset) < 0.0);
        assert_eq!(gradient(offset), -gradient(-offset));
        assert_eq!(gradient(DVec3::ZERO), DVec3::ZERO);
        assert_eq!(gradient(DVec3::X), DVec3::ZERO);
    }
}
