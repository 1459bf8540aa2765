//! Keys that had another place in scenes of earlier versions.

use toml::Table;

use super::explain::{place_of, shortened, written};
use super::paths::{put, take, value_at};
use super::{Scene, SceneError};

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

impl Scene {
    /// Reads what [`Scene::to_toml`] wrote before keys moved.
    pub(crate) fn from_old_toml(text: &str, source_name: &str) -> Result<Scene, SceneError> {
        let migrated = toml::from_str::<Table>(text).map(|mut table| {
            for (old, new) in MOVED {
                if let Some(value) = take(&mut table, old) {
                    put(&mut table, new, value);
                }
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
}
