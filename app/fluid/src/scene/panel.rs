//! A scene's fields as data: for a panel that shows and sets each of them.

use std::sync::OnceLock;

use toml::{Table, Value};

use super::applied::{Applied, Applies};
use super::fields::{FIELDS, Kind};
use super::{Scene, SceneError, explain, settings};

/// One field of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Its path, as [`Scene::with_setting`] takes it: `fluid.0.velocity_m_s`.
    pub path: String,
    /// What it takes, with limits and unit.
    pub kind: Kind,
    /// What a running scene needs to take another value, unless it is a term (see `at_zero`).
    pub applied: Applied,
    /// What it needs from or to 0, where the field's term is left out: worse than `applied` for a term.
    pub at_zero: Applied,
    /// What it is, in a sentence: the first of its documentation.
    pub doc: &'static str,
    /// Its value; none if it is left out and has no fixed default.
    pub value: Option<Value>,
}

impl Scene {
    /// Every field that has a value or may get one, in the order of scene files. Of a fluid only those of
    /// the shape that it has.
    pub fn settings(&self) -> Vec<Setting> {
        let values = self.values();
        let mut all = Vec::new();
        for (field, kind, applies) in FIELDS {
            if matches!(kind, Kind::Table | Kind::Tables) {
                continue;
            }
            let [applied, at_zero] = match applies {
                Applies::Always(applied) => [*applied; 2],
                Applies::Term => [Applied::Live, Applied::Rebuild],
            };
            let paths = match field.split_once(".*.") {
                None => vec![(*field).to_owned()],
                Some((array, rest)) => (0..self.fluids.len()).map(|index| format!("{array}.{index}.{rest}")).collect(),
            };
            for path in paths {
                let value = values.get(&path).cloned();
                if value.is_some() || !field.contains('*') {
                    let doc = doc_of(field);
                    all.push(Setting { path, kind: *kind, applied, at_zero, doc, value });
                }
            }
        }
        all
    }

    /// The scene with one value changed (`solver.xsph=0.1`, as [`Scene::load`] takes them), checked as a
    /// file is.
    ///
    /// # Errors
    /// Every [`SceneError`] about a value, naming the field, the value and what is allowed.
    pub fn with_setting(&self, setting: &str) -> Result<Scene, SceneError> {
        self.with_table(|table| settings::set(table, setting))
    }

    /// The scene with the field at `path` left out, so that its default holds.
    ///
    /// # Errors
    /// If it has no default, or the scene is not allowed with it.
    pub fn with_default(&self, path: &str) -> Result<Scene, SceneError> {
        self.with_table(|table| {
            let (parents, last) = path.rsplit_once('.').map_or((None, path), |(parents, last)| (Some(parents), last));
            let mut here = Some(table);
            for key in parents.into_iter().flat_map(|parents| parents.split('.')) {
                here = here.and_then(|table| table.get_mut(key)).and_then(Value::as_table_mut);
            }
            // What is not there is left out already.
            here.and_then(|table| table.remove(last));
            Ok(())
        })
    }

    fn with_table(&self, change: impl FnOnce(&mut Table) -> Result<(), SceneError>) -> Result<Scene, SceneError> {
        let malformed =
            |reason: String| SceneError::Malformed { source_name: self.name.clone(), place: String::new(), reason };
        let mut table = Table::try_from(self).map_err(|error| malformed(error.to_string()))?;
        change(&mut table)?;
        let mut scene: Scene = serde_path_to_error::deserialize(Value::Table(table.clone()))
            .map_err(|error| explain::mismatch(&error, &table, "", &self.name, false))?;
        scene.name.clone_from(&self.name);
        scene.check(&self.name)?;
        Ok(scene)
    }
}

/// The first sentence of a field's documentation. It is that of the scene's types: the editors' schema is
/// made of them, and a test keeps the file that is read here to it.
fn doc_of(field: &str) -> &'static str {
    static SCHEMA: OnceLock<serde_json::Value> = OnceLock::new();
    let schema = SCHEMA.get_or_init(|| {
        // A schema that cannot be read describes nothing; `every_field_has_its_sentence` would notice.
        serde_json::from_str(include_str!("../../scenes/scene.schema.json")).unwrap_or_default()
    });
    let part = field.split('.').try_fold(schema, |here, step| match step {
        "*" => here.get("items"),
        key => here.get("properties")?.get(key),
    });
    let doc = part.and_then(|part| part.get("description")).and_then(serde_json::Value::as_str).unwrap_or_default();
    doc.split_inclusive(". ").next().unwrap_or_default().trim_end()
}
