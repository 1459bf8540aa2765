//! A case made ready: the scene, its particles, and when to look.

use brooklet_fluid::particles::{ParticleSet, sample_lattice};
use brooklet_fluid::{Scene, SceneError};
use brooklet_kernels::{Position, Velocity};
use glam::DVec3;

use crate::Sample;

/// A setup, or why its scene does not allow it. (Boxed: the error is large, and rare.)
pub type SetupResult = Result<Setup, Box<SceneError>>;

/// What runs, and when it is looked at.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Settings and domain.
    pub scene: Scene,
    /// The particles at the start, relative to the domain's lowest corner.
    pub particles: ParticleSet,
    /// Times of the samples in rising order, s; the last ends the run.
    pub sample_times_s: Vec<f64>,
    /// Whether compression is taken out of the particles before time begins.
    pub relaxes: bool,
    /// Whether the start is squeezed on purpose: energy is judged from when that is spent.
    pub squeezed: bool,
}

impl Setup {
    /// The scene in `text` with `settings` (`path=value`) on top, filled with its own fluids, looked at
    /// `samples` times, evenly until `end_s`.
    ///
    /// # Errors
    /// If the scene does not allow a setting.
    pub fn new(name: &str, text: &str, settings: &[String], end_s: f64, samples: u32) -> SetupResult {
        let scene = Scene::from_toml(text, name, settings).map_err(Box::new)?;
        let particles = sample_lattice(&scene);
        let sample_times_s = (1..=samples).map(|k| end_s * f64::from(k) / f64::from(samples)).collect();
        Ok(Self { scene, particles, sample_times_s, relaxes: false, squeezed: false })
    }

    /// The same, relaxed before time begins: compression of the start would else become motion, the more the shorter
    /// the substep.
    pub fn relaxed(self) -> Self {
        Self { relaxes: true, ..self }
    }

    /// The same, told to be squeezed on purpose.
    pub fn squeezed(self) -> Self {
        Self { squeezed: true, ..self }
    }

    /// When it ends, s.
    pub fn end_s(&self) -> f64 {
        self.sample_times_s.last().copied().unwrap_or(0.0)
    }

    /// Steps until then.
    pub fn steps(&self) -> u64 {
        (self.end_s() / self.scene.solver.dt_s).round() as u64
    }

    /// The step at whose end each sample is due, rising and without repeats.
    pub fn sample_steps(&self) -> Vec<u64> {
        let mut steps: Vec<u64> =
            self.sample_times_s.iter().map(|time_s| (time_s / self.scene.solver.dt_s).round() as u64).collect();
        steps.dedup();
        steps
    }

    /// The particles as they are before the first step.
    pub fn start(&self) -> Sample {
        Sample {
            time_s: 0.0,
            positions_m: self.particles.positions.iter().map(position_m).collect(),
            velocities_m_s: self.particles.velocities.iter().map(velocity_m_s).collect(),
            ..Sample::default()
        }
    }

    /// Changes each particle: position (relative to the domain's lowest corner) and velocity.
    pub fn place(&mut self, mut change: impl FnMut(&mut DVec3, &mut DVec3)) {
        for (position, velocity) in self.particles.positions.iter_mut().zip(&mut self.particles.velocities) {
            let (mut at, mut v) = (position_m(position), velocity_m_s(velocity));
            change(&mut at, &mut v);
            position.position_m = at.as_vec3().to_array();
            velocity.velocity_m_s = v.as_vec3().to_array();
        }
    }

    /// Number of particles.
    pub fn count(&self) -> usize {
        self.particles.positions.len()
    }

    /// Particle iterations of the whole run: what it costs.
    pub fn particle_iterations(&self) -> f64 {
        self.particle_iterations_of(self.count() as u64)
    }

    /// As [`Setup::particle_iterations`] for so many particles, which need not be made.
    pub fn particle_iterations_of(&self, particles: u64) -> f64 {
        particles as f64 * self.steps() as f64 * rounds_a_step(&self.scene)
    }
}

/// What a step costs, in iterations: a substep's sort and list cost about as much as two.
pub(crate) fn rounds_a_step(scene: &Scene) -> f64 {
    f64::from(scene.iterations_a_step() + 2 * scene.substeps())
}

/// In f64.
pub(crate) fn position_m(position: &Position) -> DVec3 {
    glam::Vec3::from(position.position_m).as_dvec3()
}

/// In f64.
pub(crate) fn velocity_m_s(velocity: &Velocity) -> DVec3 {
    glam::Vec3::from(velocity.velocity_m_s).as_dvec3()
}
