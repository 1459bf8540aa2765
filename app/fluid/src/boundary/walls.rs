//! What walls count, so that the shader's closed form of the wall-weight function (Harada, Koshizuka
//! & Kawaguchi 2007) agrees with the lattice. (Shader: `boundary/walls.hlsli`.)
//!
//! Beyond one wall at distance s lies the share P(s) of the kernel; beyond several at right angles
//! nearly the product of their shares: within .003 of the kernel's integral, .004 in two dimensions.
//! By inclusion and exclusion the density ratio beyond the walls is a ΣP − e ΣPP + c PPP. Shares stand
//! for wall particles at rest; a, e and c are such that fluid placed half a spacing from walls has
//! density ratio 1 at walls, edges and corners alike.

use std::f64::consts::PI;

use crate::smoothing_kernel::{for_lattice, wendland};

/// Coefficients c of the share of Wendland's kernel beyond a wall that it reaches by t (in h):
/// t⁵ (c₀ + c₁ t + c₂ t² + c₃ t³). In three dimensions that is the integral itself. In two it has
/// logarithms; this is within 5e-5 of it and of its slope within 1e-3 / h (least squares over 0 to h; test
/// `planes_of_two_dimensions_are_close_to_their_integrals` of the twin).
pub fn wall_kernel_fraction(dimensions: u32) -> [f64; 4] {
    match dimensions {
        2 => [0.684_768_84, 1.544_916_68, -2.630_423_74, 0.900_738_22],
        _ => [0.0, 3.5, -4.5, 1.5],
    }
}

/// The share of Wendland's kernel beyond a wall, at a distance in h.
pub fn beyond_wall(dimensions: u32, distance: f64) -> f64 {
    share(wall_kernel_fraction(dimensions), distance)
}

/// The share of a kernel beyond a wall whose fraction has these coefficients, at a distance in h.
pub(crate) fn share([c0, c1, c2, c3]: [f64; 4], distance: f64) -> f64 {
    let t = (1.0 - distance).clamp(0.0, 1.0);
    t.powi(5) * (c0 + t * (c1 + t * (c2 + t * c3)))
}

/// How that share grows towards the wall, 1/h.
pub(crate) fn share_slope([c0, c1, c2, c3]: [f64; 4], distance: f64) -> f64 {
    let t = (1.0 - distance).clamp(0.0, 1.0);
    t.powi(4) * (5.0 * c0 + t * (6.0 * c1 + t * (7.0 * c2 + t * 8.0 * c3)))
}

/// Nodes of a midpoint rule over 0 to 1: within 1e-6 of kernels' integrals.
const NODES: u32 = 1000;

fn integral(of: impl Fn(f64) -> f64) -> f64 {
    (0..NODES).map(|i| of((f64::from(i) + 0.5) / f64::from(NODES))).sum::<f64>() / f64::from(NODES)
}

/// A kernel's integral over space or the plane, h = 1.
fn volume(dimensions: u32, kernel: impl Fn(f64) -> f64) -> f64 {
    match dimensions {
        2 => integral(|q| 2.0 * PI * q * kernel(q)),
        _ => integral(|q| 4.0 * PI * q * q * kernel(q)),
    }
}

/// Coefficients as those of [`wall_kernel_fraction`] of another kernel, of q: the least squares' fit to its share beyond a
/// wall over 0 to h, which is a half where the wall is touched.
pub fn fitted_wall_kernel_fraction(dimensions: u32, kernel: impl Fn(f64) -> f64) -> [f64; 4] {
    const POINTS: usize = 64;
    // What of the kernel lies in the plane, or on the line, at a distance.
    let layer = |x: f64| match dimensions {
        2 => 2.0 * (1.0 - x * x).sqrt() * integral(|y| kernel((x * x + y * y * (1.0 - x * x)).sqrt())),
        _ => 2.0 * PI * (1.0 - x) * integral(|y| (x + y * (1.0 - x)) * kernel(x + y * (1.0 - x))),
    };
    let whole = volume(dimensions, &kernel);
    let step = 1.0 / POINTS as f64;
    let mut rows = [[0.0; 4]; 3];
    let mut beyond = 0.0;
    // From h inwards. The last coefficient follows from the others: the share at 0 is a half.
    for i in (0..POINTS).rev() {
        let middle = (i as f64 + 0.5) * step;
        let t = 1.0 - middle;
        let at_middle = beyond + 0.5 * step * layer(middle + 0.25 * step) / whole;
        beyond += step * layer(middle) / whole;
        let terms: [f64; 3] = std::array::from_fn(|k| t.powi(5 + k as i32) - t.powi(8));
        let wanted = at_middle - 0.5 * t.powi(8);
        for (row, term) in rows.iter_mut().zip(terms) {
            for (column, other) in terms.iter().enumerate() {
                row[column] += term * other;
            }
            row[3] += term * wanted;
        }
    }
    let [c0, c1, c2] = solved(rows);
    [c0, c1, c2, 0.5 - c0 - c1 - c2]
}

