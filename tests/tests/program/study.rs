//! `brooklet study` and `brooklet tune`: reports are whole, killed studies go on, parts join, and what is
//! wrong is answered in one line.

use std::{
    fs,
    process::Stdio,
    thread,
    time::{Duration, Instant},
};

use brooklet_tests::program::{Ended, Workshop};
use serde_json::Value;

/// Two runs of a second each.
const SMALL: [&str; 6] = ["study", "error", "--scenes", "elliptical-drop", "--knobs", "precision"];

fn lines(workshop: &Workshop, path: &str) -> usize {
    fs::read_to_string(workshop.path(path)).map_or(0, |text| text.lines().count())
}

fn with<'a>(arguments: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    [arguments, more].concat()
}

#[test]
fn a_report_is_whole_and_is_kept() {
    let workshop = Workshop::new();
    let arguments = with(&SMALL, &["--quick", "--out", "s"]);
    let first = workshop.run(&arguments);
    assert_eq!(first.code, Some(0), "{}", first.stderr);
    let page = fs::read_to_string(workshop.path("s/report.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("elliptical-drop") && page.ends_with("</html>"));
    assert!(!page.contains("http://") || page.matches("http://").count() == page.matches("http://www.w3.org").count());
    let all: Value = workshop.json("s/results.json");
    assert_eq!((all["runs"].as_array().unwrap().len(), all["missing"].as_u64()), (2, Some(0)));
    for run in all["runs"].as_array().unwrap() {
        assert!(run["outcome"]["cost"]["median_s_per_s"].as_f64().unwrap() > 0.0, "{run}");
        assert!(run["outcome"]["figures"][0]["value"].as_f64().unwrap() > 0.0, "{run}");
    }
    let mut table = fs::read_to_string(workshop.path("s/results.csv")).unwrap();
    assert!(table.lines().count() > 10 && table.contains("axis error"));
    let solvers = fs::read_to_string(workshop.path("s/solvers.md")).unwrap();
    assert!(solvers.contains("| elliptical-drop | ") && solvers.contains("| pbf | precision "), "{solvers}");
    let runs = fs::read(workshop.path("s/runs.mcap")).unwrap();
    let messages: Vec<_> = mcap::MessageStream::new(&runs).unwrap().map(|message| message.unwrap()).collect();
    let of = |topic: &str| messages.iter().filter(|message| message.channel.topic == topic).count();
    assert!(of("/study/run") == 2 && of("/study/step") > 100, "{} messages", messages.len());

    let again = workshop.run(&arguments);
    assert_eq!(again.code, Some(0), "{}", again.stderr);
    assert!(workshop.path("s-1/report.html").is_file());
    table = fs::read_to_string(workshop.path("s/results.csv")).unwrap();
    assert!(table.contains("axis error"), "the first report is kept");
}

#[test]
fn what_precision_costs_is_a_table_for_a_page() {
    let workshop = Workshop::new();
    let ended = workshop.run(&["study", "precision", "--quick", "--out", "s"]);
    assert_eq!(ended.code, Some(0), "{}", ended.stderr);
    let table = fs::read_to_string(workshop.path("s/precision.md")).unwrap();
    let row = table.lines().find(|line| line.starts_with("| dam-break |")).expect("a row");
    assert_eq!(row.matches(" / ").count(), 7 * 3, "{row}");
    // Nothing stands apart, and something was compared.
    assert!(!row.contains("**") && !row.contains("0 / 0 / 0 / 0"), "{row}");
    assert!(fs::read_to_string(workshop.path("s/report.html")).unwrap().contains("id=\"precision\""));
}

#[cfg(unix)]
#[test]
fn a_study_that_was_ended_goes_on() {
    let workshop = Workshop::new();
    let arguments = ["study", "error", "--scenes", "elliptical-drop", "--knobs", "iterations", "--out", "s"];
    for signal in ["-INT", "-KILL"] {
        let done = lines(&workshop, "s/results.jsonl");
        let mut child =
            workshop.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        let waiting = Instant::now();
        while lines(&workshop, "s/results.jsonl") <= done {
            assert!(waiting.elapsed() < Duration::from_secs(120), "no run in two minutes");
            assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
            thread::sleep(Duration::from_millis(20));
        }
        let kill = std::process::Command::new("kill").args([signal, &child.id().to_string()]).status();
        assert!(kill.expect("kill is there").success());
        let ended = Ended::new(child.wait_with_output().unwrap());
        if signal == "-INT" {
            assert_eq!(ended.code, Some(130), "{}", ended.stderr);
            assert!(ended.stderr.contains("the same command goes on"), "{}", ended.stderr);
        }
        assert!(!workshop.path("s/report.html").exists());
    }
    // As a kill in the middle of a write would leave it.
    let kept = lines(&workshop, "s/results.jsonl");
    let mut text = fs::read(workshop.path("s/results.jsonl")).unwrap();
    text.extend_from_slice(b"{\"program\": \"0");
    fs::write(workshop.path("s/results.jsonl"), text).unwrap();
    let last = workshop.run(&arguments);
    assert_eq!(last.code, Some(0), "{}", last.stderr);
    assert!(last.stdout.contains(&format!("going on in s: {kept} of 5 runs are done")), "{}", last.stdout);
    assert_eq!(lines(&workshop, "s/results.jsonl"), 5);
    assert_eq!(workshop.json("s/results.json")["missing"], 0);
}

#[test]
fn parts_of_several_machines_are_joined() {
    let workshop = Workshop::new();
    for shard in ["1/2", "2/2"] {
        let out = format!("part-{}", &shard[..1]);
        let part = workshop.run(&with(&SMALL, &["--quick", "--shard", shard, "--out", &out]));
        assert_eq!(part.code, Some(0), "{}", part.stderr);
        assert!(!workshop.path(&out).join("report.html").exists());
    }
    let merge = ["study", "merge", "--part", "error", "--scenes", "elliptical-drop", "--knobs", "precision", "--quick"];
    let whole = workshop.run(&with(&merge, &["part-1", "part-2", "--out", "all"]));
    assert_eq!(whole.code, Some(0), "{}", whole.stderr);
    assert_eq!(workshop.json("all/results.json")["runs"].as_array().unwrap().len(), 2);
    let half = workshop.run(&with(&merge, &["part-1", "--out", "half"]));
    assert!(half.stdout.contains("1 of 2 runs are in none of the parts"), "{}", half.stdout);
    assert_eq!(workshop.json("half/results.json")["missing"], 1);
    let none = workshop.run(&with(&merge, &["nowhere", "--out", "none"]));
    assert_eq!(none.code, Some(2), "{}", none.stderr);
    assert!(none.stderr.contains("nowhere: is no folder of a study"), "{}", none.stderr);
    assert!(!workshop.path("none").exists());
}

#[test]
fn what_is_wrong_with_a_study_is_said() {
    let workshop = Workshop::new();
    fs::create_dir(workshop.path("foreign")).unwrap();
    fs::write(workshop.path("foreign/results.jsonl"), "{\"a\": 1}\n").unwrap();
    let wrong: [(&[&str], &str); 8] = [
        (&["error", "--scenes", "nothing"], "--scenes nothing: there is none of that name; there are"),
        (&["error", "--methods", "mpm"], "--methods mpm: there is none of that name; there are pbf"),
        (&["error", "--knobs", "colour"], "--knobs colour: there is none of that name; there are spacing, substeps"),
        (&["validation", "--scenes", "elliptical-drop"], "choose curves of error against time"),
        (&["error", "--shard", "3/2"], "must be I/N with I from 1 to N"),
        (&["everything"], "invalid value 'everything'"),
        (&["error", "--quick", "--out", "scene.toml"], "is a file; name a folder"),
        (&["error", "--quick", "--out", "foreign"], "holds no outcomes of a study: line 1"),
    ];
    for (arguments, message) in wrong {
        let ended = workshop.run(&with(&["study"], arguments));
        assert_eq!(ended.code, Some(2), "{arguments:?}: {}", ended.stderr);
        assert!(ended.stderr.contains(message), "{arguments:?}: {}", ended.stderr);
        assert!(!workshop.path("out").exists(), "{arguments:?} left a folder");
    }
}

#[test]
fn a_tuned_scene_is_written_and_runs() {
    let workshop = Workshop::new();
    let arguments = ["tune", "scene.toml", "--max-error", "0.05", "--seconds", "0.2", "--json"];
    let first = workshop.run(&arguments);
    assert_eq!(first.code, Some(0), "{}", first.stderr);
    let found: Value = serde_json::from_str(&first.stdout).unwrap();
    assert_eq!(found["meets"], true);
    assert!(found["chosen"]["error"].as_f64().unwrap() <= 0.05);
    // The same particles in the same order of arithmetic, but for atomics' order within a cell.
    let (chosen, checked) = (found["chosen"]["error"].as_f64().unwrap(), found["checked"]["error"].as_f64().unwrap());
    assert!((chosen - checked).abs() < 0.02, "{chosen} {checked}");
    assert_eq!(found["chosen"]["solver"], "pbf");
    let over = &found["passed_over"][0];
    assert!(over["solver"] == "sph" && over["times_of_pbf"].as_f64().unwrap() > 3.0, "{found}");
    let plan = workshop.run(&["plan", "scene-tuned.toml", "--json"]);
    assert_eq!(plan.code, Some(0), "{}", plan.stderr);
    let again = workshop.run(&arguments);
    assert_eq!(again.code, Some(2));
    assert!(again.stderr.contains("scene-tuned.toml exists and is kept"), "{}", again.stderr);
    let other = workshop.run(&with(&arguments, &["--out", "other.toml"]));
    assert_eq!(other.code, Some(0), "{}", other.stderr);
    assert!(workshop.path("other.toml").is_file());
}

#[test]
fn a_goal_that_cannot_be_met_is_no_success_and_bad_input_is_said() {
    let workshop = Workshop::new();
    let hard = workshop.run(&["tune", "scene.toml", "--budget-ms", "1e-6", "--seconds", "0.05"]);
    assert_eq!(hard.code, Some(1), "{}", hard.stderr);
    assert!(hard.stderr.contains("cannot be met") && hard.stdout.contains("checked"), "{}", hard.stderr);
    fs::write(workshop.path("dry.toml"), brooklet_tests::program::without_fluid()).unwrap();
    let wrong: [(&[&str], &str); 6] = [
        (
            &["scene.toml", "--max-error", "1", "--methods", "mpm", "--out", "x.toml"],
            "--methods mpm: what moves scene may be pbf, sph, dfsph",
        ),
        (&["scene.toml"], "--budget-ms"),
        (&["scene.toml", "--budget-ms", "1", "--max-error", "1"], "cannot be used with"),
        (&["scene.toml", "--budget-ms", "-1"], "must be a positive number"),
        (&["dry.toml", "--max-error", "0.1"], "has no particles to tune for"),
        (&["nothing", "--max-error", "0.1"], "neither a file nor a shipped scene"),
    ];
    for (arguments, message) in wrong {
        let ended = workshop.run(&with(&["tune"], arguments));
        assert_eq!(ended.code, Some(2), "{arguments:?}: {}", ended.stderr);
        assert!(ended.stderr.contains(message), "{arguments:?}: {}", ended.stderr);
    }
}
