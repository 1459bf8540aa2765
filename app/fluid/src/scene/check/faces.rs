//! What the domain's faces may be told.

use super::{Checker, numbers};
use crate::scene::faces::FACE_NAMES;
use crate::scene::field::Short;
use crate::scene::{Face, Method, Scene, SceneError, Slip};

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
