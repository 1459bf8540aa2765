//! What the domain's walls and single faces of them may be told.

use super::{Checker, numbers};
use crate::scene::faces::FACE_NAMES;
use crate::scene::field::Short;
use crate::scene::{Face, Method, Scene, SceneError, Slip, Wall, WallModel};

const AXES: [&str; 3] = ["x", "y", "z"];

impl Scene {
    /// Walls where there are some, and of each only what its slip has.
    pub(super) fn check_faces(&self, check: &Checker) -> Result<(), SceneError> {
        for (index, face) in self.domain.faces.all().into_iter().enumerate() {
            if let Some(face) = face {
                self.check_face(check, &format!("domain.faces.{}", FACE_NAMES[index]), index / 2, &face)?;
            }
        }
        Ok(())
    }

    /// A model of walls that stand, and of each only what it reads.
    pub(super) fn check_wall(&self, check: &Checker) -> Result<(), SceneError> {
        let Wall { model, stiffness_per_s2, damping_per_s, restitution } = self.domain.wall;
        let name = format!("\"{}\"", model.name());
        let field = "domain.wall.model";
        let is_chosen = model != WallModel::default();
        check.require(!is_chosen || self.domain.has_walls(), field, &name, "the domain has no walls")?;
        check.require(
            !is_chosen || self.solids.is_empty(),
            field,
            &name,
            "not with [[solid]], which answers to pressure: must be \"pressure\"",
        )?;
        for (of, value) in [("stiffness_per_s2", stiffness_per_s2), ("damping_per_s", damping_per_s)] {
            check.require(
                value.is_none() || model == WallModel::Penalty,
                &format!("domain.wall.{of}"),
                Short(value.unwrap_or_default()),
                format_args!("needs model = \"penalty\", and model = {name}"),
            )?;
        }
        check.require(
            restitution == 0.0 || model == WallModel::Deflection,
            "domain.wall.restitution",
            Short(restitution),
            format_args!("needs model = \"deflection\", and model = {name}"),
        )
    }

    fn check_face(&self, check: &Checker, field: &str, axis: usize, face: &Face) -> Result<(), SceneError> {
        let domain = &self.domain;
        let why = match () {
            () if !domain.walls => "domain.walls = false",
            () if domain.periodic[axis] => "that axis of domain.periodic = true",
            () => "domain.dimensions = 2",
        };
        check.require(
            domain.has_walls_along(axis),
            field,
            "a face",
            format_args!("not with {why}: no wall stands across {}", AXES[axis]),
        )?;
        let slip = format!("\"{}\"", Slip::NAMES[face.slip as usize]);
        check.require(
            face.slip != Slip::NoSlip || self.solver.method == Method::Sph,
            &format!("{field}.slip"),
            &slip,
            format_args!(
                "needs a viscosity, which solver.method = \"{}\" does not have: must be \"free-slip\" or \"friction\"",
                self.solver.method.name()
            ),
        )?;
        let friction = format!("{field}.friction");
        check.require(
            face.slip == Slip::Friction || face.friction == 0.0,
            &friction,
            Short(face.friction),
            format_args!("needs slip = \"friction\", and slip = {slip}"),
        )?;
        let velocity = format!("{field}.velocity_m_s");
        check.require(
            face.slip != Slip::FreeSlip || face.velocity_m_s == [0.0; 3],
            &velocity,
            numbers(face.velocity_m_s),
            "needs slip = \"no-slip\" or \"friction\": a wall without either moves nothing",
        )?;
        check.require(
            face.velocity_m_s[axis] == 0.0,
            &velocity,
            numbers(face.velocity_m_s),
            format_args!("must be 0 along {}: a wall moves along itself", AXES[axis]),
        )?;
        check.require(
            !domain.is_flat() || face.velocity_m_s[2] == 0.0,
            &velocity,
            numbers(face.velocity_m_s),
            "must be 0 along z with domain.dimensions = 2",
        )
    }
}
