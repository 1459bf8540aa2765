//! Density and forces of `solver/sph/` against their twins. Tolerances are those of sums over pairs
//! (`tolerance_of_pairs`), relative to the sum of the terms' lengths.

use std::iter::zip;

use crate::bench::Bench;
use crate::cases::{
    Case, SPACING_M, SUPPORT_M, SUPPORT_RATIO, fluid, precisions, quantization_of, sizes, step_of, walls_of,
};
use crate::compare::{ROUNDING, Worst, tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure_eq};
use brooklet_fluid::scene::Scene;
use brooklet_fluid::solver::sph;
use brooklet_kernels::{
    Accelerate, AccelerateVariant, ComputeDensity, ComputeDensityVariant, Kernel as _, Position, PrecisionKeyword,
    SphParams, SurfaceNormal, Velocity, VelocityPressure, VelocityPressureNormal,
};
use brooklet_reference::boundary::sample_boundary;
use brooklet_reference::boundary::walls::DomainWalls;
use brooklet_reference::params::Smoothing;
use brooklet_reference::solver::sph::accelerate::{Flow, accelerate};
use brooklet_reference::solver::sph::compute_density::{Kernels, State, Terms, compute_density};
use brooklet_reference::solver::sph::kernels::Kernel;
use glam::DVec3;

/// Roundings of f16 that a pressure may be off by: 1.2 are measured.
const DENSITY_HALF: f64 = 6.0;
/// And an acceleration: .5.
const ACCELERATE_HALF: f64 = 3.0;

/// A scene's settings and its twin's kernels; surface tension is given to those who want it.
struct Settings {
    scene: Scene,
    kernels: Kernels,
    chosen: bool,
    tension: bool,
}

/// Wendland's kernels, and every other one in every term that may have it.
fn settings() -> Vec<Settings> {
    let of = |names: [&str; 3], kernels: [Kernel; 3], tension: bool| {
        let mut lines = vec![
            "solver.method=sph".to_owned(),
            format!("spacing_m={SPACING_M}"),
            format!("solver.support_ratio={SUPPORT_RATIO}"),
            "solver.sph.viscosity_m2_s=0.01".to_owned(),
        ];
        let terms = ["density", "pressure", "viscosity"];
        lines.extend(zip(terms, names).map(|(term, name)| format!("solver.sph.{term}_kernel={name}")));
        let scene = Scene::load("dam-break", &lines).or_raise();
        let [density, pressure, viscosity] = kernels;
        Settings {
            scene,
            kernels: Kernels::new(3, SUPPORT_RATIO, density, pressure, viscosity),
            chosen: names != ["wendland"; 3],
            tension,
        }
    };
    vec![
        of(["wendland"; 3], [Kernel::Wendland; 3], false),
        of(["wendland"; 3], [Kernel::Wendland; 3], true),
        of(["poly6", "spiky", "viscosity"], [Kernel::Poly6, Kernel::Spiky, Kernel::Viscosity], true),
        of(["cubic-spline", "poly6", "spiky"], [Kernel::CubicSpline, Kernel::Poly6, Kernel::Spiky], false),
        of(["spiky", "cubic-spline", "cubic-spline"], [Kernel::Spiky, Kernel::CubicSpline, Kernel::CubicSpline], false),
    ]
}

impl Settings {
    fn params(&self) -> SphParams {
        let params = SphParams { end_kick: 0.5, ..sph::params(&self.scene) };
        match self.tension {
            // Of a plane surface's order.
            true => SphParams {
                tension_m3_s2: 2.0e-3,
                surface_linear: -0.05,
                surface_square: 0.25,
                most_normal: 1.3,
                ..params
            },
            false => params,
        }
    }

    /// All sizes with Wendland's kernels. Others differ in what a pair computes alone, and that in f32 whatever the
    /// precision is.
    fn sizes(&self, device: &Device, precision: PrecisionKeyword) -> Vec<usize> {
        match (self.chosen, precision) {
            (false, _) => sizes(device, Accelerate::GROUP_SIZE[0] as usize),
            (true, PrecisionKeyword::Off) => vec![Accelerate::GROUP_SIZE[0] as usize + 1, 333],
            (true, _) => Vec::new(),
        }
    }

    fn terms(&self) -> Terms {
        Terms::of(&self.params())
    }
}

fn smoothing() -> Smoothing {
    Smoothing::new(SUPPORT_M, 0.0)
}

