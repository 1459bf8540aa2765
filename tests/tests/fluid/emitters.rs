//! Particles that come from emitters and go into drains: counts, densities, capacity, what slots are left with, messages.

use std::collections::BTreeSet;

use brooklet_fluid::particles::{ParticleSet, fluid_of, id_of, is_inactive, is_simulated};
use brooklet_fluid::scene::emitters;
use brooklet_fluid::state::State;
use brooklet_fluid::{FrameRequest, ParticleSource, Scene, Session, SessionRecorder, Stats, record};
use brooklet_gpu::{Gpu, GpuOptions, Plan, Resources};
use brooklet_kernels::{StepState, WarmStart};
use brooklet_tests::compare::vector;
use brooklet_tests::{gpu, gpu_of_long_run, small};
use glam::{DVec2, DVec3, Vec3Swizzles as _};

/// A pool that a jet runs into and two drains empty, one of them slowly; what the jet emits also ends by itself.
const POOL: &str = r#"spacing_m = 0.1
capacity = 330
[domain]
min_m = [0, 0, 0]
max_m = [1.2, 1.2, 0.8]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [1.2, 0.2, 0.8] }
[[emitter]]
radius_m = 0.16
centre_m = [0.3, 0.9, 0.4]
direction = [0.3, -1, 0]
speed_m_s = 2.1
lifetime_s = 0.9
fluid = 1
[[emitter]]
block = { min_m = [0.7, 0.6, 0.2], max_m = [1.1, 0.9, 0.6] }
start_s = 0.4
[[drain]]
block = { min_m = [0.9, 0, 0], max_m = [1.2, 0.15, 0.3] }
[[drain]]
sphere = { centre_m = [0.1, 0.1, 0.7], radius_m = 0.3 }
most_m3_s = 0.03
[solver]
deterministic = true
[outputs]
measure_every_steps = 1
"#;

fn scene(text: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    Scene::from_toml(text, "pool.toml", &settings).unwrap()
}

fn session(scene: &Scene) -> Session {
    Session::start(&gpu_of_long_run(scene), SessionRecorder::new(scene, ParticleSource::Scene).sweep().unwrap())
        .unwrap()
}

/// What came and went so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Count {
    emitted: u64,
    drained: u64,
    lost: u64,
}

impl Count {
    fn add(&mut self, stats: &Stats) {
        self.emitted += u64::from(stats.counters.emitted);
        self.drained += u64::from(stats.counters.drained);
        self.lost += u64::from(stats.counters.capacity_overflow);
    }
}

/// Steps with a measurement each, every one of which has to find as many particles as came and did not go.
fn run(session: &mut Session, steps: u32, begun: u64, count: &mut Count) {
    let mut check = |session: &mut Session, finish: bool| {
        let reports = if finish { session.finish().unwrap() } else { session.reports() };
        for report in reports {
            let Some(stats) = report.stats else { continue };
            count.add(&stats);
            let there = u64::from(stats.particles) + u64::from(stats.quarantined);
            assert_eq!(begun + count.emitted - count.drained, there, "after step {}: {count:?}", report.steps);
        }
    };
    for _ in 0..steps {
        session.submit(&FrameRequest { steps: 1, measure: true, ..FrameRequest::default() }).unwrap();
        check(session, false);
    }
    check(session, true);
}

fn step_state(session: &mut Session) -> StepState {
    let buffer = session.recorded().slots.state.alias();
    session.engine_mut().read(&buffer).unwrap()[0]
}

fn bits(set: &ParticleSet) -> Vec<u8> {
    [bytemuck::cast_slice::<_, u8>(&set.positions), bytemuck::cast_slice(&set.velocities)].concat()
}

/// With what every solver's slots are taken again.
const SOLVERS: [&[&str]; 5] = [
    &["solver.pbf.warm_start=0.2"],
    &["solver.method=sph", "solver.dt_s=0.004", "solver.substeps=4"],
    &["solver.method=sph", "solver.sph.adaptive_substeps=true"],
    &["solver.method=dfsph"],
    &["solver.method=none", "solver.none.lifetime_s=1.5"],
];

