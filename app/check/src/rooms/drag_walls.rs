//! `boundary/drag_walls` against its twin.

use crate::bench::Bench;
use crate::cases::{Case, SUPPORT_M, fluid, kernel_params, out_of_part, sizes, step_state, walls_of};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure};
use brooklet_fluid::particles::is_simulated;
use brooklet_kernels::{DragWalls, Kernel as _, StepParams, Velocity, WallFace};
use brooklet_reference::boundary::drag_walls as twin;
use brooklet_reference::boundary::walls::DomainWalls;
use glam::DVec3;
use rand::{Rng, RngExt};

fn run(device: &Device, case: &Case, params: StepParams, faces: &[WallFace; 6]) -> Vec<Velocity> {
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let mut velocities = bench.input("velocities", &case.velocities);
    let wall_faces = bench.input("wall_faces", faces);
    let step_params = bench.uniform("step_params", params);
    let step_state = bench.uniform("step_state", step_state(case.count(), params.dt_s));
    let kernel = bench.uniform("kernel", kernel_params());
    bench.dispatch(
        &DragWalls {
            positions: positions.read(),
            velocities: velocities.write(),
            wall_faces: wall_faces.read(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
        },
        case.count(),
    );
    bench.run().read(&velocities, case.count())
}

fn twins_of(faces: &[WallFace; 6]) -> twin::WallFaces {
    faces.map(|face| twin::WallFace::of(&face))
}

/// Faces of which each drags in its own way, so strongly that velocities change by much in one substep.
fn faces(rng: &mut impl Rng) -> [WallFace; 6] {
    std::array::from_fn(|index| {
        let mut velocity_m_s = [0; 3].map(|_| rng.random::<f32>() * 4.0 - 2.0);
        velocity_m_s[index / 2] = 0.0;
        let [shear_m2_s, friction] = [[0.05, 0.0], [0.0, 0.5], [0.0, 0.0]][index % 3];
        WallFace { velocity_m_s, shear_m2_s, friction, ..WallFace::default() }
    })
}

/// Compares all velocities; returns how many the walls changed.
///
/// The distance over h is off by as many roundings as the domain is supports wide, and the slope L by some ten times that;
/// of a rate times dt, x, the change is 1 - exp(-x) or x/(1 + x): no more off than .4 of x is, relatively. Three axes add up.
fn check(
    worst: &mut Worst,
    case: &Case,
    params: &StepParams,
    walls: &DomainWalls,
    faces: &twin::WallFaces,
    after: &[Velocity],
) -> Result<usize, Wrong> {
    let mut moved = 0;
    for (i, position) in case.positions.iter().enumerate() {
        let (at_m, before_m_s) = (vector(position.position_m), vector(case.velocities[i].velocity_m_s));
        let expected = match is_simulated(position.tag) {
            true => twin::drag_walls(at_m, before_m_s, params.dt_s.into(), params.wall_offset_m.into(), walls, faces),
            false => before_m_s,
        };
        moved += usize::from((expected - before_m_s).length() > 0.01);
        worst.check3(after[i].velocity_m_s, expected, 4.0)?;
    }
    Ok(moved)
}

fn tolerance(case: &Case) -> f64 {
    16.0 * (1.0 + case.size_m.max_element() / SUPPORT_M) * ROUNDING
}

pub(crate) fn drag_walls_matches_its_twin(device: &Device) {
    let mut rng = rng(181);
    let mut moved = 0;
    for size in sizes(device, DragWalls::GROUP_SIZE[0] as usize) {
        let mut case = fluid(&mut rng, size);
        let mut worst = device.worst(DragWalls::STAGE, tolerance(&case));
        for (i, position) in case.positions.iter_mut().enumerate() {
            position.tag |= out_of_part(i);
        }
        let (params, faces) = (case.step_params(), faces(&mut rng));
        let walls = walls_of(&kernel_params(), case.size_m);
        let after = run(device, &case, params, &faces);
        moved += check(&mut worst, &case, &params, &walls, &twins_of(&faces), &after).or_raise();
        if size > 0 {
            worst.report(device);
        }
    }
    ensure!(moved > 100, "{moved} moved in all");
}

pub(crate) fn a_wrong_face_or_wall_is_told_apart(device: &Device) {
    let mut rng = rng(182);
    let case = fluid(&mut rng, 500);
    let (params, faces) = (case.step_params(), faces(&mut rng));
    let walls = walls_of(&kernel_params(), case.size_m);
    let after = run(device, &case, params, &faces);
    let right = twins_of(&faces);
    let told = |walls: &DomainWalls, faces: &twin::WallFaces, dt_s: f32| {
        let mut worst = Worst::new(DragWalls::STAGE, tolerance(&case));
        check(&mut worst, &case, &StepParams { dt_s, ..params }, walls, faces, &after).is_err()
    };
    ensure!(!told(&walls, &right, params.dt_s));
    let with = |change: &dyn Fn(&mut twin::WallFaces)| {
        let mut faces = right;
        change(&mut faces);
        told(&walls, &faces, params.dt_s)
    };
    ensure!(with(&|faces| faces[0].shear_m2_s *= 1.001), "a viscosity");
    ensure!(with(&|faces| faces[4].friction *= 1.001), "a friction");
    ensure!(with(&|faces| faces[0].velocity_m_s += DVec3::Y * 1e-3), "a velocity");
    ensure!(with(&|faces| faces.swap(0, 2)), "two walls changed for each other");
    ensure!(told(&walls, &right, 1.001 * params.dt_s), "a step");
    ensure!(told(&DomainWalls { support_m: 1.001 * walls.support_m, ..walls }, &right, params.dt_s), "a support");
}
