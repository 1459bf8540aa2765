//! A setup in f64 by the twins, and those runs kept for the next time.

use std::fs;
use std::path::PathBuf;

use brooklet_fluid::boundary::{repel_params, wall_faces};
use brooklet_fluid::measure::Summary;
use brooklet_fluid::scene::{Method, Scene, SmoothingKernel};
use brooklet_fluid::session::{MOST_ROUNDS, NO_COMPRESSION};
use brooklet_fluid::smoothing_kernel_params;
use brooklet_fluid::solver::dfsph::{self, Solve};
use brooklet_fluid::solver::pbf::{self, IterationWeights};
use brooklet_fluid::solver::sph;
use brooklet_kernels::SmoothingKernelParams;
use brooklet_reference::boundary::drag_walls::WallFace;
use brooklet_reference::boundary::repel_walls::RepelWalls;
use brooklet_reference::boundary::walls::{DomainWalls, WallScales};
use brooklet_reference::params::{self, Forces, NonInteracting, Smoothing, Step};
use brooklet_reference::particles::advect::Kicks;
use brooklet_reference::particles::predict::Particle;
use brooklet_reference::solver::Solver;
use brooklet_reference::solver::dfsph::correct_pressure::PressureSolve;
use brooklet_reference::solver::dfsph::substep::Dfsph;
use brooklet_reference::solver::pbf::coarse_correction::CoarseGrid;
use brooklet_reference::solver::pbf::momentum::Weights;
use brooklet_reference::solver::pbf::substep::{Iterations, Pbf};
use brooklet_reference::solver::sph::choose_time_step::{Left, Limits};
use brooklet_reference::solver::sph::compute_density::{Kernels, Terms};
use brooklet_reference::solver::sph::kernels::Kernel;
use brooklet_reference::solver::sph::substep::Sph;
use brooklet_reference::step::Fluid;
use glam::{BVec3, DVec3};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::task::hex;
use crate::{Sample, Setup};

/// Of what the twins compute: changes with them, so that nothing an older program kept is taken.
const VERSION: u32 = 2;

/// The f64 twin of a setup.
pub fn reference_fluid(setup: &Setup) -> Fluid {
    let scene = &setup.scene;
    let domain = &scene.domain;
    let (size_m, period_m) = (DVec3::from_array(domain.size_m()), DVec3::from_array(scene.period_m()));
    let axes = BVec3::from_array(std::array::from_fn(|axis| domain.has_walls_along(axis)));
    let particles = setup.particles.positions.iter().zip(&setup.particles.velocities);
    Fluid {
        particles: particles.map(|(position, velocity)| Particle::of(position, velocity)).collect(),
        step: Step {
            gravity_m_s2: DVec3::from_array(scene.gravity_m_s2),
            dt_s: scene.substep_s(),
            domain_size_m: size_m,
            walls: axes,
            period_m,
            wall_offset_m: scene.wall_offset_m(),
            max_speed_m_s: scene.max_speed_m_s(),
        },
        solver: solver_of(scene),
        walls: walls_of(scene, &smoothing_kernel_params(scene)),
        repel_walls: repel_params(scene).map(|params| RepelWalls::of(&params)),
        faces: domain.has_dragging_walls().then(|| wall_faces(scene).map(|face| WallFace::of(&face))),
    }
}

/// The walls of a scene as a kernel counts them; none of an open domain.
fn walls_of(scene: &Scene, kernel: &SmoothingKernelParams) -> Option<DomainWalls> {
    let domain = &scene.domain;
    domain.has_walls().then(|| DomainWalls {
        dimensions: domain.dimensions,
        axes: BVec3::from_array(std::array::from_fn(|axis| domain.has_walls_along(axis))),
        scales: WallScales::of(kernel),
        domain_size_m: DVec3::from_array(domain.size_m()),
        support_m: scene.support_m(),
    })
}

