//! What the table times: one block of water at rest in a box, the same at every size.
//!
//! A cube of n x n x n particles fills the floor of its box, with h = 2d and about 27 neighbours.
//! Each particle starts up to a quarter of a spacing off its lattice point, seeded, because a
//! lattice would put exactly one particle into each cell of h/2. A taller block would press its
//! lowest layer harder, and a harder pressed particle has more neighbours: so the time step is
//! such that the column law (eps = N g dt^2 / (kappa omega n d)) gives the same compression at
//! every size.

use brooklet_fluid::{
    ParticleSource, Scene, SessionPlan, SessionRecorder,
    particles::{ParticleSet, sample_lattice},
};

use crate::BenchError;

/// Particles along an edge of the block: 4k, 16k, 27k, 64k, 125k, 216k, 512k, 1M, 2M, 4M, 8M and
/// 16M particles.
pub(crate) const EDGES: [u32; 12] = [16, 25, 30, 40, 50, 60, 80, 100, 126, 160, 200, 256];

pub(crate) const SPACING_M: f64 = 0.02;
/// The lowest layer's compression by the column law, with 4 iterations.
const COMPRESSION: f64 = 0.02;
/// The column law's kappa for Wendland's C2 kernel at h = 2d.
const KAPPA: f64 = 2.05;
/// How far a particle starts from its lattice point, over the spacing, along each axis.
const JITTER: f64 = 0.25;

/// What is solved at each size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Load {
    /// Iterations a step.
    pub iterations: u32,
    /// Whether every term of the solver is there, and measuring.
    pub every_term: bool,
}

/// The three loads of the table: the default terms with 4 iterations and with the mobile deck's 6,
/// and every term.
pub const LOADS: [Load; 3] = [
    Load { iterations: 4, every_term: false },
    Load { iterations: 6, every_term: false },
    Load { iterations: 4, every_term: true },
];

impl Load {
    /// Its terms in words.
    pub fn terms(self) -> &'static str {
        if self.every_term { "every term, measuring" } else { "default terms" }
    }

    /// The block of `edge` particles along each edge as a scene.
    pub(crate) fn scene(self, edge: u32, settings: &[String]) -> Result<Scene, BenchError> {
        let (s_corr_k, vorticity_m_s, measured) = if self.every_term { (1e-4, 0.01, 4) } else { (0.0, 0.0, 0) };
        let own = [
            format!("solver.pbf.iterations={}", self.iterations),
            "solver.pbf.relaxation=0.5".into(),
            format!("solver.pbf.s_corr_k={s_corr_k:?}"),
            format!("forces.vorticity_m_s={vorticity_m_s:?}"),
            format!("outputs.measure_every_steps={measured}"),
        ];
        block([edge; 3], SPACING_M, calm_dt_s(edge), &[&own[..], settings].concat())
    }
}

/// The step at which the column law gives a block of so many layers [`COMPRESSION`].
pub(crate) fn calm_dt_s(layers: u32) -> f64 {
    (COMPRESSION * KAPPA * 0.5 * 4.0 * SPACING_M / (f64::from(layers) * 9.81)).sqrt()
}

/// A block of so many particles along each axis, on the floor of a box that it fills but for a fifth of its height.
pub(crate) fn block(edges: [u32; 3], spacing_m: f64, dt_s: f64, settings: &[String]) -> Result<Scene, BenchError> {
    let [x_m, y_m, z_m] = edges.map(|edge| f64::from(edge) * spacing_m);
    let text = format!(
        "spacing_m = {spacing_m}\n\
         domain = {{ min_m = [0.0, 0.0, 0.0], max_m = [{x_m}, {height_m}, {z_m}] }}\n\
         fluid = [{{ block = {{ min_m = [0.0, 0.0, 0.0], max_m = [{x_m}, {y_m}, {z_m}] }} }}]\n\
         solver = {{ dt_s = {dt_s:?} }}\n\
         outputs = {{ images = 0, measure_every_steps = 0 }}\n",
        height_m = 1.25 * y_m,
    );
    Scene::from_toml(&text, "block at rest", settings).map_err(BenchError::input)
}

/// Plans `scene` with its particles off the lattice.
pub(crate) fn plan(scene: &Scene) -> Result<SessionPlan, BenchError> {
    SessionRecorder::new(scene, ParticleSource::Given(jittered(scene))).sweep().map_err(BenchError::stopped)
}

/// The scene's particles off their lattice.
pub(crate) fn jittered(scene: &Scene) -> ParticleSet {
    let mut particles = sample_lattice(scene);
    let mut random = fastrand::Rng::with_seed(27);
    for position in &mut particles.positions {
        for x_m in &mut position.position_m {
            *x_m += ((2.0 * random.f64() - 1.0) * JITTER * scene.spacing_m) as f32;
        }
    }
    particles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_size_is_a_whole_cube_inside_its_box() {
        for edge in EDGES {
            for load in LOADS {
                let scene = load.scene(edge, &[]).unwrap();
                assert_eq!(scene.solver.pbf.iterations, load.iterations);
                assert_eq!(scene.outputs.measure_every_steps > 0, load.every_term);
            }
        }
        let scene = LOADS[2].scene(EDGES[0], &["forces.xsph=0.5".into()]).unwrap();
        assert_eq!(scene.forces.xsph, 0.5);
        let particles = jittered(&scene);
        assert_eq!(particles.positions.len(), 16 * 16 * 16);
        assert_eq!(particles.positions, jittered(&scene).positions, "seeded");
        let size_m = scene.domain.size_m();
        for position in &particles.positions {
            assert!((0..3).all(|axis| (0.0..size_m[axis] as f32).contains(&position.position_m[axis])));
        }
        assert!(LOADS[0].scene(16, &["forces.xsph=2".into()]).is_err());
    }

    #[test]
    fn the_time_step_gives_the_same_compression_at_every_size() {
        let dt_s = |edge| LOADS[0].scene(edge, &[]).unwrap().solver.dt_s;
        assert!((dt_s(25) / dt_s(100) - 2.0).abs() < 1e-12);
    }
}
