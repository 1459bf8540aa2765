//! Seeded fluids for kernel tests: positions, velocities, neighbours and settings, as the GPU gets
//! them and as the twins do.

use crate::bench::Bench;
use crate::compare::{HALF_ROUNDING, ROUNDING, vector};
use crate::device::Device;
use brooklet_fluid::grid::NO_SEAM;
use brooklet_fluid::visit_slots;
use brooklet_gpu::Tier;
use brooklet_kernels::{
    Buffer, FLUID_SHIFT, ForceParams, GridParams, INACTIVE_FLUID, LIST_CHUNK, ListHead, PbfParams, Position,
    PrecisionKeyword, QUARANTINED, SmoothingKernelParams, StepParams, StepState, Velocity,
};
use brooklet_reference::boundary::walls::{DomainWalls, WallScales};
use brooklet_reference::grid::list_neighbours::{Neighbours, list_neighbours};
use brooklet_reference::params::{Forces, Pbf, Smoothing, Step};
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::shared::{lattice, list};
use glam::{BVec3, DVec3};
use rand::{Rng, RngExt};

/// Spacing of the test fluids, m.
pub const SPACING_M: f64 = 0.02;
/// h / spacing.
pub const SUPPORT_RATIO: f64 = 2.0;
/// Support radius, m.
pub const SUPPORT_M: f64 = SPACING_M * SUPPORT_RATIO;
/// Room for neighbours of one particle.
pub const SLOTS: u32 = 96;
/// The same in runs of `LIST_CHUNK`.
pub const LIST_CHUNKS: u32 = SLOTS / LIST_CHUNK;

/// Particle counts of the tests: around one group of `group`, and one that is large and odd.
pub fn sizes(device: &Device, group: usize) -> Vec<usize> {
    let large = if device.small() { 333 } else { 2049 };
    vec![0, 1, 2, group - 1, group, group + 1, large]
}

/// Runs in the lists of `count` particles.
pub fn list_length(count: usize, chunks: u32) -> usize {
    brooklet_fluid::grid::list_length(count as u32, chunks) as usize
}

/// The precisions that the device has, and how large a rounding of each is.
pub fn precisions(device: &Device) -> Vec<(PrecisionKeyword, f64)> {
    let mut precisions = vec![(PrecisionKeyword::Off, ROUNDING), (PrecisionKeyword::RelaxedPrecision, HALF_ROUNDING)];
    // Real f16 is of the desktop tier; on the others its modules are refused, which `gpu_engine` tests.
    if device.gpu().tier() == Tier::Desktop {
        precisions.push((PrecisionKeyword::HalfPrecision, HALF_ROUNDING));
    }
    precisions
}

/// The positions that kernels of a precision gather.
pub fn quantization_of(precision: PrecisionKeyword) -> Quantization {
    match precision {
        PrecisionKeyword::Off => Quantization::Full,
        PrecisionKeyword::RelaxedPrecision | PrecisionKeyword::HalfPrecision => Quantization::Packed,
    }
}

/// One precision of each quantization, for kernels that compute nothing for pairs.
pub const STORAGES: [PrecisionKeyword; 2] = [PrecisionKeyword::Off, PrecisionKeyword::RelaxedPrecision];

/// A fluid.
pub struct Case {
    /// Particles.
    pub positions: Vec<Position>,
    /// Their velocities.
    pub velocities: Vec<Velocity>,
    /// Their neighbours, in f64.
    pub neighbours: Neighbours,
    /// Size of the domain, m.
    pub size_m: DVec3,
}

/// A jittered lattice of `count` particles, squeezed so that most are compressed, which touches
/// three walls of its domain. Distances of nearly h are left out of the neighbours on both sides.
pub fn fluid(rng: &mut impl Rng, count: usize) -> Case {
    let side = (count as f64).cbrt().ceil().max(1.0) as usize;
    let spacing_m = 0.9 * SPACING_M;
    let size_m = DVec3::splat((side as f64 * spacing_m).max(2.5 * SUPPORT_M));
    let mut jitter = || (rng.random::<f64>() - 0.5) * 0.5 * spacing_m;
    let positions: Vec<Position> = lattice::points([side; 3], spacing_m)
        .iter()
        .take(count)
        .enumerate()
        .map(|(i, at)| Position {
            position_m: (*at + DVec3::new(jitter(), jitter(), jitter())).to_array().map(|x| x as f32),
            tag: i as u32,
        })
        .collect();
    let velocities = (0..count)
        .map(|_| Velocity { velocity_m_s: [0; 3].map(|_| rng.random::<f32>() * 4.0 - 2.0), age_s: 0.0 })
        .collect();
    let neighbours = list_neighbours(&vectors(&positions), |_| false, SUPPORT_M);
    Case { positions, velocities, neighbours, size_m }
}

