//! Ellipsoids of particles (Yu & Turk 2013).

use brooklet_kernels::{
    AnisotropyParams, FLAT_MEAN, LEAST_VARIANCE, MOST_STRETCH, SMOOTHED_CENTER, SPRAY_RADIUS, SurfaceParams,
};
use glam::{DMat3, DVec3};

/// Weight of neighbours from which a particle is no more a drop of spray.
const CROWD: f64 = 6.0;

/// A particle's ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Its middle, m.
    pub center_m: DVec3,
    /// The symmetric matrix, without unit, that stretches the particle's sphere into it.
    pub stretch: DMat3,
}

/// The ellipsoid of particle `i` between the walls of `surface`. (Shader: `surface/anisotropy.compute`.)
pub fn anisotropy(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    params: &AnisotropyParams,
    surface: &SurfaceParams,
) -> Ellipsoid {
    let (x_i_m, support_m) = (positions_m[i], f64::from(params.support_m));
    let images = |at_m: DVec3| -> Vec<DVec3> {
        let mut images = vec![at_m];
        for axis in 0..3 {
            let (low_m, high_m) = (f64::from(surface.wall_min_m[axis]), f64::from(surface.wall_max_m[axis]));
            let (below_m, above_m) = (x_i_m[axis] - low_m, high_m - x_i_m[axis]);
            if below_m.min(above_m) < support_m {
                let wall_m = if below_m < above_m { low_m } else { high_m };
                for image in images.clone() {
                    let mut mirrored = image;
                    mirrored[axis] = 2.0 * wall_m - image[axis];
                    images.push(mirrored);
                }
            }
        }
        images
    };
    let weight = |at_m: DVec3| (1.0 - ((at_m - x_i_m).length() / support_m).powi(3)).max(0.0);
    let near: f64 = neighbours.iter().map(|&j| weight(positions_m[j])).sum();
    let seen_m: Vec<DVec3> =
        std::iter::once(i).chain(neighbours.iter().copied()).flat_map(|j| images(positions_m[j])).collect();
    let weights: f64 = seen_m.iter().map(|&at_m| weight(at_m)).sum();
    let mean_m = seen_m.iter().map(|&at_m| weight(at_m) * at_m).sum::<DVec3>() / weights;
    let covariance = seen_m.iter().fold(DMat3::ZERO, |sum, &at_m| {
        let offset = (at_m - mean_m) / support_m;
        sum + DMat3::from_cols(offset * offset.x, offset * offset.y, offset * offset.z) * (weight(at_m) / weights)
    });
    let crowd = smooth_step(near / CROWD);
    let (variances, axes) = eigen(covariance);
    let clamped = variances.max(DVec3::splat(variances.max_element() / f64::from(MOST_STRETCH)));
    let clamped = clamped.max(DVec3::splat(f64::from(LEAST_VARIANCE)));
    let stretched = clamped / clamped.element_product().cbrt();
    let size = f64::from(SPRAY_RADIUS) + (1.0 - f64::from(SPRAY_RADIUS)) * crowd;
    let diagonal = size * (DVec3::ONE + (stretched - DVec3::ONE) * crowd);
    let moved = (mean_m - x_i_m) / support_m;
    let flat = f64::from(FLAT_MEAN);
    let beyond = moved - moved.normalize_or_zero() * flat * smooth_step(moved.length() / flat);
    Ellipsoid {
        center_m: x_i_m + beyond * (support_m * crowd * f64::from(SMOOTHED_CENTER)),
        stretch: axes * DMat3::from_diagonal(diagonal) * axes.transpose(),
    }
}

