//! What solids may be that the fluid moves.

use glam::DVec3;

use super::{Checker, numbers, tidied};
use crate::scene::bodies::{MOST_BODIES, body_solids, points_of};
use crate::scene::field::Short;
use crate::scene::solid_shapes::StandingSolid;
use crate::scene::{Scene, SceneError, Shape, SolidSettings};

/// Of the fluid's density: what is lighter or heavier was not tried.
const RATIOS: [f64; 2] = [0.05, 20.0];

impl Scene {
    /// No more than a group has threads, of a density that was tried, in the domain, and none in another or in a solid.
    pub(super) fn check_bodies(&self, check: &Checker) -> Result<(), SceneError> {
        let count = body_solids(self).count();
        check.require(
            count <= MOST_BODIES,
            "solid",
            format_args!("{count} solids with a density_kg_m3"),
            format_args!("at most {MOST_BODIES}"),
        )?;
        if count > 0 {
            check.require(
                self.solver.pbf.warm_start == 0.0,
                "solver.pbf.warm_start",
                Short(self.solver.pbf.warm_start),
                "must be 0 with a solid that has a density_kg_m3: what it gave back is not begun with",
            )?;
        }
        for (index, solid, density_kg_m3) in body_solids(self) {
            let field = format!("solid.{index}");
            let [least, most] = RATIOS.map(|ratio| ratio * self.rest_density_kg_m3());
            check.require(
                density_kg_m3 >= least && density_kg_m3 <= most,
                &format!("{field}.density_kg_m3"),
                Short(density_kg_m3),
                format_args!("{} to {}: {} to {} times the fluid's", Short(least), Short(most), RATIOS[0], RATIOS[1]),
            )?;
            check.require(
                solid.terrain.is_none(),
                &format!("{field}.density_kg_m3"),
                Short(density_kg_m3),
                "not with terrain, which stands",
            )?;
            check.require(
                solid.shape() != Shape::Triangles || solid.thickness_m.is_none(),
                &format!("{field}.thickness_m"),
                Short(solid.thickness_m.unwrap_or_default()),
                "not with a density_kg_m3: a sheet holds nothing that could be weighed",
            )?;
            check_hinge(check, &field, solid)?;
            self.check_place(check, &field, solid)?;
            self.check_overlap(check, &field, (index, solid))?;
        }
        Ok(())
    }

    /// Inside walls, where there are any.
    fn check_place(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
        let standing = StandingSolid::of(solid, self);
        let corners_m = solid.triangles().map(|triangles| triangles.solid.positions_m.as_slice()).unwrap_or_default();
        // The box around a mesh's origin may be far larger than the mesh.
        let [low_m, high_m] = corners_m
            .iter()
            .map(|&corner_m| standing.placed_m(corner_m))
            .map(|at_m| [at_m, at_m])
            .reduce(|[low_m, high_m], [at_m, _]| [low_m.min(at_m), high_m.max(at_m)])
            .unwrap_or_else(|| standing.bounds_m());
        let hair_m = 1e-6 * self.domain.size_m().into_iter().fold(0.0, f64::max);
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let [min_m, max_m] = [self.domain.min_m[axis], self.domain.max_m[axis]];
            let is_inside = low_m[axis] >= min_m - hair_m && high_m[axis] <= max_m + hair_m;
            check.require(
                is_inside || !self.domain.has_walls(),
                &format!("{field}.centre_m"),
                format_args!("a body from {name} = {} to {}", Short(tidied(low_m[axis])), Short(tidied(high_m[axis]))),
                format_args!("must begin in the domain, {} to {}", Short(min_m), Short(max_m)),
            )?;
        }
        Ok(())
    }

    /// A quarter of a spacing into another is still let out gently.
    fn check_overlap(
        &self,
        check: &Checker,
        field: &str,
        (index, solid): (usize, &SolidSettings),
    ) -> Result<(), SceneError> {
        let own = StandingSolid::of(solid, self);
        let points: Vec<(DVec3, f64)> =
            points_of(solid).into_iter().map(|(at, radius)| (own.placed_m(at), radius)).collect();
        let allowed_m = 0.25 * self.fitted_spacing_m();
        for (other, settings) in self.solids.iter().enumerate().filter(|(other, _)| *other != index) {
            let standing = StandingSolid::of(settings, self);
            let gaps_m = points.iter().map(|(at_m, radius_m)| standing.distance_m(at_m.to_array()) - radius_m);
            let deepest_m = -gaps_m.fold(f64::INFINITY, f64::min);
            check.require(
                deepest_m <= allowed_m,
                &format!("{field}.centre_m"),
                format_args!("{} m of it are in solid.{other}", Short(tidied(deepest_m))),
                format_args!("a quarter of a spacing at most, {} m", Short(tidied(allowed_m))),
            )?;
        }
        Ok(())
    }
}

