//! Dragging: the kernel against its twin, and as a program records it.

use crate::bench::Bench;
use crate::cases::{fluid, out_of_part, sizes, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::drag::{Drag, record_drag};
use brooklet_fluid::particles::is_simulated;
use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::{DragParams, Kernel, Position, Velocity};
use brooklet_reference::particles::drag as twin;
use glam::DVec3;
use rand::{Rng, RngExt};

fn run(device: &Device, positions: &[Position], velocities: &[Velocity], params: DragParams) -> Vec<Velocity> {
    let mut bench = Bench::new(device);
    let (count, positions) = (positions.len(), bench.input("positions", positions));
    let mut velocities = bench.input("velocities", velocities);
    let drag = bench.uniform("drag_params", params);
    let step_state = bench.uniform("step_state", step_state(count, 0.0));
    bench.dispatch(
        &brooklet_kernels::Drag {
            positions: positions.read(),
            velocities: velocities.write(),
            step_state: step_state.uniform(),
            drag: drag.uniform(),
        },
        count,
    );
    bench.run().read(&velocities, count)
}

fn twin_of(params: &DragParams) -> twin::Drag {
    twin::Drag {
        origin_m: vector(params.origin_m),
        direction: vector(params.direction),
        radius_m: f64::from(params.radius_m),
        near_m: f64::from(params.near_m),
        far_m: f64::from(params.far_m),
        velocity_m_s: vector(params.velocity_m_s),
        share: f64::from(params.share),
        flat: params.along_z == 0.0,
    }
}

/// Compares all velocities; returns how many the drag changed.
///
/// The weight is a polynomial of the squared distance over the squared radius. With L the largest
/// distance from the origin, difference and cross product are off by 4 L roundings, the weight with slope
/// 2 then by 16 L / radius of them, and what follows adds fewer than ten.
fn check(
    device: &Device,
    positions: &[Position],
    before: &[Velocity],
    after: &[Velocity],
    drag: &twin::Drag,
) -> Result<usize, Wrong> {
    let furthest_m = positions.iter().map(|p| (vector(p.position_m) - drag.origin_m).length()).fold(0.0, f64::max);
    let mut worst = Worst::new(brooklet_kernels::Drag::STAGE, (16.0 * furthest_m / drag.radius_m + 10.0) * ROUNDING);
    let mut moved = 0;
    for (i, position) in positions.iter().enumerate() {
        let (at_m, velocity_m_s) = (vector(position.position_m), vector(before[i].velocity_m_s));
        let expected = match is_simulated(position.tag) {
            true => twin::drag(at_m, velocity_m_s, drag),
            false => velocity_m_s,
        };
        moved += usize::from(expected != velocity_m_s);
        // At the ends of the range a rounding decides.
        let depth_m = (at_m - drag.origin_m).dot(drag.direction);
        let doubt_m = 4.0 * ROUNDING * furthest_m;
        if (depth_m - drag.near_m).abs() > doubt_m && (depth_m - drag.far_m).abs() > doubt_m {
            worst.check3(after[i].velocity_m_s, expected, 8.0)?;
        }
    }
    if !positions.is_empty() {
        worst.report(device);
    }
    Ok(moved)
}

fn drag_params(rng: &mut impl Rng, size_m: DVec3) -> DragParams {
    let mut random = || DVec3::new(rng.random(), rng.random(), rng.random());
    let through_m = random() * size_m;
    let direction = (random() - 0.5).normalize();
    DragParams {
        origin_m: (through_m - 1.2 * direction).as_vec3().to_array(),
        radius_m: 0.4 * size_m.max_element() as f32,
        direction: direction.as_vec3().to_array(),
        share: 0.7,
        velocity_m_s: (4.0 * random() - 2.0).as_vec3().to_array(),
        along_z: 1.0,
        near_m: 1.15,
        far_m: 1.5,
        ..DragParams::default()
    }
}

pub(crate) fn drag_matches_its_twin(device: &Device) {
    let mut rng = rng(61);
    let mut moved = 0;
    for size in sizes(device, brooklet_kernels::Drag::GROUP_SIZE[0] as usize) {
        for along_z in [1.0, 0.0] {
            let mut case = fluid(&mut rng, size);
            for (i, position) in case.positions.iter_mut().enumerate() {
                position.tag |= out_of_part(i);
            }
            let params = DragParams { along_z, ..drag_params(&mut rng, case.size_m) };
            let after = run(device, &case.positions, &case.velocities, params);
            moved += check(device, &case.positions, &case.velocities, &after, &twin_of(&params)).or_raise();
            let still = |i: usize| after[i].velocity_m_s[2] == case.velocities[i].velocity_m_s[2];
            ensure!(along_z == 1.0 || (0..size).all(still), "in two dimensions nothing moves along z");
        }
    }
    ensure!(moved > 100, "{moved} moved in all");
}

pub(crate) fn a_drag_of_another_radius_or_velocity_fails(device: &Device) {
    let mut rng = rng(62);
    let case = fluid(&mut rng, 500);
    let params = drag_params(&mut rng, case.size_m);
    let after = run(device, &case.positions, &case.velocities, params);
    let right = twin_of(&params);
    check(device, &case.positions, &case.velocities, &after, &right).or_raise();
    for wrong in [
        twin::Drag { radius_m: 1.001 * right.radius_m, ..right },
        twin::Drag { share: 0.999 * right.share, ..right },
        twin::Drag { velocity_m_s: right.velocity_m_s + DVec3::X * 1e-3, ..right },
        twin::Drag { near_m: right.near_m + 0.01, ..right },
    ] {
        ensure!(check(device, &case.positions, &case.velocities, &after, &wrong).is_err(), "{wrong:?}");
    }
}

fn block(settings: &[&str]) -> Scene {
    let text = "spacing_m = 0.05\n[domain]\nmin_m = [1, 2, 3]\nmax_m = [2, 3, 4]\n[[fluid]]\n\
                block = { min_m = [1, 2, 3], max_m = [1.6, 2.5, 4] }\nvelocity_m_s = [0.5, -0.25, 0]";
    let settings: Vec<String> = settings.iter().map(|setting| (*setting).to_owned()).collect();
    Scene::from_toml(text, "block", &settings).or_raise()
}

pub(crate) fn a_scene_is_dragged_only_if_somebody_asks(device: &Device) {
    let scene = block(&[]);
    let plan_of = |dragged: bool| {
        let mut resources = Resources::new();
        let mut recorded = record(&mut resources, &scene);
        let pass = dragged.then(|| record_drag(&mut resources, &mut recorded));
        let drags = pass.as_ref().map(|pass| pass.recording.clone());
        let recordings = recorded.recordings().into_iter().chain(drags).collect();
        let plan = Plan::sweep(resources, recordings, &[]).or_raise();
        (plan, recorded, pass)
    };
    let has_drag = |plan: &Plan| plan.passes().iter().any(|pass| pass.stage == brooklet_kernels::Drag::STAGE);
    let labels = |plan: &Plan| plan.buffers().iter().filter(|buffer| buffer.label == "drag_params").count();
    let (without, ..) = plan_of(false);
    ensure!(!has_drag(&without) && labels(&without) == 0);
    let (plan, recorded, pass) = plan_of(true);
    ensure!(has_drag(&plan) && labels(&plan) == 1);
    ensure!(
        !plan.commands(recorded.step.id()).iter().any(|command| command.stage() == Some(brooklet_kernels::Drag::STAGE))
    );

    let pass = pass.or_raise();
    let mut engine = device.engine(plan);
    engine.run(&[recorded.init.id(), pass.recording.id()], &[]).or_raise();
    let positions = engine.read(&recorded.positions).or_raise();
    let before = engine.read(&recorded.velocities).or_raise();
    ensure!(before.iter().all(|v| v.velocity_m_s == [0.5, -0.25, 0.0]), "nothing moves before the first drag");

    // An eye a hundred metres away, whose own position in f32 is known to 8 micrometres.
    let direction = DVec3::new(-0.3, -0.2, -0.9);
    let origin_m = DVec3::new(0.3, 0.25, 0.5) - 100.0 * direction.normalize();
    let drag = Drag {
        origin_m: origin_m.to_array(),
        direction: direction.to_array(),
        radius_m: 0.2,
        near_m: 0.1,
        far_m: f64::INFINITY,
        velocity_m_s: [1.0, 2.0, 3.0],
        dt_s: 0.02,
        tau_s: 0.05,
    };
    for idle in [
        Drag { direction: [0.0; 3], ..drag },
        Drag { origin_m: [f64::NAN, 0.0, 0.0], ..drag },
        Drag { velocity_m_s: [0.0, f64::INFINITY, 0.0], ..drag },
        Drag { radius_m: 0.0, ..drag },
        Drag { dt_s: 0.0, tau_s: 0.0, ..drag },
        Drag { tau_s: -1.0, ..drag },
        Drag { far_m: 50.0, ..drag },
    ] {
        pass.write(&mut engine, &scene, &idle);
        engine.run(&[pass.recording.id()], &[]).or_raise();
        ensure!(engine.read(&recorded.velocities).or_raise() == before, "{idle:?}");
    }
    pass.write(&mut engine, &scene, &drag);
    engine.run(&[pass.recording.id()], &[]).or_raise();
    let after = engine.read(&recorded.velocities).or_raise();
    ensure!(engine.read(&recorded.positions).or_raise() == positions);
    // The twin in f64, from a point on the same ray: what the foot's rounding may be is in the tolerance.
    let expected = twin::Drag {
        origin_m: DVec3::new(0.3, 0.25, 0.5),
        direction: direction.normalize(),
        radius_m: 0.2,
        near_m: -100.0,
        far_m: 100.0,
        velocity_m_s: DVec3::new(1.0, 2.0, 3.0),
        share: 1.0 - (-0.02f64 / 0.05).exp(),
        flat: false,
    };
    let moved = check(device, &positions, &before, &after, &expected).or_raise();
    ensure!(moved > 100 && moved < positions.len(), "{moved} of {}", positions.len());

    // In two dimensions z stays 0.
    let flat = block(&["domain.dimensions=2"]);
    ensure_eq!(pass.params(&flat, &drag).along_z, 0.0);
}
