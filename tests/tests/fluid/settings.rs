//! Settings of a running scene: each one's place in a panel, what a change of it asks for, and that
//! it is all that has to be done.

use std::collections::BTreeSet;

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::scene::{Kind, Setting, Update};
use brooklet_fluid::{FrameRequest, ParticleSource, Scene, Session, SessionPlan, SessionRecorder, shipped_scenes};
use brooklet_gpu::RecordingId;
use brooklet_kernels::Buffer;
use brooklet_render::{FrameOptions, ScenePlan, View};
use brooklet_tests::gpu;
use toml::Value;

/// Every term on, so that a small change of none leaves it out; but for a warm start, without which alone iterations can do
/// without an acceleration.
const TERMS_ON: &[&str] = &[
    "spacing_m=0.1",
    "solver.pbf.s_corr_k=0.01",
    "forces.vorticity_m_s=0.05",
    "solver.deterministic=true",
    "camera.eye_m=[4,2,5]",
    "camera.target_m=[0,0,0]",
];

const WARM: &str = "solver.pbf.warm_start=0.2";

fn scene(settings: &[&str]) -> Scene {
    let settings: Vec<String> = TERMS_ON.iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("dam-break", &settings).unwrap()
}

/// The scene with another value of a setting that is allowed.
fn changed(scene: &Scene, setting: &Setting) -> Scene {
    let number = |value: &Value| value.as_float().or(value.as_integer().map(|whole| whole as f64)).unwrap();
    let texts: Vec<String> = match (setting.kind, &setting.value) {
        (Kind::Number(limits), value) => {
            let value = value.as_ref().map_or(limits.least, number);
            [1.25 * value, 0.8 * value, 5.0, 0.5, 0.25].map(|number| number.to_string()).to_vec()
        }
        (Kind::Whole(_), value) => {
            let value = value.as_ref().map_or(1.0, number);
            [value + 1.0, value - 1.0, value + 5.0].map(|number| number.to_string()).to_vec()
        }
        (Kind::Vector(_), Some(Value::Array(items))) => [1.01, 0.99]
            .map(|scale| {
                let items: Vec<String> =
                    items.iter().map(|item| format!("{:?}", scale * number(item) + 0.001 * (scale - 1.0))).collect();
                format!("[{}]", items.join(","))
            })
            .to_vec(),
        (Kind::Vector(_), _) => vec!["[0.5,0.25,0.125]".to_owned()],
        (Kind::Choice(names), _) => names.iter().map(|name| (*name).to_owned()).collect(),
        // What is left out is there by default.
        (Kind::Switch, None) => vec!["false".to_owned()],
        (Kind::Switch, value) => vec![(value != &Some(Value::Boolean(true))).to_string()],
        (Kind::Switches, _) => vec!["[true,false,false]".to_owned(), "[false,false,true]".to_owned()],
        (Kind::Text, _) => vec!["another".to_owned()],
        (Kind::Vectors(_) | Kind::Table | Kind::Tables, _) => Vec::new(),
    };
    let wall = |model: &str, field: &str, text: &str| format!("domain.wall={{ model = '{model}', {field} = {text} }}");
    let one = |text: &String| match setting.path.strip_prefix("domain.faces.").and_then(|face| face.split_once('.')) {
        // What a wall that does not drag may not have.
        Some((face, "friction")) => format!("domain.faces.{face}={{ slip = 'friction', friction = {text} }}"),
        Some((face, "velocity_m_s")) => {
            let mut along = [0.5, 0.25, 0.125];
            along[usize::from(face.as_bytes()[0] - b'x')] = 0.0;
            format!("domain.faces.{face}={{ slip = 'friction', friction = 0.01, velocity_m_s = {along:?} }}")
        }
        _ => match setting.path.strip_prefix("domain.wall.") {
            // What only one model of walls has.
            Some(field @ ("stiffness_per_s2" | "damping_per_s")) => wall("penalty", field, text),
            Some("restitution") => wall("deflection", "restitution", text),
            _ => format!("{}={text}", setting.path),
        },
    };
    let settings = texts.iter().map(one);
    let mut allowed = settings.filter_map(|setting| scene.with_setting(&setting).ok()).filter(|other| other != scene);
    allowed.next().unwrap_or_else(|| panic!("{}: none of {texts:?} is another value that is allowed", setting.path))
}

struct Running {
    session: Session,
}

fn planned(scene: &Scene, source: ParticleSource) -> SessionPlan {
    SessionRecorder::new(scene, source).sweep().unwrap()
}

/// Whether a window, which also draws, takes `other` as it goes.
fn window_takes(scene: &Scene, other: &Scene) -> bool {
    let view = View::of_scene(scene);
    let [running, wanted] = [scene, other].map(|scene| {
        let looks = (view, FrameOptions::for_scene(scene, gpu().tier()));
        ScenePlan::sweep(scene, SessionRecorder::new(scene, ParticleSource::Count(100)), Some(looks)).unwrap()
    });
    running.plan().differs_only_in_uploads(wanted.plan())
}

