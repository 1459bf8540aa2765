//! Keys that had another place in scenes of earlier versions.

use toml::{Table, Value};

use super::explain::{place_of, shortened, written};
use super::paths::{put, take, value_at};
use super::{Precision, Scene, SceneError};

/// Old path and new path of each.
const MOVED: &[(&str, &str)] = &[
    ("solver.iterations", "solver.pbf.iterations"),
    ("solver.relaxation", "solver.pbf.relaxation"),
    ("solver.cfm", "solver.pbf.cfm"),
    ("solver.s_corr_k", "solver.pbf.s_corr_k"),
    ("solver.s_corr_distance_ratio", "solver.pbf.s_corr_distance_ratio"),
    ("solver.xsph", "forces.xsph"),
    ("solver.vorticity_m_s", "forces.vorticity_m_s"),
];

/// A key whose value `solver.precision` settles now.
const PACKED: &str = "solver.packed_positions";
const PRECISION: &str = "solver.precision";
const ACCELERATION: &str = "solver.pbf.acceleration";

/// Where the key at `path` is now, if it has moved.
pub(super) fn new_place(path: &str) -> Option<&'static str> {
    MOVED.iter().find(|(old, _)| *old == path).map(|(_, new)| *new)
}

/// Refuses old places, naming each and its new one.
pub(super) fn refuse(table: &Table, text: &str, source_name: &str) -> Result<(), SceneError> {
    let found: Vec<(&str, String)> = MOVED
        .iter()
        .filter_map(|(old, new)| {
            let value = shortened(&written(value_at(table, old)?));
            Some((*old, format!("{old} = {value} is now {new}")))
        })
        .collect();
    let Some((first, _)) = found.first() else { return Ok(()) };
    let moves: Vec<&str> = found.iter().map(|(_, words)| words.as_str()).collect();
    Err(SceneError::Moved { source_name: source_name.into(), place: place_of(text, first), moves: moves.join(", ") })
}

/// The precision that a table sets; none if it is no precision.
fn precision_of(table: &Table) -> Option<Precision> {
    value_at(table, PRECISION).map_or(Some(Precision::default()), |value| value.clone().try_into().ok())
}

/// Takes [`PACKED`] out of a table where it says what the precision does, and refuses it where it says another thing:
/// that combination is gone. Returns whether the table had it.
pub(super) fn settle_packing(table: &mut Table, text: &str, source_name: &str) -> Result<bool, SceneError> {
    let Some(packed) = value_at(table, PACKED).and_then(Value::as_bool) else { return Ok(false) };
    let Some(precision) = precision_of(table).filter(|precision| precision.packs_positions() != packed) else {
        take(table, PACKED);
        return Ok(true);
    };
    let packing = match packed {
        true => "does not pack positions; \"relaxed\" and \"half\" do",
        false => "packs positions; \"full\" does not",
    };
    Err(SceneError::NotAllowed {
        source_name: source_name.into(),
        place: place_of(text, PACKED),
        field: PACKED.into(),
        value: packed.to_string(),
        allowed: format!("{PRECISION} = {:?} {packing}; leave {PACKED} out", precision.name()),
    })
}