fn smooth_step(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Eigenvalues of a symmetric matrix, and its eigenvectors as columns: rotations of the largest
/// element beside the diagonal, until nothing is left of it.
pub fn eigen(mut matrix: DMat3) -> (DVec3, DMat3) {
    let mut axes = DMat3::IDENTITY;
    for _ in 0..100 {
        let largest = [(0, 1), (0, 2), (1, 2)]
            .into_iter()
            .max_by(|&(a, b), &(c, d)| matrix.col(a)[b].abs().total_cmp(&matrix.col(c)[d].abs()));
        let Some((p, q)) = largest.filter(|&(p, q)| matrix.col(p)[q].abs() > 1e-300) else { break };
        let angle = 0.5 * (2.0 * matrix.col(p)[q]).atan2(matrix.col(q)[q] - matrix.col(p)[p]);
        let mut rotation = DMat3::IDENTITY;
        rotation.col_mut(p)[p] = angle.cos();
        rotation.col_mut(q)[q] = angle.cos();
        rotation.col_mut(p)[q] = -angle.sin();
        rotation.col_mut(q)[p] = angle.sin();
        matrix = rotation.transpose() * matrix * rotation;
        axes *= rotation;
    }
    (DVec3::new(matrix.x_axis.x, matrix.y_axis.y, matrix.z_axis.z), axes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open() -> SurfaceParams {
        SurfaceParams { wall_min_m: [-1e18; 3], wall_max_m: [1e18; 3], ..SurfaceParams::default() }
    }

    /// A lattice of spacing 1 around the origin, where it is inside.
    fn lattice(inside: impl Fn(DVec3) -> bool) -> Vec<DVec3> {
        let all = (0..343).map(|i| DVec3::new(f64::from(i % 7), f64::from(i / 7 % 7), f64::from(i / 49)) - 3.0);
        std::iter::once(DVec3::ZERO).chain(all.filter(|&at| at != DVec3::ZERO && inside(at))).collect()
    }

    fn at_origin(points: &[DVec3], surface: &SurfaceParams) -> Ellipsoid {
        let params = AnisotropyParams { support_m: 2.0, ..AnisotropyParams::default() };
        anisotropy(0, points, &(1..points.len()).collect::<Vec<_>>(), &params, surface)
    }

    #[test]
    fn inside_a_lattice_it_is_the_sphere_and_at_its_face_flat() {
        let inside = at_origin(&lattice(|_| true), &open());
        assert!(inside.center_m.length() < 1e-12 && (inside.stretch - DMat3::IDENTITY).abs_diff_eq(DMat3::ZERO, 1e-9));
        let face = at_origin(&lattice(|at| at.y <= 0.0), &open());
        let axes = DVec3::new(face.stretch.x_axis.x, face.stretch.y_axis.y, face.stretch.z_axis.z);
        assert!(axes.y < 0.6 && axes.x > 1.2 && (axes.x - axes.z).abs() < 1e-9, "{axes}");
        assert!((face.stretch.determinant() - 1.0).abs() < 1e-9 && face.center_m.length() < 0.02, "{}", face.center_m);
    }

    #[test]
    fn at_the_wall_the_fluid_goes_on_in_its_mirror() {
        let wall = SurfaceParams { wall_max_m: [1e18, 0.5, 1e18], ..open() };
        let face = at_origin(&lattice(|at| at.y <= 0.0), &wall);
        assert!(face.center_m.length() < 1e-12, "{}", face.center_m);
        assert!(face.stretch.abs_diff_eq(DMat3::IDENTITY, 1e-9));
    }

    #[test]
    fn a_particle_alone_is_a_small_sphere() {
        let alone = at_origin(&[DVec3::ZERO], &open());
        assert!(alone.stretch.abs_diff_eq(DMat3::IDENTITY * f64::from(SPRAY_RADIUS), 1e-12));
    }

    #[test]
    fn eigenvectors_make_the_matrix_again() {
        let root = DMat3::from_cols(DVec3::new(1.0, 0.2, -0.4), DVec3::new(0.3, 2.0, 0.1), DVec3::new(0.0, -0.7, 0.5));
        let matrix = root * root.transpose();
        let (values, axes) = eigen(matrix);
        let again = axes * DMat3::from_diagonal(values) * axes.transpose();
        assert!(again.abs_diff_eq(matrix, 1e-12) && (axes.determinant() - 1.0).abs() < 1e-12);
    }
}
