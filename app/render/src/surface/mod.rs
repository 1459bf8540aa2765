//! What is drawn of the fluid: its particles as balls, or its surface as water.
//!
//! Depths and particle indices are `R32Float`, drawn to and loaded, never blended nor filtered. Thickness is `R16Float`
//! and light `Rgba16Float`, both blended and filtered. Pictures are `Rgba8Unorm`. WebGPU's base promises all of that
//! anywhere, and a test holds every surface against it; the driver is asked all the same, and what it lacks is drawn in
//! another format (`formats.rs`).

pub mod auto;
pub mod marching_cubes;
pub(crate) mod points;
pub mod screen_space;

use brooklet_fluid::diffuse::DiffuseSlots;
use brooklet_fluid::grid::Neighbours;
use brooklet_fluid::measure::Densities;
use brooklet_fluid::scene::SurfaceMethod;
use brooklet_fluid::{Recorded, Scene, Slots};
use brooklet_kernels::{Buffer, Position, Tier, Velocity};

pub use auto::AutoOptions;
pub use marching_cubes::MarchingCubesOptions;
pub use screen_space::{ScreenSpaceOptions, SmoothedSurface};

/// The particles that are drawn. Positions are relative to the view's `domain_min_m`.
#[derive(Clone, Copy)]
pub struct Particles<'a> {
    /// Where they are.
    pub positions: &'a Buffer<Position>,
    /// How fast they are; read where colours tell speeds.
    pub velocities: &'a Buffer<Velocity>,
    /// The slots they stand in.
    pub slots: &'a Slots,
    /// Their neighbours, in the same order: few make a particle a drop of spray, drawn small, and
    /// ellipsoids are made from them. Without, all are drawn as spheres of one size.
    pub neighbours: Option<&'a Neighbours>,
    /// What their densities are computed from, where colours tell them.
    pub densities: Option<&'a Densities>,
    /// Spray, foam and bubbles, if there are any.
    pub diffuse: Option<&'a DiffuseSlots>,
}

impl<'a> Particles<'a> {
    /// Those of a recorded simulation.
    pub fn of(recorded: &'a Recorded) -> Self {
        Self {
            positions: &recorded.positions,
            velocities: &recorded.velocities,
            slots: &recorded.slots,
            neighbours: recorded.neighbours.as_ref(),
            densities: recorded.densities.as_ref(),
            diffuse: recorded.diffuse.as_ref(),
        }
    }
}

/// What is drawn of the fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceOptions {
    /// Nothing: floor and sky. Particles are then not read.
    None,
    /// The particles, as balls.
    Points,
    /// Water, smoothed in screen space.
    ScreenSpace(ScreenSpaceOptions),
    /// Water with a meshed surface, shaded as the other.
    MarchingCubes(ScreenSpaceOptions, MarchingCubesOptions),
    /// Either of the two, whichever is cheaper for what is seen.
    Auto(ScreenSpaceOptions, MarchingCubesOptions, AutoOptions),
}

impl SurfaceOptions {
    /// What a scene asks for, on a device of `tier`.
    pub fn for_scene(scene: &Scene, tier: Tier) -> Self {
        let water = || ScreenSpaceOptions::for_scene(scene, tier);
        match scene.surface.method {
            SurfaceMethod::None => Self::None,
            SurfaceMethod::Points => Self::Points,
            SurfaceMethod::ScreenSpace => Self::ScreenSpace(water()),
            SurfaceMethod::MarchingCubes => Self::MarchingCubes(water(), MarchingCubesOptions::for_scene(scene)),
            SurfaceMethod::Auto => {
                Self::Auto(water(), MarchingCubesOptions::for_scene(scene), AutoOptions::for_scene(scene, tier))
            }
        }
    }

    /// The water's, where it is drawn as a surface.
    pub fn water_mut(&mut self) -> Option<&mut ScreenSpaceOptions> {
        match self {
            Self::ScreenSpace(water) | Self::MarchingCubes(water, _) | Self::Auto(water, ..) => Some(water),
            Self::Points | Self::None => None,
        }
    }

    /// The mesh's, where there may be one.
    pub fn mesh(&self) -> Option<&MarchingCubesOptions> {
        match self {
            Self::MarchingCubes(_, mesh) | Self::Auto(_, mesh, _) => Some(mesh),
            Self::ScreenSpace(_) | Self::Points | Self::None => None,
        }
    }

    /// As [`SurfaceOptions::mesh`], to be changed.
    pub fn mesh_mut(&mut self) -> Option<&mut MarchingCubesOptions> {
        match self {
            Self::MarchingCubes(_, mesh) | Self::Auto(_, mesh, _) => Some(mesh),
            Self::ScreenSpace(_) | Self::Points | Self::None => None,
        }
    }
}
