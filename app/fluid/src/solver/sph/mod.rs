//! Smoothed particle hydrodynamics after Müller, Charypar & Gross 2003: pressure follows from density by an equation of
//! state, and time goes in steps that its sound cannot outrun.
//!
//! A substep moves particles first and computes forces of where they then are, so that lists, densities and positions of a
//! measurement belong together. The acceleration is kept by slot: the next substep reads it before it sorts.
//!
//! Substeps are short: a particle moves a fiftieth of h in one at most. So most keep the order and the lists of one before
//! (`choose_time_step.compute`).

mod accelerate;
mod compute_density;
mod kernels;
mod plane_surface;
mod solids;
mod time_step;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, KickParams, SmoothingKernelParams, SphKernels, SphParams, VelocityPressure, VelocityPressureNormal,
};

use crate::grid::NeighbourSearch;
use crate::particles::advect;
use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::step_context::StepContext;
use accelerate::accelerate;
use compute_density::compute_density;
pub(crate) use kernels::shear_beyond;
pub use kernels::{density_walls, pressure_walls, sph_kernels, tension_walls};
use plane_surface::PlaneSurface;
use solids::{add_solid_acceleration, add_solid_density};
use time_step::TimeStep;
pub use time_step::limits;

/// The solver's settings and buffers.
pub struct Sph {
    pub(crate) params: Buffer<SphParams>,
    pub(crate) search: NeighbourSearch,
    kernels: Buffer<SphKernels>,
    density_walls: Buffer<SmoothingKernelParams>,
    pressure_walls: Buffer<SmoothingKernelParams>,
    /// Whether a term has another kernel than Wendland's.
    chosen_kernels: bool,
    gathered: Gathered,
    kicks: Buffer<KickParams>,
    accelerations: Buffer<[f32; 4]>,
    time_step: TimeStep,
}

/// What pairs gather.
enum Gathered {
    Flow(Buffer<VelocityPressure>),
    /// With surface tension.
    FlowAndSurface {
        both: Buffer<VelocityPressureNormal>,
        /// What walls count in the colour field.
        walls: Buffer<SmoothingKernelParams>,
    },
}

/// Pressure that is clamped nowhere: no fluid pulls as much.
const UNCLAMPED_M2_S2: f64 = -1.0e30;
/// Two particles closer than half a spacing part: at one point with the pressure of fluid that is 5 % compressed.
const SEPARATION: [f64; 2] = [0.5, 0.05];

/// What the shaders are given.
pub fn params(scene: &Scene) -> SphParams {
    let (sph, support_m) = (&scene.solver.sph, scene.support_m());
    let stiffness_m2_s2 = scene.stiffness_m2_s2();
    let g_m_s2 = scene.gravity_length_m_s2();
    let surface = if sph.surface_tension_n_m > 0.0 { PlaneSurface::of(scene) } else { PlaneSurface::default() };
    let tension_m3_s2 = sph.surface_tension_n_m / scene.rest_density_kg_m3() * surface.tension_scale;
    let [distance, compression] = SEPARATION;
    let [_, _, end_kick] = sph.integrator.kicks();
    SphParams {
        stiffness_m2_s2: stiffness_m2_s2 as f32,
        exponent: sph.exponent as f32,
        least_pressure_m2_s2: if sph.clamp_pressure { 0.0 } else { UNCLAMPED_M2_S2 as f32 },
        viscosity_m2_s: scene.sph_viscosity_m2_s() as f32,
        tension_m3_s2: tension_m3_s2 as f32,
        separation: (distance / scene.solver.support_ratio) as f32,
        separation_m2_s2: (compression * stiffness_m2_s2) as f32,
        // Of fluid as deep as a quarter of the support.
        supported_per_m2_s2: if g_m_s2 > 0.0 { (4.0 / (g_m_s2 * support_m)) as f32 } else { 0.0 },
        borne_scale: kernels::borne_scale(scene) as f32,
        end_kick: end_kick as f32,
        defers_pressure: u32::from(!scene.solids.is_empty()),
        surface_linear: surface.completion[0] as f32,
        surface_square: surface.completion[1] as f32,
        most_normal: surface.most_normal as f32,
        ..SphParams::default()
    }
}

/// What the move is given.
pub fn kick_params(scene: &Scene) -> KickParams {
    let [before, after, end] = scene.solver.sph.integrator.kicks().map(|share| share as f32);
    KickParams { before, after, end, reserved: 0.0 }
}

impl Sph {
    /// Declares the buffers of the terms that `scene` has.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        Self {
            params: resources.persistent("sph_params", 1),
            search: NeighbourSearch::declare(resources, scene, capacity),
            kernels: resources.persistent("sph_kernels", 1),
            density_walls: resources.persistent("density_walls", 1),
            pressure_walls: resources.persistent("pressure_walls", 1),
            chosen_kernels: kernels::are_chosen(scene),
            gathered: match scene.solver.sph.surface_tension_n_m > 0.0 {
                true => Gathered::FlowAndSurface {
                    both: resources.buffer("velocity_pressure_normals", capacity),
                    walls: resources.persistent("tension_walls", 1),
                },
                false => Gathered::Flow(resources.buffer("velocity_pressures", capacity)),
            },
            kicks: resources.persistent("kick_params", 1),
            accelerations: resources.persistent("accelerations", capacity),
            time_step: TimeStep::declare(resources, scene),
        }
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.params, &[params(scene)]);
        init.upload(&mut self.kernels, &[sph_kernels(scene)]);
        init.upload(&mut self.density_walls, &[density_walls(scene)]);
        if let Gathered::FlowAndSurface { walls, .. } = &mut self.gathered {
            init.upload(walls, &[tension_walls(scene)]);
        }
        init.upload(&mut self.pressure_walls, &[pressure_walls(scene)]);
        init.upload(&mut self.kicks, &[kick_params(scene)]);
        init.clear(&mut self.accelerations);
        self.time_step.record_init(init, scene, self.search.grid.cell_counts.len);
        self.search.record_init(init, scene);
    }

    /// Opens a substep.
    pub(super) fn begin_substep(&mut self, recording: &mut Recording, context: &mut StepContext) {
        self.time_step.choose(recording, context);
    }

    pub(super) fn record_substep(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        advect(recording, context, particles, Some((&self.accelerations, &self.kicks)));
        if let Some(solids) = &mut context.solids {
            solids.record_collide(recording, &mut particles.positions, &mut particles.velocities);
        }
        match self.time_step.search_groups() {
            Some(due) => self.search.sort_and_list_if_due(recording, context, particles, due),
            None => {
                self.search.sort(recording, context, particles);
                self.search.list(recording, context);
            }
        }
        compute_density(recording, self, context, particles);
        if let Some(solids) = &mut context.solids {
            solids.record_sample(recording, &self.search.sorted.positions, &self.search.smoothing_kernel);
        }
        if let Some(solids) = &context.solids {
            add_solid_density(recording, self, solids, context);
        }
        accelerate(recording, self, context, particles);
        if let Some(solids) = &mut context.solids {
            add_solid_acceleration(recording, self, solids, (&context.slots, &context.step), particles);
            solids.record_gather(recording, &self.search.sorted.positions);
        }
        self.time_step.find_fastest(recording, &context.slots, &particles.velocities, &self.accelerations);
    }

    /// What the next substep's move takes of the last one's acceleration, by slot.
    pub(crate) fn accelerations(&self) -> &Buffer<[f32; 4]> {
        &self.accelerations
    }
}
