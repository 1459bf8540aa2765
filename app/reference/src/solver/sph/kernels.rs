//! The kernels of SPH's terms, from the papers' own formulas: what the shader's polynomials stand for. (Shader:
//! `solver/sph/kernels.hlsli`.) q = r/h; W and its derivatives are those of h = 1 and integrate to 1 over space.

use std::f64::consts::PI;

/// A smoothing kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// Müller, Charypar & Gross 2003, eq. 20.
    Poly6,
    /// Eq. 21.
    Spiky,
    /// Eq. 22.
    Viscosity,
    /// Monaghan & Lattanzio 1985, support h.
    CubicSpline,
    /// Wendland 1995, C2.
    Wendland,
}

impl Kernel {
    /// Every kernel.
    pub const ALL: [Kernel; 5] =
        [Kernel::Poly6, Kernel::Spiky, Kernel::Viscosity, Kernel::CubicSpline, Kernel::Wendland];

    /// W(q) in three dimensions.
    pub fn w(self, q: f64) -> f64 {
        if q >= 1.0 {
            return 0.0;
        }
        match self {
            Self::Poly6 => 315.0 / (64.0 * PI) * (1.0 - q * q).powi(3),
            Self::Spiky => 15.0 / PI * (1.0 - q).powi(3),
            Self::Viscosity => 15.0 / (2.0 * PI) * (-0.5 * q.powi(3) + q * q + 0.5 / q - 1.0),
            Self::CubicSpline if q < 0.5 => 8.0 / PI * (1.0 - 6.0 * q * q + 6.0 * q.powi(3)),
            Self::CubicSpline => 16.0 / PI * (1.0 - q).powi(3),
            Self::Wendland => 21.0 / (2.0 * PI) * (1.0 - q).powi(4) * (1.0 + 4.0 * q),
        }
    }

    /// dW/dq.
    pub fn slope(self, q: f64) -> f64 {
        if q >= 1.0 {
            return 0.0;
        }
        match self {
            Self::Poly6 => -6.0 * q * 315.0 / (64.0 * PI) * (1.0 - q * q).powi(2),
            Self::Spiky => -45.0 / PI * (1.0 - q).powi(2),
            Self::Viscosity => 15.0 / (2.0 * PI) * (-1.5 * q * q + 2.0 * q - 0.5 / (q * q)),
            Self::CubicSpline if q < 0.5 => 8.0 / PI * (-12.0 * q + 18.0 * q * q),
            Self::CubicSpline => -48.0 / PI * (1.0 - q).powi(2),
            Self::Wendland => -20.0 * q * 21.0 / (2.0 * PI) * (1.0 - q).powi(3),
        }
    }

    /// What a difference of velocities counts in the Laplacian: the viscosity kernel's own, of others -2 W'/q (Brookshaw
    /// 1985).
    pub fn laplacian(self, q: f64) -> f64 {
        match self {
            Self::Viscosity => 45.0 / PI * (1.0 - q).max(0.0),
            other => -2.0 * other.slope(q) / q,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::quadrature::Gauss;

    /// Over space, in two halves: the spline changes its formula between them.
    fn over_space(of: impl Fn(f64) -> f64) -> f64 {
        let gauss = Gauss::new(24);
        let shell = |q: f64| 4.0 * PI * q * q * of(q);
        gauss.integrate(0.0, 0.5, shell) + gauss.integrate(0.5, 1.0, shell)
    }

    #[test]
    fn kernels_integrate_to_one() {
        for kernel in Kernel::ALL {
            let volume = over_space(|q| kernel.w(q));
            assert!((volume - 1.0).abs() < 1e-12, "{kernel:?}: {volume}");
        }
    }

    #[test]
    fn slopes_are_the_derivatives() {
        for kernel in Kernel::ALL {
            for i in 1..50 {
                let (q, e) = (f64::from(i) / 50.0 - 0.003, 1e-6);
                let difference = (kernel.w(q + e) - kernel.w(q - e)) / (2.0 * e);
                let scale = kernel.slope(q).abs().max(1.0);
                assert!((kernel.slope(q) - difference).abs() < 1e-7 * scale, "{kernel:?} at {q}");
            }
        }
    }

    #[test]
    fn a_parabola_has_its_laplacian_and_a_slope_its_gradient() {
        // Of v = x^2/2 the Laplacian is 1: the integral of x^2/2 w is that of r^2/6 w. Of p = x the gradient is 1.
        for kernel in Kernel::ALL {
            let laplacian = over_space(|q| q * q / 6.0 * kernel.laplacian(q));
            let gradient = over_space(|q| -q * kernel.slope(q) / 3.0);
            assert!((laplacian - 1.0).abs() < 1e-10, "{kernel:?}: {laplacian}");
            assert!((gradient - 1.0).abs() < 1e-10, "{kernel:?}: {gradient}");
        }
    }
}
