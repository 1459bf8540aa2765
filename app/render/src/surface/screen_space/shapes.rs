//! What a particle is drawn as: its ellipsoid where its neighbours are known, a smaller sphere where they are few,
//! or a sphere.

use brooklet_fluid::{Slots, grid::Neighbours};
use brooklet_kernels::{Buf, Buffer, Ellipsoid, ListHead, Position, ShapeKeyword};

use crate::surface::Particles;

/// The shapes of particles, as the stages that draw them bind them.
#[derive(Clone, Copy)]
pub(crate) struct Shapes<'a> {
    particles: &'a Particles<'a>,
    ellipsoids: Option<&'a Buffer<Ellipsoid>>,
}

impl<'a> Shapes<'a> {
    /// Those of `particles`, whose ellipsoids these are.
    pub fn new(particles: &'a Particles<'a>, ellipsoids: Option<&'a Buffer<Ellipsoid>>) -> Self {
        Self { particles, ellipsoids }
    }

    /// The slots they stand in.
    pub fn slots(&self) -> &Slots {
        self.particles.slots
    }

    /// The variant that draws them.
    pub fn keyword(&self) -> ShapeKeyword {
        match (self.ellipsoids, self.spray()) {
            (Some(_), _) => ShapeKeyword::EllipsoidShape,
            (None, Some(_)) => ShapeKeyword::SprayShape,
            (None, None) => ShapeKeyword::Off,
        }
    }

    /// Their ellipsoids, where those are drawn.
    pub fn ellipsoids(&self) -> Option<Buf<'a, Ellipsoid>> {
        self.ellipsoids.map(Buffer::read)
    }

    /// Where they are, for those who do not draw ellipsoids.
    pub fn positions(&self) -> Option<Buf<'a, Position>> {
        self.ellipsoids.is_none().then(|| self.particles.positions.read())
    }

    /// What tells spray from water.
    pub fn list_heads(&self) -> Option<Buf<'a, ListHead>> {
        self.spray().map(|neighbours| neighbours.heads.read())
    }

    fn spray(&self) -> Option<&'a Neighbours> {
        self.particles.neighbours.filter(|_| self.ellipsoids.is_none())
    }
}
