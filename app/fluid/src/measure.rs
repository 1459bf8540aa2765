//! Density error, energy, momentum and front of the fluid, measured on the GPU. (Shaders: `measure/`.)

mod sample_particles;

pub use sample_particles::{Sample, record_sample};

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, Counters, DensityRatios, DensityRatiosVariant, HISTOGRAM_BINS, Kernel, Measure, MeasureParticles,
    MeasureParticlesVariant, MeasureSums, MeasureTotals, Position, SmoothingKernelParams, StepParams, WallsKeyword,
};

use crate::boundary::solids::Solids;
use crate::grid::{NeighbourSearch, Neighbours};
use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::slots::Slots;
use crate::step_context::StepContext;

/// The measuring stages' buffers.
pub struct Measuring {
    /// What the host reads back.
    pub measure: Buffer<Measure>,
    group_measures: Buffer<MeasureSums>,
    histograms: Buffer<u32>,
}

impl Measuring {
    /// Declares the buffers for `capacity` slots.
    pub fn declare(resources: &mut Resources, capacity: u32) -> Self {
        let groups = capacity.div_ceil(MeasureParticles::GROUP_SIZE[0]);
        Self {
            measure: resources.buffer("measure", 1),
            group_measures: resources.buffer("group_measures", groups.max(1)),
            histograms: resources.buffer("histograms", 2 * HISTOGRAM_BINS),
        }
    }

    /// Measures the state after a step: densities with the neighbour lists of its last substep, where there are some.
    pub fn record(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        search: Option<&NeighbourSearch>,
        particles: &Particles,
    ) {
        // Without particles nothing else writes it.
        recording.clear(&mut self.group_measures);
        recording.clear(&mut self.histograms);
        let has_density = search.is_some();
        if let (Some(search), Some(solids)) = (search, &mut context.solids) {
            solids.record_sample_anew(recording, &particles.positions, &search.smoothing_kernel);
        }
        let walls = context.boundary();
        context.slots.dispatch(
            recording,
            &MeasureParticles {
                variant: MeasureParticlesVariant {
                    density: has_density,
                    walls: if has_density { walls } else { WallsKeyword::Off },
                    periodic: has_density && context.periodic,
                },
                positions: particles.positions.read(),
                velocities: particles.velocities.read(),
                neighbours: search.map(|search| search.neighbours.deltas.read()),
                list_heads: search.map(|search| search.neighbours.heads.read()),
                solid_contacts: search.and(context.solids.as_ref()).map(|solids| solids.contacts().read()),
                group_measures: self.group_measures.write(),
                histograms: has_density.then(|| self.histograms.write()),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                kernel: search.map(|search| search.smoothing_kernel.uniform()),
            },
        );
        recording.dispatch_groups(
            &MeasureTotals {
                group_measures: self.group_measures.read(),
                histograms: self.histograms.read(),
                counters: context.counters.read(),
                measure: self.measure.write(),
                step_state: context.slots.state.uniform(),
            },
            [1; 3],
        );
        // Counted from one measurement to the next.
        recording.clear(&mut context.counters);
    }
}

/// What every particle's density ratio is computed from.
pub struct Densities {
    step: Buffer<StepParams>,
    slots: Slots,
    kernel: Buffer<SmoothingKernelParams>,
    walls: WallsKeyword,
    solids: Option<Solids>,
    periodic: bool,
}

impl Densities {
    /// Of a simulation with these settings and this kernel.
    pub fn of(context: &StepContext, search: &NeighbourSearch) -> Self {
        Self {
            step: context.step.alias(),
            slots: context.slots.alias(),
            kernel: search.smoothing_kernel.alias(),
            walls: context.boundary(),
            solids: context.solids.as_ref().map(Solids::alias),
            periodic: context.periodic,
        }
    }

