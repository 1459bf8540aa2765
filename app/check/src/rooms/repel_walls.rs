//! `boundary/repel_walls` against its twin.

use crate::bench::Bench;
use crate::cases::{Case, SPACING_M, fluid, out_of_part, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure};
use brooklet_fluid::particles::is_simulated;
use brooklet_kernels::{
    Kernel as _, RepelParams, RepelWalls, StepParams, Velocity, WALLS_BY_DEFLECTION, WALLS_BY_PENALTY,
};
use brooklet_reference::boundary::repel_walls as twin;
use glam::DVec3;

fn run(device: &Device, case: &Case, params: StepParams, repel: RepelParams) -> Vec<Velocity> {
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let mut velocities = bench.input("velocities", &case.velocities);
    let step_params = bench.uniform("step_params", params);
    let step_state = bench.uniform("step_state", step_state(case.count(), params.dt_s));
    let repel = bench.uniform("repel", repel);
    bench.dispatch(
        &RepelWalls {
            positions: positions.read(),
            velocities: velocities.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            repel: repel.uniform(),
        },
        case.count(),
    );
    bench.run().read(&velocities, case.count())
}

/// Each model, its reach a spacing, so that two layers are in it.
fn models() -> [RepelParams; 2] {
    [WALLS_BY_PENALTY, WALLS_BY_DEFLECTION].map(|model| RepelParams {
        model,
        reach_m: SPACING_M as f32,
        stiffness_per_s2: 4.0e4,
        damping_per_s: 90.0,
        restitution: 0.4,
        ..RepelParams::default()
    })
}

/// Compares all velocities; returns how many the walls changed.
///
/// A position is off by roundings of the domain's size, which a stiff spring all but divides by the time; two walls an axis.
/// At the very edge of what a model tells apart, a rounding decides which side a particle is on: such a one is as fast as on
/// either.
fn check(
    worst: &mut Worst,
    case: &Case,
    params: &StepParams,
    walls: &twin::RepelWalls,
    after: &[Velocity],
) -> Result<usize, Wrong> {
    let step = step_of(params, true);
    let size_m = step.domain_size_m.max_element();
    let mut moved = 0;
    for (i, position) in case.positions.iter().enumerate() {
        let (at_m, before_m_s) = (vector(position.position_m), vector(case.velocities[i].velocity_m_s));
        let expected_with = |walls: &twin::RepelWalls| match is_simulated(position.tag) {
            true => twin::repel_walls(at_m, before_m_s, step.dt_s, &step, walls),
            false => before_m_s,
        };
        let edge_m = 8.0 * ROUNDING * size_m;
        let sides = [0.0, -edge_m, edge_m]
            .map(|by_m| expected_with(&twin::RepelWalls { reach_m: walls.reach_m + by_m, ..*walls }));
        let expected = sides[0];
        moved += usize::from((expected - before_m_s).length() > 0.01);
        let scale = size_m / step.dt_s + 4.0;
        let off_m_s = |of: &DVec3| (vector(after[i].velocity_m_s) - *of).abs().max_element();
        let nearest = sides.into_iter().min_by(|a, b| off_m_s(a).total_cmp(&off_m_s(b))).unwrap_or(expected);
        worst.check3(after[i].velocity_m_s, nearest, scale)?;
    }
    Ok(moved)
}

const TOLERANCE: f64 = 16.0 * ROUNDING;

pub(crate) fn repel_walls_matches_its_twin(device: &Device) {
    let mut rng = rng(187);
    for repel in models() {
        let walls = twin::RepelWalls::of(&repel);
        let mut worst = device.worst(format!("{} {:?}", RepelWalls::STAGE, walls.model), TOLERANCE);
        let mut moved = 0;
        for size in sizes(device, RepelWalls::GROUP_SIZE[0] as usize) {
            let mut case = fluid(&mut rng, size);
            for (i, position) in case.positions.iter_mut().enumerate() {
                position.tag |= out_of_part(i);
            }
            let params = case.step_params();
            let after = run(device, &case, params, repel);
            moved += check(&mut worst, &case, &params, &walls, &after).or_raise();
        }
        worst.report(device);
        ensure!(moved > 50, "{moved} moved in all by {:?}", walls.model);
    }
}

pub(crate) fn a_wrong_wall_that_repels_is_told_apart(device: &Device) {
    let case = fluid(&mut rng(188), 500);
    let params = case.step_params();
    for repel in models() {
        let after = run(device, &case, params, repel);
        let told = |repel: RepelParams, params: StepParams| {
            let mut worst = Worst::new(RepelWalls::STAGE, TOLERANCE);
            check(&mut worst, &case, &params, &twin::RepelWalls::of(&repel), &after).is_err()
        };
        ensure!(!told(repel, params));
        ensure!(told(RepelParams { reach_m: 1.01 * repel.reach_m, ..repel }, params), "a reach");
        ensure!(told(RepelParams { model: 1 - repel.model, ..repel }, params), "another model");
        ensure!(told(repel, StepParams { max_speed_m_s: 0.5, ..params }), "a limit of speed");
        match repel.model {
            WALLS_BY_PENALTY => {
                let stiffness_per_s2 = 1.01 * repel.stiffness_per_s2;
                ensure!(told(RepelParams { stiffness_per_s2, ..repel }, params), "a stiffness");
                ensure!(told(RepelParams { damping_per_s: 1.01 * repel.damping_per_s, ..repel }, params), "a damping");
                ensure!(told(repel, StepParams { dt_s: 1.01 * params.dt_s, ..params }), "a step");
            }
            _ => ensure!(told(RepelParams { restitution: 0.41, ..repel }, params), "a restitution"),
        }
    }
}
