//! `brooklet report compare`: two devices, or two versions on one.

use std::{fs, path::Path};

use brooklet_capture::{Comparison, Times};
use serde::Serialize;
use serde_json::{Value, json};

use super::FIGURES;
use crate::{
    capture::{CaptureCompare, compare_captures, judge},
    failure::Failure,
    report_options::CompareOptions,
    table::table,
};

/// The form of `report.json`; another one cannot be compared.
pub const FORMAT: u32 = 1;

/// One size of the scaling table in both reports.
#[derive(Clone, Debug, Serialize)]
struct Size {
    particles: u64,
    terms: String,
    iterations: u64,
    /// Particle iterations a second.
    a_per_s: f64,
    b_per_s: f64,
    /// B's over A's.
    ratio: f64,
}

/// Prints how B compares with A: rates by size, then the passes of both runs' captures with their intervals.
pub fn compare(options: &CompareOptions) -> Result<(), Failure> {
    let (a, b) = (read(&options.a)?, read(&options.b)?);
    let sizes = sizes(&a, &b);
    let captures = [&options.a, &options.b].map(|folder| folder.join("run").join("capture.mcap"));
    let missing = captures.iter().find(|path| !path.is_file());
    let missing = missing.map(|path| format!("{}: is not there, so that passes cannot be compared", path.display()));
    // A verdict is wanted of passes, and there are none.
    if let (true, Some(missing)) = (sizes.is_empty() || options.fail_if_slower.is_some(), &missing) {
        return Err(Failure::Input(missing.clone()));
    }
    if options.json {
        let passes = match &missing {
            None => {
                let [a, b] = captures.map(|path| Times::read(&path).map_err(Failure::input));
                Some(Comparison::of(&a?, &b?))
            }
            Some(_) => None,
        };
        let of = |report: &Value| json!({ "device": report["device"], "driver": report["driver"], "tier": report["tier"], "commit": report["commit"] });
        let both = json!({ "a": of(&a), "b": of(&b), "sizes": sizes, "passes": passes });
        say!("{}", serde_json::to_string_pretty(&both).map_err(Failure::stopped)?);
        let judged = passes.as_ref().zip(options.fail_if_slower);
        return judged.map_or(Ok(()), |(passes, share)| judge(passes, share));
    }
    for (which, report) in [("A", &a), ("B", &b)] {
        let text = |name: &str| report[name].as_str().unwrap_or("-").to_string();
        say!("{which}: {} ({}), {}, commit {}", text("device"), text("driver"), text("tier"), text("commit"));
    }
    print(&sizes);
    if let Some(missing) = missing {
        say!("{missing}");
        return Ok(());
    }
    let ([a, b], fail_if_slower) = (captures, options.fail_if_slower);
    compare_captures(&CaptureCompare { a, b, plot: None, fail_if_slower, anyway: false, json: false })
}

fn read(folder: &Path) -> Result<Value, Failure> {
    let path = folder.join(FIGURES);
    let wrong = |why: String| Failure::Input(format!("{}: {why}", path.display()));
    let bytes = fs::read(&path).map_err(|error| wrong(format!("cannot be read: {error}; name a report's folder")))?;
    let report: Value = serde_json::from_slice(&bytes).map_err(|error| wrong(format!("is no report: {error}")))?;
    match report["format"].as_u64() {
        Some(format) if format == u64::from(FORMAT) => Ok(report),
        Some(format) => Err(wrong(format!("has format {format}, and this version reads {FORMAT}"))),
        None => Err(wrong("is no report: it has no format".into())),
    }
}

fn rows(report: &Value) -> &[Value] {
    let parts = report["parts"].as_array().map_or(&[][..], Vec::as_slice);
    let table = parts.iter().find(|part| part["name"] == "scaling").map(|part| &part["figures"]["scaling"]["rows"]);
    table.and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn sizes(a: &Value, b: &Value) -> Vec<Size> {
    let same = |a: &Value, b: &Value| ["particles", "terms", "iterations"].iter().all(|name| a[name] == b[name]);
    let size = |a: &Value| {
        let b = rows(b).iter().find(|b| same(a, b))?;
        let rate = |row: &Value| row["particle_iterations_per_s"].as_f64();
        let (a_per_s, b_per_s) = (rate(a)?, rate(b)?);
        Some(Size {
            particles: a["particles"].as_u64()?,
            terms: a["terms"].as_str()?.to_string(),
            iterations: a["iterations"].as_u64()?,
            a_per_s,
            b_per_s,
            ratio: b_per_s / a_per_s,
        })
    };
    rows(a).iter().filter_map(size).collect()
}

fn print(sizes: &[Size]) {
    let mut list = table(&["particles", "terms", "iterations", "A M/s", "B M/s", "B to A"], &[0, 2, 3, 4, 5]);
    for size in sizes {
        list.add_row([
            size.particles.to_string(),
            size.terms.clone(),
            size.iterations.to_string(),
            format!("{:.2}", size.a_per_s * 1e-6),
            format!("{:.2}", size.b_per_s * 1e-6),
            format!("{:.2}", size.ratio),
        ]);
    }
    say!("\n{}\n", list.trim_fmt());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(rate: f64, particles: u32) -> Value {
        let row = json!({ "particles": particles, "terms": "default terms", "iterations": 4, "particle_iterations_per_s": rate });
        json!({ "format": FORMAT, "parts": [{ "name": "scaling", "figures": { "scaling": { "rows": [row] } } }] })
    }

    #[test]
    fn sizes_of_both_are_compared_and_no_others() {
        let found = sizes(&report(2e6, 4096), &report(3e6, 4096));
        assert_eq!((found.len(), found[0].particles, found[0].ratio), (1, 4096, 1.5));
        assert!(sizes(&report(2e6, 4096), &report(3e6, 27_000)).is_empty());
        assert!(sizes(&json!({}), &report(3e6, 27_000)).is_empty());
    }
}