impl Scene {
    /// Reads what [`Scene::to_toml`] wrote into a saved state; `flat` says that it was before keys moved. A combination
    /// of precision and packed positions that is gone becomes the nearest there is, so that no state is lost, and one from
    /// before there were accelerations goes on without.
    pub(crate) fn from_saved_toml(text: &str, source_name: &str, flat: bool) -> Result<Scene, SceneError> {
        let migrated = toml::from_str::<Table>(text).map(|mut table| {
            for (old, new) in MOVED.iter().filter(|_| flat) {
                if let Some(value) = take(&mut table, old) {
                    put(&mut table, new, value);
                }
            }
            // What was saved before there were accelerations had none.
            if value_at(&table, "solver.pbf").is_some() && value_at(&table, ACCELERATION).is_none() {
                put(&mut table, ACCELERATION, Value::String("none".into()));
            }
            let packed = take(&mut table, PACKED).and_then(|value| value.as_bool());
            if packed == Some(true) && precision_of(&table) == Some(Precision::Full) {
                put(&mut table, PRECISION, Precision::Relaxed.name().into());
            }
            table.to_string()
        });
        // What is no TOML is refused as any other text.
        Self::from_toml(migrated.as_deref().unwrap_or(text), source_name, &[])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fields::kind_of;

    #[test]
    fn old_places_are_gone_and_new_ones_are_there() {
        for (old, new) in MOVED {
            assert!(kind_of(old).is_none(), "{old} is still a key");
            assert!(kind_of(new).is_some(), "{new} is no key");
        }
    }

    #[test]
    fn each_old_key_is_named_with_its_new_place() {
        let head = "spacing_m = 0.1\ndomain = { min_m = [0, 0, 0], max_m = [1, 1, 1] }\n";
        let read = |text: &str, settings: &[&str]| {
            let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
            Scene::from_toml(text, "old.toml", &settings).map_err(|error| error.to_string())
        };
        for (old, new) in MOVED {
            let key = old.rsplit('.').next().unwrap();
            let message = read(&format!("{head}[solver]\n{key} = 0.5\n"), &[]).unwrap_err();
            assert_eq!(message, format!("scene old.toml:4:1: {old} = 0.5 is now {new}"));
            let setting = format!("{old}=0.5");
            let message = read(head, &[&setting]).unwrap_err();
            assert_eq!(message, format!("--set {setting}: the key is now {new}"));
        }
        let several = format!("{head}[solver]\ndt_s = 0.01\niterations = 4\nxsph = 0\n");
        assert_eq!(
            read(&several, &[]).unwrap_err(),
            "scene old.toml:5:1: solver.iterations = 4 is now solver.pbf.iterations, solver.xsph = 0 is now forces.xsph"
        );
        assert!(read(head, &["solver={ cfm = 1 }"]).unwrap_err().contains("solver.cfm = 1 is now solver.pbf.cfm"));
        assert!(read(head, &["solver.pbf.cfm=1", "forces.xsph=0"]).is_ok());
    }

    #[test]
    fn packed_positions_are_accepted_where_the_precision_says_the_same() {
        let text = |precision: &str, packed: bool| {
            format!(
                "spacing_m = 0.1\ndomain = {{ min_m = [0, 0, 0], max_m = [1, 1, 1] }}\n[solver]\n{precision}packed_positions = {packed}\n"
            )
        };
        for precision in [Precision::Full, Precision::Relaxed, Precision::Half] {
            let line = format!("precision = \"{}\"\n", precision.name());
            let packs = precision.packs_positions();
            assert_eq!(Scene::from_toml(&text(&line, packs), "old.toml", &[]).unwrap().solver.precision, precision);
            let error = Scene::from_toml(&text(&line, !packs), "old.toml", &[]).unwrap_err().to_string();
            assert!(
                error.starts_with(&format!("scene old.toml:5:1: solver.packed_positions = {}: ", !packs)),
                "{error}"
            );
            assert!(error.contains(&format!("solver.precision = \"{}\"", precision.name())), "{error}");
            let saved = |packed| Scene::from_saved_toml(&text(&line, packed), "state", false).unwrap().solver.precision;
            assert_eq!(saved(packs), precision);
            // The nearest that is left: unpacked `relaxed` and `half` keep their arithmetic, packed `full` its storage.
            assert_eq!(saved(!packs), if precision == Precision::Full { Precision::Relaxed } else { precision });
        }
        assert_eq!(Scene::from_toml(&text("", false), "old.toml", &[]).unwrap().solver.precision, Precision::Full);
        let set = ["solver.packed_positions=true".to_owned()];
        let error = Scene::from_toml(&text("", false), "old.toml", &set).unwrap_err().to_string();
        assert!(error.contains("solver.packed_positions = true: solver.precision = \"full\" does not pack"), "{error}");
        // Another mistake beside it is the one that is told.
        let error = Scene::from_toml(&text("precision = \"hlaf\"\n", true), "old.toml", &[]).unwrap_err().to_string();
        assert!(error.contains("solver.precision"), "{error}");
        let error = Scene::from_toml(&text("dt_s = -1\n", false), "old.toml", &[]).unwrap_err().to_string();
        assert!(error.contains("solver.dt_s"), "{error}");
    }
}