#[test]
fn counts_are_exact_and_slots_are_taken_anew_with_every_solver() {
    for settings in SOLVERS {
        let scene = scene(POOL, settings);
        let steps = if small() { 60 } else { 400 };
        let begun = scene.particle_count();
        let mut once = session(&scene);
        let mut count = Count::default();
        run(&mut once, steps, begun, &mut count);
        // More came than there ever were slots, and now and then none was free.
        assert!(small() || count.emitted > 300 && count.drained > 300, "{settings:?}: {count:?}");
        assert!(count.emitted > 20 && count.drained > 0, "{settings:?}: {count:?}");

        let set = once.read_particles().unwrap();
        let mut ids: Vec<u32> = set.positions.iter().map(|position| id_of(position.tag)).collect();
        ids.sort_unstable();
        assert!(ids.into_iter().eq(0..330), "{settings:?}: each slot keeps its id");
        assert!(set.positions.iter().all(|p| p.position_m.iter().all(|x| x.is_finite())));
        let active = step_state(&mut once).active_count as usize;
        assert!(set.positions[active..].iter().all(|p| is_inactive(p.tag)), "{settings:?}: none behind {active}");

        // Whoever stands behind them next begins with nothing of those before.
        let warm = once.recorded().warm_starts.as_ref().map(|buffer| buffer.alias());
        if let Some(warm) = warm {
            let warm: Vec<WarmStart> = once.engine_mut().read(&warm).unwrap();
            assert!(warm[..active].iter().any(|warm| *warm != WarmStart::default()), "something is kept");
            assert!(warm[active..].iter().all(|warm| *warm == WarmStart::default()), "{settings:?}");
        }
        let pressures: Vec<_> = once.recorded().pressures.iter().map(|buffer| buffer.alias()).collect();
        for pressures in pressures {
            let pressures: Vec<f32> = once.engine_mut().read(&pressures).unwrap();
            assert!(pressures[active..].iter().all(|pressure| *pressure == 0.0), "{settings:?}");
        }
        let accelerations = once.recorded().accelerations.as_ref().map(|buffer| buffer.alias());
        if let Some(accelerations) = accelerations {
            let accelerations: Vec<[f32; 4]> = once.engine_mut().read(&accelerations).unwrap();
            assert!(accelerations[..active].iter().any(|a| a[3] > 0.0));
            assert!(accelerations[active..].iter().all(|a| a[3] == 0.0), "{settings:?}");
        }

        let mut again = session(&scene);
        let mut same = Count::default();
        run(&mut again, steps, begun, &mut same);
        assert_eq!(count, same);
        assert!(bits(&again.read_particles().unwrap()) == bits(&set), "{settings:?}: the same each time, bit for bit");
    }
}

/// Without gravity or anybody near: a nozzle, and a hole before it.
const HUNDRED_THOUSAND: &str = "spacing_m = 0.1
gravity_m_s2 = [0, 0, 0]
capacity = 14
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 1]
[[emitter]]
radius_m = 0.1
centre_m = [0.3, 0.5, 0.5]
direction = [1, 0, 0]
speed_m_s = 3.7
[[drain]]
block = { min_m = [0.7, 0, 0], max_m = [1, 1, 1] }
[solver]
method = \"none\"
dt_s = 1.0
substeps = 250
[outputs]
measure_every_steps = 1
";