fn run(scene: &Scene, particles: Option<ParticleSet>) -> Running {
    let source = particles.map_or(ParticleSource::Scene, ParticleSource::Given);
    Running { session: Session::start(&gpu(), planned(scene, source)).unwrap() }
}

impl Running {
    /// The bytes of every uniform buffer of the simulation.
    fn uniforms(&mut self) -> Vec<(String, Vec<u8>)> {
        let labels =
            ["grid_params", "coarse_grid_0", "smoothing_kernel_params", "pbf_params", "force_params", "step_params"];
        let buffers: Vec<_> =
            self.session.engine().plan().buffers().into_iter().filter(|b| labels.contains(&b.label.as_str())).collect();
        assert_eq!(buffers.len(), labels.len());
        let mut read = |buffer: brooklet_gpu::KeptBuffer| {
            let bytes = self.session.engine_mut().read::<u8>(&Buffer::new(buffer.id, buffer.bytes as u32)).unwrap();
            (buffer.label, bytes)
        };
        buffers.into_iter().map(&mut read).collect()
    }

    /// What runs, and in what memory.
    fn plan(&self) -> (Vec<(RecordingId, &'static str, u32)>, Vec<brooklet_gpu::KeptBuffer>) {
        let plan = self.session.engine().plan();
        (plan.passes().iter().map(|pass| (pass.recording, pass.module.name, pass.count)).collect(), plan.buffers())
    }

    /// Whether it takes another scene as it goes.
    fn takes(&mut self, other: &Scene) -> bool {
        let count = self.session.slot_count();
        self.session.apply(&planned(other, ParticleSource::Count(count))).unwrap()
    }

    fn step(&mut self, steps: u32) {
        self.session.submit(&FrameRequest { steps, ..FrameRequest::default() }).unwrap();
    }

    fn particles(&mut self) -> ParticleSet {
        self.session.read_particles().unwrap()
    }
}

fn bits(particles: &ParticleSet) -> (&[u8], &[u8]) {
    (bytemuck::cast_slice(&particles.positions), bytemuck::cast_slice(&particles.velocities))
}

fn with(scene: &Scene, update: Update) -> Vec<(Setting, Scene)> {
    let of = scene.settings().into_iter().filter(|setting| setting.update == update && setting.path != "solver.method");
    of.map(|setting| (changed(scene, &setting), setting)).map(|(other, setting)| (setting, other)).collect()
}

#[test]
fn writing_a_live_field_is_what_a_new_engine_would_have() {
    let scene = scene(&[WARM]);
    let mut running = run(&scene, None);
    let before = running.uniforms();
    let mut moved = BTreeSet::new();
    for (setting, other) in with(&scene, Update::Live) {
        let change = scene.change_to(&other);
        assert_eq!(change.update, Update::Live, "{change:?}");
        assert_eq!(change.fields, [(setting.path.clone(), Update::Live)]);
        assert!(running.takes(&other), "{}", setting.path);
        assert!(window_takes(&scene, &other), "{}", setting.path);
        let mut fresh = run(&other, None);
        assert_eq!(running.plan(), fresh.plan(), "{}", setting.path);
        assert!(running.uniforms() == fresh.uniforms(), "{}", setting.path);
        if fresh.uniforms() != before {
            moved.insert(setting.path);
        }
    }
    let expected = [
        "forces.vorticity_m_s",
        "forces.xsph",
        "gravity_m_s2",
        "solver.dt_s",
        "solver.max_speed_m_s",
        "solver.pbf.cfm",
        "solver.pbf.relaxation",
        "solver.pbf.s_corr_distance_ratio",
        "solver.pbf.s_corr_k",
        "solver.pbf.warm_start",
    ];
    assert_eq!(moved.iter().map(String::as_str).collect::<Vec<_>>(), expected, "what the uniforms hold");
    // And it steps as the new engine does.
    let other = scene.with_setting("gravity_m_s2=[3,-5,0]").unwrap();
    let mut fresh = run(&other, None);
    assert!(running.takes(&other));
    for running in [&mut running, &mut fresh] {
        running.step(2);
    }
    assert!(bits(&running.particles()) == bits(&fresh.particles()));
}

#[test]
fn a_rebuild_carries_the_particles_over_bit_for_bit() {
    let scene = scene(&[]);
    let mut running = run(&scene, None);
    running.step(3);
    let particles = running.particles();
    let rebuilds = with(&scene, Update::Rebuild);
    assert!(rebuilds.len() > 10);
    for (setting, other) in rebuilds {
        assert_eq!(scene.change_to(&other).update, Update::Rebuild, "{}", setting.path);
        // Some of a surface's fields are numbers in this picture and more than that in others.
        // A wall that is told to do nothing does what one does that nobody tells anything.
        let may_be_live = setting.path.starts_with("surface.") || setting.path.ends_with(".slip");
        assert!(may_be_live || !window_takes(&scene, &other), "{}", setting.path);
        let mut fresh = run(&other, Some(particles.clone()));
        assert!(bits(&fresh.particles()) == bits(&particles), "{}", setting.path);
        fresh.step(1);
        assert!(fresh.particles().positions.iter().flat_map(|p| p.position_m).all(f32::is_finite));
    }
}

#[test]
fn a_term_that_comes_or_goes_is_a_rebuild() {
    let on = scene(&[WARM]);
    for setting in [
        "forces.xsph",
        "forces.vorticity_m_s",
        "solver.pbf.s_corr_k",
        "solver.pbf.warm_start",
        "outputs.measure_every_steps",
    ] {
        let off = on.with_setting(&format!("{setting}=0")).unwrap();
        for (from, to) in [(&on, &off), (&off, &on)] {
            let change = from.change_to(to);
            assert_eq!(change.fields, [(setting.to_owned(), Update::Rebuild)]);
        }
        assert_ne!(run(&on, None).plan(), run(&off, None).plan(), "{setting}");
    }
}

#[test]
fn the_worst_field_decides_and_all_are_named() {
    let scene = scene(&[]);
    assert!(scene.change_to(&scene).is_nothing());
    assert_eq!(scene.change_to(&scene).update, Update::Live);
    let other = scene.with_setting("solver.dt_s=0.002").unwrap().with_setting("solver.pbf.iterations=3").unwrap();
    let change = scene.change_to(&other);
    let expected = [("solver.dt_s", Update::Live), ("solver.pbf.iterations", Update::Rebuild)];
    assert_eq!(change.fields, expected.map(|(path, update)| (path.to_owned(), update)));
    assert_eq!(change.update, Update::Rebuild);
    for reset in ["spacing_m=0.09", "domain.dimensions=2", "fluid.0.velocity_m_s=[1,0,0]"] {
        assert_eq!(scene.change_to(&scene.with_setting(reset).unwrap()).update, Update::Reset, "{reset}");
    }
    let mut more = scene.clone();
    more.fluids.push(more.fluids[0].clone());
    let change = scene.change_to(&more);
    assert!(change.update == Update::Reset && change.fields.iter().all(|(path, _)| path.starts_with("fluid.1.")));
}

#[test]
fn a_panel_can_show_and_set_every_field_of_every_scene() {
    for (name, _) in shipped_scenes() {
        let scene = Scene::load(name, &[]).unwrap();
        let settings = scene.settings();
        assert!(settings.len() > 40);
        for setting in &settings {
            let doc = setting.doc;
            assert!(doc.ends_with('.') && doc.len() > 5 && !doc.contains('\n'), "{}: {doc:?}", setting.path);
            let Some(value) = &setting.value else { continue };
            let same = scene.with_setting(&format!("{}={value}", setting.path)).unwrap();
            assert_eq!(same, scene, "{}", setting.path);
        }
        let names: BTreeSet<&str> = settings.iter().map(|setting| setting.path.as_str()).collect();
        assert_eq!(names.len(), settings.len(), "each once");
    }
    let of = |path: &str| scene(&[]).settings().into_iter().find(|setting| setting.path == path).unwrap();
    assert!(of("solver.dt_s").doc.starts_with("Time a step advances, s."));
    assert!(matches!(of("solver.dt_s").kind, Kind::Number(limits) if limits.unit == "s" && limits.least > 0.0));
    assert_eq!((of("forces.xsph").update, of("forces.xsph").at_zero), (Update::Live, Update::Rebuild));
    assert_eq!(of("solver.max_speed_m_s").value, None);
}

#[test]
fn a_setting_is_checked_as_a_file_is_and_can_be_taken_back() {
    let scene = scene(&[]);
    for setting in [
        "forces.xsph=3",
        "forces.xsph=water",
        "solver.nothing=1",
        "solver.dt_s",
        "camera.eye_m=[0,0,0]",
        "spacing_m=nan",
    ] {
        let settings: Vec<String> = TERMS_ON.iter().chain(&[setting]).map(|&s| s.into()).collect();
        let expected = Scene::load("dam-break", &settings).unwrap_err().to_string();
        assert_eq!(scene.with_setting(setting).unwrap_err().to_string(), expected);
    }
    let fast = scene.with_setting("solver.max_speed_m_s=3").unwrap();
    assert_eq!(fast.solver.max_speed_m_s, Some(3.0));
    assert_eq!(fast.with_default("solver.max_speed_m_s").unwrap(), scene);
    assert_eq!(scene.with_default("forces.vorticity_m_s").unwrap().forces.vorticity_m_s, 0.0);
    assert_eq!(scene.with_default("no.such.field").unwrap(), scene);
    let error = scene.with_default("spacing_m").unwrap_err().to_string();
    assert!(error.contains("spacing_m is missing"), "{error}");
}