/// SPH with the settings of a scene.
fn sph_of(scene: &Scene) -> Sph {
    let settings = &scene.solver.sph;
    let kernel = |kernel: SmoothingKernel| match kernel {
        SmoothingKernel::Poly6 => Kernel::Poly6,
        SmoothingKernel::Spiky => Kernel::Spiky,
        SmoothingKernel::Viscosity => Kernel::Viscosity,
        SmoothingKernel::CubicSpline => Kernel::CubicSpline,
        SmoothingKernel::Wendland => Kernel::Wendland,
    };
    let [before, after, end] = settings.integrator.kicks();
    Sph {
        smoothing: Smoothing {
            period_m: DVec3::from_array(scene.period_m()),
            ..Smoothing::new(scene.support_m(), f64::from(smoothing_kernel_params(scene).weight))
        },
        kernels: Kernels::new(
            scene.domain.dimensions,
            scene.solver.support_ratio,
            kernel(settings.density_kernel),
            kernel(settings.pressure_kernel),
            kernel(settings.viscosity_kernel),
        ),
        terms: Terms::of(&sph::params(scene)),
        kicks: Kicks { before, after, end },
        density_walls: walls_of(scene, &sph::density_walls(scene)),
        tension_walls: walls_of(scene, &sph::tension_walls(scene)),
        pressure_walls: walls_of(scene, &sph::pressure_walls(scene)),
        limits: Limits::of(&sph::limits(scene)),
        adapts: scene.adapts_substeps(),
        left: Left::default(),
        maxima: [0.0; 2],
        neighbours: Vec::new(),
        drift_m: 0.0,
    }
}

fn solver_of(scene: &Scene) -> Solver {
    match scene.solver.method {
        Method::Pbf => {
            let weights = IterationWeights::of(scene);
            let coarse_grid = CoarseGrid::of(&pbf::coarse_grid_params(scene, &weights));
            let pbf = pbf::params(scene, &weights);
            Solver::Pbf(Pbf {
                smoothing: smoothing_of(scene),
                params: params::Pbf {
                    relaxation: f64::from(pbf.relaxation),
                    cfm: f64::from(pbf.cfm),
                    s_corr_k: f64::from(pbf.s_corr_k),
                    s_corr_inverse_w: f64::from(pbf.s_corr_inverse_w),
                    max_correction_m: f64::from(pbf.max_correction_m),
                    separation: f64::from(pbf.separation),
                    separation_lambda: f64::from(pbf.separation_lambda),
                    warm_start: f64::from(pbf.warm_start),
                },
                iterations: iterations_of(scene, &weights, coarse_grid.is_some() || scene.solver.pbf.warm_start > 0.0),
                coarse_grid: coarse_grid.map(Box::new),
                forces: Forces { xsph: scene.forces.xsph, vorticity_m_s: scene.forces.vorticity_m_s },
                grid_ends_at_domain: true,
                walls_push: scene.domain.wall.model.answers_pressure(),
            })
        }
        Method::Sph => Solver::Sph(Box::new(sph_of(scene))),
        Method::Dfsph => {
            let settings = &scene.solver.dfsph;
            let solve = |which: Solve| {
                let [first, next] = dfsph::params(scene, which);
                PressureSolve {
                    tolerance: f64::from(first.tolerance),
                    first_step: f64::from(first.step),
                    step: f64::from(next.step),
                    momentum: f64::from(next.momentum),
                    guarded_step: f64::from(first.guarded_step),
                    room_share: f64::from(first.room_share),
                    excess_share: f64::from(first.excess_share),
                    warm_share: if settings.warm_start { f64::from(first.warm_share) } else { 0.0 },
                    most_iterations: first.most_iterations as usize,
                    least_iterations: first.least_iterations as usize,
                    is_fixed: settings.fixed_iterations,
                }
            };
            Solver::Dfsph(Dfsph {
                smoothing: smoothing_of(scene),
                divergence: solve(Solve::Divergence),
                coarse_grid: CoarseGrid::of(&dfsph::coarse_grid_params(scene)).map(Box::new),
                density: (settings.max_density_iterations > 0).then(|| solve(Solve::Density)),
                forces: Forces { xsph: scene.forces.xsph, vorticity_m_s: scene.forces.vorticity_m_s },
                grid_ends_at_domain: true,
            })
        }
        Method::None => {
            let settings = &scene.solver.none;
            Solver::None(NonInteracting {
                lifetime_s: settings.lifetime_s,
                lifetime_variation: settings.lifetime_variation,
                drag_per_s: settings.drag_per_s,
                restitution: settings.restitution,
            })
        }
    }
}

fn smoothing_of(scene: &Scene) -> Smoothing {
    let kernel = smoothing_kernel_params(scene);
    Smoothing {
        period_m: DVec3::from_array(scene.period_m()),
        ..Smoothing::new(scene.support_m(), f64::from(kernel.weight))
    }
}