/// A line that is one, and a body that moves along it alone.
fn check_hinge(check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
    let Some(hinge) = solid.hinge else { return Ok(()) };
    let axis = DVec3::from_array(hinge.axis).normalize_or_zero();
    check.require(axis != DVec3::ZERO, &format!("{field}.hinge.axis"), numbers(hinge.axis), "must point somewhere")?;
    check.require(
        solid.velocity_m_s == [0.0; 3],
        &format!("{field}.velocity_m_s"),
        numbers(solid.velocity_m_s),
        "must be 0 with a hinge: give it a spin_deg_s",
    )?;
    let spin = DVec3::from_array(solid.spin_deg_s);
    check.require(
        spin.reject_from_normalized(axis).length() <= 1e-9 * spin.length(),
        &format!("{field}.spin_deg_s"),
        numbers(solid.spin_deg_s),
        format_args!("must be along the hinge's axis, {}", numbers(hinge.axis)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::body_mass_kg;

    const SMALL: &str = "spacing_m = 0.1\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 2, 1]\n[[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [0.3, 0.2, 0.1] }\n";

    fn load(text: &str, settings: &[&str]) -> Result<Scene, String> {
        let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
        Scene::from_toml(text, "small.toml", &settings).map_err(|error| error.to_string())
    }

    /// One wrong thing each, of a scene with a body over a solid.
    #[test]
    fn messages_about_bodies_name_the_body_and_what_is_allowed() {
        let solids = "[[solid]]\nbox = { size_m = [0.4, 0.2, 0.4] }\ncentre_m = [0.5, 1.5, 0.5]\ndensity_kg_m3 = 500\n\
            [[solid]]\nsphere = { radius_m = 0.2 }\ncentre_m = [0.5, 1.2, 0.5]\n";
        let text = SMALL.to_string() + solids;
        let scene = load(&text, &[]).unwrap();
        assert!((body_mass_kg(&scene.solids[0]) - 16.0).abs() < 1e-9 && body_mass_kg(&scene.solids[1]) == 0.0);
        let cases: &[(&str, &[&str])] = &[
            ("solid.0.density_kg_m3=0", &["solid.0.density_kg_m3 = 0", "0.001 to"]),
            ("solid.0.density_kg_m3=10", &["solid.0.density_kg_m3 = 10", "50 to 20000: 0.05 to 20 times the fluid's"]),
            ("solid.0.keyframe=[{ time_s = 0 }]", &["solid.0", "not with"]),
            ("solid.0.hinge={ axis = [0, 0, 0] }", &["solid.0.hinge.axis", "must point somewhere"]),
            (
                "solid.0={ box = { size_m = [0.4, 0.2, 0.4] }, centre_m = [0.5, 1.5, 0.5], density_kg_m3 = 500, \
                 velocity_m_s = [1, 0, 0], hinge = { axis = [0, 0, 1] } }",
                &["solid.0.velocity_m_s", "must be 0 with a hinge"],
            ),
            (
                "solid.0={ box = { size_m = [0.4, 0.2, 0.4] }, centre_m = [0.5, 1.5, 0.5], density_kg_m3 = 500, \
                 spin_deg_s = [10, 0, 0], hinge = { axis = [0, 0, 1] } }",
                &["solid.0.spin_deg_s", "must be along the hinge's axis"],
            ),
            (
                "solid.1={ sphere = { radius_m = 0.2 }, centre_m = [0.5, 1.2, 0.5], hinge = { axis = [0, 0, 1] } }",
                &["solid.1.hinge", "needs a density_kg_m3"],
            ),
            (
                "solid.0={ terrain = { size_m = [1, 0.1, 1] }, centre_m = [0.5, 0, 0.5], density_kg_m3 = 500 }",
                &["solid.0.density_kg_m3", "not with terrain"],
            ),
            (
                "solid.0.centre_m=[0.5, 1.3, 0.5]",
                &["solid.0.centre_m = 0.2 m of it are in solid.1", "at most, 0.025 m"],
            ),
            ("solid.0.centre_m=[0.9, 1.5, 0.5]", &["a body from x = 0.7 to 1.1: must begin in the domain, 0 to 1"]),
            (
                "solver.pbf.warm_start=0.2",
                &["solver.pbf.warm_start = 0.2", "must be 0 with a solid that has a density_kg_m3"],
            ),
        ];
        for (setting, parts) in cases {
            let message = load(&text, &[setting]).unwrap_err();
            assert!(parts.iter().all(|part| message.contains(part)), "{setting}: {message}");
        }
        let many = SMALL.to_string() + &"[[solid]]\nsphere = { radius_m = 0.1 }\ndensity_kg_m3 = 500\n".repeat(65);
        assert!(load(&many, &[]).unwrap_err().contains("solid = 65 solids with a density_kg_m3: at most 64"));
    }
}
