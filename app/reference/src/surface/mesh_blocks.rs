//! Which blocks of a mesh's grid the surface may cross: those near particles but for those that are full all around.

use brooklet_kernels::{BLOCK_CELLS, BLOCK_INSIDE, BLOCK_LISTED, BLOCK_OUTSIDE, MeshParams};
use glam::{DVec3, I64Vec3, IVec3, UVec3};

/// Particles of each bin.
pub fn count_bins(particles_m: &[DVec3], mesh: &MeshParams) -> Vec<u32> {
    let bin_m = f64::from(mesh.bin_cells) * DVec3::from_array(mesh.cell_m.map(f64::from));
    let last = UVec3::from_array(mesh.bins).as_ivec3() - 1;
    let mut counts = vec![0; mesh.bin_count as usize];
    for particle_m in particles_m {
        let bin = (*particle_m / bin_m).floor();
        if bin.cmpge(DVec3::splat(-2.0)).all() && bin.cmple((last + 2).as_dvec3()).all() {
            counts[number(bin.as_ivec3().clamp(IVec3::ZERO, last), mesh.bins)] += 1;
        }
    }
    counts
}

fn number(at: IVec3, sides: [u32; 3]) -> usize {
    ((at.z as u32 * sides[1] + at.y as u32) * sides[0] + at.x as u32) as usize
}

/// Every lattice point of a box, x fastest.
fn box_of(low: IVec3, high: IVec3) -> impl Iterator<Item = IVec3> {
    (low.z..=high.z)
        .flat_map(move |z| (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| IVec3::new(x, y, z))))
}

/// What a block is by the bins in reach of its points: outside, inside, or such that the field must be asked.
pub fn class_of(block: IVec3, bin_counts: &[u32], mesh: &MeshParams) -> u32 {
    let side = BLOCK_CELLS as i32;
    let cells = UVec3::from_array(mesh.cells).as_ivec3();
    let [low_point, high_point] = [mesh.low_point, mesh.high_point].map(|at| UVec3::from_array(at).as_ivec3());
    let first = block * side;
    let outside_grid = block.cmpge(UVec3::from_array(mesh.blocks).as_ivec3()).any();
    if outside_grid || first.cmpgt(high_point).any() || (first + side - 1).cmplt(low_point).any() {
        return BLOCK_OUTSIDE;
    }
    let cell_m = DVec3::from_array(mesh.cell_m.map(f64::from));
    let reach = (f64::from(mesh.reach_m) / cell_m - 1e-3).ceil().as_ivec3();
    let [low, high] = [first - side - reach, first - 1 + reach];
    let bin_of = |cell: IVec3| cell.clamp(IVec3::ZERO, cells - 1) / mesh.bin_cells as i32;
    let bins: Vec<IVec3> = box_of(bin_of(low), bin_of(high)).collect();
    let count = |bin: &IVec3| bin_counts[number(*bin, mesh.bins)];
    let is_full = |bin: &IVec3| {
        let width = IVec3::splat(mesh.bin_cells as i32).min(cells - *bin * mesh.bin_cells as i32);
        let at_rest = (width.as_dvec3() * cell_m / f64::from(mesh.spacing_m)).element_product();
        f64::from(count(bin)) >= (0.625 * at_rest).max(at_rest - 3.0) - 0.01
    };
    let open_low = low_point.cmplt(IVec3::splat(side)) & low.cmplt(IVec3::ZERO);
    let open_high = high_point.cmpgt(cells + side) & high.cmpgt(cells);
    if bins.iter().all(|bin| count(bin) == 0) {
        BLOCK_OUTSIDE
    } else if bins.iter().all(is_full) && !open_low.any() && !open_high.any() {
        BLOCK_INSIDE
    } else {
        BLOCK_LISTED
    }
}

/// Whether a block's cells may hold a piece of the surface: it or a block above it must be asked, or they differ.
pub fn is_listed(block: IVec3, class: impl Fn(IVec3) -> u32, mesh: &MeshParams) -> bool {
    let own = class(block);
    let ends = (block + 1) * BLOCK_CELLS as i32 - 1;
    let holds_wall = own == BLOCK_INSIDE
        && (ends.cmpgt(UVec3::from_array(mesh.high_point).as_ivec3()).any()
            || (block * BLOCK_CELLS as i32).cmplt(UVec3::from_array(mesh.low_point).as_ivec3()).any());
    own == BLOCK_LISTED || holds_wall || box_of(block, block + 1).any(|other| class(other) != own)
}

/// A block's place in the grid.
pub fn block_at(block: usize, mesh: &MeshParams) -> IVec3 {
    let sides = I64Vec3::from_array(mesh.blocks.map(i64::from));
    let block = block as i64;
    I64Vec3::new(block % sides.x, block / sides.x % sides.y, block / sides.x / sides.y).as_ivec3()
}