fn iterations_of(scene: &Scene, weights: &IterationWeights, gives_back: bool) -> Iterations {
    let Some(chebyshev) = &weights.chebyshev else { return Iterations::Plain(scene.solver.pbf.iterations) };
    let one = |own: &pbf::Weights| Weights {
        step: own.step,
        momentum: own.momentum,
        guarded_step: weights.guarded_step(own),
    };
    let weights = chebyshev.iterations.iter().map(one).collect();
    let accumulates = chebyshev.accumulates() || gives_back;
    if accumulates { Iterations::AccumulatedMomentum(weights) } else { Iterations::Momentum(weights) }
}

/// Runs `setup` in f64; `None` if `stop` says so before its end.
pub fn run_reference(setup: &Setup, stop: &dyn Fn() -> bool) -> Option<Vec<Sample>> {
    let mut fluid = reference_fluid(setup);
    if setup.relaxes && !relax(&mut fluid, stop) {
        return None;
    }
    let mut samples = Vec::new();
    let mut done = 0;
    for due in setup.sample_steps() {
        while done < due {
            for _ in 0..setup.scene.substeps() {
                if stop() {
                    return None;
                }
                fluid.substep();
            }
            done += 1;
        }
        samples.push(Sample {
            time_s: due as f64 * setup.scene.solver.dt_s,
            positions_m: fluid.particles.iter().map(|p| p.position_m).collect(),
            velocities_m_s: fluid.particles.iter().map(|p| p.velocity_m_s).collect(),
            unsound: fluid.particles.iter().filter(|p| p.quarantined).count(),
            ..Sample::default()
        });
    }
    Some(samples)
}

/// Takes out the start's compression as a session does, measuring after each round; false if it was stopped.
fn relax(fluid: &mut Fluid, stop: &dyn Fn() -> bool) -> bool {
    let Solver::Pbf(pbf) = fluid.solver.clone() else { return true };
    for _ in 0..MOST_ROUNDS {
        let ratios = pbf.density_ratios(&fluid.particles, &fluid.step, fluid.walls.as_ref());
        if compression(&ratios).is_within(&NO_COMPRESSION) {
            return true;
        }
        if stop() {
            return false;
        }
        fluid.relax();
    }
    true
}

fn compression(ratios: &[f64]) -> Summary {
    let mut all: Vec<f64> = ratios.iter().map(|ratio| (ratio - 1.0).max(0.0)).collect();
    all.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| all.get(((share * all.len() as f64).ceil() as usize).saturating_sub(1)).copied();
    Summary {
        mean: all.iter().sum::<f64>() / all.len().max(1) as f64,
        p99: at(0.99).unwrap_or(0.0),
        max: at(1.0).unwrap_or(0.0),
    }
}

/// Where f64 runs are kept, if anywhere.
#[derive(Clone, Debug, Default)]
pub struct Cache {
    /// A folder that may be lost at any time.
    pub folder: Option<PathBuf>,
}

/// Where a reference came from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Computed now.
    Computed,
    /// Kept from an earlier time.
    Kept,
    /// Something was kept, and it was not this: computed anew. Says what it was.
    Replaced(String),
}

#[derive(Serialize, Deserialize)]
struct Kept {
    version: u32,
    content: String,
    samples: Vec<KeptSample>,
}

#[derive(Serialize, Deserialize)]
struct KeptSample {
    time_s: f64,
    positions_m: Vec<[f64; 3]>,
    velocities_m_s: Vec<[f64; 3]>,
}

/// As [`run_reference`], or what an earlier run of the same content gave.
pub fn converged(setup: &Setup, cache: &Cache, stop: &dyn Fn() -> bool) -> Option<(Vec<Sample>, Origin)> {
    let content = content_hash(setup);
    let path = cache.folder.as_ref().map(|folder| folder.join(format!("{content}.json")));
    let mut origin = Origin::Computed;
    if let Some(path) = &path
        && let Ok(bytes) = fs::read(path)
    {
        match serde_json::from_slice::<Kept>(&bytes) {
            Ok(kept) if kept.version == VERSION && kept.content == content => {
                return Some((kept.samples.into_iter().map(Into::into).collect(), Origin::Kept));
            }
            Ok(kept) => {
                let of = format!("{} is of version {}, this is {VERSION}", path.display(), kept.version);
                origin = Origin::Replaced(of);
            }
            Err(error) => origin = Origin::Replaced(format!("{} cannot be read: {error}", path.display())),
        }
    }
    let samples = run_reference(setup, stop)?;
    if let Some(path) = &path {
        // A cache that cannot be written costs time, nothing else.
        let _ = keep(path, &content, &samples);
    }
    Some((samples, origin))
}

