//! Spray, foam and bubbles: where they come from, how many there are, that they are the same each time.

use std::collections::BTreeMap;

use brooklet_fluid::diffuse::DiffuseSet;
use brooklet_fluid::particles::sample_lattice;
use brooklet_fluid::state::State;
use brooklet_fluid::{FrameRequest, ParticleSource, Scene, Session, SessionRecorder};
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::{Counters, DiffuseParticle, DiffuseState};
use brooklet_tests::states::{state_of, with_section};
use brooklet_tests::{gpu_of_long_run, small};

/// A dam breaks over a wet bed.
const WAVE: &str = r#"spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [1.6, 0.8, 0.4]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.5, 0.6, 0.4] }
[[fluid]]
block = { min_m = [0.5, 0, 0], max_m = [1.6, 0.1, 0.4] }
[diffuse]
max_particles = 3000
[solver]
deterministic = true
[outputs]
measure_every_steps = 1
"#;

fn scene(text: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    Scene::from_toml(text, "wave.toml", &settings).unwrap()
}

fn session(scene: &Scene) -> Session {
    Session::start(&gpu_of_long_run(scene), SessionRecorder::new(scene, ParticleSource::Scene).sweep().unwrap())
        .unwrap()
}

/// What was counted so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Count {
    spawned: u64,
    ended: u64,
    overwritten: u64,
    dropped: u64,
}

impl Count {
    fn add(&mut self, counters: &Counters) {
        self.spawned += u64::from(counters.diffuse_spawned);
        self.ended += u64::from(counters.diffuse_ended);
        self.overwritten += u64::from(counters.diffuse_overwritten);
        self.dropped += u64::from(counters.diffuse_dropped);
    }

    fn there(&self) -> u64 {
        self.spawned - self.ended - self.overwritten
    }
}

fn run(session: &mut Session, steps: u32) -> Count {
    let mut count = Count::default();
    let mut add = |reports: Vec<brooklet_fluid::SessionReport>| {
        reports.iter().filter_map(|report| report.stats).for_each(|stats| count.add(&stats.counters));
    };
    for _ in 0..steps {
        session.submit(&FrameRequest { steps: 1, measure: true, ..FrameRequest::default() }).unwrap();
        add(session.reports());
    }
    add(session.finish().unwrap());
    count
}

fn slots(session: &mut Session) -> (Vec<DiffuseParticle>, DiffuseState) {
    let diffuse = session.recorded().diffuse.as_ref().unwrap().alias();
    let particles = session.engine_mut().read(&diffuse.particles).unwrap();
    (particles, session.engine_mut().read(&diffuse.state).unwrap()[0])
}

fn living(particles: &[DiffuseParticle]) -> impl Iterator<Item = &DiffuseParticle> {
    particles.iter().filter(|particle| particle.lifetime_s > 0.0)
}

fn steps(many: u32) -> u32 {
    if small() { 40 } else { many }
}

const SOLVERS: [&[&str]; 5] = [
    &[],
    &["solver.substeps=2", "solver.pbf.iterations=2"],
    &["solver.method=sph", "solver.dt_s=0.004", "solver.substeps=4"],
    &["solver.method=sph", "solver.sph.adaptive_substeps=true"],
    &["solver.method=dfsph"],
];

#[test]
fn a_wave_spawns_as_many_as_are_counted_with_every_solver() {
    for settings in SOLVERS {
        let scene = scene(WAVE, settings);
        let mut session = session(&scene);
        let count = run(&mut session, steps(160));
        let (particles, state) = slots(&mut session);
        assert!(small() || count.spawned > 300, "{settings:?}: {count:?}");
        assert_eq!(living(&particles).count() as u64, count.there(), "{settings:?}: {count:?}");
        assert_eq!(u64::from(state.instance_count), count.spawned.min(3000), "{settings:?}");
        assert_eq!(u64::from(state.next_slot), count.spawned % 3000, "{settings:?}");
        let max_m = scene.domain.size_m();
        for particle in living(&particles) {
            let at = particle.position_m.map(f64::from);
            let inside = (0..3).all(|axis| (0.0..=max_m[axis]).contains(&at[axis]));
            assert!(inside && particle.velocity_m_s.iter().all(|v| v.is_finite()), "{settings:?}: {particle:?}");
        }
    }
}

#[test]
fn more_than_there_is_room_for_overwrite_the_oldest() {
    let scene = scene(WAVE, &["diffuse.max_particles=100", "diffuse.trapped_air_per_s=3000", "diffuse.lifetime_s=30"]);
    let mut session = session(&scene);
    let count = run(&mut session, steps(120));
    let (particles, state) = slots(&mut session);
    assert_eq!(living(&particles).count() as u64, count.there());
    assert!(count.there() <= 100 && state.instance_count <= 100, "{count:?}");
    assert!(small() || count.overwritten > 100, "{count:?}");
}

