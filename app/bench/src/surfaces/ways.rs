//! The ways to get a surface that are held against each other.

use brooklet_fluid::scene::Smoothing;

/// A way to smooth or to mesh, as a scene has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter {
    pub name: &'static str,
    pub smoothing: Smoothing,
    pub iterations: u32,
    pub anisotropic: bool,
    /// Meshed instead.
    pub mesh: Option<Mesh>,
}

/// A way to mesh, as a scene has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    pub cells: Cells,
    pub smooth_normals: u32,
    pub anisotropic: bool,
}

/// Side of a mesh's cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells {
    /// Over the spacing d.
    pub ratio: f64,
    /// As figures call it.
    pub name: &'static str,
}

const WHOLE: Cells = Cells { ratio: 1.0, name: "d" };
const TWO_THIRDS: Cells = Cells { ratio: 2.0 / 3.0, name: "2d/3" };
const HALF: Cells = Cells { ratio: 0.5, name: "d/2" };
const THIRD: Cells = Cells { ratio: 1.0 / 3.0, name: "d/3" };

const fn filter(name: &'static str, smoothing: Smoothing, iterations: u32) -> Filter {
    Filter { name, smoothing, iterations, anisotropic: false, mesh: None }
}

const fn ellipsoids(name: &'static str, smoothing: Smoothing, iterations: u32) -> Filter {
    Filter { anisotropic: true, ..filter(name, smoothing, iterations) }
}

const fn mesh(name: &'static str, cells: Cells) -> Filter {
    let mesh = Some(Mesh { cells, smooth_normals: 4, anisotropic: false });
    Filter { mesh, ..filter(name, Smoothing::None, 0) }
}

/// What the product has; curvature flow as often as the mobile deck's figure has it.
pub const FILTERS: [Filter; 15] = [
    filter("none", Smoothing::None, 0),
    filter("gaussian", Smoothing::Gaussian, 1),
    filter("bilateral", Smoothing::Bilateral, 1),
    filter("bilateral-2d", Smoothing::Bilateral2d, 1),
    filter("narrow-range", Smoothing::NarrowRange, 1),
    filter("curvature-flow 40", Smoothing::CurvatureFlow, 40),
    filter("curvature-flow 60", Smoothing::CurvatureFlow, 60),
    ellipsoids("ellipsoids", Smoothing::None, 0),
    ellipsoids("ellipsoids, narrow-range", Smoothing::NarrowRange, 1),
    mesh("mesh, cells d", WHOLE),
    mesh("mesh, cells 2d/3", TWO_THIRDS),
    mesh("mesh, cells d/2", HALF),
    mesh("mesh, cells d/3", THIRD),
    Filter {
        mesh: Some(Mesh { cells: HALF, smooth_normals: 0, anisotropic: false }),
        ..filter("mesh, not smoothed", Smoothing::None, 0)
    },
    Filter {
        mesh: Some(Mesh { cells: HALF, smooth_normals: 4, anisotropic: true }),
        ..ellipsoids("mesh of ellipsoids", Smoothing::None, 0)
    },
];

/// The reference that no GPU draws.
pub const MARCHED: &str = "density field";

/// What each way is called.
pub fn names() -> impl Iterator<Item = &'static str> {
    FILTERS.into_iter().map(|filter| filter.name).chain([MARCHED])
}
