//! The file that a phone's owner sends.

use std::time::Duration;

use brooklet_mobile::script::Hand;
use serde_json::Value;

use crate::{LONG, SMALL_PX, app, current, mark_checked, said};

/// What is wrong with a report, if anything.
fn wrong(report: &Value) -> Option<String> {
    let number = |value: &Value| value.as_f64().filter(|number| number.is_finite() && *number > 0.0);
    for (part, field) in [("device", "name"), ("device", "driver"), ("self_check", "of")] {
        if report[part][field].as_str().is_none_or(str::is_empty) {
            return Some(format!("{part} has no {field}"));
        }
    }
    if number(&report["device"]["limits"]["max_storage_buffer_binding_size"]).is_none() {
        return Some("no limits".into());
    }
    let scenes = report["scenes"].as_array()?;
    let names: Vec<&str> = scenes.iter().filter_map(|scene| scene["scene"].as_str()).collect();
    if names != ["phone-1k", "phone-5k"] {
        return Some(format!("scenes {names:?}"));
    }
    for scene in scenes {
        let median = |time: &str| number(&scene[time]["median"]);
        let (Some(step_ms), Some(gpu_ms), Some(wall_ms)) = (median("step_ms"), median("gpu_ms"), median("wall_ms"))
        else {
            return Some(format!("times are missing: {scene}"));
        };
        if !(step_ms < gpu_ms && gpu_ms < 1.1 * wall_ms) || number(&scene["frames"]).is_none_or(|frames| frames < 8.0) {
            return Some(format!("a step of {step_ms} ms, a frame of {gpu_ms} ms, and {wall_ms} ms for it"));
        }
        let passes = scene["passes"].as_object()?;
        let sum_ms: f64 = passes.values().filter_map(|pass| number(&pass["median_ms"])).sum();
        if sum_ms > 1.3 * gpu_ms || sum_ms < 0.5 * gpu_ms {
            return Some(format!("passes of {sum_ms} ms in a frame of {gpu_ms} ms"));
        }
        let of_solver_and_picture = ["constrain_density", "reorder", "gather_field", "draw_water"];
        if let Some(missing) = of_solver_and_picture.into_iter().find(|stage| !passes.contains_key(*stage)) {
            return Some(format!("no {missing}"));
        }
    }
    None
}

#[test]
fn a_report_has_the_device_the_self_check_and_times_by_pass() {
    let folder = tempfile::tempdir().unwrap();
    mark_checked(folder.path());
    let mut app = app(folder.path()).with_report_time(Duration::from_secs(1));
    app.resume_offscreen(SMALL_PX, 0.5);
    let mut hand = Hand::new(app, 0.5);
    assert!(hand.until(LONG, |hand| current(hand).is_some()), "{:?}", said(&hand));
    hand.tap("menu").unwrap();
    hand.tap("report").unwrap();
    assert!(hand.marks.contains_key("reporting") && !hand.marks.contains_key("plainer"), "{:?}", hand.marks.keys());
    assert!(hand.app.viewer().unwrap().is_paused(), "the GPU is the report's");
    let path = folder.path().join("files/report.json");
    assert!(hand.until(LONG, |_| path.exists()), "{:?}", said(&hand));
    hand.settle();
    assert!(said(&hand).iter().any(|text| text.contains("report.json")), "{:?}", said(&hand));
    assert!(!hand.app.viewer().unwrap().is_paused() && hand.steps(1, LONG), "the water goes on");

    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.len() < 64 << 10, "{} bytes", text.len());
    let report: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(wrong(&report), None, "{text}");
    assert_eq!(report["self_check"]["wrong"], Value::Array(Vec::new()));
    // One with a part taken out is told apart.
    for part in ["/self_check/of", "/device/limits", "/scenes/1/step_ms", "/scenes/0/passes/reorder", "/scenes/0"] {
        let mut other = report.clone();
        let (parent, name) = part.rsplit_once('/').unwrap();
        match other.pointer_mut(parent).unwrap() {
            Value::Object(fields) => drop(fields.remove(name).unwrap()),
            Value::Array(items) => drop(items.remove(name.parse().unwrap())),
            _ => unreachable!("{part}"),
        }
        assert!(wrong(&other).is_some(), "{part}");
    }
}