/// Positions in f64.
pub fn vectors(positions: &[Position]) -> Vec<DVec3> {
    positions.iter().map(|p| vector(p.position_m)).collect()
}

impl Case {
    /// Number of particles.
    pub fn count(&self) -> usize {
        self.positions.len()
    }

    /// Positions in f64.
    pub fn positions_m(&self) -> Vec<DVec3> {
        vectors(&self.positions)
    }

    /// Velocities in f64.
    pub fn velocities_m_s(&self) -> Vec<DVec3> {
        self.velocities.iter().map(|v| vector(v.velocity_m_s)).collect()
    }

    /// Quantized positions as the sort makes them.
    pub fn quantized_positions(&self, quantization: Quantization) -> Vec<[u32; 2]> {
        let inverse_support_per_m = kernel_params().inverse_support_per_m;
        self.positions.iter().map(|p| quantization.quantize(p.position_m.map(|x| x * inverse_support_per_m))).collect()
    }

    /// Where pairs see those quantized positions, m: within a step of the positions.
    pub fn quantized_m(&self, quantization: Quantization) -> Vec<DVec3> {
        let support_m = f64::from(kernel_params().support_m);
        let near = |(quantized, position_m): (_, DVec3)| {
            quantization.near(quantization.of_pairs(quantized), position_m / support_m) * support_m
        };
        self.quantized_positions(quantization).into_iter().zip(self.positions_m()).map(near).collect()
    }

    /// The neighbour lists as the GPU has them, and where each begins.
    pub fn upload_neighbours(&self, bench: &mut Bench) -> (Buffer<[u32; 2]>, Buffer<ListHead>) {
        let (lists, heads) = list::encoded(&self.neighbours, LIST_CHUNKS);
        (bench.input("neighbours", &lists), bench.input("list_heads", &heads))
    }

    /// The state of a substep that visits all particles.
    pub fn step_state(&self) -> StepState {
        step_state(self.count(), self.step_params().dt_s)
    }

    /// Settings of a substep.
    pub fn step_params(&self) -> StepParams {
        StepParams {
            gravity_m_s2: [0.3, -9.81, 0.1],
            dt_s: 1.0 / 240.0,
            domain_size_m: self.size_m.to_array().map(|x| x as f32),
            wall_offset_m: (SPACING_M / 4.0) as f32,
            wall_max_m: self.size_m.to_array().map(|x| x as f32),
            max_speed_m_s: 2.5,
            list_chunks: LIST_CHUNKS,
            ..StepParams::default()
        }
    }
}

/// Scale of the smoothing kernel.
pub fn kernel_params() -> SmoothingKernelParams {
    let walls = WallScales::new(3, SUPPORT_RATIO);
    SmoothingKernelParams {
        support_m: SUPPORT_M as f32,
        inverse_support_per_m: (1.0 / SUPPORT_M) as f32,
        weight: lattice::weight(3, SUPPORT_RATIO) as f32,
        wall_plane: walls.plane as f32,
        wall_edge: walls.edge as f32,
        wall_corner: walls.corner as f32,
        along_z: 1.0,
        wall_kernel_fraction: brooklet_fluid::boundary::wall_kernel_fraction(3).map(|c| c as f32),
        ..SmoothingKernelParams::default()
    }
}

/// Settings of the solver, every term on.
pub fn pbf_params() -> PbfParams {
    PbfParams {
        relaxation: 0.5,
        cfm: 0.05,
        s_corr_k: 0.02,
        s_corr_inverse_w: 4.0,
        max_correction_m: (0.5 * SPACING_M) as f32,
        separation: 0.25,
        separation_lambda: -0.03,
        ..PbfParams::default()
    }
}

/// Coefficients of the forces, each on.
pub fn force_params() -> ForceParams {
    ForceParams { xsph: 0.1, vorticity_m_s: 0.02, ..ForceParams::default() }
}

/// The state of a substep of `dt_s` that visits `count` slots.
pub fn step_state(count: usize, dt_s: f32) -> StepState {
    StepState { dt_s, ..visit_slots(count as u32) }
}

/// Settings of a grid over `size_m` with cells of `cell_m`.
pub fn grid_params(size_m: DVec3, cell_m: f64) -> GridParams {
    let cells = (size_m / cell_m).ceil().max(DVec3::ONE);
    let cells = cells.to_array().map(|n| n as u32);
    GridParams {
        cells,
        cell_count: cells.iter().product(),
        cell_size_m: cell_m as f32,
        inverse_cell_size_per_m: (1.0 / cell_m) as f32,
        support_m: SUPPORT_M as f32,
        list_chunks: LIST_CHUNKS,
        inverse_support_per_m: (1.0 / SUPPORT_M) as f32,
        domain_cells: cells,
        seam_cells: [NO_SEAM; 3],
        ..GridParams::default()
    }
}

