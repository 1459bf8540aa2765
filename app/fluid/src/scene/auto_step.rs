//! `dt_s = "auto"`: the default step, cut into as many substeps as the solver's limits need.

use toml::{Table, Value};

use super::explain::{place_of, shortened, written};
use super::fields::kind_of;
use super::paths::{take, value_at};
use super::{Method, SceneError, methods};

/// The field that takes a time in s, or [`AUTO`].
pub(super) const DT: &str = "solver.dt_s";
const AUTO: &str = "auto";
const ADAPTIVE: &str = "solver.sph.adaptive_substeps";
/// The methods that choose substeps: SPH on the GPU, each anew, DFSPH by its depth when a scene is read.
const CHOOSE: [Method; 2] = [Method::Sph, Method::Dfsph];

/// Takes the step out of a table that leaves it to the solver, so that it has its default. Returns whether it did.
pub(super) fn settle(table: &mut Table, text: &str, source_name: &str) -> Result<bool, SceneError> {
    let Some(Value::String(word)) = value_at(table, DT) else { return Ok(false) };
    let refused = |allowed: String| SceneError::NotAllowed {
        source_name: source_name.into(),
        place: place_of(text, DT),
        field: DT.into(),
        value: shortened(&written(&Value::String(word.clone()))),
        allowed,
    };
    let number = kind_of(DT).map_or_else(String::new, |kind| kind.to_string());
    if word != AUTO {
        return Err(refused(format!("{number}, or {AUTO:?}")));
    }
    let method = methods::chosen(table);
    if !CHOOSE.iter().any(|chooses| chooses.name() == method) && Method::NAMES.contains(&method) {
        let names = CHOOSE.map(Method::name).join(" and ");
        return Err(refused(format!("{number} with solver.method = {method:?}; {names} choose their substeps")));
    }
    if value_at(table, ADAPTIVE).and_then(Value::as_bool) == Some(false) {
        return Err(refused(format!("not with {ADAPTIVE} = false")));
    }
    take(table, DT);
    Ok(true)
}

/// Adds the word to the schema of a number, whose limits are for numbers alone.
#[cfg(feature = "schema")]
pub(super) fn describe(step: &mut serde_json::Value) {
    step["type"] = serde_json::json!(["number", "string"]);
    step["pattern"] = format!("^{AUTO}$").into();
    step["description"] =
        "Time a step advances, s. \"auto\": the default, cut into as many substeps as the limits of SPH need \
        (on the GPU, each anew) or DFSPH's (by its depth, when the scene is read)."
            .into();
}

#[cfg(test)]
mod tests {
    use crate::Scene;

    fn read(solver: &str, settings: &[&str]) -> Result<Scene, String> {
        let text =
            format!("spacing_m = 0.1\ndomain = {{ min_m = [0, 0, 0], max_m = [1, 1, 1] }}\n[solver]\n{solver}\n");
        let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
        Scene::from_toml(&text, "auto.toml", &settings).map_err(|error| error.to_string())
    }

    #[test]
    fn an_automatic_step_is_the_default_one_of_solvers_that_choose_substeps() {
        for method in ["sph", "dfsph"] {
            let chosen = read(&format!("method = \"{method}\"\ndt_s = \"auto\""), &[]).unwrap();
            assert_eq!(chosen, read(&format!("method = \"{method}\""), &[]).unwrap(), "{method}");
            assert_eq!(chosen, read(&format!("method = \"{method}\"\ndt_s = 0.1"), &["solver.dt_s=auto"]).unwrap());
        }
        assert!(read("method = \"sph\"\ndt_s = \"auto\"", &[]).unwrap().adapts_substeps());
    }

    #[test]
    fn what_is_no_step_is_refused() {
        for (solver, words) in [
            ("dt_s = \"auto\"", "auto.toml:4:1: solver.dt_s = \"auto\": must be "),
            ("dt_s = \"auto\"", "with solver.method = \"pbf\"; sph and dfsph choose their substeps"),
            ("method = \"sph\"\ndt_s = \"quick\"", "auto.toml:5:1: solver.dt_s = \"quick\": must be "),
            ("method = \"sph\"\ndt_s = \"quick\"", "1000 s, or \"auto\""),
            ("method = \"sph\"\ndt_s = \"auto\"\nsph = { adaptive_substeps = false }", "not with solver.sph.adaptive"),
            // A method that is not there is the mistake that is told.
            ("method = \"shp\"\ndt_s = \"auto\"", "solver.method = \"shp\""),
            ("method = \"sph\"\ndt_s = \"auto\"\nsubsteps = 0", "solver.substeps = 0"),
        ] {
            let error = read(solver, &[]).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }
}
