//! Which points of a lattice the scene's fluids fill.

use brooklet_kernels::{FLUID_SHIFT, INACTIVE_FLUID};

use super::lattice::{self, WHOLE, steps_m};
use super::{Block, Fluid, Scene};

/// What a tag's bits below the fluid's number can tell apart.
pub const MAX_PARTICLES: u32 = 1 << FLUID_SHIFT;
/// What its bits between the id and the quarantine flag can tell apart; the number above all says that a slot is
/// inactive.
pub const MAX_FLUIDS: u32 = INACTIVE_FLUID;

/// The spacing that the scene's particles have, m: the one it asks for, or the nearest of which a whole number fit
/// where blocks reach from wall to wall (`lattice.rs`). A periodic side fits the one asked for alone.
pub(crate) fn fitted_spacing_m(scene: &Scene) -> f64 {
    let filled = scene.fluids.iter().filter_map(|fluid| fluid.block.as_ref()).map(|block| filled_m(block, scene));
    let any = filled.fold([None; 3], |any, filled_m| std::array::from_fn(|axis| any[axis].or(filled_m[axis])));
    match scene.domain.is_periodic() {
        true => scene.spacing_m,
        false => lattice::fitted_spacing_m(scene.spacing_m, scene.domain.dimensions, any),
    }
}

/// Along which axes a block stands against the domain's lowest face, and its highest.
fn faces(block: &Block, scene: &Scene) -> [[bool; 3]; 2] {
    let touches = |face_m: f64, at_m: f64| (face_m - at_m).abs() <= WHOLE * scene.spacing_m;
    [
        std::array::from_fn(|axis| touches(block.min_m[axis], scene.domain.min_m[axis])),
        std::array::from_fn(|axis| touches(block.max_m[axis], scene.domain.max_m[axis])),
    ]
}

/// The sides of a block along axes on which it reaches from wall to wall, or around a periodic domain, m.
fn filled_m(block: &Block, scene: &Scene) -> [Option<f64>; 3] {
    let [low, high] = faces(block, scene);
    let is_closed = |axis: usize| scene.domain.has_walls_along(axis) || scene.domain.periodic[axis];
    let side_m = |axis: usize| block.max_m[axis] - block.min_m[axis];
    std::array::from_fn(|axis| (is_closed(axis) && low[axis] && high[axis]).then(|| side_m(axis)))
}

/// How many particles the scene has, without making them.
pub(crate) fn count(scene: &Scene) -> u64 {
    let mut count = 0;
    for_each_point(scene, |_, _, _| count += 1);
    count
}

/// Whether the fluid alone has a particle.
pub(crate) fn fits(fluid: &Fluid, scene: &Scene) -> bool {
    let (min_m, max_m) = fluid.bounds_m();
    let mut middle_m: [f64; 3] = std::array::from_fn(|axis| 0.5 * (min_m[axis] + max_m[axis]));
    if scene.domain.is_flat() {
        middle_m[2] = scene.domain.plane_z_m();
    }
    let has_places = Lattice::of(fluid, scene).is_some_and(|lattice| !lattice.counts.contains(&0));
    has_places && fluid.contains(middle_m)
}

/// Calls `visit` with the number of each fluid, the fluid, and each point of it, m: in the order of ids.
pub(crate) fn for_each_point(scene: &Scene, mut visit: impl FnMut(usize, &Fluid, [f64; 3])) {
    for (index, fluid) in scene.fluids.iter().enumerate() {
        let Some(lattice) = Lattice::of(fluid, scene) else { continue };
        let (min_m, max_m) = fluid.bounds_m();
        let meets = |earlier: &&Fluid| {
            let (low_m, high_m) = earlier.bounds_m();
            (0..3).all(|axis| low_m[axis] <= max_m[axis] && high_m[axis] >= min_m[axis])
        };
        let earlier: Vec<&Fluid> = scene.fluids[..index].iter().filter(meets).collect();
        lattice.for_each(|place_m| {
            if fluid.contains(place_m) && !earlier.iter().any(|earlier| earlier.contains(place_m)) {
                visit(index, fluid, place_m);
            }
        });
    }
}

/// Lattice points around one fluid, x fastest.
struct Lattice {
    first_m: [f64; 3],
    steps_m: [f64; 3],
    counts: [usize; 3],
}

impl Lattice {
    fn of(fluid: &Fluid, scene: &Scene) -> Option<Self> {
        let spacing_m = fitted_spacing_m(scene);
        let mut lattice = if let Some(block) = &fluid.block {
            Self::of_block(block, scene, spacing_m)
        } else {
            let sphere = fluid.sphere.as_ref()?;
            let half = (sphere.radius_m / spacing_m).floor();
            Self {
                first_m: sphere.centre_m.map(|x| x - half * spacing_m),
                steps_m: [spacing_m; 3],
                counts: [2 * half as usize + 1; 3],
            }
        };
        if scene.domain.is_flat() {
            lattice.first_m[2] = scene.domain.plane_z_m();
            lattice.counts[2] = 1;
        }
        Some(lattice)
    }

    fn of_block(block: &Block, scene: &Scene, spacing_m: f64) -> Self {
        let domain = &scene.domain;
        let side_m = |axis: usize| block.max_m[axis] - block.min_m[axis];
        let [low, high] = faces(block, scene);
        let steps_m = steps_m(spacing_m, domain.dimensions, filled_m(block, scene));
        let counts = std::array::from_fn(|axis| (side_m(axis) / steps_m[axis] + WHOLE).floor() as usize);
        let first_m = std::array::from_fn(|axis| {
            let over_m = side_m(axis) - counts[axis] as f64 * steps_m[axis];
            // What is over lies away from a wall that the block stands against.
            let shift_m = match domain.has_walls_along(axis) && high[axis] && !low[axis] {
                true if over_m > WHOLE * spacing_m => over_m,
                _ => 0.0,
            };
            block.min_m[axis] + 0.5 * steps_m[axis] + shift_m
        });
        Self { first_m, steps_m, counts }
    }

    fn for_each(&self, mut visit: impl FnMut([f64; 3])) {
        for z in 0..self.counts[2] {
            for y in 0..self.counts[1] {
                for x in 0..self.counts[0] {
                    let steps = [x, y, z];
                    visit(std::array::from_fn(|axis| self.first_m[axis] + steps[axis] as f64 * self.steps_m[axis]));
                }
            }
        }
    }
}

impl Fluid {
    fn bounds_m(&self) -> ([f64; 3], [f64; 3]) {
        if let Some(block) = &self.block {
            (block.min_m, block.max_m)
        } else if let Some(sphere) = &self.sphere {
            (sphere.centre_m.map(|x| x - sphere.radius_m), sphere.centre_m.map(|x| x + sphere.radius_m))
        } else {
            ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3])
        }
    }

    fn contains(&self, place_m: [f64; 3]) -> bool {
        if let Some(block) = &self.block {
            (0..3).all(|axis| (block.min_m[axis]..=block.max_m[axis]).contains(&place_m[axis]))
        } else if let Some(sphere) = &self.sphere {
            let squared_m2: f64 = (0..3).map(|axis| (place_m[axis] - sphere.centre_m[axis]).powi(2)).sum();
            squared_m2 <= sphere.radius_m.powi(2)
        } else {
            false
        }
    }
}