#[test]
fn water_at_rest_spawns_none() {
    let settings = ["spacing_m=0.1", "diffuse={ max_particles = 1000 }", "outputs.measure_every_steps=1"];
    let scene = Scene::load("calm-pool", &settings.map(String::from)).unwrap();
    let mut session = session(&scene);
    let count = run(&mut session, steps(100));
    assert_eq!(count, Count::default());
    assert_eq!(slots(&mut session).1.instance_count, 0);
}

#[test]
fn runs_repeat_bit_for_bit_where_the_scene_is_deterministic() {
    let run = |settings: &[&str]| {
        let mut session = session(&scene(WAVE, settings));
        run(&mut session, steps(160));
        let (particles, _) = slots(&mut session);
        assert!(small() || living(&particles).count() > 100);
        bytemuck::cast_slice::<_, u8>(&particles).to_vec()
    };
    let first = run(&[]);
    assert!(first == run(&[]), "the same each time");
    assert!(small() || first != run(&["diffuse.wave_crest_per_s=150"]), "another setting is another run");
}

/// Where they stand, in use and not, and the fluid.
fn bits(session: &mut Session) -> (Vec<u8>, DiffuseState, Vec<u8>) {
    let (particles, state) = slots(session);
    let fluid = session.read_particles().unwrap();
    (bytemuck::cast_slice(&particles).to_vec(), state, bytemuck::cast_slice(&fluid.positions).to_vec())
}

#[test]
fn a_run_that_goes_on_from_a_state_has_those_that_there_were() {
    // Room for all, and a ring that has come round.
    for settings in [&[][..], &["diffuse.max_particles=100"]] {
        let scene = scene(WAVE, settings);
        let mut whole = session(&scene);
        run(&mut whole, steps(100));
        let saved = whole.read_state().unwrap();
        let is_full = saved.diffuse.particles.len() == 100;
        assert!(small() || is_full != settings.is_empty(), "{}", saved.diffuse.particles.len());
        let read = State::from_bytes(&saved.to_bytes(), "test").unwrap();
        assert_eq!(read.diffuse, saved.diffuse);
        let recorder = SessionRecorder::new(&read.scene, ParticleSource::Given(read.particles.clone()));
        let mut planned = recorder.sweep().unwrap();
        planned.start_at(&read);
        let mut again = Session::start(&gpu_of_long_run(&scene), planned).unwrap();
        assert!(bits(&mut again) == bits(&mut whole), "those that there were");
        assert_eq!(run(&mut again, 30), run(&mut whole, 30));
        assert!(bits(&mut again) == bits(&mut whole), "and they go on alike");
        // The comparator: a run without any does not, though its fluid does, which does not know of them.
        planned = SessionRecorder::new(&read.scene, ParticleSource::Given(read.particles.clone())).sweep().unwrap();
        planned.start_at(&State { diffuse: DiffuseSet::default(), ..read });
        let mut without = Session::start(&gpu_of_long_run(&scene), planned).unwrap();
        run(&mut without, 30);
        let [with, without] = [&mut again, &mut without].map(bits);
        assert!((small() || with.0 != without.0) && with.2 == without.2);
    }
}

#[test]
fn what_is_wrong_with_a_saved_state_of_them_is_refused() {
    let scene = scene(WAVE, &[]);
    let bubble = DiffuseParticle { lifetime_s: 1.0, ..DiffuseParticle::default() };
    let state = state_of(scene.clone(), sample_lattice(&scene), 30, 0.125);
    let with = |diffuse: DiffuseSet| State { diffuse, ..state.clone() };
    let read = |bytes: &[u8]| State::from_bytes(bytes, "foam").map_err(|error| error.to_string());
    let endless = DiffuseParticle { lifetime_s: f32::INFINITY, ..bubble };
    let saved = with(DiffuseSet { particles: vec![bubble, endless], next_slot: 2 });
    let found = read(&saved.to_bytes()).unwrap().diffuse;
    assert_eq!(found.particles, [bubble, DiffuseParticle::default()], "what is not finite is an empty slot");
    let content = |next: u32, lifetime_s: f32| {
        let numbers = [0.0, 0.0, 0.0, lifetime_s, 0.0, 0.0, 0.0, 0.0];
        [next.to_le_bytes().to_vec(), numbers.iter().flat_map(|x| x.to_le_bytes()).collect()].concat()
    };
    let plain = state.to_bytes();
    let file = |content: &[u8]| with_section(&plain, b"FOAM", 1, 1, content);
    assert_eq!(read(&file(&content(1, 1.0))).unwrap().diffuse.particles, [bubble]);
    for (content, words) in [
        (content(2, 1.0), "its next diffuse particle's slot is 2; at most 1 are allowed"),
        (content(0, f32::NAN), "diffuse particle 0 is [0.0, 0.0, 0.0, NaN, 0.0, 0.0, 0.0, 0.0]; it must be finite"),
        (content(0, 1.0)[..35].to_vec(), "its section FOAM has 35 bytes; it must have 4 and 32 a slot"),
        (vec![0; 3], "its section FOAM has 3 bytes"),
        (vec![], "its section FOAM has 0 bytes"),
    ] {
        let message = read(&file(&content)).unwrap_err();
        assert!(message.contains(words), "{message}");
    }
    // Another program's, which this one does not know: it may go on without.
    assert!(read(&with_section(&plain, b"FOAM", 2, 1, &[])).unwrap().diffuse.particles.is_empty());
}

