//! The wall-weight function as the shader has it: in closed form, a little off the integrals
//! ([`crate::boundary::wall_integrals`]) beyond edges and corners. (Shader: `boundary/walls.hlsli`.)

use super::BoundarySample;
use crate::shared::lattice;
use brooklet_kernels::SmoothingKernelParams;
use glam::{BVec3, DVec3, Vec3Swizzles};

/// Coefficients of the share of the kernel beyond a wall that it reaches by t: t^5 times a polynomial of
/// t. In two dimensions the integral is no polynomial; this one is close to it.
fn coefficients(dimensions: u32) -> [f64; 4] {
    match dimensions {
        2 => [0.684_768_84, 1.544_916_68, -2.630_423_74, 0.900_738_22],
        _ => [0.0, 3.5, -4.5, 1.5],
    }
}

/// The share of the kernel beyond one wall, at a distance in h.
pub fn beyond_wall(dimensions: u32, distance: f64) -> f64 {
    beyond_wall_of(coefficients(dimensions), distance)
}

fn beyond_wall_of([c0, c1, c2, c3]: [f64; 4], distance: f64) -> f64 {
    let reach = (1.0 - distance).clamp(0.0, 1.0);
    reach.powi(5) * (c0 + reach * (c1 + reach * (c2 + reach * c3)))
}

/// Its derivative over the distance, per h.
fn beyond_wall_slope([c0, c1, c2, c3]: [f64; 4], distance: f64) -> f64 {
    let reach = (1.0 - distance).clamp(0.0, 1.0);
    -reach.powi(4) * (5.0 * c0 + reach * (6.0 * c1 + reach * (7.0 * c2 + reach * 8.0 * c3)))
}

/// The density ratio of all space, as one, two or three walls' shares of it count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallScales {
    /// Of one wall's share.
    pub plane: f64,
    /// Of two walls' product.
    pub edge: f64,
    /// Of three walls' product; zero in two dimensions, which have no third.
    pub corner: f64,
    /// Coefficients of the share of the kernel beyond a wall that it reaches by t: t^5 times a polynomial of t.
    pub fraction: [f64; 4],
}

impl WallScales {
    /// Those that shaders are given.
    pub fn of(kernel: &SmoothingKernelParams) -> Self {
        Self {
            plane: kernel.wall_plane.into(),
            edge: kernel.wall_edge.into(),
            corner: kernel.wall_corner.into(),
            fraction: kernel.wall_kernel_fraction.map(f64::from),
        }
    }

    /// Scales with which a lattice half a spacing from walls has density ratio 1, where
    /// `support_ratio` = h / spacing and the lattice has points beyond a corner (1.74 or more).
    pub fn new(dimensions: u32, support_ratio: f64) -> Self {
        let share = beyond_wall(dimensions, 0.5 / support_ratio);
        Self {
            plane: lattice::deficit(dimensions, support_ratio, 1) / share,
            edge: lattice::deficit(dimensions, support_ratio, 2) / share.powi(2),
            corner: lattice::deficit(dimensions, support_ratio, 3) / share.powi(3),
            fraction: coefficients(dimensions),
        }
    }
}

/// The walls of a box.
#[derive(Clone, Copy, Debug)]
pub struct DomainWalls {
    /// 2 or 3.
    pub dimensions: u32,
    /// Along which axes they stand, at both ends.
    pub axes: BVec3,
    /// How much what lies beyond them counts.
    pub scales: WallScales,
    /// The box; its lowest corner is the origin.
    pub domain_size_m: DVec3,
    /// Support radius, m.
    pub support_m: f64,
}

impl DomainWalls {
    /// What the walls answer at a position.
    ///
    /// Beyond two opposite walls no point is the same, so their shares add up.
    ///
    /// A correction is scaled to stand for the neighbours' mirror images in the walls of the other two axes. Along a
    /// wall an even slope of pressure pulls with the integral of -y dW/dy, which by parts is that of W: the images'
    /// share of it is the density that the wall adds. Never more than doubled for an axis.
    ///
    /// What they bear of the fluid's weight across them is the integral of u dW/du beyond, negative, u from the particle, with
    /// which a pressure that grows by ρ g u pushes back. By parts it is the density beyond and the wall's distance times its
    /// slope.
    pub fn sample(&self, position_m: DVec3) -> BoundarySample {
        let (share, slope) = self.shares(position_m);
        let [others, product] =
            [DVec3::new(share.y + share.z, share.z + share.x, share.x + share.y), share.yzx() * share.zxy()];
        let WallScales { plane, edge, corner, .. } = self.scales;
        let gain = 1.0 / (1.0 - (plane * share).min(DVec3::splat(0.5)));
        let density = plane * share.element_sum() - edge * product.element_sum() + corner * share.element_product();
        BoundarySample {
            density,
            gradient: slope * (DVec3::splat(plane) - edge * others + corner * product),
            correction_scale: gain.yzx() * gain.zxy(),
            borne: plane * (share + self.moments(position_m)),
        }
    }