/// What pairs gather, as the kernel wrote it; normals are 0 without surface tension.
fn run_density(
    device: &Device,
    case: &Case,
    settings: &Settings,
    walls: bool,
    precision: PrecisionKeyword,
) -> Vec<VelocityPressureNormal> {
    let (count, quantization) = (case.count(), quantization_of(precision));
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(quantization));
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let sorted_velocities = bench.input("sorted_velocities", &case.velocities);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut positions = bench.output("positions", count);
    let mut velocities = bench.output("velocities", count);
    let mut flow = bench.output("velocity_pressures", count);
    let mut both = bench.output("velocity_pressure_normals", count);
    let step_params = bench.uniform("step_params", case.step_params());
    let density_walls = bench.uniform("density_walls", sph::density_walls(&settings.scene));
    let tension_walls = bench.uniform("tension_walls", sph::tension_walls(&settings.scene));
    let kernels = bench.uniform("kernels", sph::sph_kernels(&settings.scene));
    let params = bench.uniform("sph", settings.params());
    let state = bench.uniform("step_state", case.step_state());
    bench.dispatch(
        &ComputeDensity {
            variant: ComputeDensityVariant {
                walls,
                chosen_kernels: settings.chosen,
                surface_tension: settings.tension,
                precision,
            },
            quantized_positions: quantized_positions.read(),
            sorted_positions: sorted_positions.read(),
            sorted_velocities: sorted_velocities.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            velocity_pressures: (!settings.tension).then(|| flow.write()),
            velocity_pressure_normals: settings.tension.then(|| both.write()),
            step_state: state.uniform(),
            step_params: step_params.uniform(),
            density_walls: walls.then(|| density_walls.uniform()),
            tension_walls: (walls && settings.tension).then(|| tension_walls.uniform()),
            kernels: kernels.uniform(),
            sph: params.uniform(),
        },
        count,
    );
    bench.want(&positions);
    bench.want(&velocities);
    let mut done = bench.run();
    ensure_eq!(done.read::<Position>(&positions, count), case.positions);
    ensure_eq!(done.read::<Velocity>(&velocities, count), case.velocities);
    match settings.tension {
        true => done.read(&both, count),
        false => done
            .read(&flow, count)
            .into_iter()
            .map(|flow: VelocityPressure| VelocityPressureNormal { flow, ..VelocityPressureNormal::default() })
            .collect(),
    }
}

fn states(case: &Case, settings: &Settings, walls: bool, at_m: &[DVec3]) -> Vec<State> {
    let size_m = vector(case.step_params().domain_size_m);
    let [of_density, of_tension] =
        [sph::density_walls, sph::tension_walls].map(|of| walls_of(&of(&settings.scene), size_m));
    let [density_walls, tension_walls] = [&of_density, &of_tension].map(|of| walls.then_some(of));
    let terms = settings.terms();
    (0..case.count())
        .map(|i| {
            let list = &case.neighbours[i];
            compute_density(i, at_m, list, &smoothing(), &settings.kernels, &terms, density_walls, tension_walls)
        })
        .collect()
}

fn check_density(
    worst: &mut Worst,
    settings: &Settings,
    got: &[VelocityPressureNormal],
    states: &[State],
) -> Result<(), Wrong> {
    let params = settings.params();
    for (got, state) in zip(got, states) {
        // p = k/gamma (c^gamma - 1) / c^2, of which the power and its exponent times c's error are the largest terms.
        let c = state.density_ratio.max(1.0);
        let scale = f64::from(params.stiffness_m2_s2) * c.powf(f64::from(params.exponent));
        worst.check(got.flow.pressure_m2_s2, state.pressure_m2_s2, scale)?;
        if settings.tension {
            // Terms are 20 t^3 q at most, some 30 of them.
            worst.check3(got.surface.normal, state.normal, 8.0)?;
            worst.check(got.surface.length, state.normal.length(), 8.0)?;
        }
    }
    Ok(())
}

pub(crate) fn compute_density_matches_its_twin(device: &Device) {
    let mut rng = rng(111);
    for (precision, rounding) in precisions(device) {
        let name = format!("{} {precision:?}", ComputeDensity::STAGE);
        let mut worst = device.worst(name, tolerance_of_pairs(rounding, DENSITY_HALF));
        for settings in settings() {
            for size in settings.sizes(device, precision) {
                for walls in [false, true] {
                    let case = fluid(&mut rng, size);
                    let got = run_density(device, &case, &settings, walls, precision);
                    let at_m = case.quantized_m(quantization_of(precision));
                    check_density(&mut worst, &settings, &got, &states(&case, &settings, walls, &at_m)).or_raise();
                }
            }
        }
        worst.report(device);
    }
}