#[test]
fn a_hundred_thousand_substeps_keep_the_count_exact() {
    let steps = if small() { 4 } else { 400 };
    let scene = scene(HUNDRED_THOUSAND, &[]);
    let points = u64::from(emitters(&scene).emitters[0].points);
    // Without times: a pass a dispatch would take most of it.
    let options = GpuOptions {
        device_name: Some(gpu().info().name.clone()),
        tier: Some(gpu().tier()),
        timing: false,
        ..GpuOptions::default()
    };
    let planned = SessionRecorder::new(&scene, ParticleSource::Scene).sweep().unwrap();
    let mut session = Session::start(&Gpu::open(&options).unwrap(), planned).unwrap();
    let mut count = Count::default();
    run(&mut session, steps, 0, &mut count);
    let flowed = 3.7 * f64::from(steps) / 0.1;
    let layers = (count.emitted + count.lost) as f64 / points as f64;
    // A layer is a step of the flow by a spacing; the sum of so many in f32 is off by a few.
    assert!((layers - flowed).abs() < 1.0 + 1e-4 * flowed, "{layers} layers of {flowed}");
    assert!(small() || count.lost > 1000 && count.drained > 10_000, "{count:?}");
}

#[test]
fn nothing_is_read_back_that_nobody_asked_for() {
    let mut session = session(&scene(POOL, &[]));
    for _ in 0..40 {
        session.step().unwrap();
    }
    let reports = session.finish().unwrap();
    assert!(reports.len() == 40 && reports.iter().all(|report| report.report.readbacks.is_empty()));
    let set = session.read_particles().unwrap();
    assert!(set.positions.iter().any(|position| fluid_of(position.tag) == 1), "though particles came");
}

/// A jet in free space.
const JET: &str = "spacing_m = 0.05
gravity_m_s2 = [0, 0, 0]
[domain]
min_m = [0, 0, 0]
max_m = [3, 1, 1]
walls = false
[[emitter]]
radius_m = 0.17
centre_m = [0.3, 0.5, 0.5]
direction = [1, 0, 0]
speed_m_s = 1.7
[outputs]
seconds = 1.2
measure_every_steps = 1
";

#[test]
fn a_jet_has_its_density_at_rest_its_speed_and_its_volume() {
    for settings in [&["solver.method=pbf"][..], &["solver.method=dfsph"]] {
        let scene = scene(JET, settings);
        let mut session = session(&scene);
        let steps = (1.2 / scene.solver.dt_s).round() as u32;
        let mut count = Count::default();
        run(&mut session, steps, 0, &mut count);
        let stats = session.stats().unwrap();
        let points = u64::from(emitters(&scene).emitters[0].points);
        let wanted = (1.7_f64 * (1.2 - scene.solver.dt_s) / 0.05 + 0.5).floor() as u64 * points;
        assert_eq!(count, Count { emitted: wanted, ..Count::default() }, "as much as flowed");
        assert_eq!(u64::from(scene.slot_capacity().unwrap()) / points, 41, "room for what comes in outputs.seconds");
        println!("{settings:?}: {:?} {:?}", stats.compression, stats.density_error);
        assert!(stats.compression.max < 0.006, "{settings:?}: {:?}", stats.compression);
        // In the middle, where nobody misses neighbours, each is between its own.
        let set = session.read_particles().unwrap();
        let mut inner = 0;
        for (position, velocity) in set.positions.iter().zip(&set.velocities).filter(|(p, _)| is_simulated(p.tag)) {
            let at_m = vector(position.position_m);
            assert!((at_m.yz() - DVec2::splat(0.5)).length() < 0.18, "{settings:?}: {at_m} left the jet");
            let off = (vector(velocity.velocity_m_s) - 1.7 * DVec3::X).length();
            assert!(off < 0.05, "{settings:?}: {velocity:?}");
            inner += u64::from(at_m.x > 0.3);
        }
        assert!(inner + points >= wanted, "{inner} of {wanted}");
    }
}

