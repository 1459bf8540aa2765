//! SPlisHSPlasH on the workload of the peers, in a Python of its own.

use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// The Python with pySPlisHSPlasH 2.19.0 that BROOKLET_PEERS_PYTHON names; without one that is said.
pub fn python() -> Option<OsString> {
    let python = std::env::var_os("BROOKLET_PEERS_PYTHON");
    if python.is_none() {
        println!("SKIPPED: BROOKLET_PEERS_PYTHON does not name a Python with pySPlisHSPlasH 2.19.0");
    }
    python
}

/// One of its solvers.
#[derive(Clone, Copy)]
pub enum Solver {
    /// WCSPH with fixed steps and this speed of sound, m/s.
    Wcsph(f64),
    /// DFSPH to this density tolerance, steps by its CFL condition.
    Dfsph(f64),
}

/// What a run told.
pub struct Told {
    /// How many particles there are.
    pub particles: u64,
    /// Wall time of each step but the first, s.
    pub step_s: Vec<f64>,
    /// Its own densities at the end over that at rest: their mean and the largest.
    pub density: [f64; 2],
}

/// Runs it at a spacing, with steps of at most `dt_s`, until `end_s`.
///
/// # Errors
/// If it does not start, or tells nothing.
pub fn run(python: &OsString, solver: Solver, spacing_m: f64, dt_s: f64, end_s: f64) -> Result<Told, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let (name, number) = match solver {
        Solver::Wcsph(sound_m_s) => ("wcsph", sound_m_s),
        Solver::Dfsph(tolerance) => ("dfsph", tolerance),
    };
    let ended = Command::new(python)
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("step_splishsplash.py"))
        .arg(folder.path())
        .arg(name)
        .args([spacing_m, dt_s, end_s, number].map(|x| format!("{x:?}")))
        // Threads that spin while they wait lose whole time slices where others work: 188 ms a step instead of 51.
        .env("OMP_WAIT_POLICY", "passive")
        .output()
        .map_err(|error| format!("cannot start {}: {error}", python.display()))?;
    let told = std::fs::read(folder.path().join("told.json"))
        .map_err(|_| format!("{} told nothing: {}", python.display(), String::from_utf8_lossy(&ended.stderr)))?;
    let told: Value = serde_json::from_slice(&told).map_err(|error| error.to_string())?;
    let numbers =
        |key: &str| -> Vec<f64> { told[key].as_array().into_iter().flatten().filter_map(Value::as_f64).collect() };
    let [mean, largest] = numbers("density")[..] else { return Err("it told no densities".into()) };
    Ok(Told {
        particles: told["particles"].as_u64().unwrap_or(0),
        step_s: numbers("step_s"),
        density: [mean, largest].map(|density| density / 1000.0),
    })
}
