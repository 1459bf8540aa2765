//! Which points of a lattice the scene's fluids fill.

use brooklet_kernels::{FLUID_SHIFT, INACTIVE_FLUID};

use super::lattice::{self, WHOLE, steps_m};
use super::solid_shapes::StandingSolid;
use super::{Block, Cylinder, Fluid, Scene};

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

/// How many particles the scene has, without making them: of blocks that meet no other fluid by their sides alone.
pub(crate) fn count(scene: &Scene) -> u64 {
    filled(scene).map(|part| part.count()).sum()
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
    for part in filled(scene) {
        part.for_each(|place_m| visit(part.index, part.fluid, place_m));
    }
}

/// What one fluid fills: points of its lattice in it that no earlier fluid has, and that no solid is nearer to than half a
/// spacing, as far as the lattice is from walls.
struct Filled<'a> {
    index: usize,
    fluid: &'a Fluid,
    lattice: Lattice,
    /// Those that may have some.
    earlier: Vec<&'a Fluid>,
    /// As many as may be near.
    solids: Vec<StandingSolid>,
    from_solids_m: f64,
}

fn filled(scene: &Scene) -> impl Iterator<Item = Filled<'_>> {
    let fluids = scene.fluids.iter().enumerate();
    fluids.filter_map(|(index, fluid)| Filled::of(index, fluid, &scene.fluids[..index], scene))
}

/// The points that a fluid fills by itself, m.
pub(super) fn points_of(fluid: &Fluid, scene: &Scene) -> Vec<[f64; 3]> {
    let mut points_m = Vec::new();
    if let Some(filled) = Filled::of(0, fluid, &[], scene) {
        filled.for_each(|place_m| points_m.push(place_m));
    }
    points_m
}

impl<'a> Filled<'a> {
    fn of(index: usize, fluid: &'a Fluid, before: &'a [Fluid], scene: &'a Scene) -> Option<Self> {
        let lattice = Lattice::of(fluid, scene)?;
        let (min_m, max_m) = fluid.bounds_m();
        let meets = |earlier: &&Fluid| {
            let (low_m, high_m) = earlier.bounds_m();
            (0..3).all(|axis| low_m[axis] <= max_m[axis] && high_m[axis] >= min_m[axis])
        };
        let earlier = before.iter().filter(meets).collect();
        // A hair nearer: f32 is not exact either.
        let from_solids_m = (0.5 - WHOLE) * fitted_spacing_m(scene);
        let is_near = |solid: &StandingSolid| {
            let [low_m, high_m] = solid.bounds_m();
            (0..3).all(|axis| low_m[axis] - from_solids_m <= max_m[axis] && high_m[axis] + from_solids_m >= min_m[axis])
        };
        let solids = scene.solids.iter().map(|solid| StandingSolid::of(solid, scene)).filter(is_near).collect();
        Some(Filled { index, fluid, lattice, earlier, solids, from_solids_m })
    }

    fn for_each(&self, mut visit: impl FnMut([f64; 3])) {
        self.lattice.for_each(|place_m| {
            let is_free = |solid: &StandingSolid| solid.distance_m(place_m) >= self.from_solids_m;
            if self.fluid.contains(place_m)
                && !self.earlier.iter().any(|earlier| earlier.contains(place_m))
                && self.solids.iter().all(is_free)
            {
                visit(place_m);
            }
        });
    }

    fn count(&self) -> u64 {
        let Lattice { counts, .. } = &self.lattice;
        // A block has all points of a lattice whose first and last it has.
        let ends = [[0; 3], counts.map(|count| count.saturating_sub(1))].map(|steps| self.lattice.place_m(steps));
        if self.fluid.block.is_some()
            && self.earlier.is_empty()
            && self.solids.is_empty()
            && ends.iter().all(|end| self.fluid.contains(*end))
        {
            return counts.iter().map(|count| *count as u64).product();
        }
        let mut count = 0;
        self.for_each(|_| count += 1);
        count
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
        } else if let Some(cylinder) = &fluid.cylinder {
            // Around its axis, and from its foot up.
            let lattice = Self::of_block(&cylinder.block(), scene, spacing_m);
            let around_m = |axis: usize| 0.5 * (lattice.counts[axis] as f64 - 1.0) * lattice.steps_m[axis];
            let [x, z] = [0, 2].map(|axis| cylinder.centre_m[axis] - around_m(axis));
            Self { first_m: [x, lattice.first_m[1], z], ..lattice }
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

    fn place_m(&self, steps: [usize; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| self.first_m[axis] + steps[axis] as f64 * self.steps_m[axis])
    }

    fn for_each(&self, mut visit: impl FnMut([f64; 3])) {
        for z in 0..self.counts[2] {
            for y in 0..self.counts[1] {
                for x in 0..self.counts[0] {
                    visit(self.place_m([x, y, z]));
                }
            }
        }
    }
}

impl Fluid {
    pub(super) fn bounds_m(&self) -> ([f64; 3], [f64; 3]) {
        if let Some(block) = &self.block {
            (block.min_m, block.max_m)
        } else if let Some(sphere) = &self.sphere {
            (sphere.centre_m.map(|x| x - sphere.radius_m), sphere.centre_m.map(|x| x + sphere.radius_m))
        } else if let Some(cylinder) = &self.cylinder {
            let Block { min_m, max_m } = cylinder.block();
            (min_m, max_m)
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
        } else if let Some(Cylinder { centre_m, radius_m, length_m }) = &self.cylinder {
            let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| place_m[axis] - centre_m[axis]);
            y.abs() <= 0.5 * length_m && x * x + z * z <= radius_m * radius_m
        } else {
            false
        }
    }
}