/// Three unknowns of three equations, by elimination; their matrix is that of a least squares' fit.
fn solved(mut rows: [[f64; 4]; 3]) -> [f64; 3] {
    for pivot in 0..3 {
        let first = rows[pivot];
        for other in (0..3).filter(|&other| other != pivot) {
            let factor = rows[other][pivot] / first[pivot];
            for column in 0..4 {
                rows[other][column] -= factor * first[column];
            }
        }
    }
    std::array::from_fn(|k| rows[k][3] / rows[k][k])
}

/// The density ratio of all space, as one, two or three walls' shares of it count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallScales {
    /// a: of one wall's share.
    pub plane: f64,
    /// e: of two walls' product.
    pub edge: f64,
    /// c: of three walls' product; of no use in two dimensions.
    pub corner: f64,
}

impl WallScales {
    /// The scales of Wendland's kernel in 2 or 3 `dimensions` at a support of `support_ratio` spacings.
    pub fn new(dimensions: u32, support_ratio: f64) -> Self {
        Self::of(dimensions, support_ratio, wendland, wall_kernel_fraction(dimensions))
    }

    /// Those of another kernel, of q, whose share beyond a wall has these coefficients.
    pub fn of(dimensions: u32, support_ratio: f64, kernel: impl Fn(f64) -> f64, fraction: [f64; 4]) -> Self {
        let (mut missing, mut all) = ([0.0; 3], 0.0);
        for_lattice(dimensions, support_ratio, |step, q| {
            all += kernel(q);
            for (axes, sum) in missing.iter_mut().enumerate() {
                if step[..=axes].iter().all(|&k| k > 0) {
                    *sum += kernel(q);
                }
            }
        });
        let weight = 1.0 / all;
        let share = share(fraction, 0.5 / support_ratio);
        // Where the lattice has no point beyond an edge or a corner, the continuum stands in.
        let continuum = weight * support_ratio.powi(dimensions as i32) * volume(dimensions, &kernel);
        let scale = |sum: f64, share: f64| if sum > 0.0 { weight * sum / share } else { continuum };
        Self {
            plane: scale(missing[0], share),
            edge: scale(missing[1], share.powi(2)),
            corner: scale(missing[2], share.powi(3)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::smoothing_kernel::lattice;

    #[test]
    fn lattice_against_walls_has_density_ratio_one() {
        for (dimensions, support_ratio) in [2, 3].into_iter().flat_map(|n| [2.0, 2.5, 3.0].map(|ratio| (n, ratio))) {
            let scales = WallScales::new(dimensions, support_ratio);
            let weight = lattice(dimensions, support_ratio).weight;
            let share = beyond_wall(dimensions, 0.5 / support_ratio);
            for walls in 0..=dimensions as usize {
                let mut inside = 0.0;
                for_lattice(dimensions, support_ratio, |step, q| {
                    if step[..walls].iter().all(|&k| k >= 0) {
                        inside += wendland(q) * weight;
                    }
                });
                // Of one, two and three walls: how many planes, edges and corners there are.
                let [planes, edges, corners] = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0]][walls];
                let beyond = scales.plane * planes * share - scales.edge * edges * share.powi(2)
                    + scales.corner * corners * share.powi(3);
                let ratio = inside + beyond;
                assert!((ratio - 1.0).abs() < 1.0e-12, "{dimensions}-D, h = {support_ratio} d, {walls} walls: {ratio}");
            }
        }
    }

    #[test]
    fn the_fit_of_a_kernel_is_close_to_its_share() {
        // Wendland's is known; that of (1 - q)^3 is t^5/20 - t^6/30 over pi/30 times 2 pi: no more than two terms.
        for dimensions in [2, 3] {
            let fit = fitted_wall_kernel_fraction(dimensions, wendland);
            for i in 0..=20 {
                let distance = f64::from(i) / 20.0;
                let off = share(fit, distance) - beyond_wall(dimensions, distance);
                assert!(off.abs() < 3e-4, "{dimensions}-D at {distance}: {off}");
            }
        }
        let spiky = fitted_wall_kernel_fraction(3, |q| (1.0 - q).max(0.0).powi(3));
        let exact = |distance: f64| (1.0 - distance).powi(5) * (1.5 - (1.0 - distance));
        for i in 0..=20 {
            let distance = f64::from(i) / 20.0;
            assert!((share(spiky, distance) - exact(distance)).abs() < 3e-4, "{distance}");
        }
    }

    #[test]
    fn half_of_the_kernel_is_beyond_a_wall_that_is_touched() {
        for dimensions in [2, 3] {
            assert!((beyond_wall(dimensions, 0.0) - 0.5).abs() < 1.0e-12);
            assert_eq!(beyond_wall(dimensions, 1.0), 0.0);
            assert_eq!(beyond_wall(dimensions, 7.0), 0.0);
        }
    }
}