#[test]
fn what_finds_no_slot_is_counted_and_changes_nobody() {
    let text = JET.replace("spacing_m", "capacity = 60\nspacing_m");
    let scene = scene(&text, &["solver.deterministic=true"]);
    let mut session = session(&scene);
    let mut count = Count::default();
    run(&mut session, 120, 0, &mut count);
    assert_eq!(count.emitted, 60);
    assert!(count.lost > 100 && count.drained == 0, "{count:?}");
    let before = session.read_particles().unwrap();
    run(&mut session, 1, 60 - count.emitted, &mut count);
    let after = session.read_particles().unwrap();
    let moved = |set: &ParticleSet, id: u32| {
        vector(set.positions.iter().find(|position| id_of(position.tag) == id).unwrap().position_m)
    };
    for id in 0..60 {
        let way_m = moved(&after, id) - moved(&before, id);
        assert!((way_m - 1.7 * scene.solver.dt_s * DVec3::X).length() < 5e-4, "{id}: {way_m}");
    }
}

#[test]
fn a_hose_gives_what_leaves_it_its_own_motion_too() {
    let scene = scene(
        "spacing_m = 0.02
        gravity_m_s2 = [0, 0, 0]
        [domain]
        min_m = [-1, -1, -1]
        max_m = [1, 1, 1]
        [[emitter]]
        radius_m = 0.01
        direction = [1, 0, 0]
        speed_m_s = 0.5
        velocity_m_s = [0, 0.25, 0]
        [[emitter]]
        radius_m = 0.01
        direction = [0, 0, 1]
        speed_m_s = 0.5
        turned_deg = [0, 90, 0]
        start_s = 0.25
        end_s = 0.5
        [solver]
        method = \"none\"
        dt_s = 0.0078125",
        &[],
    );
    let mut session = session(&scene);
    for _ in 0..128 {
        session.step().unwrap();
    }
    let set = session.read_particles().unwrap();
    let there = set.positions.iter().zip(&set.velocities).filter(|(p, _)| is_simulated(p.tag));
    let (carried, turned): (Vec<_>, Vec<_>) = there.partition(|(_, velocity)| velocity.velocity_m_s[1] > 0.1);
    assert_eq!([carried.len(), turned.len()], [25, 6], "of .5 m, and of .125 m");
    for (position, velocity) in &carried {
        let off = vector(velocity.velocity_m_s) - DVec3::new(0.5, 0.25, 0.0);
        assert!(off.length() < 1e-4, "{velocity:?}");
        // All began at the nozzle and went on as it does: beside each other.
        assert!((position.position_m[1] - 1.25).abs() < 0.002, "{position:?}");
    }
    assert!(turned.iter().all(|(_, v)| (vector(v.velocity_m_s) - 0.5 * DVec3::X).length() < 1e-4), "{turned:?}");
}

#[test]
fn a_saved_state_goes_on_emitting() {
    let scene = scene(POOL, &["solver.method=none", "capacity=2000"]);
    let mut session = session(&scene);
    let mut count = Count::default();
    run(&mut session, 100, scene.particle_count(), &mut count);
    let saved = session.read_state().unwrap();
    assert!(saved.particles.velocities.iter().any(|velocity| velocity.age_s < 0.0), "lifetimes");
    let read = State::from_bytes(&saved.to_bytes(), "test").unwrap();
    assert_eq!(read.particles.velocities, saved.particles.velocities);
    let begun = u64::from(step_state(&mut session).active_count);
    let mut planned = SessionRecorder::new(&read.scene, ParticleSource::Given(read.particles.clone())).sweep().unwrap();
    planned.start_at(&read);
    let mut resumed = Session::start(&gpu(), planned).unwrap();
    let (mut went_on, mut anew) = (Count::default(), Count::default());
    run(&mut session, 100, begun, &mut went_on);
    run(&mut resumed, 100, begun, &mut anew);
    assert_eq!(went_on.emitted, anew.emitted, "no layer twice, none lost, and the fill only once");
    assert!(went_on.emitted > 50 && went_on.drained.abs_diff(anew.drained) <= 4, "{went_on:?} {anew:?}");
}

fn stages(scene: &Scene) -> BTreeSet<&'static str> {
    let mut resources = Resources::new();
    let recorded = record(&mut resources, scene);
    let plan = Plan::sweep(resources, recorded.recordings(), recorded.measure_id().as_slice()).unwrap();
    plan.passes().iter().map(|pass| pass.stage).collect()
}

