//! A scene's fields as data: for a panel that shows and sets each of them.

use std::sync::OnceLock;

use toml::{Table, Value};

use super::field::{Kind, Slider};
use super::fields::FIELDS;
use super::sph::SUPPORT_RATIO;
use super::update::{Update, UpdateRule};
use super::{Scene, SceneError, methods, paths, settings};

/// One field of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Its path, as [`Scene::with_setting`] takes it: `fluid.0.velocity_m_s`.
    pub path: String,
    /// What it takes, with limits and unit.
    pub kind: Kind,
    /// What a running scene needs to take another value, unless it is a term (see `at_zero`).
    pub update: Update,
    /// What it needs from or to 0, where the field's term is left out: worse than `update` for a term.
    pub at_zero: Update,
    /// What it is, in a sentence: the first of its documentation.
    pub doc: &'static str,
    /// How far a slider goes; none of what is no number.
    pub slider: Option<Slider>,
    /// Its value; none if it is left out and has no fixed default.
    pub value: Option<Value>,
}

impl Scene {
    /// Every field of the scene's method that has a value or may get one, in the order of scene files. Of a fluid
    /// only those of the shape that it has.
    pub fn settings(&self) -> Vec<Setting> {
        let values = self.values();
        let mut all = Vec::new();
        let method = self.solver.method.name();
        for field in FIELDS.iter().filter(|field| field.is_of(method)) {
            if matches!(field.kind, Kind::Table | Kind::Tables) {
                continue;
            }
            let [update, at_zero] = match field.update_rule {
                UpdateRule::Always(update) => [update; 2],
                UpdateRule::Term => [Update::Live, Update::Rebuild],
            };
            let paths = match field.path.split_once(".*.") {
                None => vec![field.path.to_owned()],
                Some((array, rest)) => {
                    let items = if array == "fluid" { self.fluids.len() } else { self.forces.fields.len() };
                    (0..items).map(|index| format!("{array}.{index}.{rest}")).collect()
                }
            };
            for path in paths {
                let value = values.get(&path).cloned();
                if value.is_some() || !field.path.contains('*') {
                    let doc = doc_of(field.path);
                    let number = value.as_ref().and_then(paths::as_number);
                    let slider = field.slider_at(number.unwrap_or(0.0));
                    all.push(Setting { path, kind: field.kind, update, at_zero, doc, slider, value });
                }
            }
        }
        all
    }

    /// The scene with one value changed (`forces.xsph=0.1`, as [`Scene::load`] takes them), checked as a
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
            // What is not there is left out already.
            paths::take(table, path);
            Ok(())
        })
    }

    fn with_table(&self, change: impl FnOnce(&mut Table) -> Result<(), SceneError>) -> Result<Scene, SceneError> {
        let malformed =
            |reason: String| SceneError::Malformed { source_name: self.name.clone(), place: String::new(), reason };
        let mut table = self.to_table().map_err(|error| malformed(error.to_string()))?;
        if self.solver.support_ratio == self.default_support_ratio() {
            // Which is another's with another method or without bodies.
            paths::take(&mut table, SUPPORT_RATIO);
        }
        change(&mut table)?;
        let method = methods::chosen(&table).to_owned();
        if method != self.solver.method.name() {
            // The old method's settings go with it.
            methods::prune(&mut table, &method, FIELDS);
        }
        let mut scene = Self::from_table(&table, "", &self.name, false)?;
        scene.name.clone_from(&self.name);
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