    /// Records the density ratio of every particle, 0 of quarantined ones.
    pub fn record(
        &self,
        resources: &mut Resources,
        recording: &mut Recording,
        positions: &Buffer<Position>,
        neighbours: &Neighbours,
    ) -> Buffer<f32> {
        let mut density_ratios = resources.buffer("density_ratios", positions.len);
        // Without particles nothing else writes it.
        recording.clear(&mut density_ratios);
        let mut solids = self.solids.as_ref().map(Solids::alias);
        if let Some(solids) = &mut solids {
            solids.record_sample_anew(recording, positions, &self.kernel);
        }
        self.slots.dispatch(
            recording,
            &DensityRatios {
                variant: DensityRatiosVariant { walls: self.walls, periodic: self.periodic },
                positions: positions.read(),
                neighbours: neighbours.deltas.read(),
                list_heads: neighbours.heads.read(),
                solid_contacts: solids.as_ref().map(|solids| solids.contacts().read()),
                density_ratios: density_ratios.write(),
                step_state: self.slots.state.uniform(),
                step_params: self.step.uniform(),
                kernel: self.kernel.uniform(),
            },
        );
        density_ratios
    }
}

/// Mean, 99th percentile and largest value over the particles.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Summary {
    /// Mean.
    pub mean: f64,
    /// 99th percentile, within 3 % of itself; 0 below 6e-5.
    pub p99: f64,
    /// Largest.
    pub max: f64,
}

/// A measurement in SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stats {
    /// Whether densities were measured: particles that do not interact have none, and both summaries are 0.
    pub has_density: bool,
    /// Of |ρ/ρ0 − 1|.
    pub density_error: Summary,
    /// Of max(ρ/ρ0 − 1, 0).
    pub compression: Summary,
    /// m/s.
    pub max_speed_m_s: f64,
    /// J.
    pub kinetic_j: f64,
    /// J, against gravity, from the domain's lowest corner.
    pub potential_j: f64,
    /// Centre of mass, in the scene's coordinates, m.
    pub centre_of_mass_m: [f64; 3],
    /// kg·m/s.
    pub momentum_kg_m_s: [f64; 3],
    /// Largest x of a particle's middle plus half a spacing, in the scene's coordinates, m; at most
    /// a wall's.
    pub front_m: f64,
    /// Particles measured.
    pub particles: u32,
    /// Particles whose state was not finite; they are out of the simulation.
    pub quarantined: u32,
    /// Particles outside an open domain.
    pub escaped: u32,
    /// Events since the last measurement.
    pub counters: Counters,
}

impl Stats {
    /// Reads what the GPU measured. `bytes` are those of one [`Measure`].
    ///
    /// # Panics
    /// If `bytes` is not as long as a [`Measure`].
    pub fn new(bytes: &[u8], scene: &Scene) -> Self {
        let measure: Measure = bytemuck::pod_read_unaligned(bytes);
        let sums = measure.sums;
        let count = f64::from(sums.particles.max(1));
        let mass_kg = scene.particle_mass_kg();
        let mean_m = sums.position_sum_m.map(|sum| f64::from(sum) / count);
        let summary = |sum: f32, p99: f32, max: f32| Summary {
            mean: f64::from(sum) / count,
            p99: f64::from(p99).min(f64::from(max)),
            max: f64::from(max),
        };
        let potential_m2_s2: f64 = (0..3).map(|axis| -scene.gravity_m_s2[axis] * mean_m[axis]).sum();
        let origin_m = scene.domain.min_m;
        let present = sums.particles > 0;
        let furthest_m = if scene.domain.has_walls_along(0) { scene.domain.max_m[0] } else { f64::INFINITY };
        let front_m = (origin_m[0] + f64::from(sums.front_m) + 0.5 * scene.fitted_spacing_m()).min(furthest_m);
        Self {
            has_density: scene.solver.method.interacts(),
            density_error: summary(sums.density_error_sum, measure.density_error_p99, sums.density_error_max),
            compression: summary(sums.compression_sum, measure.compression_p99, sums.compression_max),
            max_speed_m_s: f64::from(sums.speed_max_m_s),
            kinetic_j: 0.5 * mass_kg * f64::from(sums.speed_squared_sum_m2_s2),
            potential_j: mass_kg * f64::from(sums.particles) * potential_m2_s2,
            centre_of_mass_m: std::array::from_fn(|axis| if present { origin_m[axis] + mean_m[axis] } else { 0.0 }),
            momentum_kg_m_s: sums.velocity_sum_m_s.map(|sum| mass_kg * f64::from(sum)),
            front_m: if present { front_m } else { 0.0 },
            particles: sums.particles,
            quarantined: sums.quarantined,
            escaped: sums.escaped,
            counters: measure.counters,
        }
    }
}
