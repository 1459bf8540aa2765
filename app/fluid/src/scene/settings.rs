//! `path=value` settings, which replace values of a scene before it is read.

use toml::{Table, Value};

use super::explain::shortened;
use super::{SceneError, moved};

/// No field lies deeper than `fluid.0.block.min_m.0`.
const MOST_KEYS: usize = 8;

/// Puts `value` at `path` (`a.b.0.c=value`). The value is [`value_of`] its text.
pub(super) fn set(table: &mut Table, setting: &str) -> Result<(), SceneError> {
    let bad = |reason: String| SceneError::BadSetting { setting: shortened(setting), reason };
    let (path, text) = setting.split_once('=').ok_or_else(|| bad("write path=value".into()))?;
    let (path, text) = (path.trim(), text.trim());
    if let Some(new) = moved::new_place(path) {
        return Err(bad(format!("the key is now {new}")));
    }
    let value = value_of(text);

    let mut keys: Vec<&str> = path.split('.').collect();
    if keys.len() > MOST_KEYS {
        return Err(bad(format!("the path has {} keys, and no scene has more than {MOST_KEYS}", keys.len())));
    }
    if keys.iter().any(|key| key.is_empty()) {
        return Err(bad("a key of the path is empty".into()));
    }
    let last = keys.pop().ok_or_else(|| bad("the path is empty".into()))?;
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

/// A value from its text. One that is not TOML is a string.
pub(super) fn value_of(text: &str) -> Value {
    toml::from_str::<Table>(&format!("value = {text}"))
        .ok()
        .filter(|parsed| parsed.len() == 1)
        .and_then(|mut parsed| parsed.remove("value"))
        .unwrap_or_else(|| Value::String(text.into()))
}

/// The item of an array that `key` numbers.
fn item<'a>(items: &'a mut [Value], key: &str) -> Result<&'a mut Value, String> {
    let count = items.len();
    let found = key.parse::<usize>().ok().and_then(|index| items.get_mut(index));
    found.ok_or_else(|| format!("`{key}` must be a number below {count}"))
}
