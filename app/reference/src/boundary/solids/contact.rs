//! What a particle knows of the solids near it, and what that is to it while iterations move it. (Shaders:
//! `boundary/solids/sample_solids.compute`, `sample.hlsli`.)

use super::motion::Pose;
use super::shapes::{BeyondPlane, Solid};
use crate::boundary::BoundarySample;
use brooklet_kernels::CONTACT_REACH;
use glam::DVec3;

/// A half-space that adds as much density as the solids do, and the plane of the nearest surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Out of the half-space; 0 where no solid is near.
    pub normal: DVec3,
    /// The half-space is beyond normal · x < this, m.
    pub offset_m: f64,
    /// Out of the nearest solid.
    pub stop_normal: DVec3,
    /// Of its surface, m.
    pub stop_offset_m: f64,
    /// How much of the kernel lies in solids where the particle is.
    pub share: f64,
    /// The slope of that, per h.
    pub slope: DVec3,
    /// The nearest solid.
    pub solid: usize,
    /// How much further than it the next one is, m.
    pub lead_m: f64,
}

/// A slope that is less steep is none.
const FELT: f64 = 1e-4;

/// The contact of a particle with solids where they are; none where all are [`CONTACT_REACH`] supports away or more.
pub fn contact(position_m: DVec3, solids: &[(Solid, Pose)], support_m: f64, plane: &BeyondPlane) -> Option<Contact> {
    let mut surfaces: Vec<(f64, usize, DVec3)> = solids
        .iter()
        .enumerate()
        .map(|(index, (solid, pose))| {
            let (distance_m, out) = solid.surface(pose.in_frame(position_m));
            (distance_m, index, pose.rotation * out)
        })
        .collect();
    surfaces.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (distance_m, solid, stop_normal) =
        *surfaces.first().filter(|surface| surface.0 < f64::from(CONTACT_REACH) * support_m)?;
    let lead_m = surfaces.get(1).map_or(f64::INFINITY, |next| next.0 - distance_m);
    let (mut left, mut slope) = (1.0, DVec3::ZERO);
    for (solid, pose) in solids {
        let place_m = pose.in_frame(position_m);
        if solid.surface(place_m).0 < support_m {
            let (of, of_slope) = solid.share(place_m / support_m, support_m, plane);
            slope = slope * (1.0 - of) + pose.rotation * of_slope * left;
            left *= 1.0 - of;
        }
    }
    let share = 1.0 - left;
    let is_felt = slope.length() > FELT;
    let normal = if is_felt { -slope.normalize() } else { stop_normal };
    let away_m = if is_felt { plane.distance_of(share) * support_m } else { distance_m.max(0.0) };
    Some(Contact {
        normal,
        offset_m: normal.dot(position_m) - away_m,
        stop_normal,
        stop_offset_m: stop_normal.dot(position_m) - distance_m,
        share,
        slope,
        solid,
        lead_m,
    })
}

/// What the solids near a particle are to it at a place where iterations moved it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidSample {
    /// The density ratio that they add.
    pub density: f64,
    /// The gradient of that by position, per h.
    pub gradient: DVec3,
    /// Out of them.
    pub normal: DVec3,
    /// The slope of their share, times the distance in h.
    pub moment: f64,
}

/// A half-space beyond normal · x < offset, counted as a wall is.
pub fn sample_solids_near(
    normal: DVec3,
    offset_m: f64,
    position_m: DVec3,
    support_m: f64,
    plane: &BeyondPlane,
    wall_plane: f64,
) -> SolidSample {
    let distance = (normal.dot(position_m) - offset_m) / support_m;
    let (share, slope) = plane.at(distance);
    SolidSample {
        density: wall_plane * share,
        gradient: -wall_plane * slope * normal,
        normal,
        moment: wall_plane * slope * distance.clamp(0.0, 1.0),
    }
}

impl SolidSample {
    /// Density and gradient of walls and solids together: shares add up as independent ones do.
    pub fn with_walls(&self, walls: &BoundarySample) -> (f64, DVec3) {
        let left = (1.0 - walls.density).clamp(0.0, 1.0);
        let gradient = walls.gradient * (1.0 - self.density.clamp(0.0, 1.0)) + self.gradient * left;
        (walls.density + self.density * left, gradient)
    }

    /// What the fluid's own neighbours push, more along the solid as images behind it would.
    pub fn along(&self, push: DVec3) -> DVec3 {
        let across = push.project_onto_normalized(self.normal);
        across + (push - across) / (1.0 - self.density.min(0.5))
    }

    /// What they bear of an acceleration, across them.
    pub fn borne(&self, acceleration_m_s2: DVec3) -> DVec3 {
        (self.density + self.moment) * self.normal.dot(acceleration_m_s2) * self.normal
    }
}
