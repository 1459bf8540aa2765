//! What a changed setting asks of a scene that runs.

use std::collections::{BTreeMap, BTreeSet};

use toml::Value;

use super::Scene;
use super::field::Kind;
use super::fields::field_of;
use super::update::Update;

/// What differs between two scenes, and what that asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The worst of all changed fields; [`Update::Live`] if nothing changed.
    pub update: Update,
    /// Path of each changed field (`fluid.0.velocity_m_s`), with what it alone asks for.
    pub fields: Vec<(String, Update)>,
}

impl Change {
    /// Whether the scenes are the same.
    pub fn is_nothing(&self) -> bool {
        self.fields.is_empty()
    }
}

impl Scene {
    /// What a running `self` needs to go on as `other`. What only one of their methods has is no change of a
    /// setting: the method's is.
    pub fn change_to(&self, other: &Scene) -> Change {
        let [before, after] = [self, other].map(Scene::values);
        let paths: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
        let methods = [self, other].map(|scene| scene.solver.method.name());
        let changed = paths.into_iter().filter(|path| before.get(*path) != after.get(*path)).filter_map(|path| {
            let field = field_of(path);
            let of_both = field.is_none_or(|field| methods.iter().all(|method| field.is_of(method)));
            let update = field.map_or(Update::Reset, |field| field.update(before.get(path), after.get(path)));
            of_both.then(|| (path.clone(), update))
        });
        let fields: Vec<(String, Update)> = changed.collect();
        Change { update: fields.iter().map(|(_, update)| *update).max().unwrap_or(Update::Live), fields }
    }

    /// Each field of its method that has a value, those of defaults too, by its path.
    pub(super) fn values(&self) -> BTreeMap<String, Value> {
        let mut values = BTreeMap::new();
        if let Ok(scene) = self.to_table() {
            collect(String::new(), Value::Table(scene), &mut values);
        }
        values
    }
}

fn collect(path: String, value: Value, values: &mut BTreeMap<String, Value>) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    let is_group =
        path.is_empty() || field_of(&path).is_some_and(|field| matches!(field.kind, Kind::Table | Kind::Tables));
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
