//! What solids add to SPH's density and acceleration, against their twins.

use crate::bench::Bench;
use crate::cases::{kernel_params, out_of_part, sizes, step_state, walls_of};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::rooms::solid_contacts::{Pairs, pairs, plane_sample};
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{
    AddSolidAcceleration, AddSolidAccelerationVariant, AddSolidDensity, AddSolidDensityVariant, Kernel as _, NO_BODY,
    SphParams, SurfaceNormal, Velocity, VelocityPressure, VelocityPressureNormal,
};
use brooklet_reference::boundary::BoundarySample;
use brooklet_reference::boundary::solids::contact::SolidSample;
use brooklet_reference::solver::sph::compute_density::{Terms, completed, pressure_of};
use glam::DVec3;
use rand::RngExt;

const DT_S: f32 = 0.01;
/// What a distance of places up to a metre over h is off by, times slopes of up to 10, as in `solid_contacts`.
const TOLERANCE: f64 = 4096.0 * ROUNDING;

fn params() -> SphParams {
    SphParams {
        stiffness_m2_s2: 30.0,
        exponent: 3.0,
        least_pressure_m2_s2: -1.0e30,
        supported_per_m2_s2: 0.2,
        borne_scale: 1.4,
        end_kick: 0.5,
        defers_pressure: 1,
        ..SphParams::default()
    }
}

/// What walls alone are to a particle, and what solids add.
fn samples(pairs: &Pairs, i: usize) -> (BoundarySample, SolidSample) {
    let at_m = vector(pairs.case.positions[i].position_m);
    (
        walls_of(&kernel_params(), pairs.case.size_m).sample(at_m),
        plane_sample(&pairs.contacts[i], at_m, &kernel_params()),
    )
}

pub(crate) fn add_solid_density_matches_its_twin(device: &Device) {
    let mut rng = rng(197);
    let mut worst = device.worst(AddSolidDensity::STAGE, TOLERANCE);
    for surface_tension in [false, true] {
        let params = match surface_tension {
            true => SphParams { surface_linear: -0.05, surface_square: 0.25, most_normal: 2.4, ..params() },
            false => params(),
        };
        let (terms, stiffness) = (Terms::of(&params), f64::from(params.stiffness_m2_s2));
        for size in sizes(device, AddSolidDensity::GROUP_SIZE[0] as usize) {
            let mut pairs = pairs(&mut rng, size);
            pairs.case.positions.iter_mut().enumerate().for_each(|(i, at)| at.tag |= out_of_part(i));
            let flows: Vec<VelocityPressure> = (0..size)
                .map(|_| VelocityPressure {
                    velocity_m_s: [1.0, 2.0, 3.0],
                    pressure_m2_s2: 0.6 + 0.4 * rng.random::<f32>(),
                })
                .collect();
            let normals: Vec<VelocityPressureNormal> = flows
                .iter()
                .map(|&flow| VelocityPressureNormal {
                    flow,
                    surface: SurfaceNormal { normal: [0.5, -1.0, 2.0], length: 0.0 },
                })
                .collect();
            let mut bench = Bench::new(device);
            let sorted = bench.input("sorted_positions", &pairs.case.positions);
            let contacts = bench.input("solid_contacts", &pairs.contacts);
            let mut flow = bench.input("velocity_pressures", &flows);
            let mut both = bench.input("velocity_pressure_normals", &normals);
            let state = bench.uniform("step_state", step_state(size, DT_S));
            let step = bench.uniform("step_params", pairs.step());
            let walls = bench.uniform("density_walls", kernel_params());
            let sph = bench.uniform("sph", params);
            bench.dispatch(
                &AddSolidDensity {
                    variant: AddSolidDensityVariant { surface_tension },
                    sorted_positions: sorted.read(),
                    solid_contacts: contacts.read(),
                    velocity_pressures: (!surface_tension).then(|| flow.write()),
                    velocity_pressure_normals: surface_tension.then(|| both.write()),
                    step_state: state.uniform(),
                    step_params: step.uniform(),
                    density_walls: walls.uniform(),
                    tension_walls: surface_tension.then(|| walls.uniform()),
                    sph: sph.uniform(),
                },
                size,
            );
            let mut done = bench.run();
            let (flow, both) = (done.read(&flow, size), done.read(&both, size));
            let mut refused = size < 60;
            for i in 0..size {
                let got = if surface_tension { both[i].flow } else { flow[i] };
                ensure_eq!(got.velocity_m_s, [1.0, 2.0, 3.0]);
                let before = f64::from(flows[i].pressure_m2_s2);
                if out_of_part(i) != 0 {
                    ensure_eq!(got.pressure_m2_s2, flows[i].pressure_m2_s2);
                    continue;
                }
                let (walls, solids) = samples(&pairs, i);
                let (density, gradient) = solids.with_walls(&walls);
                let normal = DVec3::new(0.5, -1.0, 2.0) + gradient - walls.gradient;
                let ratio = before + density - walls.density;
                let ratio = if surface_tension { completed(ratio, normal, &terms) } else { ratio };
                let pressure = |ratio: f64| pressure_of(ratio, &terms) / ratio.powi(2);
                // A power of a density: as many times as uncertain as the exponent.
                worst.check(got.pressure_m2_s2, pressure(ratio), 3.0 * stiffness).or_raise();
                let mut wrong = Worst::new(AddSolidDensity::STAGE, TOLERANCE);
                refused |= wrong.check(got.pressure_m2_s2, pressure(1.005 * ratio), 3.0 * stiffness).is_err();
                if surface_tension {
                    worst.check3(both[i].surface.normal, normal, 1.0).or_raise();
                    worst.check(both[i].surface.length, normal.length(), 1.0).or_raise();
                }
            }
            ensure!(refused, "half a hundredth more density");
        }
    }
    worst.report(device);
}

