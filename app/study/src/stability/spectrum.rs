//! How much relaxation Jacobi's iteration bears on the lattice at rest.
//!
//! A constraint that varies as exp(i k·x) is multiplied by 1 − ω |G(k)|² / D each iteration, with
//! G(k) = w Σ ∇W(r) exp(i k·r) over the lattice and D the denominator of λ: the correction
//! −Σ (λ_i + λ_j) ∇W is G/D of the constraint, and what it changes of the density is G again. The largest
//! |G|²/D over the wave vectors is λmax; ω must stay below 2/λmax.

use std::f64::consts::PI;

use brooklet_reference::shared::wendland;
use glam::DVec3;

/// Wave vectors an axis of the scan, over half of the Brillouin zone.
const WAVES: i32 = 24;

/// Largest relaxation ω of a lattice in `dimensions` (2 or 3) at h/d = `support_ratio`, with constraint
/// force mixing `cfm` over the lattice's own denominator.
pub fn relaxation_limit(support_ratio: f64, cfm: f64, dimensions: u32) -> f64 {
    let gradients = gradients(support_ratio, dimensions);
    let own: f64 = gradients.iter().map(|(_, gradient)| gradient.length_squared()).sum();
    let depth = if dimensions == 3 { WAVES } else { 0 };
    let mut most = 0.0_f64;
    for x in 0..=WAVES {
        for y in 0..=x {
            for z in 0..=y.min(depth) {
                let wave = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) * PI / f64::from(WAVES);
                // The kernel is even, so only the sine is left.
                let sum: DVec3 = gradients.iter().map(|(at, gradient)| *gradient * wave.dot(*at).sin()).sum();
                most = most.max(sum.length_squared());
            }
        }
    }
    2.0 * own * (1.0 + cfm) / most
}

/// Lattice points around the origin, in spacings, with the kernel's gradients there.
fn gradients(support_ratio: f64, dimensions: u32) -> Vec<(DVec3, DVec3)> {
    let reach = support_ratio.ceil() as i32;
    let deep = if dimensions == 3 { reach } else { 0 };
    let mut all = Vec::new();
    for z in -deep..=deep {
        for y in -reach..=reach {
            for x in -reach..=reach {
                let at = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                if at.length() > 0.0 && at.length() < support_ratio {
                    all.push((at, wendland::gradient(at / support_ratio)));
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_fall_with_the_support_as_published_spectra_do() {
        // Measured spectra of jittered fluids, another kernel (cubic spline): .71-.77, .46-.53, .27-.33.
        let limits = [2.0, 2.5, 3.0].map(|ratio| relaxation_limit(ratio, 0.0, 3));
        println!("largest relaxation at h/d 2, 2.5, 3: {limits:?}");
        for (limit, published) in limits.into_iter().zip([0.74, 0.5, 0.3]) {
            assert!((limit / published - 1.0).abs() < 0.35, "{limits:?}");
        }
        assert!(limits[0] > limits[1] && limits[1] > limits[2]);
        assert!((relaxation_limit(2.0, 0.1, 3) / limits[0] - 1.1).abs() < 1e-12);
    }
}
