//! Solids that the fluid moves. (Shaders: `boundary/bodies/`.)

pub mod drag_body;
pub mod find_contacts;
pub mod step_bodies;

use glam::{DMat3, DQuat, DVec3};

/// A body's inertia.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// In its solid's frame, m.
    pub centre_of_mass_m: DVec3,
    /// Mass, kg.
    pub mass_kg: f64,
    /// About its centre of mass, in the frame.
    pub inertia_kg_m2: DMat3,
    /// Of fluid that it takes along where it is all wet.
    pub added_mass_kg: f64,
    /// The same of inertia.
    pub added_inertia_kg_m2: DMat3,
    /// Share of its surface that one particle wets.
    pub wet_per_push: f64,
    /// What holds it.
    pub hinge: Option<Hinge>,
}

/// A line that a body turns around.
#[derive(Clone, Copy, Debug)]
pub struct Hinge {
    /// A place on it, m.
    pub at_m: DVec3,
    /// Along it, as long as 1.
    pub axis: DVec3,
    /// That place in the body's frame, m.
    pub place_m: DVec3,
    /// Of fluid that the body takes along around it where it is all wet.
    pub added_kg_m2: f64,
}

/// How a body moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyState {
    /// Of its centre of mass, m.
    pub position_m: DVec3,
    /// Of its frame.
    pub rotation: DQuat,
    /// Of its centre of mass.
    pub velocity_m_s: DVec3,
    /// Around it.
    pub spin_rad_s: DVec3,
    /// What the fluid gave and it has not taken yet.
    pub owed_kg_m_s: DVec3,
    /// The same of angular momentum.
    pub owed_kg_m2_s: DVec3,
}

impl BodyState {
    /// The velocity of what of the body is at a place.
    pub fn velocity_at(&self, at_m: DVec3) -> DVec3 {
        self.velocity_m_s + self.spin_rad_s.cross(at_m - self.position_m)
    }
}

/// What a point of a body touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyContact {
    /// On the other's surface, m.
    pub at_m: DVec3,
    /// Between the two, m; negative where one is in the other.
    pub gap_m: f64,
    /// Towards the body.
    pub normal: DVec3,
    /// The body.
    pub body: usize,
    /// The other, if it is a body.
    pub other: Option<usize>,
    /// Of what is no body.
    pub other_m_s: DVec3,
    /// Coulomb's.
    pub friction: f64,
    /// Share of the speed that comes back.
    pub restitution: f64,
}
