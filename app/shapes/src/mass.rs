//! What a closed mesh weighs, and how hard it is to turn: sums over tetrahedra between its triangles and its middle.

use glam::{DMat3, DVec3};

use crate::mesh::Mesh;

/// What a body's mass is made of, for a density of 1 kg/m³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// m³.
    pub volume_m3: f64,
    /// m.
    pub centre_of_mass_m: DVec3,
    /// About that.
    pub inertia_m5: DMat3,
}

/// v v^T.
fn outer(v: DVec3) -> DMat3 {
    DMat3::from_cols(v * v.x, v * v.y, v * v.z)
}

/// The inertia of what has these second moments: the integral of r² - r r^T.
fn inertia(second_moments: DMat3) -> DMat3 {
    let trace = second_moments.x_axis.x + second_moments.y_axis.y + second_moments.z_axis.z;
    DMat3::from_diagonal(DVec3::splat(trace)) - second_moments
}

impl MassProperties {
    /// The inertia about another place, m⁵ (Huygens and Steiner).
    pub fn inertia_about_m5(&self, place_m: DVec3) -> DMat3 {
        self.inertia_m5 + inertia(outer(self.centre_of_mass_m - place_m)) * self.volume_m3
    }
}

impl Mesh {
    /// Those of a closed one whose triangles face outward.
    pub fn mass_properties(&self) -> MassProperties {
        let middle_m = self.bounds_m().into_iter().sum::<DVec3>() / 2.0;
        let (mut volume_m3, mut first_m4, mut second_m5) = (0.0, DVec3::ZERO, DMat3::ZERO);
        for triangle in 0..self.triangles.len() {
            let corners_m = self.corners_m(triangle).map(|corner_m| corner_m - middle_m);
            let [a, b, c] = corners_m;
            let sum_m = a + b + c;
            let of_m3 = a.dot(b.cross(c)) / 6.0;
            volume_m3 += of_m3;
            first_m4 += sum_m * (of_m3 / 4.0);
            // Of a tetrahedron with one corner at nothing: V/20 (sum of v v^T + (sum of v)(sum of v)^T).
            let squares = corners_m.into_iter().map(outer).fold(outer(sum_m), |sum, one| sum + one);
            second_m5 += squares * (of_m3 / 20.0);
        }
        let from_middle_m = first_m4 / volume_m3;
        let inertia_m5 = inertia(second_m5 - outer(from_middle_m) * volume_m3);
        MassProperties { volume_m3, centre_of_mass_m: middle_m + from_middle_m, inertia_m5 }
    }

    /// The largest of its shadows along the axes, m²: of a convex one exactly, of others what each dent adds besides.
    pub fn largest_shadow_m2(&self) -> f64 {
        let areas_m2 = (0..self.triangles.len()).map(|triangle| self.area_normal_m2(triangle).abs());
        0.5 * areas_m2.sum::<DVec3>().max_element()
    }

    /// Places of its surface at least `apart_m` from each other, and at most `most`: each is the one furthest from those before
    /// it, of its corners and of points on its triangles.
    pub fn spread_points_m(&self, apart_m: f64, most: usize) -> Vec<DVec3> {
        let mut candidates_m: Vec<DVec3> =
            self.triangles.iter().flatten().map(|&corner| self.positions_m[corner as usize]).collect();
        for triangle in 0..self.triangles.len() {
            let [a, b, c] = self.corners_m(triangle);
            let longest_m = a.distance(b).max(b.distance(c)).max(c.distance(a));
            // A triangle's own points are few: the largest has as many as are asked for at most.
            let parts = (2.0 * longest_m / apart_m).min((2.0 * most as f64).sqrt()).ceil() as u32;
            for i in 0..=parts {
                for j in 0..=parts - i {
                    let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(parts.max(1)));
                    candidates_m.push(a + u * (b - a) + v * (c - a));
                }
            }
        }
        let mut gaps_m = vec![f64::INFINITY; candidates_m.len()];
        let mut points_m: Vec<DVec3> = Vec::new();
        // The first is the one furthest from the middle.
        let middle_m = self.bounds_m().into_iter().sum::<DVec3>() / 2.0;
        let mut next = (0..candidates_m.len())
            .max_by(|&a, &b| candidates_m[a].distance(middle_m).total_cmp(&candidates_m[b].distance(middle_m)));
        while let Some(chosen) = next {
            let at_m = candidates_m[chosen];
            points_m.push(at_m);
            let mut furthest: Option<(usize, f64)> = None;
            for (index, (gap_m, candidate_m)) in gaps_m.iter_mut().zip(&candidates_m).enumerate() {
                *gap_m = gap_m.min(candidate_m.distance(at_m));
                if furthest.is_none_or(|(_, most_m)| *gap_m > most_m) {
                    furthest = Some((index, *gap_m));
                }
            }
            next = furthest.filter(|&(_, gap_m)| gap_m >= apart_m && points_m.len() < most).map(|(index, _)| index);
        }
        points_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hull;
    use glam::DQuat;