#[test]
fn a_plan_has_what_its_scene_has() {
    let nothing = |text: &str| {
        let table: toml::Table = toml::from_str(text).unwrap();
        let kept = table.into_iter().filter(|(key, _)| !["emitter", "drain", "capacity"].contains(&key.as_str()));
        toml::to_string(&kept.collect::<toml::Table>()).unwrap()
    };
    let added = |settings: &[&str]| -> Vec<&str> {
        let without = stages(&scene(&nothing(POOL), settings));
        stages(&scene(POOL, settings)).difference(&without).copied().collect()
    };
    let drains = ["mark_drained", "settle_drain", "take_drained"];
    let of_a_sort = [
        &["count_active", "drain_particles", "emit_particles", "guide_particles"],
        &drains[..1],
        &["open_emitters"],
        &drains[1..],
    ];
    assert_eq!(added(&[]), of_a_sort.concat());
    let without_a_sort: BTreeSet<&str> =
        ["count_compacted", "drain_particles", "emit_particles", "fill_holes", "list_movers", "mark_active"]
            .into_iter()
            .chain(["open_emitters", "reduce_groups", "scan_groups"])
            .chain(drains)
            .collect();
    let got: BTreeSet<&str> = added(&["solver.method=none"]).into_iter().collect();
    assert!(got.is_subset(&without_a_sort) && got.len() + 1 >= without_a_sort.len(), "{got:?}");
    // One thing alone.
    assert_eq!(
        added(&["drain=[]", "outputs.seconds=1"]),
        ["count_active", "drain_particles", "emit_particles", "guide_particles", "open_emitters"]
    );
    let one = JET.replace("speed_m_s", "start_s = 0\nspeed_m_s");
    assert!(!stages(&scene(&one, &[])).contains("drain_particles"), "nobody goes");
}