/// A solid through which nobody goes, and a wall of one's own.
#[test]
fn solids_stop_them() {
    let block = "solid=[{ box = { size_m = [0.1, 0.8, 0.4] }, centre_m = [1.0, 0.4, 0.2] }]";
    let mut session =
        session(&scene(WAVE, &[block, "fluid=[{ block = { min_m = [0, 0, 0], max_m = [0.5, 0.6, 0.4] } }]"]));
    run(&mut session, steps(200));
    let (particles, _) = slots(&mut session);
    let mut count = 0;
    for particle in living(&particles) {
        count += 1;
        assert!(particle.position_m[0] < 0.96, "{particle:?}");
    }
    assert!(small() || count > 50, "{count}");
}

/// How often each stage runs in all recordings, and their bytes.
fn planned(settings: &[&str], text: &str) -> (BTreeMap<&'static str, u64>, u64) {
    let mut resources = Resources::new();
    let recorded = brooklet_fluid::record(&mut resources, &scene(text, settings));
    let wanted: Vec<_> = recorded.measure_id().into_iter().collect();
    let plan = Plan::sweep(resources, recorded.recordings(), &wanted).unwrap();
    let mut counts = BTreeMap::new();
    plan.passes().iter().for_each(|pass| *counts.entry(pass.stage).or_default() += u64::from(pass.count));
    (counts, plan.without_sharing().bytes())
}

#[test]
fn a_scene_without_has_nothing_of_it() {
    let own = ["crest_normals", "count_spawned", "spawn_diffuse", "settle_diffuse", "advect_diffuse"];
    let without = WAVE.replace("[diffuse]\nmax_particles = 3000\n", "");
    let ((mut with, bytes), (lean, lean_bytes)) = (planned(&[], WAVE), planned(&[], &without));
    for name in own {
        assert!(with.remove(name) == Some(1) && !lean.contains_key(name), "{name}");
    }
    assert!(bytes > lean_bytes + 3000 * 32);
    // The scan of what is spawned, of less than a group's particles.
    *with.get_mut("scan_groups").unwrap() -= 1;
    assert_eq!(with, lean);
    // Of particles that do not interact, or with no room for any, there are none.
    for settings in [&["solver.method=none"][..], &["diffuse.max_particles=0"]] {
        let (other, _) = planned(settings, WAVE);
        assert!(own.iter().all(|name| !other.contains_key(name)), "{settings:?}");
    }
}

#[test]
fn what_they_may_not_be_told_is_said_in_a_line() {
    for (setting, words) in [
        ("diffuse.wave_crest_max=0.01", "diffuse.wave_crest_max = 0.01: must be above wave_crest_min = 0.04"),
        (
            "diffuse.trapped_air_max_m_s=0.1",
            "diffuse.trapped_air_max_m_s = 0.1: must be above trapped_air_min_m_s = 0.1",
        ),
        ("diffuse.energy_min_j_kg=1e6", "must be above energy_min_j_kg = 1e6 J/kg"),
        ("diffuse.drag=2", "diffuse.drag = 2: must be a number from 0 to 1"),
        ("diffuse.max_particles=-1", "diffuse.max_particles"),
        ("diffuse.max_particles=2e7", "diffuse.max_particles"),
        ("diffuse.lifetime_s=0", "diffuse.lifetime_s = 0: must be a number from 0.001 to 1e6 s"),
        ("diffuse.foam=1", "foam"),
    ] {
        let message = Scene::from_toml(WAVE, "wave.toml", &[setting.into()]).unwrap_err().to_string();
        assert!(message.contains("wave.toml") && message.contains(words), "{setting}: {message}");
        assert!(!message.contains('\n'), "{message}");
    }
}
