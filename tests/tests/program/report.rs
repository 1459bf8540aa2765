//! `brooklet report`: what is done is on the page whatever ends it, and two reports are compared.
#![cfg(unix)]

use std::{fs, process::Command, process::Stdio, thread, time::Duration, time::Instant};

use brooklet_tests::program::Workshop;
use serde_json::{Value, json};

/// All but the device.
const SKIP_SLOW: &str = "check,runs,scaling,pictures,sorting,submissions,errors,extremes";

fn part<'a>(report: &'a Value, name: &str) -> &'a Value {
    report["parts"].as_array().unwrap().iter().find(|part| part["name"] == name).unwrap()
}

fn assert_whole_page(workshop: &Workshop, path: &str) -> String {
    let page = fs::read_to_string(workshop.path(path)).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>"));
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http"), "the page needs another file");
    page
}

#[test]
fn parts_that_are_left_out_say_so_and_a_folder_is_never_overwritten() {
    let workshop = Workshop::new();
    for folder in ["r", "r-1"] {
        let done = workshop.run(&["report", "--minutes", "0.5", "--skip", SKIP_SLOW, "--out", "r"]);
        assert_eq!(done.code, Some(0), "{}", done.stderr);
        assert!(done.stdout.contains(&format!("{folder}/index.html")), "{}", done.stdout);
        let report = workshop.json(&format!("{folder}/report.json"));
        assert_eq!(part(&report, "device")["state"], "done");
        assert_eq!(part(&report, "scaling")["state"], "left-out");
        assert!(part(&report, "device")["figures"]["doctor"][0]["limits"].is_object());
        let page = assert_whole_page(&workshop, &format!("{folder}/index.html"));
        assert!(page.contains("left out") && page.contains(report["device"].as_str().unwrap()));
    }
}

#[test]
fn a_killed_report_keeps_what_it_has_and_what_it_was_doing() {
    let workshop = Workshop::new();
    // Ways to sort take the longest of what is left, and nothing before them is skipped without need.
    let skip = "check,runs,scaling,pictures,submissions,errors";
    let mut child = workshop
        .command(["report", "--minutes", "1", "--skip", skip, "--out", "r"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begun = Instant::now();
    let is_sorting = || {
        let text = fs::read_to_string(workshop.path("r/report.json")).unwrap_or_default();
        let report: Value = serde_json::from_str(&text).unwrap_or_default();
        report["parts"].is_array() && part(&report, "sorting")["state"] == "under-way"
    };
    while !is_sorting() {
        assert!(begun.elapsed() < Duration::from_secs(60), "it never came to sorting");
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        thread::sleep(Duration::from_millis(20));
    }
    let kill = Command::new("kill").args(["-KILL", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    child.wait().unwrap();
    let page = assert_whole_page(&workshop, "r/index.html");
    assert!(page.contains("under way when this was written") && page.contains("not begun"));
    assert_eq!(part(&workshop.json("r/report.json"), "device")["state"], "done");
}

#[test]
fn ways_to_submit_are_compared_round_by_round() {
    let workshop = Workshop::new();
    let done = workshop.run(&["bench", "submissions", "scene.toml", "--rounds", "2", "--json"]);
    assert_eq!(done.code, Some(0), "{}", done.stderr);
    let found: Value = serde_json::from_str(&done.stdout).unwrap();
    let ways = found["ways"].as_array().unwrap();
    let batches: Vec<u64> = ways.iter().map(|way| way["steps_a_submission"].as_u64().unwrap()).collect();
    assert_eq!(batches, [1, 1, 4, 4, 16, 16]);
    assert_eq!(ways[0]["ratio"], json!([1.0, 1.0, 1.0]));
    assert!(ways.iter().all(|way| way["wall_ms"].as_f64().unwrap() > 0.0));
}

#[test]
fn what_cannot_be_reported_or_compared_is_refused() {
    let workshop = Workshop::new();
    let report = |name: &str, text: &str| {
        fs::create_dir_all(workshop.path(name)).unwrap();
        fs::write(workshop.path(&format!("{name}/report.json")), text).unwrap();
    };
    let row = json!({ "particles": 4096, "terms": "t", "iterations": 4, "particle_iterations_per_s": 2e6 });
    let part = json!({ "name": "scaling", "figures": { "scaling": { "rows": [row] } } });
    report("a", &json!({ "format": 1, "parts": [part] }).to_string());
    report("old", &json!({ "format": 0 }).to_string());
    report("none", "{}");
    report("torn", "{\"format\"");
    fs::write(workshop.path("file"), "").unwrap();
    for (arguments, words) in [
        (&["report", "--minutes", "0.1"][..], &["--minutes", "0.5 to 1440"][..]),
        (&["report", "--minutes", "long"], &["--minutes", "number"]),
        (&["report", "--skip", "lunch"], &["lunch", "sorting", "extremes"]),
        (&["report", "--skip", SKIP_SLOW, "--out", "file/r"], &["--out file", "cannot create"]),
        (&["report", "compare", "a", "old"], &["old/report.json", "format 0", "reads 1"]),
        (&["report", "compare", "a", "none"], &["none/report.json", "no report"]),
        (&["report", "compare", "torn", "a"], &["torn/report.json", "no report"]),
        (&["report", "compare", "a", "gone"], &["gone/report.json", "cannot be read"]),
        (&["report", "compare", "a", "a", "--fail-if-slower", "soon"], &["--fail-if-slower", "soon"]),
    ] {
        let refused = workshop.run(arguments);
        assert_eq!(refused.code, Some(2), "{arguments:?}: {}", refused.stderr);
        for word in words {
            assert!(refused.stderr.contains(word), "{arguments:?}: no {word:?} in {}", refused.stderr);
        }
    }
    let compared = workshop.run(&["report", "compare", "a", "a", "--json"]);
    assert_eq!(compared.code, Some(0), "{}", compared.stderr);
    let both: Value = serde_json::from_str(&compared.stdout).unwrap();
    assert_eq!((&both["sizes"][0]["ratio"], &both["passes"]), (&json!(1.0), &Value::Null));
}
