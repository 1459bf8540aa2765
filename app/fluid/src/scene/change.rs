//! What a changed setting asks of a scene that runs.

use std::collections::{BTreeMap, BTreeSet};

use toml::Value;

use super::Scene;
use super::applied::{Applied, Applies};
use super::fields::{Kind, field_of};

/// What differs between two scenes, and what that asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The worst of all changed fields; [`Applied::Live`] if nothing changed.
    pub applied: Applied,
    /// Path of each changed field (`fluid.0.velocity_m_s`), with what it alone asks for.
    pub fields: Vec<(String, Applied)>,
}

impl Change {
    /// Whether the scenes are the same.
    pub fn is_nothing(&self) -> bool {
        self.fields.is_empty()
    }
}

impl Scene {
    /// What a running `self` needs to go on as `other`.
    pub fn change_to(&self, other: &Scene) -> Change {
        let [before, after] = [self, other].map(Scene::values);
        let paths: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
        let changed = paths.into_iter().filter(|path| before.get(*path) != after.get(*path)).map(|path| {
            let applies = field_of(path).map_or(Applies::Always(Applied::Reset), |(_, _, applies)| *applies);
            (path.clone(), applies.between(before.get(path), after.get(path)))
        });
        let fields: Vec<(String, Applied)> = changed.collect();
        Change { applied: fields.iter().map(|(_, applied)| *applied).max().unwrap_or(Applied::Live), fields }
    }

    /// Each field that has a value, those of defaults too, by its path.
    pub(super) fn values(&self) -> BTreeMap<String, Value> {
        let mut values = BTreeMap::new();
        if let Ok(scene) = Value::try_from(self) {
            collect(String::new(), scene, &mut values);
        }
        values
    }
}

fn collect(path: String, value: Value, values: &mut BTreeMap<String, Value>) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    let is_group = path.is_empty() || matches!(field_of(&path), Some((_, Kind::Table | Kind::Tables, _)));
    match value {
        Value::Table(table) if is_group => {
            table.into_iter().for_each(|(key, value)| collect(below(&key), value, values));
        }
        Value::Array(items) if is_group => {
            items.into_iter().enumerate().for_each(|(index, value)| collect(below(&index.to_string()), value, values));
        }
        leaf => {
            values.insert(path, leaf);
        }
    }
}