fn keep(path: &std::path::Path, content: &str, samples: &[Sample]) -> std::io::Result<()> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder)?;
    let kept = Kept { version: VERSION, content: content.into(), samples: samples.iter().map(Into::into).collect() };
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    serde_json::to_writer(std::io::BufWriter::new(file.as_file_mut()), &kept)?;
    file.persist(path)?;
    Ok(())
}

/// Of everything that the run depends on, but for the twins themselves: see [`VERSION`].
fn content_hash(setup: &Setup) -> String {
    let mut hash = Sha256::new();
    hash.update(setup.scene.to_toml());
    for (position, velocity) in setup.particles.positions.iter().zip(&setup.particles.velocities) {
        for x in position.position_m.iter().chain(&velocity.velocity_m_s) {
            hash.update(x.to_le_bytes());
        }
        hash.update(position.tag.to_le_bytes());
    }
    if setup.relaxes {
        hash.update(b"relaxed");
    }
    for time_s in &setup.sample_times_s {
        hash.update(time_s.to_le_bytes());
    }
    hex(&hash.finalize()[..16])
}

impl From<KeptSample> for Sample {
    fn from(kept: KeptSample) -> Self {
        let vectors = |all: Vec<[f64; 3]>| all.into_iter().map(DVec3::from_array).collect();
        Self {
            time_s: kept.time_s,
            positions_m: vectors(kept.positions_m),
            velocities_m_s: vectors(kept.velocities_m_s),
            ..Self::default()
        }
    }
}

impl From<&Sample> for KeptSample {
    fn from(sample: &Sample) -> Self {
        let arrays = |all: &[DVec3]| all.iter().map(|v| v.to_array()).collect();
        Self {
            time_s: sample.time_s,
            positions_m: arrays(&sample.positions_m),
            velocities_m_s: arrays(&sample.velocities_m_s),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setup(dt_s: f64) -> Setup {
        let text = format!(
            "spacing_m = 0.1
            [domain]
            min_m = [0, 0, 0]
            max_m = [0.4, 0.4, 0.1]
            dimensions = 2
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [0.2, 0.3, 0.1] }}
            [solver]
            dt_s = {dt_s}"
        );
        Setup::new("small", &text, &[], 0.1, 2).unwrap()
    }

    #[test]
    fn what_was_computed_is_kept_and_what_is_not_it_is_computed_anew() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache { folder: Some(folder.path().join("deep")) };
        let go = |setup: &Setup| converged(setup, &cache, &|| false).unwrap();
        let (first, origin) = go(&setup(0.01));
        assert_eq!((first.len(), origin), (2, Origin::Computed));
        let (again, origin) = go(&setup(0.01));
        assert_eq!(origin, Origin::Kept);
        assert_eq!(first, again);
        assert_eq!(go(&setup(0.005)).1, Origin::Computed, "another content");
        let kept: Vec<PathBuf> =
            fs::read_dir(folder.path().join("deep")).unwrap().map(|entry| entry.unwrap().path()).collect();
        assert_eq!(kept.len(), 2);
        for path in &kept {
            let text = fs::read_to_string(path).unwrap();
            fs::write(path, text.replace(&format!("\"version\":{VERSION}"), "\"version\":0")).unwrap();
        }
        let (anew, origin) = go(&setup(0.01));
        assert!(matches!(&origin, Origin::Replaced(what) if what.contains("version 0")), "{origin:?}");
        assert_eq!(first, anew);
        assert_eq!(go(&setup(0.01)).1, Origin::Kept);
        for path in &kept {
            fs::write(path, "{").unwrap();
        }
        assert!(matches!(go(&setup(0.01)).1, Origin::Replaced(what) if what.contains("cannot be read")));
    }

    #[test]
    fn a_stopped_run_keeps_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache { folder: Some(folder.path().to_path_buf()) };
        assert!(converged(&setup(0.01), &cache, &|| true).is_none());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
