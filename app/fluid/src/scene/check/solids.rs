//! What solids may be.

use super::{Checker, numbers, tidied};
use crate::scene::field::Short;
use crate::scene::solid_shapes::{MOST_SOLIDS, fastest_m_s};
use crate::scene::{OpenFaces, Scene, SceneError, Shape, SolidSettings};

impl Scene {
    /// Each with one shape, no thinner and no faster than the fluid can feel.
    pub(super) fn check_solids(&self, check: &Checker) -> Result<(), SceneError> {
        if self.solids.is_empty() {
            return Ok(());
        }
        check.require(
            self.solids.len() <= MOST_SOLIDS,
            "solid",
            format_args!("{} solids", self.solids.len()),
            format_args!("at most {MOST_SOLIDS}"),
        )?;
        let why = match self.domain.is_flat() {
            true => "domain.dimensions = 2",
            false => "a side of domain.periodic = true",
        };
        check.require(
            !self.domain.is_flat() && !self.domain.is_periodic(),
            "solid",
            format_args!("{} solids", self.solids.len()),
            format_args!("not with {why}"),
        )?;
        self.check_nodes(check)?;
        let each = self.solids.iter().enumerate();
        each.map(|(index, solid)| (format!("solid.{index}"), solid)).try_for_each(|(field, solid)| {
            self.check_shape(check, &field, solid)?;
            self.check_field(check, &field, solid)?;
            self.check_cavity(check, &field, solid)?;
            self.check_motion(check, &field, solid)
        })?;
        self.check_bodies(check)
    }

    fn check_shape(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
        let given = solid.shapes_given();
        check.require(
            given == 1,
            field,
            format_args!("{given} shapes"),
            "give it one of `box`, `sphere`, `capsule`, `cylinder`, `mesh`, `hull`, `wheel` and `terrain`",
        )?;
        if let Some(capsule) = solid.capsule {
            check.require(
                capsule.length_m >= 2.0 * capsule.radius_m,
                &format!("{field}.capsule.length_m"),
                Short(capsule.length_m),
                format_args!("at least {} with its ends, twice its radius_m", Short(2.0 * capsule.radius_m)),
            )?;
        }
        let (Shape::Capsule(radius_m, _) | Shape::Cylinder(radius_m, _)) = solid.shape() else { return Ok(()) };
        self.check_radius(check, field, radius_m)
    }

    /// A surface that curves more than a particle sees.
    fn check_radius(&self, check: &Checker, field: &str, radius_m: f64) -> Result<(), SceneError> {
        check.require(
            radius_m >= 0.5 * self.support_m() || !self.solver.method.interacts(),
            field,
            format_args!("a radius of {} m", Short(tidied(radius_m))),
            format_args!("at least h/2 = {} m: particles do not see less", Short(0.5 * self.support_m())),
        )
    }

    fn check_cavity(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
        let open = format!("{field}.open");
        let name = solid.open.map_or("", |open| OpenFaces::NAMES[open as usize]);
        let Some(thickness_m) = solid.thickness_m else {
            return check.require(solid.open.is_none(), &open, format_args!("\"{name}\""), "needs a thickness_m");
        };
        let (narrowest_m, faces) = match solid.shape() {
            Shape::Box(half_m) => (half_m.into_iter().fold(f64::INFINITY, f64::min), OpenFaces::NAMES),
            Shape::Cylinder(radius_m, half_m) => (radius_m.min(half_m), &["y_min", "y_max", "ends"][..]),
            Shape::Capsule(radius_m, _) => (radius_m, &[][..]),
            Shape::Triangles => return self.check_sheet(check, field, solid),
        };
        check.require(
            thickness_m < narrowest_m,
            &format!("{field}.thickness_m"),
            Short(thickness_m),
            format_args!("below {}, half of the shape where it is narrowest", Short(narrowest_m)),
        )?;
        check.require(
            solid.open.is_none() || faces.contains(&name),
            &open,
            format_args!("\"{name}\""),
            match faces {
                [] => "a sphere and a capsule have no face".to_owned(),
                faces => format!("must be \"{}\"", faces.join("\" or \"")),
            },
        )?;
        match solid.shape() {
            Shape::Box(_) | Shape::Triangles => Ok(()),
            Shape::Capsule(radius_m, _) | Shape::Cylinder(radius_m, _) => {
                self.check_radius(check, &format!("{field}.thickness_m"), radius_m - thickness_m)
            }
        }
    }

    pub(super) fn check_motion(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
        if solid.density_kg_m3.is_some() {
            check.require(
                !solid.measure_force,
                &format!("{field}.measure_force"),
                true,
                "not with a density_kg_m3: what pushes a body moves it",
            )?;
            return check.require(
                solid.keyframes.is_empty() && !solid.repeat,
                &format!("{field}.density_kg_m3"),
                format_args!("{} keyframes", solid.keyframes.len()),
                "not with keyframes or repeat: the fluid moves what has a density",
            );
        }
        check.require(
            solid.hinge.is_none(),
            &format!("{field}.hinge"),
            "an axis",
            "needs a density_kg_m3: what moves as it is told needs no hinge",
        )?;
        let is_steady = solid.velocity_m_s != [0.0; 3] || solid.spin_deg_s != [0.0; 3];
        check.require(
            solid.velocity_m_s == [0.0; 3] || solid.spin_deg_s == [0.0; 3],
            &format!("{field}.spin_deg_s"),
            numbers(solid.spin_deg_s),
            "not with a velocity_m_s: keyframes can do both",
        )?;
        let keyframes = &solid.keyframes;
        check.require(
            keyframes.is_empty() || !is_steady && solid.centre_m == [0.0; 3] && solid.turned_deg == [0.0; 3],
            &format!("{field}.keyframe"),
            format_args!("{} keyframes", keyframes.len()),
            "not with centre_m, turned_deg, velocity_m_s or spin_deg_s: they say all of that",
        )?;
        check.require(
            !solid.repeat || keyframes.len() > 1,
            &format!("{field}.repeat"),
            "true",
            "needs two keyframes or more",
        )?;
        for (index, pair) in keyframes.windows(2).enumerate() {
            check.require(
                pair[1].time_s > pair[0].time_s,
                &format!("{field}.keyframe.{}.time_s", index + 1),
                Short(pair[1].time_s),
                format_args!("must be after the one before, {}", Short(pair[0].time_s)),
            )?;
        }
        let (fastest_m_s, keyframe) = fastest_m_s(solid);
        let (moved_m, most_m) = (fastest_m_s * self.substep_s(), self.fitted_spacing_m());
        let culprit = match () {
            () if !keyframes.is_empty() => format!("{field}.keyframe.{keyframe}"),
            () if solid.spin_deg_s != [0.0; 3] => format!("{field}.spin_deg_s"),
            () => format!("{field}.velocity_m_s"),
        };
        check.require(
            moved_m <= most_m,
            &culprit,
            format_args!("{} m a substep", Short(moved_m)),
            format_args!(
                "at most a spacing, {} m: slower, or more solver.substeps or a shorter solver.dt_s",
                Short(most_m)
            ),
        )
    }
}
