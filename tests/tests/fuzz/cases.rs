//! Fuzzes what reads files: the scene parser and the capture reader. Each case is a shipped scene
//! or a real capture, damaged; it must be read or refused in words, and never panic, hang, or take
//! memory that its size does not explain.
//!
//! By default some thousand cases, the same in each run. The long form, with other cases in each:
//!
//!     BROOKLET_FUZZ_MINUTES=15 BROOKLET_FUZZ_SEED=7 cargo test -p brooklet-tests --test fuzz -- --nocapture

use std::path::Path;

use crate::support::{Budget, Fuzz, damage, scenes};
use brooklet_capture::Capture;
use brooklet_fluid::{Scene, record_count, scene::schema};
use brooklet_gpu::{Plan, Resources, Tier};
use brooklet_render::{FrameOptions, Particles, View};
use brooklet_tests::program::Workshop;
use jsonschema::Validator;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Cases in the ordinary tests.
const SCENES: u64 = 3_000;
const CAPTURES: u64 = 2_000;

/// Memory that reading a scene of some kilobytes and planning it may take: the recording of
/// 10,000 iterations, the most a scene may have, is the largest part.
const SCENE_BYTES: usize = 256 << 20;

struct SceneCase {
    text: String,
    settings: Vec<String>,
}

fn check_scene(case: &SceneCase, validator: &Validator) -> Result<bool, String> {
    let SceneCase { text, settings } = case;
    let scene = match Scene::from_toml(text, "case.toml", settings) {
        Err(error) => {
            let message = error.to_string();
            let named = message.contains("case.toml") || message.contains("--set");
            let fine = named && !message.chars().any(char::is_control) && message.chars().count() < 700;
            return if fine { Ok(false) } else { Err(format!("a bad message: {message:?}")) };
        }
        Ok(scene) => scene,
    };
    let count = scene.particle_count();
    if count > u64::from(brooklet_fluid::scene::MAX_PARTICLES) {
        return Err(format!("{count} particles were let through"));
    }
    if count < 20_000 {
        let emitted = brooklet_fluid::particles::sample_lattice(&scene);
        let size_m = scene.domain.size_m();
        let inside = |at: &[f32; 3]| {
            (0..3).all(|axis| (-1e-3 * scene.spacing_m..=size_m[axis] + scene.spacing_m).contains(&f64::from(at[axis])))
        };
        if emitted.positions.len() as u64 != count || !emitted.positions.iter().all(|p| inside(&p.position_m)) {
            return Err("particles are not as counted, or outside the domain".into());
        }
    }
    let mut resources = Resources::new();
    let recorded = record_count(&mut resources, &scene, count as u32);
    let mut wanted: Vec<_> = recorded.measure_id().into_iter().collect();
    let mut recordings = recorded.recordings();
    if scene.outputs.images > 0 {
        let options = FrameOptions::for_scene(&scene, Tier::Floor);
        let view = View::of_scene(&scene);
        let drawn = brooklet_render::record(&mut resources, &view, &Particles::of(&recorded), &options);
        let drawn = drawn.map_err(|error| format!("a picture that the scene's check let through: {error}"))?;
        recordings.extend([drawn.init, drawn.draw]);
        wanted.push(drawn.color.id);
    }
    let plan = Plan::sweep(resources, recordings, &wanted).map_err(|error| format!("no plan: {error}"))?;
    if plan.bytes() < count * 32 {
        return Err(format!("{} bytes for {count} particles", plan.bytes()));
    }
    let again =
        Scene::from_toml(&scene.to_toml(), "case.toml", &[]).map_err(|error| format!("written out: {error}"))?;
    if again != scene {
        return Err("does not survive being written out".into());
    }
    let value = toml::from_str::<toml::Table>(&scene.to_toml()).map_err(|error| error.to_string())?;
    let value = serde_json::to_value(value).map_err(|error| error.to_string())?;
    match validator.iter_errors(&value).next() {
        Some(error) => Err(format!("the schema refuses what the parser reads: {error}")),
        None => Ok(true),
    }
}

fn scene_case(rng: &mut ChaCha8Rng, corpus: &[String]) -> SceneCase {
    let mut text = corpus[rng.random_range(0..corpus.len())].clone();
    let mut settings = Vec::new();
    for _ in 0..rng.random_range(0..4) {
        text = match rng.random_range(0..4) {
            0 => {
                let other = corpus[rng.random_range(0..corpus.len())].as_bytes();
                String::from_utf8_lossy(&damage(rng, text.as_bytes(), other)).into_owned()
            }
            _ => scenes::replace_token(rng, &text),
        };
    }
    for _ in 0..rng.random_range(0..3) {
        settings.push(scenes::setting(rng));
    }
    SceneCase { text, settings }
}

fn scene_corpus() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../app/fluid/scenes");
    let mut texts: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .map(|path| std::fs::read_to_string(path).unwrap())
        .collect();
    assert!(texts.len() >= 6);
    texts.sort();
    // Every optional key, which no shipped scene has.
    texts.push(format!(
        "{}[camera]\neye_m = [3, 2, 5]\ntarget_m = [1, 2, 3]\nfov_deg = 50\n[solver]\nmethod = \"pbf\"\n\
         support_ratio = 2\nmax_speed_m_s = 9\nneighbour_slots = 64\nsubsteps = 2\n[solver.pbf]\niterations = 3\n\
         relaxation = 0.4\ncfm = 0.1\ns_corr_k = 0.1\ns_corr_distance_ratio = 0.3\n\
         [forces]\nxsph = 0.1\nvorticity_m_s = 0.2\n",
        brooklet_tests::program::SCENE
    ));
    texts
}