/// The twin's substep, from the rounded values that the GPU has.
pub fn step_of(params: &StepParams, walls: bool) -> Step {
    Step {
        gravity_m_s2: vector(params.gravity_m_s2),
        dt_s: f64::from(params.dt_s),
        domain_size_m: vector(params.domain_size_m),
        walls: if walls { vector(params.wall_max_m).cmplt(DVec3::splat(1e20)) } else { BVec3::FALSE },
        period_m: vector(params.period_m),
        wall_offset_m: f64::from(params.wall_offset_m),
        max_speed_m_s: f64::from(params.max_speed_m_s),
    }
}

/// The twin's smoothing kernel.
pub fn smoothing_of(params: &SmoothingKernelParams) -> Smoothing {
    Smoothing::new(f64::from(params.support_m), f64::from(params.weight))
}

/// The twin's forces.
pub fn forces_of(params: &ForceParams) -> Forces {
    Forces { xsph: f64::from(params.xsph), vorticity_m_s: f64::from(params.vorticity_m_s) }
}

/// The twin's solver.
pub fn pbf_of(params: &PbfParams) -> Pbf {
    Pbf {
        relaxation: f64::from(params.relaxation),
        cfm: f64::from(params.cfm),
        s_corr_k: f64::from(params.s_corr_k),
        s_corr_inverse_w: f64::from(params.s_corr_inverse_w),
        max_correction_m: f64::from(params.max_correction_m),
        separation: f64::from(params.separation),
        separation_lambda: f64::from(params.separation_lambda),
        warm_start: f64::from(params.warm_start),
    }
}

/// Walls of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Around {
    /// None.
    Nothing,
    /// Each particle has at most one an axis within reach.
    Walls,
    /// Some have both walls of an axis within reach.
    NarrowWalls,
}

impl Around {
    /// Every one.
    pub const ALL: [Self; 3] = [Self::Nothing, Self::Walls, Self::NarrowWalls];

    /// Whether there are any.
    pub fn has_walls(self) -> bool {
        self != Self::Nothing
    }
}

/// The walls of a box whose kernel has these scales, for the twin.
pub fn walls_of(kernel: &SmoothingKernelParams, domain_size_m: DVec3) -> DomainWalls {
    let flat = kernel.along_z == 0.0;
    DomainWalls {
        dimensions: if flat { 2 } else { 3 },
        axes: BVec3::new(true, true, !flat),
        scales: WallScales::of(kernel),
        domain_size_m,
        support_m: f64::from(kernel.support_m),
    }
}

/// Particles all over the domain and some outside it or quarantined.
pub fn scattered(rng: &mut impl Rng, count: usize, size_m: DVec3) -> Vec<Position> {
    (0..count)
        .map(|i| {
            let beyond = if i % 11 == 3 { 0.2 } else { 0.0 };
            let mut at = |axis: usize| (rng.random::<f64>() * (size_m[axis] + 2.0 * beyond) - beyond) as f32;
            Position { position_m: [at(0), at(1), at(2)], tag: i as u32 | out_of_part(i) }
        })
        .collect()
}

/// An inactive slot's bits of a tag.
pub const INACTIVE: u32 = INACTIVE_FLUID << FLUID_SHIFT;

/// Bits that leave some particles out: quarantined, or inactive.
pub fn out_of_part(i: usize) -> u32 {
    match i % 13 {
        5 => QUARANTINED,
        11 => INACTIVE,
        _ => 0,
    }
}

/// Whether the domain is larger than its cells: they are wrapped onto it.
pub fn is_wrapped(grid: &GridParams) -> bool {
    grid.cells != grid.domain_cells
}

/// The same domain, its cells wrapped onto `cells`.
pub fn wrapped(grid: GridParams, cells: [u32; 3]) -> GridParams {
    GridParams { cells, cell_count: cells.iter().product(), ..grid }
}

/// The same domain, periodic along some axes: its cells go round there.
pub fn periodic(grid: GridParams, axes: [bool; 3]) -> GridParams {
    let seam = |axis: usize| if axes[axis] { grid.domain_cells[axis] } else { NO_SEAM };
    GridParams { seam_cells: std::array::from_fn(seam), ..grid }
}

/// The periods of a grid's domain, m; 0 along axes that have none.
pub fn period_m(grid: &GridParams) -> DVec3 {
    let period = |seam: u32| if seam == NO_SEAM { 0.0 } else { f64::from(seam) * f64::from(grid.cell_size_m) };
    DVec3::from_array(grid.seam_cells.map(period))
}
