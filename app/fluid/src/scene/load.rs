//! From TOML to a checked [`Scene`].

use std::path::Path;

use toml::{Table, Value};

use super::nearest::nearest;
use super::{Scene, SceneError, shipped};

impl Scene {
    /// Reads a shipped scene by its name, or a file by its path; `settings` (`path=value`, as
    /// `solver.iterations=8` or `fluid.0.velocity_m_s=[1,0,0]`) replace values before the scene is
    /// checked.
    ///
    /// # Errors
    /// Every [`SceneError`].
    pub fn load(name_or_path: &str, settings: &[String]) -> Result<Scene, SceneError> {
        if let Some(text) = shipped::text_of(name_or_path) {
            return Self::from_toml(text, name_or_path, settings);
        }
        let path = Path::new(name_or_path);
        if !path.exists() {
            return Err(shipped::unknown(name_or_path));
        }
        let text = std::fs::read_to_string(path)
            .map_err(|error| SceneError::Unreadable { source_name: name_or_path.into(), reason: error.to_string() })?;
        Self::from_toml(&text, name_or_path, settings)
    }

    /// Reads a scene from its text; `source_name` is what errors call it.
    ///
    /// # Errors
    /// Every [`SceneError`] but `Unreadable` and `Unknown`.
    pub fn from_toml(text: &str, source_name: &str, settings: &[String]) -> Result<Scene, SceneError> {
        let mut scene: Scene = if settings.is_empty() {
            toml::from_str(text).map_err(|error| toml_error(&error, Some(text), source_name))?
        } else {
            let mut table: Table = toml::from_str(text).map_err(|error| toml_error(&error, Some(text), source_name))?;
            for setting in settings {
                set(&mut table, setting)?;
            }
            table.try_into().map_err(|error: toml::de::Error| toml_error(&error, None, source_name))?
        };
        scene.name =
            Path::new(source_name).file_stem().map_or_else(|| source_name.into(), |stem| stem.to_string_lossy().into());
        scene.check(source_name)?;
        Ok(scene)
    }

    /// The scene as TOML, defaults written out.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).unwrap_or_else(|error| format!("# not representable: {error}\n"))
    }
}

/// Puts `value` at `path` (`a.b.0.c=value`). A value that is not TOML is taken as a string.
fn set(table: &mut Table, setting: &str) -> Result<(), SceneError> {
    let bad = |reason: String| SceneError::BadSetting { setting: setting.into(), reason };
    let (path, text) = setting.split_once('=').ok_or_else(|| bad("write path=value".into()))?;
    let (path, text) = (path.trim(), text.trim());
    let value = toml::from_str::<Table>(&format!("value = {text}"))
        .ok()
        .and_then(|mut parsed| parsed.remove("value"))
        .unwrap_or_else(|| Value::String(text.into()));

    let mut keys: Vec<&str> = path.split('.').collect();
    let last = keys.pop().filter(|key| !key.is_empty()).ok_or_else(|| bad("the path is empty".into()))?;
    let mut here = Value::Table(std::mem::take(table));
    let mut place = &mut here;
    for key in keys {
        place = match place {
            Value::Table(inner) => inner.entry(key).or_insert_with(|| Value::Table(Table::new())),
            Value::Array(items) => item(items, key).map_err(bad)?,
            _ => return Err(bad(format!("nothing lies below `{key}`"))),
        };
    }
    match place {
        Value::Table(inner) => {
            inner.insert(last.into(), value);
        }
        Value::Array(items) => *item(items, last).map_err(bad)? = value,
        _ => return Err(bad(format!("`{last}` lies below a plain value"))),
    }
    if let Value::Table(changed) = here {
        *table = changed;
    }
    Ok(())
}

/// The item of an array that `key` numbers.
fn item<'a>(items: &'a mut [Value], key: &str) -> Result<&'a mut Value, String> {
    let count = items.len();
    let found = key.parse::<usize>().ok().and_then(|index| items.get_mut(index));
    found.ok_or_else(|| format!("`{key}` must be a number below {count}"))
}

fn toml_error(error: &toml::de::Error, text: Option<&str>, source_name: &str) -> SceneError {
    let place = match (error.span(), text) {
        (Some(span), Some(text)) => {
            let before = &text[..span.start.min(text.len())];
            let line = before.matches('\n').count() + 1;
            let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
            format!(":{line}:{column}")
        }
        _ => String::new(),
    };
    let message = error.message();
    if let Some(rest) = message.strip_prefix("unknown field `") {
        let mut quoted = rest.split('`').step_by(2);
        let key = quoted.next().unwrap_or_default().to_string();
        let allowed: Vec<&str> = quoted.filter(|name| !name.is_empty()).collect();
        return SceneError::UnknownKey {
            source_name: source_name.into(),
            place,
            nearest: nearest(&key, allowed.iter().copied()).unwrap_or_default().into(),
            allowed: allowed.join(", "),
            key,
        };
    }
    SceneError::Malformed { source_name: source_name.into(), place, reason: message.replace('\n', " ") }
}