    /// Along each axis, the slopes of its two walls' shares, each times the wall's distance in h.
    fn moments(&self, position_m: DVec3) -> DVec3 {
        let low = position_m / self.support_m;
        let high = (self.domain_size_m - position_m) / self.support_m;
        let moment = |s: f64| s.clamp(0.0, 1.0) * self.share_slope(s);
        let each = |axis: usize| moment(low[axis]) + moment(high[axis]);
        DVec3::select(self.axes, DVec3::new(each(0), each(1), each(2)), DVec3::ZERO)
    }

    /// How much of the kernel beyond one wall a step toward it adds, at a distance in h, per h.
    pub fn share_slope(&self, distance: f64) -> f64 {
        -beyond_wall_slope(self.scales.fraction, distance)
    }

    /// Along each axis, the share of the kernel beyond its two walls, and the share's derivative by
    /// the position, per h.
    fn shares(&self, position_m: DVec3) -> (DVec3, DVec3) {
        let low = position_m / self.support_m;
        let high = (self.domain_size_m - position_m) / self.support_m;
        let each = |of: &dyn Fn(usize) -> f64| DVec3::select(self.axes, DVec3::new(of(0), of(1), of(2)), DVec3::ZERO);
        let of = self.scales.fraction;
        (
            each(&|axis| beyond_wall_of(of, low[axis]) + beyond_wall_of(of, high[axis])),
            each(&|axis| beyond_wall_slope(of, low[axis]) - beyond_wall_slope(of, high[axis])),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::wall_integrals::WallIntegrals;
    use crate::shared::quadrature::Gauss;
    use crate::shared::wendland::{gradient, kernel};
    use std::f64::consts::PI;

    /// A box far larger than the support, which is 1 m.
    fn wide(support_ratio: f64) -> DomainWalls {
        DomainWalls {
            dimensions: 3,
            axes: BVec3::TRUE,
            scales: WallScales::new(3, support_ratio),
            domain_size_m: DVec3::splat(100.0),
            support_m: 1.0,
        }
    }

    #[test]
    fn planes_are_their_integrals() {
        let walls = wide(2.0);
        let integrals = WallIntegrals::new(2.0);
        for i in 0..=40 {
            let s = f64::from(i) / 40.0;
            let at = walls.sample(DVec3::new(s, 50.0, 50.0));
            assert!((at.density - integrals.plane(s)).abs() < 1e-12, "{s}");
            assert!((at.gradient.x - integrals.plane_slope(s)).abs() < 1e-12, "{s}");
        }
    }

    #[test]
    fn planes_of_two_dimensions_are_close_to_their_integrals() {
        // The share of the disc beyond a line and its slope; beyond two lines the product of shares.
        let gauss = Gauss::new(48);
        let line = |x: f64| 2.0 * gauss.integrate(0.0, (1.0 - x * x).max(0.0).sqrt(), |y| kernel(x.hypot(y)));
        let volume = PI / 7.0;
        let (mut share, mut slope, mut product) = (0.0_f64, 0.0_f64, 0.0_f64);
        for i in 0..=40 {
            let s = f64::from(i) / 40.0;
            let integral = gauss.integrate(s, 1.0, line) / volume;
            share = share.max((beyond_wall(2, s) - integral).abs());
            slope = slope.max((beyond_wall_slope(coefficients(2), s) + line(s) / volume).abs());
            for j in (0..=40).step_by(4) {
                let t = f64::from(j) / 40.0;
                let beyond = |x: f64| gauss.integrate(t, (1.0 - x * x).max(t * t).sqrt(), |y| kernel(x.hypot(y)));
                let both = gauss.integrate(s, (1.0 - t * t).max(s * s).sqrt(), beyond) / volume;
                product = product.max((beyond_wall(2, s) * beyond_wall(2, t) - both).abs());
            }
        }
        println!("two dimensions: share {share:.1e}, slope {slope:.1e} / h, product {product:.1e}");
        assert!(share < 6e-5 && slope < 1.2e-3 && product < 4e-3, "{share} {slope} {product}");
        // Told apart from the share of the ball.
        let off = (0..=40).map(|i| f64::from(i) / 40.0).map(|s| (beyond_wall(2, s) - beyond_wall(3, s)).abs());
        assert!(off.fold(0.0, f64::max) > 4e-3);
    }

    #[test]
    fn a_lattice_in_two_dimensions_keeps_density_one() {
        for support_ratio in [2.0, 2.5, 3.0] {
            let walls = DomainWalls {
                dimensions: 2,
                axes: BVec3::new(true, true, false),
                scales: WallScales::new(2, support_ratio),
                ..wide(support_ratio)
            };
            for axes in 0..=2 {
                // z is at the domain's face, where no wall stands.
                let mut at = DVec3::new(50.0, 50.0, 0.0);
                (0..axes).for_each(|axis| at[axis] = 0.5 / support_ratio);
                let inside = lattice::sum_where(2, support_ratio, |k| k[..axes].iter().all(|&k| k >= 0));
                let ratio = lattice::weight(2, support_ratio) * inside + walls.sample(at).density;
                assert!((ratio - 1.0).abs() < 1e-12, "{axes} walls: {ratio}");
                assert_eq!(walls.sample(at).gradient.z, 0.0);
            }
        }
    }

    #[test]
    fn products_of_planes_are_close_to_edges_and_corners() {
        // The kernel is not quite a product of kernels along the axes. At 11^3 points in a corner:
        // how far off the product is where particles may be, half a spacing from walls or further,
        // and anywhere.
        for (support_ratio, allowed) in [(2.0, [0.002, 0.012]), (2.5, [0.003, 0.006]), (3.0, [0.003, 0.004])] {
            let walls = wide(support_ratio);
            let integrals = WallIntegrals::new(support_ratio);
            for (nearest, allowed) in [0.5 / support_ratio, 0.0].into_iter().zip(allowed) {
                let (mut density, mut slope) = (0.0_f64, 0.0_f64);
                let node = |i: usize| nearest + (1.0 - nearest) * i as f64 / 10.0;
                for i in 0..11_usize.pow(3) {
                    let position = DVec3::new(node(i % 11), node(i / 11 % 11), node(i / 121));
                    let at = walls.sample(position);
                    density = density.max((at.density - integrals.density(position)).abs());
                    slope = slope.max((at.gradient - integrals.gradient(position)).abs().max_element());
                }
                println!("h = {support_ratio} d, from {nearest} h: {density:.4}, gradient {slope:.4} / h");
                assert!(
                    density < allowed && slope < 0.025,
                    "h = {support_ratio} d, from {nearest} h: {density} {slope}"
                );
            }
        }
    }

    #[test]
    fn lattice_keeps_density_one() {
        for support_ratio in [2.0, 2.5, 3.0] {
            let walls = wide(support_ratio);
            let near = 0.5 / support_ratio;
            for axes in 0..=3 {
                let mut at = DVec3::splat(50.0);
                (0..axes).for_each(|axis| at[axis] = near);
                let inside = lattice::sum_where(3, support_ratio, |k| k[..axes].iter().all(|&k| k >= 0));
                let ratio = lattice::weight(3, support_ratio) * inside + walls.sample(at).density;
                assert!((ratio - 1.0).abs() < 1e-12, "{axes} walls: {ratio}");
            }
        }
    }

    #[test]
    fn gradient_is_the_derivative() {
        let walls = wide(2.0);
        for at in [DVec3::new(0.25, 0.3, 0.1), DVec3::new(0.1, 0.8, 2.0), DVec3::new(99.5, 2.0, 99.9)] {
            let gradient = walls.sample(at).gradient;
            for axis in 0..3 {
                let mut e = DVec3::ZERO;
                e[axis] = 1e-5;
                let difference = (walls.sample(at + e).density - walls.sample(at - e).density) / 2e-5;
                assert!((gradient[axis] - difference).abs() < 1e-6, "{at} axis {axis}");
            }
        }
    }

    #[test]
    fn narrow_channels_keep_density_one() {
        // One layer between two walls, and one particle in a box of its own size.
        let weight = lattice::weight(3, 2.0);
        for (size, layer) in [(DVec3::new(9.0, 1.0, 9.0), true), (DVec3::ONE, false)] {
            let walls = DomainWalls { domain_size_m: size, support_m: 2.0, ..wide(2.0) };
            let at = walls.sample(size / 2.0);
            let inside = lattice::sum_where(3, 2.0, |k| k == [0; 3] || layer && k[1] == 0);
            let ratio = weight * inside + at.density;
            assert!((ratio - 1.0).abs() < 1e-12, "{size}: {ratio}");
            assert!(at.gradient.length() < 1e-14);
        }
    }

    #[test]
    fn mirror_images_pull_along_walls() {
        // Half a spacing from a wall, in a lattice whose lambda rises evenly along the wall: what
        // the fluid's side gives times the gain is what it and its mirror image give together.
        for (support_ratio, tolerance) in [(2.0, 0.02), (2.5, 0.02), (3.0, 0.01)] {
            let domain = DomainWalls { support_m: support_ratio, ..wide(support_ratio) };
            let pull = |walls: usize| {
                let mut sum = 0.0;
                let reach = support_ratio.ceil() as i32;
                for point in lattice::points([2 * reach as usize + 1; 3], 1.0) {
                    let offset = point - 0.5 - f64::from(reach);
                    if (0..walls).all(|axis| offset[axis] >= 0.0) {
                        sum += offset.z * gradient(-offset / support_ratio).z;
                    }
                }
                sum
            };
            for count in 0..=2 {
                let mut at = DVec3::splat(50.0);
                for axis in 0..count {
                    at[axis] = 0.5;
                }
                let error = pull(count) * domain.sample(at).correction_scale.z / pull(0) - 1.0;
                assert!(error.abs() < tolerance, "h = {support_ratio} d, {count} walls: {error}");
            }
        }
    }
}