    fn turned_box() -> (Mesh, DQuat, DVec3) {
        let (half_m, at_m) = (DVec3::new(0.1, 0.2, 0.4), DVec3::new(3.0, -1.0, 0.5));
        let rotation = DQuat::from_scaled_axis(DVec3::new(0.4, -0.7, 0.2));
        let corner = |k: usize| {
            let signs = DVec3::from_array(std::array::from_fn(|axis| if k >> axis & 1 == 0 { -1.0 } else { 1.0 }));
            at_m + rotation * (signs * half_m)
        };
        (hull(&(0..8).map(corner).collect::<Vec<_>>()).unwrap(), rotation, at_m)
    }

    #[test]
    fn a_turned_box_weighs_and_turns_as_its_formula_says() {
        let (mesh, rotation, at_m) = turned_box();
        let mass = mesh.mass_properties();
        let volume_m3 = 0.2 * 0.4 * 0.8;
        assert!((mass.volume_m3 / volume_m3 - 1.0).abs() < 1e-12);
        assert!(mass.centre_of_mass_m.distance(at_m) < 1e-12);
        let along = DMat3::from_diagonal(volume_m3 / 12.0 * DVec3::new(0.16 + 0.64, 0.04 + 0.64, 0.04 + 0.16));
        let turned = DMat3::from_quat(rotation) * along * DMat3::from_quat(rotation.conjugate());
        assert!(mass.inertia_m5.abs_diff_eq(turned, 1e-12), "{} and {turned}", mass.inertia_m5);
        // About a place a metre away along x there is V more to turn about y and z.
        let there = mass.inertia_about_m5(at_m + DVec3::X);
        let more = DMat3::from_diagonal(DVec3::new(0.0, volume_m3, volume_m3));
        assert!(there.abs_diff_eq(turned + more, 1e-12), "{there}");
    }

    /// Of a box the largest face, times what it is turned by at most.
    #[test]
    fn shadows_are_those_of_faces() {
        let straight =
            hull(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]].map(DVec3::from_array)).unwrap();
        assert!((straight.largest_shadow_m2() - 3.0).abs() < 1e-12, "{}", straight.largest_shadow_m2());
    }

    #[test]
    fn spread_points_are_on_the_surface_apart_and_leave_no_gap() {
        let (mesh, rotation, at_m) = turned_box();
        let points_m = mesh.spread_points_m(0.1, 1000);
        let beyond_m = |place_m: DVec3| {
            let q = (rotation.conjugate() * (place_m - at_m)).abs() - DVec3::new(0.1, 0.2, 0.4);
            q.max_element()
        };
        for (k, &one) in points_m.iter().enumerate() {
            assert!(beyond_m(one).abs() < 1e-9, "{one}");
            assert!(points_m[..k].iter().all(|other| other.distance(one) >= 0.1));
        }
        // Corners come first, and everything is within reach of a point.
        assert!(points_m.len() > 50 && points_m.len() < 130, "{}", points_m.len());
        assert_eq!(mesh.spread_points_m(0.1, 8).len(), 8);
        for corner in mesh.spread_points_m(0.02, 3000) {
            assert!(points_m.iter().any(|other| other.distance(corner) < 0.13), "{corner}");
        }
    }
}
