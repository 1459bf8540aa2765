//! Faults put into the solver turn a row of the study red: a study that could not find them would find
//! nothing. They are compiled here and nowhere else.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};

use brooklet_compiler::{Places, naming::snake};
use brooklet_fluid::scene::Acceleration;
use brooklet_gpu::{Gpu, Plan, Tier};
use brooklet_kernels::Module;
use brooklet_study::backend::Cache;
use brooklet_study::{Event, Fault, Outcome, Runner, Session, Setup, State, Task, Verdict, stability, validation};
use brooklet_tests::gpu;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Modules of one kernel, compiled from its source with some text replaced.
struct Faulty {
    modules: BTreeMap<String, &'static [u8]>,
}

impl Faulty {
    /// `kernel` below `shaders/hlsl`; each edit is a file, what stands there, and what stands there instead.
    fn compile(kernel: &str, edits: &[(&str, &str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (root().join("shaders/hlsl"), folder.path().join("shaders"));
        // What is included, and no other kernel.
        for room in ["shared", "grid", "boundary", "boundary/solids", "boundary/bodies", "solver/pbf"] {
            std::fs::create_dir_all(to.join(room)).unwrap();
            for entry in std::fs::read_dir(from.join(room)).unwrap() {
                let name = format!("{room}/{}", entry.unwrap().file_name().to_string_lossy());
                if name.ends_with(".hlsli") || name == kernel {
                    let mut text = std::fs::read_to_string(from.join(&name)).unwrap();
                    for (_, there, instead) in edits.iter().filter(|(file, ..)| *file == name) {
                        assert!(text.contains(there), "{name} has no `{there}` to put a fault at");
                        text = text.replace(there, instead);
                    }
                    std::fs::write(to.join(&name), text).unwrap();
                }
            }
        }
        let out = folder.path().join("out");
        let places = Places { shaders: to, out: out.clone(), parts: Vec::new(), target: Places::below(&root()).target };
        brooklet_compiler::build(&places).unwrap_or_else(|problems| panic!("{problems}"));
        let mut modules = BTreeMap::new();
        for entry in std::fs::read_dir(out.join("spirv")).unwrap() {
            let path = entry.unwrap().path();
            let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
            modules.insert(stem, &*Vec::leak(std::fs::read(&path).unwrap()));
        }
        Self { modules }
    }

    fn put_into(&self, plan: Plan) -> Plan {
        let exchanged = RefCell::new(0);
        let plan = plan
            .with_modules(|module| {
                let (kernel, keywords) = module.name.split_once('+').unwrap_or((module.name, ""));
                let stem = match keywords {
                    "" => snake(kernel),
                    keywords => format!("{}+{}", snake(kernel), keywords.to_lowercase()),
                };
                let spirv = self.modules.get(&stem)?;
                *exchanged.borrow_mut() += 1;
                // Pipelines are known by their module's hash.
                Some(Box::leak(Box::new(Module {
                    spirv: brooklet_kernels::Spirv::Plain(spirv),
                    hash: "faulty",
                    ..*module
                })))
            })
            .unwrap();
        assert!(*exchanged.borrow() > 0, "no module of the plan was exchanged");
        plan
    }
}

fn run(task: &Task, fault: Fault<'_>) -> Outcome {
    let open = |_: Tier, _: bool| -> Result<Gpu, String> { Ok(gpu()) };
    let (stop, notify) = (|| false, |_: Event<'_>| {});
    let session = Session::new(&open, Cache::default(), &stop, &notify).with_fault(fault);
    Runner::new(session).outcome(task).unwrap().unwrap()
}

const SOUND: Fault<'static> = Fault { setup: &|_| {}, plan: &|plan| plan };

fn validated(case: &str) -> Task {
    let mut tasks = validation::tasks(false).into_iter().map(|(_, task)| task);
    tasks.find(|task| task.case == case).unwrap()
}

/// Whether anything of it is marked: a figure beyond its limit, or an end that is not sound.
fn is_red(outcome: &Outcome) -> bool {
    let short = outcome.figures.iter().any(|figure| figure.verdict() == Verdict::FallsShort);
    short || matches!(outcome.state, State::Unstable | State::Silent | State::Refused)
}

fn shown(outcome: &Outcome) -> String {
    let figures: Vec<String> = outcome.figures.iter().map(|f| format!("{} {:?}", f.name, f.value)).collect();
    format!("{:?} {} {}", outcome.state, outcome.reason, figures.join(", "))
}

/// Of a task without a fault: run once, whatever asks first.
fn sound(task: &Task) -> Outcome {
    static KNOWN: Mutex<BTreeMap<String, Arc<OnceLock<Outcome>>>> = Mutex::new(BTreeMap::new());
    let known = Arc::clone(KNOWN.lock().unwrap().entry(task.key("")).or_default());
    known.get_or_init(|| run(task, SOUND)).clone()
}

fn check(task: &Task, fault: Fault<'_>) {
    let sound = sound(task);
    println!("{} sound:  {}", task.case, shown(&sound));
    assert!(!is_red(&sound), "{}", shown(&sound));
    let faulty = run(task, fault);
    println!("{} faulty: {}", task.case, shown(&faulty));
    assert!(is_red(&faulty), "{}", shown(&faulty));
}

#[test]
fn a_wrong_sign_in_the_kernels_gradient_is_found() {
    let gradient = [("shared/wendland.hlsli", "WENDLAND_GRADIENT = -20.0;", "WENDLAND_GRADIENT = 20.0;")];
    let faulty = Faulty::compile("solver/pbf/correct_positions.compute", &gradient);
    check(&validated("hydrostatic"), Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}

#[test]
fn too_much_relaxation_is_found() {
    // Scenes do not allow it; a fault is behind every check.
    let plain = |setup: &mut Setup| {
        setup.scene.solver.pbf.relaxation = Some(1.9);
        setup.scene.solver.pbf.acceleration = Acceleration::None;
    };
    let fault = Fault { setup: &plain, ..SOUND };
    check(&validated("hydrostatic"), fault);
}

#[test]
fn too_much_of_a_coarse_correction_is_found() {
    let weight = [("solver/pbf/coarse_correction.hlsli", "COARSE_WEIGHT = 0.3;", "COARSE_WEIGHT = 3.0;")];
    let faulty = Faulty::compile("solver/pbf/prolong_multiplier.compute", &weight);
    check(&validated("hydrostatic"), Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}

#[test]
fn too_much_of_a_warm_start_is_found() {
    // Settings do not allow it; ten times what they do is three times the last substep's pressure.
    let share = [("solver/pbf/start_warm.compute", "share = pbf.warm_start *", "share = 10.0 * pbf.warm_start *")];
    let faulty = Faulty::compile("solver/pbf/start_warm.compute", &share);
    let task = validated("hydrostatic");
    let warm = Task { settings: [&task.settings[..], &["solver.pbf.warm_start=0.3".into()]].concat(), ..task };
    check(&warm, Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}

#[test]
fn a_dropped_range_of_neighbours_is_found() {
    let rows = [(
        "grid/rows.hlsli",
        "rows.reach_squared_m2 = reach_m * reach_m;",
        "rows.low.y += 2; rows.reach_squared_m2 = reach_m * reach_m;",
    )];
    let faulty = Faulty::compile("grid/list_neighbours.compute", &rows);
    check(&validated("hydrostatic"), Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}

#[test]
fn compression_of_three_per_cent_that_is_overlooked_is_found() {
    let deaf = [
        ("solver/pbf/momentum.hlsli", "excess = sums.density - 1.0", "excess = sums.density - 1.03"),
        (
            "solver/pbf/constrain_density.compute",
            "sorted_positions[i], sums.density - 1.0",
            "sorted_positions[i], sums.density - 1.03",
        ),
    ];
    let faulty = Faulty::compile("solver/pbf/constrain_density.compute", &deaf);
    check(&validated("hydrostatic"), Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}

#[test]
fn too_much_momentum_is_found() {
    let momentum = [("solver/pbf/momentum.hlsli", "iteration.momentum * before", "2.5 * iteration.momentum * before")];
    let faulty = Faulty::compile("solver/pbf/constrain_density.compute", &momentum);
    check(&validated("hydrostatic"), Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}

#[test]
fn an_overflow_of_f16_is_found() {
    // 70,000 is infinity in f16, and infinity over itself is none.
    let large = [(
        "shared/wendland.hlsli",
        "pair.t_squared = pair.t * pair.t;",
        "pair.t_squared = pair.t * (pair.t * real(70000.0) / real(70000.0));",
    )];
    let faulty = Faulty::compile("solver/pbf/correct_positions.compute", &large);
    let task = stability::row_tasks(false)
        .into_iter()
        .find(|task| task.case == "corner" && task.settings[0].ends_with("=half"))
        .unwrap();
    check(&task, Fault { plan: &|plan| faulty.put_into(plan), ..SOUND });
}
