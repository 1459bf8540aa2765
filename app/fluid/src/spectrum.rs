//! How fast Jacobi iterations of the density constraint answer on the lattice at rest.
//!
//! A constraint that varies as exp(i k·x) is multiplied by 1 − ω |G(k)|² / D each iteration, with
//! G(k) = w Σ ∇W(r) exp(i k·r) over the lattice and D the denominator of λ: the correction
//! −Σ (λ_i + λ_j) ∇W is G/D of the constraint, and what it changes of the density is G again. The largest
//! |G|²/D over the wave vectors is λmax: iterations are stable for ω below 2/λmax.

use std::f64::consts::PI;

use crate::smoothing_kernel::{for_lattice, wendland_slope};

/// Wave vectors an axis of the first scan, over half of the Brillouin zone.
const WAVES: i32 = 16;
/// How often the distance between wave vectors is halved around the best one.
const HALVINGS: u32 = 6;

/// λmax of the cubic lattice, or in two `dimensions` of the square one, at h/d = `support_ratio`, with constraint
/// force mixing `cfm` over the lattice's own denominator: 2.6 in three dimensions at h = 2 d, 3.3 in two at h = 3 d.
/// Fluid that is compressed has more, by 3 % at 6 % of compression (three dimensions, h = 2 d) and by 9 % at 10 %
/// (two, h = 3 d).
pub fn lambda_max(dimensions: u32, support_ratio: f64, cfm: f64) -> f64 {
    let gradients = gradients(dimensions, support_ratio);
    // The kernel is even: opposite points give the same sine, and only one of the two is in the list.
    let own: f64 = 2.0 * gradients.iter().map(|(_, gradient)| dot(*gradient, *gradient)).sum::<f64>();
    let response = |wave: [f64; 3]| {
        let mut sum = [0.0; 3];
        for (at, gradient) in &gradients {
            let sine = 2.0 * dot(wave, *at).sin();
            (0..3).for_each(|axis| sum[axis] += sine * gradient[axis]);
        }
        dot(sum, sum) / own
    };
    let (mut best, mut most) = ([0.0; 3], 0.0);
    let mut look = |wave: [f64; 3], best: &mut [f64; 3]| {
        let here = response(wave);
        if here > most {
            (most, *best) = (here, wave);
        }
    };
    let mut step = PI / f64::from(WAVES);
    let depth = if dimensions == 2 { 0 } else { WAVES };
    // The lattice's symmetries leave x >= y >= z.
    for x in 0..=WAVES {
        for y in 0..=x {
            for z in 0..=y.min(depth) {
                look([x, y, z].map(|n| f64::from(n) * step), &mut best);
            }
        }
    }
    for _ in 0..HALVINGS {
        step *= 0.5;
        for axis in 0..dimensions as usize {
            for side in [-step, step] {
                let mut wave = best;
                wave[axis] += side;
                look(wave, &mut best);
            }
        }
    }
    most / (1.0 + cfm)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

/// Half of the lattice points around the origin, in spacings, with the kernel's gradients there; the others are
/// opposite.
fn gradients(dimensions: u32, support_ratio: f64) -> Vec<([f64; 3], [f64; 3])> {
    let mut all = Vec::new();
    for_lattice(dimensions, support_ratio, |steps, q| {
        if steps > [0; 3] {
            let at = steps.map(f64::from);
            all.push((at, at.map(|x| -wendland_slope(q) * x / (q * support_ratio))));
        }
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_what_power_iteration_finds() {
        // Power iterations on periodic lattices in f64, with a cfm of 0.01.
        for (dimensions, support_ratio, measured) in [(3, 2.0, 2.58), (3, 2.5, 3.81), (2, 3.0, 3.29)] {
            let found = lambda_max(dimensions, support_ratio, 0.01);
            println!("{dimensions}-D, h = {support_ratio} d: {found:.4}, measured {measured}");
            assert!((found / measured - 1.0).abs() < 0.03, "{dimensions}-D, h = {support_ratio} d: {found}");
        }
        // No measured figure fits another kernel, dimension or support.
        assert!((lambda_max(2, 2.0, 0.01) / 2.58 - 1.0).abs() > 0.03);
        assert!((lambda_max(3, 2.0, 0.1) / lambda_max(3, 2.0, 0.0) - 1.0 / 1.1).abs() < 1e-12);
    }

    #[test]
    fn limits_fall_with_the_support_as_published_spectra_do() {
        // Measured spectra of jittered fluids, another kernel (cubic spline): .71-.77, .46-.53, .27-.33.
        let limits = [2.0, 2.5, 3.0].map(|ratio| 2.0 / lambda_max(3, ratio, 0.0));
        println!("largest relaxation at h/d 2, 2.5, 3: {limits:?}");
        for (limit, published) in limits.into_iter().zip([0.74, 0.5, 0.3]) {
            assert!((limit / published - 1.0).abs() < 0.35, "{limits:?}");
        }
        assert!(limits[0] > limits[1] && limits[1] > limits[2]);
    }

    #[test]
    fn no_wave_answers_more() {
        // A scan three times as fine, of the whole octant, finds hardly more than the search does.
        for (dimensions, support_ratio) in [(2, 2.0), (2, 3.0), (3, 1.6), (3, 2.0)] {
            let points = gradients(dimensions, support_ratio);
            let own: f64 = 2.0 * points.iter().map(|(_, gradient)| dot(*gradient, *gradient)).sum::<f64>();
            let waves = 3 * WAVES;
            let deep = if dimensions == 2 { 0 } else { waves };
            let mut most = 0.0_f64;
            for n in 0..(waves + 1) * (waves + 1) * (deep + 1) {
                let wave = [n % (waves + 1), n / (waves + 1) % (waves + 1), n / (waves + 1) / (waves + 1)]
                    .map(|n| f64::from(n) * PI / f64::from(waves));
                let mut sum = [0.0; 3];
                for (at, gradient) in &points {
                    (0..3).for_each(|axis| sum[axis] += 2.0 * dot(wave, *at).sin() * gradient[axis]);
                }
                most = most.max(dot(sum, sum) / own);
            }
            let found = lambda_max(dimensions, support_ratio, 0.0);
            assert!((found / most - 1.0).abs() < 3e-3, "{dimensions} {support_ratio}: {found} {most}");
        }
    }
}