#[test]
fn damaged_scenes_are_read_or_refused() {
    let validator = jsonschema::validator_for(&serde_json::from_str(&schema()).unwrap()).unwrap();
    let corpus = scene_corpus();
    let check = |case: &SceneCase| check_scene(case, &validator);
    for text in &corpus {
        let sound = check(&SceneCase { text: text.clone(), settings: Vec::new() });
        assert_eq!(sound, Ok(true), "the corpus is sound:\n{text}");
    }
    let report = Fuzz { name: "scenes", budget: Budget::of(SCENES), bytes: |_: &SceneCase| SCENE_BYTES }.run(
        |rng| scene_case(rng, &corpus),
        check,
        |case| {
            [case.settings.iter().map(|s| format!("# --set {s}\n")).collect(), case.text.clone()].concat().into_bytes()
        },
    );
    // Both ends of the parser are reached, or the cases are no good.
    assert!(report.accepted * 20 > report.cases && report.refused * 4 > report.cases, "{report:?}");
}

/// The file, its rows with their names, and what the reader buffers.
fn capture_memory(case: &[u8]) -> usize {
    (8 << 20) + 64 * case.len()
}

fn capture_bytes() -> Vec<u8> {
    let workshop = Workshop::new();
    workshop.succeed(&["run", "scene.toml", "--steps", "4", "--out", "result"]);
    std::fs::read(workshop.path("result/capture.mcap")).unwrap()
}

fn check_capture(bytes: &[u8]) -> Result<bool, String> {
    match Capture::read(std::io::Cursor::new(bytes), bytes.len() as u64, "case.mcap") {
        Ok(capture) => {
            // A message is never shorter than 16 bytes, and a span in its frame's message than 4 ("0,0,").
            let most = bytes.len() / 4;
            let found = capture.frames.len() + capture.spans.len() + capture.passes.len() + capture.stats.len();
            if found <= most { Ok(true) } else { Err(format!("{found} messages in {} bytes", bytes.len())) }
        }
        Err(error) => {
            let message = error.to_string();
            let fine = message.contains("case.mcap") && !message.chars().any(char::is_control) && message.len() < 2_000;
            if fine { Ok(false) } else { Err(format!("a bad message: {message:?}")) }
        }
    }
}

#[test]
fn damaged_captures_are_read_or_refused() {
    let sound = capture_bytes();
    assert_eq!(check_capture(&sound), Ok(true));
    // Damage behind a checksum only shows that the checksum works; without one it reaches further.
    let unchecked = crate::support::captures::without_checksums(&sound);
    assert_eq!(check_capture(&unchecked), Ok(true));
    let report = Fuzz { name: "captures", budget: Budget::of(CAPTURES), bytes: |case: &Vec<u8>| capture_memory(case) }
        .run(
            |rng| {
                let base = if rng.random_bool(0.7) { &unchecked } else { &sound };
                let mut case = base.clone();
                for _ in 0..rng.random_range(1..4) {
                    case = match rng.random_range(0..3) {
                        0 => crate::support::captures::replace_number(rng, &case),
                        1 => crate::support::captures::replace_text(rng, &case),
                        _ => damage(rng, &case, &sound),
                    };
                }
                case
            },
            |case| check_capture(case),
            Clone::clone,
        );
    assert!(report.accepted > 0 && report.refused * 4 > report.cases, "{report:?}");
}

/// Inputs that an earlier run of the fuzzers found something with.
#[test]
fn what_was_found_once_stays_mended() {
    let validator = jsonschema::validator_for(&serde_json::from_str(&schema()).unwrap()).unwrap();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("found");
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let bytes = std::fs::read(&path).unwrap();
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("toml") => {
                let text = String::from_utf8_lossy(&bytes).into_owned();
                let settings = text.lines().map_while(|line| line.strip_prefix("# --set ").map(String::from)).collect();
                let case = SceneCase { text, settings };
                let fuzz = Fuzz { name: "found", budget: Budget::Cases(1), bytes: |_: &&SceneCase| SCENE_BYTES };
                fuzz.run(|_| &case, |case| check_scene(case, &validator), |_| Vec::new());
            }
            Some("mcap") => {
                let fuzz =
                    Fuzz { name: "found", budget: Budget::Cases(1), bytes: |case: &Vec<u8>| capture_memory(case) };
                fuzz.run(|_| bytes.clone(), |case| check_capture(case), Clone::clone);
            }
            _ => continue,
        }
        count += 1;
    }
    assert!(count > 0, "nothing in {}", folder.display());
}

/// The fuzzers can fail: each kind of fault is seen and its input kept.
#[test]
fn faults_are_seen() {
    let run = |check: fn(&u64) -> Result<bool, String>| {
        let fuzz = Fuzz { name: "self-test", budget: Budget::Cases(50), bytes: |_: &u64| 1 << 20 };
        std::panic::catch_unwind(|| {
            fuzz.run(|rng| rng.random_range(0..10), check, |case| case.to_string().into_bytes())
        })
    };
    assert!(run(|_| Ok(true)).is_ok());
    assert!(run(|case| if *case == 7 { Err("seven".into()) } else { Ok(true) }).is_err(), "an error");
    assert!(run(|case| if *case == 7 { panic!("seven") } else { Ok(true) }).is_err(), "a panic");
    assert!(run(|case| Ok(vec![1_u8; 8 << (20 * u64::from(*case == 7))].iter().all(|b| *b == 1))).is_err(), "memory");
}