pub(crate) fn add_solid_acceleration_matches_its_twin(device: &Device) {
    let mut rng = rng(198);
    let mut worst = device.worst(AddSolidAcceleration::STAGE, TOLERANCE);
    let params = params();
    for surface_tension in [false, true] {
        for size in sizes(device, AddSolidAcceleration::GROUP_SIZE[0] as usize) {
            let mut pairs = pairs(&mut rng, size);
            pairs.case.positions.iter_mut().enumerate().for_each(|(i, at)| at.tag |= out_of_part(i));
            let flows: Vec<VelocityPressure> = (0..size)
                .map(|_| VelocityPressure { pressure_m2_s2: 10.0 * rng.random::<f32>(), ..VelocityPressure::default() })
                .collect();
            let normals: Vec<VelocityPressureNormal> = flows
                .iter()
                .map(|&flow| VelocityPressureNormal { flow, ..VelocityPressureNormal::default() })
                .collect();
            let velocities: Vec<Velocity> = (0..size)
                .map(|_| Velocity { velocity_m_s: [0.4 * rng.random::<f32>(), 0.2, -0.3], age_s: 0.0 })
                .collect();
            let mut bench = Bench::new(device);
            let sorted = bench.input("sorted_positions", &pairs.case.positions);
            let mut contacts = bench.input("solid_contacts", &pairs.contacts);
            let flow = bench.input("velocity_pressures", &flows);
            let both = bench.input("velocity_pressure_normals", &normals);
            let mut moving = bench.input("velocities", &velocities);
            let mut accelerations = bench.input("accelerations", &vec![[1.0_f32, 0.0, -1.0, 1.0]; size]);
            let state = bench.uniform("step_state", step_state(size, DT_S));
            let step = bench.uniform("step_params", pairs.step());
            let walls = bench.uniform("pressure_walls", kernel_params());
            let sph = bench.uniform("sph", params);
            bench.dispatch(
                &AddSolidAcceleration {
                    variant: AddSolidAccelerationVariant { surface_tension },
                    sorted_positions: sorted.read(),
                    solid_contacts: contacts.write(),
                    velocity_pressures: (!surface_tension).then(|| flow.read()),
                    velocity_pressure_normals: surface_tension.then(|| both.read()),
                    velocities: moving.write(),
                    accelerations: accelerations.write(),
                    step_state: state.uniform(),
                    step_params: step.uniform(),
                    pressure_walls: walls.uniform(),
                    sph: sph.uniform(),
                },
                size,
            );
            let mut done = bench.run();
            let (moving, got) = (done.read(&moving, size), done.read(&accelerations, size));
            let taken = done.read(&contacts, size);
            let gravity_m_s2 = vector(pairs.step().gravity_m_s2);
            let per_m = f64::from(kernel_params().inverse_support_per_m);
            let mut refused = size < 60;
            for i in 0..size {
                let [x, y, z, had] = got[i];
                ensure_eq!(had, 1.0);
                if out_of_part(i) != 0 {
                    ensure_eq!([x, y, z], [1.0, 0.0, -1.0]);
                    ensure_eq!(moving[i], velocities[i]);
                    ensure_eq!(taken[i].taken_m_s, [0.0; 3]);
                    continue;
                }
                let (walls, solids) = samples(&pairs, i);
                let (_, gradient) = solids.with_walls(&walls);
                let pressure = f64::from(flows[i].pressure_m2_s2);
                let push = -2.0 * pressure * per_m * (gradient - walls.gradient);
                let supported =
                    (pressure * f64::from(params.supported_per_m2_s2)).clamp(0.0, 1.0) * f64::from(params.borne_scale);
                let by_walls =
                    -2.0 * pressure * per_m * walls.gradient + gravity_m_s2 * (DVec3::ONE - supported * walls.borne);
                let fluid = DVec3::new(1.0, 0.0, -1.0) - by_walls;
                let added = push + solids.along(fluid) - fluid - supported * solids.borne(gravity_m_s2);
                let scale_m_s2 = 20.0 * per_m + gravity_m_s2.length();
                worst.check3([x, y, z], added + DVec3::new(1.0, 0.0, -1.0), scale_m_s2).or_raise();
                let given_m_s = if taken[i].body == NO_BODY { DVec3::ZERO } else { added * f64::from(DT_S) };
                worst.check3(taken[i].taken_m_s, given_m_s, scale_m_s2 * f64::from(DT_S)).or_raise();
                let kicked = vector(velocities[i].velocity_m_s) + added * (0.5 * f64::from(DT_S));
                let limit_m_s = f64::from(pairs.step().max_speed_m_s);
                worst.check3(moving[i].velocity_m_s, kicked.clamp_length_max(limit_m_s), scale_m_s2 * 0.005).or_raise();
                let mut wrong = Worst::new(AddSolidAcceleration::STAGE, TOLERANCE);
                let other = 1.01 * added + DVec3::new(1.0, 0.0, -1.0);
                refused |= wrong.check3([x, y, z], other, scale_m_s2).is_err();
            }
            ensure!(refused, "a hundredth more acceleration");
        }
    }
    worst.report(device);
}
