//! `brooklet doctor --check`: a device that computes right passes, and each of three broken kernels is named.

use std::fs;

use brooklet_capture::Capture;
use brooklet_kernels::Module;
use brooklet_tests::program::Workshop;
use serde_json::Value;

/// SPIR-V opcodes (Unified Specification, 3.52).
const NOP: u32 = 0;
const F_SUB: u32 = 131;
const U_DIV: u32 = 134;
const U_LESS_THAN: u32 = 176;
const U_LESS_THAN_EQUAL: u32 = 178;
const SHIFT_RIGHT: u32 = 194;
const CONTROL_BARRIER: u32 = 224;

fn module(name: &str) -> &'static Module {
    brooklet_kernels::modules().find(|module| module.name == name).expect("a module")
}

/// The module with some of its instructions changed, at least one.
fn patched(module: &Module, mut change: impl FnMut(&mut [u32]) -> bool) -> Vec<u8> {
    let mut words: Vec<u32> =
        module.spirv.bytes().chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
    let (mut at, mut changed) = (5, 0);
    while at < words.len() {
        let end = at + (words[at] >> 16) as usize;
        changed += u32::from(change(&mut words[at..end]));
        at = end;
    }
    assert!(changed > 0, "{} has no such instruction", module.name);
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

/// What `doctor --check` says of a room with the SPIR-V of a variant replaced.
fn checked_with(name: &str, spirv: &[u8], room: &str) -> Value {
    let workshop = Workshop::new();
    fs::write(workshop.path("broken.spv"), spirv).unwrap();
    let replace = format!("{name}=broken.spv");
    let done = workshop.run(&["doctor", "--check", "--room", room, "--json", "--replace", &replace]);
    assert_eq!(done.code, Some(1), "{}", done.stderr);
    assert!(done.stderr.starts_with("error: ") && done.stderr.contains("computes wrong"), "{}", done.stderr);
    done.json()
}

/// The verdict says that the variant is wrong, and a case names it with what was got and expected.
fn is_named(report: &Value, name: &str) {
    let modules = report["modules"].as_array().unwrap();
    let verdict = &modules.iter().find(|module| module["module"] == name).unwrap()["verdict"];
    assert_eq!(verdict, "wrong", "{name}");
    let wrong = report["cases"].as_array().unwrap().iter().map(|case| &case["wrong"]);
    let named = |wrong: &&Value| wrong["modules"].as_array().is_some_and(|all| all.iter().any(|module| module == name));
    let of: Vec<&Value> = wrong.filter(named).collect();
    let told = |wrong: &&Value| !wrong["got"].as_str().unwrap().is_empty() && wrong["element"].is_number();
    assert!(of.iter().any(told), "{of:?}");
}

#[test]
fn a_wrong_sign_is_named() {
    // Every difference the other way round.
    let spirv = patched(module("Xsph"), |words| {
        let is_difference = words[0] & 0xffff == F_SUB;
        if is_difference {
            words.swap(3, 4);
        }
        is_difference
    });
    is_named(&checked_with("Xsph", &spirv, "velocity"), "Xsph");
}

#[test]
fn an_off_by_one_in_the_scan_is_named() {
    let mut quotients = Vec::new();
    // "Blocks before mine" takes mine as well: of a thread's number over a block's.
    let spirv = patched(module("ScanGroups"), |words| {
        if words[0] & 0xffff == SHIFT_RIGHT || words[0] & 0xffff == U_DIV {
            quotients.push(words[2]);
        }
        let is_before = words[0] & 0xffff == U_LESS_THAN && quotients.contains(&words[4]);
        if is_before {
            words[0] = words[0] & 0xffff_0000 | U_LESS_THAN_EQUAL;
        }
        is_before
    });
    is_named(&checked_with("ScanGroups", &spirv, "scan"), "ScanGroups");
}

#[test]
fn a_dropped_barrier_is_named() {
    let spirv = patched(module("ReduceGroups"), |words| {
        let is_barrier = words[0] & 0xffff == CONTROL_BARRIER;
        if is_barrier {
            words.fill(1 << 16 | NOP);
        }
        is_barrier
    });
    is_named(&checked_with("ReduceGroups", &spirv, "scan"), "ReduceGroups");
}

#[test]
fn a_device_that_computes_right_passes() {
    let report =
        Workshop::new().succeed(&["doctor", "--check", "--room", "velocity", "--room", "runs", "--json"]).json();
    assert_eq!(report["right"], true);
    let modules = report["modules"].as_array().unwrap();
    let verdict_of = |name: &str| &modules.iter().find(|module| module["module"] == name).unwrap()["verdict"];
    assert_eq!(verdict_of("Xsph"), "right");
    // What no case looked at is not taken for right.
    assert_eq!(verdict_of("ListNeighbours"), "not checked");
    let table = Workshop::new().succeed(&["doctor", "--check", "--room", "velocity"]).stdout;
    assert!(table.contains("Xsph") && table.contains("not checked"), "{table}");
}

#[test]
fn verdicts_are_captured() {
    let workshop = Workshop::new();
    workshop.succeed(&["doctor", "--check", "--room", "velocity", "--capture", "verdicts.mcap"]);
    let capture = Capture::open(&workshop.path("verdicts.mcap")).unwrap();
    let verdict_of = |name: &str| capture.checks.iter().find(|row| row.name == name).map(|row| &*row.verdict);
    assert_eq!(verdict_of("velocity: xsph matches its twin"), Some("right"));
    assert_eq!(verdict_of("Xsph"), Some("right"));
    assert_eq!(verdict_of("ListNeighbours"), Some("not checked"));
    let xsph = capture.checks.iter().find(|row| row.name == "Xsph").unwrap();
    assert!(xsph.compared > 0 && xsph.difference.unwrap() <= xsph.tolerance.unwrap());
    workshop.succeed(&["capture", "check", "verdicts.mcap"]);
}

#[test]
fn bad_input_is_told_and_nothing_runs() {
    let wrong = |words: &[&str], said: &str| {
        let done = Workshop::new().run(words);
        assert_eq!(done.code, Some(2), "{}", done.stderr);
        assert!(done.stderr.contains(said) && done.stdout.is_empty(), "{}", done.stderr);
    };
    wrong(&["doctor", "--check", "no-such-scene"], "no-such-scene");
    wrong(&["doctor", "--all"], "--check");
    wrong(&["doctor", "--check", "--room", "nowhere"], "allowed: anisotropic_mesh");
    wrong(&["doctor", "--check", "--device", "no such device"], "no such device");
    wrong(&["doctor", "--check", "--set", "solver.dt_s=-1"], "solver.dt_s");
    wrong(&["doctor", "--capture", "a.mcap"], "--check");
    wrong(&["doctor", "--check", "--capture", "no-such-folder/a.mcap"], "no-such-folder");
    wrong(&["doctor", "--check", "--replace", "Xsph"], "VARIANT=FILE");
    wrong(&["doctor", "--check", "--replace", "Nobody=a.spv"], "'Nobody'");
    wrong(&["doctor", "--check", "--replace", "Xsph=no-such.spv"], "no-such.spv");
    wrong(&["doctor", "--check", "--replace", "Xsph=scene.toml"], "no SPIR-V");
}