struct Accelerated {
    velocities: Vec<Velocity>,
    accelerations: Vec<[f32; 4]>,
}

fn run_accelerate(
    device: &Device,
    case: &Case,
    settings: &Settings,
    gathered: &[VelocityPressureNormal],
    walls: bool,
    precision: PrecisionKeyword,
) -> Accelerated {
    let (count, quantization) = (case.count(), quantization_of(precision));
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(quantization));
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let flow: Vec<VelocityPressure> = gathered.iter().map(|both| both.flow).collect();
    let flow = bench.input("velocity_pressures", &flow);
    let both = bench.input("velocity_pressure_normals", gathered);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut velocities = bench.input("velocities", &case.velocities);
    let mut accelerations = bench.output("accelerations", count);
    let step_params = bench.uniform("step_params", case.step_params());
    let pressure_walls = bench.uniform("pressure_walls", sph::pressure_walls(&settings.scene));
    let kernels = bench.uniform("kernels", sph::sph_kernels(&settings.scene));
    let params = bench.uniform("sph", settings.params());
    let state = bench.uniform("step_state", case.step_state());
    bench.dispatch(
        &Accelerate {
            variant: AccelerateVariant {
                walls,
                chosen_kernels: settings.chosen,
                surface_tension: settings.tension,
                precision,
            },
            quantized_positions: quantized_positions.read(),
            sorted_positions: sorted_positions.read(),
            velocity_pressures: (!settings.tension).then(|| flow.read()),
            velocity_pressure_normals: settings.tension.then(|| both.read()),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            velocities: velocities.write(),
            accelerations: accelerations.write(),
            step_state: state.uniform(),
            step_params: step_params.uniform(),
            pressure_walls: pressure_walls.uniform(),
            kernels: kernels.uniform(),
            sph: params.uniform(),
        },
        count,
    );
    bench.want(&accelerations);
    let mut done = bench.run();
    Accelerated { velocities: done.read(&velocities, count), accelerations: done.read(&accelerations, count) }
}

/// Lengths of what a particle's acceleration adds up, m/s².
fn terms_m_s2(
    case: &Case,
    settings: &Settings,
    flow: &Flow<'_>,
    pressure_walls: Option<&DomainWalls>,
    i: usize,
) -> f64 {
    let (terms, h_m) = (settings.terms(), SUPPORT_M);
    let Flow { positions_m: at_m, velocities_m_s, states } = *flow;
    let pairs: f64 = case.neighbours[i]
        .iter()
        .map(|&j| {
            let offset = (at_m[i] - at_m[j]) / h_m;
            let [gradient, draw] = [settings.kernels.push(offset), settings.kernels.draw(offset)].map(DVec3::length);
            let viscosity = settings.kernels.viscosity;
            let weight = viscosity.scale * viscosity.kernel.laplacian(offset.length().max(1e-3)).abs();
            (states[i].pressure_m2_s2 + states[j].pressure_m2_s2) * gradient / h_m
                + terms.viscosity_m2_s * weight * (velocities_m_s[i] - velocities_m_s[j]).length() / (h_m * h_m)
                + terms.tension_m3_s2 * (states[i].normal.length() + states[j].normal.length()) * 2.3 * draw
                    / (h_m * h_m)
                + terms.separation_m2_s2 / h_m * f64::from(offset.length() < terms.separation)
        })
        .sum();
    let wall = sample_boundary(at_m[i], pressure_walls).gradient.length();
    pairs + 2.0 * states[i].pressure_m2_s2 * wall / h_m + 20.0
}

pub(crate) fn accelerate_matches_its_twin(device: &Device) {
    let mut rng = rng(112);
    for (precision, rounding) in precisions(device) {
        let name = format!("{} {precision:?}", Accelerate::STAGE);
        let mut worst = device.worst(name, tolerance_of_pairs(rounding, ACCELERATE_HALF));
        for settings in settings() {
            for size in settings.sizes(device, precision) {
                for walls in [false, true] {
                    let case = fluid(&mut rng, size);
                    check_accelerate(device, &mut worst, &case, &settings, walls, precision).or_raise();
                }
            }
        }
        worst.report(device);
    }
}