#[test]
fn what_cannot_be_is_said() {
    let solid = "solid=[{ box = { size_m = [0.6, 0.6, 0.6] }, centre_m = [0.3, 0.9, 0.4] }]";
    let cases: &[(&[&str], &[&str])] = &[
        (
            &["emitter.0.centre_m=[1.15, 0.9, 0.4]"],
            &["emitter.0 = a nozzle that is at [", "must lie inside the domain"],
        ),
        (
            &["emitter.0.velocity_m_s=[0, 0, 0.3]"],
            &["emitter.0 = a nozzle that is at", " s: must lie inside the domain"],
        ),
        (&["solver.method=none", solid], &["emitter.0 = a nozzle at [", "must not lie inside solid.0"]),
        (&["emitter.0.radius_m=40"], &["emitter.0.radius_m = 40: a layer of", "at most 65536"]),
        (&["emitter.0.width_m=0.2", "emitter.0.height_m=0.2"], &["emitter.0 = 2 shapes", "`radius_m`"]),
        (&["emitter=[{ speed_m_s = 1 }]"], &["emitter.0 = 0 shapes"]),
        (&["emitter=[{ width_m = 0.2, speed_m_s = 1 }]"], &["emitter.0 = one side", "`height_m`"]),
        (&["emitter.0.speed_m_s=0"], &["emitter.0.speed_m_s = 0: must be above 0"]),
        (&["emitter.0.speed_m_s=1000"], &["emitter.0.speed_m_s = 1000: at most", "solver.max_speed_m_s"]),
        (&["emitter.0.direction=[0, 0, 0]"], &["emitter.0.direction = [0, 0, 0]: must have a length"]),
        (&["emitter.0.start_s=3", "emitter.0.end_s=2"], &["emitter.0.end_s = 2: must be after start_s = 3"]),
        (&["emitter.0.fluid=127"], &["emitter.0.fluid = 127", "0 to 126"]),
        (
            &["emitter.1.block.max_m=[1.3, 0.9, 0.6]"],
            &["emitter.1 = [0.7, 0.6, 0.2] to [1.3, 0.9, 0.6]", "inside the domain"],
        ),
        (&["emitter.1.end_s=2"], &["emitter.1 = a body that fills at once", "those are a nozzle's"]),
        (&["emitter.1.block.min_m=[1.08, 0.6, 0.2]"], &["emitter.1", "no room for a particle"]),
        (
            &["drain.0.block.min_m=[1.3, 0, 0]", "drain.0.block.max_m=[1.5, 1, 1]"],
            &["drain.0", "must reach into the domain"],
        ),
        (&["drain.0.domain_exit=true"], &["drain.0 = 2 regions"]),
        (&["drain=[{ domain_exit = true }]"], &["drain.0.domain_exit = true: needs domain.walls = false"]),
        (&["drain=[{}]"], &["drain.0 = 0 regions"]),
        (&["drain.1.most_m3_s=-1"], &["drain.1.most_m3_s = -1"]),
        (&["capacity=12"], &["capacity = 12: must be 192 or more"]),
        (
            &["emitter.0.keyframe=[{ time_s = 1 }, { time_s = 0.5 }]"],
            &["emitter.0.keyframe", "not with centre_m, turned_deg, velocity_m_s or spin_deg_s"],
        ),
    ];
    for (settings, parts) in cases {
        let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
        let error = Scene::from_toml(POOL, "pool.toml", &settings).expect_err(&format!("{settings:?}")).to_string();
        for part in *parts {
            assert!(error.contains(part), "{settings:?}: {error:?} does not say {part:?}");
        }
        assert!(error.contains("pool.toml") && !error.contains('\n') && error.len() < 400, "{error}");
    }
    let long: Vec<String> = ["outputs.seconds=1e5".into()].into();
    let endless = POOL.replace("capacity = 330\n", "").replace("lifetime_s = 0.9\n", "");
    let error = Scene::from_toml(&endless, "pool.toml", &long).unwrap_err().to_string();
    assert!(error.contains("outputs.seconds = 100000") && error.contains("give it a capacity"), "{error}");
    let many =
        format!("emitter=[{}]", vec!["{ radius_m = 0.1, centre_m = [0.5, 0.5, 0.5], speed_m_s = 1 }"; 65].join(", "));
    let error = Scene::from_toml(POOL, "pool.toml", &[many]).unwrap_err().to_string();
    assert!(error.contains("emitter = 65 emitters: at most 64"), "{error}");
}

#[test]
fn what_leaves_an_open_domain_is_drained() {
    let text = format!("{}\n[[drain]]\ndomain_exit = true\n", JET.replace("seconds = 1.2", "seconds = 2"));
    let scene = scene(&text, &["domain.max_m=[1, 1, 1]"]);
    let mut session = session(&scene);
    let mut count = Count::default();
    run(&mut session, 480, 0, &mut count);
    assert!(count.drained > 1000, "{count:?}");
    // Whoever left in the last substep is taken in the next.
    assert!(session.stats().unwrap().escaped <= 37);
}

#[test]
fn two_dimensions_have_a_line_of_points_and_stay_in_their_plane() {
    let text = POOL.replace("max_m = [1.2, 1.2, 0.8]", "max_m = [1.2, 1.2, 0.8]\ndimensions = 2");
    let scene = scene(&text, &["emitter.0.radius_m=0.15", "solver.deterministic=true"]);
    assert_eq!(emitters(&scene).emitters[0].points, 3);
    let mut session = session(&scene);
    let mut count = Count::default();
    run(&mut session, 200, scene.particle_count(), &mut count);
    assert!(count.emitted > 50, "{count:?}");
    let set = session.read_particles().unwrap();
    let off = |p: &&brooklet_kernels::Position| is_simulated(p.tag) && (p.position_m[2] - 0.4).abs() > 1e-6;
    assert!(set.positions.iter().find(off).is_none(), "{:?}", set.positions.iter().find(off));
}