/// Runs it with what the twin says that pairs gather.
fn check_accelerate(
    device: &Device,
    worst: &mut Worst,
    case: &Case,
    settings: &Settings,
    walls: bool,
    precision: PrecisionKeyword,
) -> Result<(), Wrong> {
    let at_m = case.quantized_m(quantization_of(precision));
    let states = states(case, settings, walls, &at_m);
    let gathered: Vec<VelocityPressureNormal> = zip(&states, &case.velocities)
        .map(|(state, velocity)| VelocityPressureNormal {
            flow: VelocityPressure { velocity_m_s: velocity.velocity_m_s, pressure_m2_s2: state.pressure_m2_s2 as f32 },
            surface: SurfaceNormal {
                normal: state.normal.to_array().map(|n| n as f32),
                length: state.normal.length() as f32,
            },
        })
        .collect();
    let got = run_accelerate(device, case, settings, &gathered, walls, precision);
    let step = step_of(&case.step_params(), walls);
    let pressure_walls = walls_of(&sph::pressure_walls(&settings.scene), step.domain_size_m);
    let pressure_walls = walls.then_some(&pressure_walls);
    let velocities_m_s = case.velocities_m_s();
    let flow = Flow { positions_m: &at_m, velocities_m_s: &velocities_m_s, states: &states };
    let terms = settings.terms();
    for (i, &velocity_m_s) in velocities_m_s.iter().enumerate() {
        let none = |_, _| DVec3::ZERO;
        let list = &case.neighbours[i];
        let expected = accelerate(i, &flow, list, &step, &smoothing(), &settings.kernels, &terms, pressure_walls, none);
        let [x, y, z, was_computed] = got.accelerations[i];
        let scale = terms_m_s2(case, settings, &flow, pressure_walls, i);
        worst.check3([x, y, z], expected, scale)?;
        ensure_eq!(was_computed, 1.0);
        let (kicked_m_s, _) = step.slowed(velocity_m_s + vector([x, y, z]) * (0.5 * step.dt_s));
        let speed_m_s = kicked_m_s.length().max(velocity_m_s.length());
        let off_m_s = (vector(got.velocities[i].velocity_m_s) - kicked_m_s).length();
        if off_m_s > 8.0 * ROUNDING * speed_m_s.max(1.0) {
            return Err(format!("velocity {i} is off its acceleration by {off_m_s} m/s").into());
        }
    }
    Ok(())
}

pub(crate) fn a_wrong_kernel_or_term_of_sph_is_told_apart(device: &Device) {
    let case = fluid(&mut rng(113), 300);
    let right = settings().swap_remove(2);
    let precision = PrecisionKeyword::Off;
    let at_m = case.quantized_m(quantization_of(precision));
    let got = run_density(device, &case, &right, true, precision);
    let worst = || Worst::new(ComputeDensity::STAGE, tolerance_of_pairs(ROUNDING, DENSITY_HALF));
    check_density(&mut worst(), &right, &got, &states(&case, &right, true, &at_m)).or_raise();
    let others = [Kernel::Spiky, Kernel::CubicSpline, Kernel::Wendland];
    for wrong in others {
        let kernels = Kernels::new(3, SUPPORT_RATIO, wrong, Kernel::Spiky, Kernel::Viscosity);
        let wrong = Settings { kernels, ..settings().swap_remove(2) };
        check_density(&mut worst(), &right, &got, &states(&case, &wrong, true, &at_m)).unwrap_err();
    }
    check_density(&mut worst(), &right, &got, &states(&case, &right, false, &at_m)).unwrap_err();
    // Forces of the right settings against a twin with one other.
    let mut worst = Worst::new(Accelerate::STAGE, tolerance_of_pairs(ROUNDING, ACCELERATE_HALF));
    check_accelerate(device, &mut worst, &case, &right, true, precision).or_raise();
    for kernels in [
        Kernels::new(3, SUPPORT_RATIO, Kernel::Poly6, Kernel::Poly6, Kernel::Viscosity),
        Kernels::new(3, SUPPORT_RATIO, Kernel::Poly6, Kernel::Spiky, Kernel::Wendland),
    ] {
        let wrong = Settings { kernels, ..settings().swap_remove(2) };
        check_accelerate(device, &mut worst, &case, &wrong, true, precision).unwrap_err();
    }
}
