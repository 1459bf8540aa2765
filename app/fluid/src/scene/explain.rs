//! What the TOML reader has against a file, in words that name the field, its value and what is
//! allowed.

use serde_path_to_error::Segment;
use toml::de::{DeTable, DeValue};
use toml::{Table, Value};

use super::field::Short;
use super::fields::kind_of;
use super::nearest::nearest;
use super::paths::value_at;
use super::{Scene, SceneError};

/// A text that is not TOML.
pub(super) fn syntax(error: &toml::de::Error, text: &str, source_name: &str) -> SceneError {
    let start = error.span().map_or(0, |span| span.start.min(text.len()));
    let before = text.get(..start).unwrap_or_default();
    let line = text[before.rfind('\n').map_or(0, |end| end + 1)..].lines().next().unwrap_or_default().trim();
    let at = if line.is_empty() { String::new() } else { format!(", at `{}`", shortened(line)) };
    SceneError::Malformed {
        source_name: source_name.into(),
        place: place(error, text),
        reason: one_line(error.message()) + &at,
    }
}

/// TOML that is not a scene. `from_text` says that `table` is what `text` holds, unchanged.
pub(super) fn mismatch(
    error: &serde_path_to_error::Error<toml::de::Error>,
    table: &Table,
    text: &str,
    source_name: &str,
    from_text: bool,
) -> SceneError {
    let message = error.inner().message();
    // Only the text's own reader knows lines, and it meets the same mistake unless a setting made it.
    let place = match toml::from_str::<Scene>(text) {
        Err(other) if from_text || other.message() == message => place(&other, text),
        _ => String::new(),
    };
    let source_name = source_name.to_owned();
    let mut path = dotted(error.path());
    if let Some(rest) = message.strip_prefix("unknown field `") {
        let mut quoted = rest.split('`').step_by(2);
        let key = quoted.next().unwrap_or_default().to_owned();
        let allowed: Vec<&str> = quoted.filter(|name| !name.is_empty()).collect();
        return SceneError::UnknownKey {
            source_name,
            place,
            nearest: nearest(&key, allowed.iter().copied()).unwrap_or_default().into(),
            allowed: allowed.join(", "),
            key: shortened(&key),
        };
    }
    if let Some(field) = message.strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`')) {
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(field);
        let allowed = kind_of(&path).map_or_else(String::new, |kind| kind.to_string());
        return SceneError::Missing { source_name, place, field: path, allowed };
    }
    // A component of a vector has no limits of its own.
    let known = kind_of(&path).map(|kind| (path.clone(), kind)).or_else(|| {
        let whole = path.rsplit_once('.')?.0.to_owned();
        kind_of(&whole).map(|kind| (whole, kind))
    });
    match known {
        Some((field, kind)) => SceneError::NotAllowed {
            source_name,
            place,
            value: value_at(table, &field).map_or_else(|| "?".into(), |value| shortened(&written(value))),
            field,
            allowed: kind.to_string(),
        },
        None => SceneError::Malformed { source_name, place, reason: one_line(message) },
    }
}

fn dotted(path: &serde_path_to_error::Path) -> String {
    let steps: Vec<String> = path
        .iter()
        .filter_map(|segment| match segment {
            Segment::Seq { index } => Some(index.to_string()),
            Segment::Map { key } => Some(key.clone()),
            // The chosen name of a choice is its value, not a field below it.
            Segment::Enum { .. } | Segment::Unknown => None,
        })
        .collect();
    steps.join(".")
}

/// A value as a person writes it.
pub(super) fn written(value: &Value) -> String {
    match value {
        Value::Float(number) => Short(*number).to_string(),
        Value::Array(items) => format!("[{}]", items.iter().map(written).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

/// `:line:column`, where known.
fn place(error: &toml::de::Error, text: &str) -> String {
    error.span().map_or_else(String::new, |span| line_and_column(text, span.start))
}

/// `:line:column` of the key at `path`; nothing if the text has none.
pub(super) fn place_of(text: &str, path: &str) -> String {
    let Ok(document) = DeTable::parse(text) else { return String::new() };
    let (above, last) = path.rsplit_once('.').map_or((None, path), |(above, last)| (Some(above), last));
    let mut here = document.into_inner();
    for step in above.into_iter().flat_map(|above| above.split('.')) {
        let below = here.into_iter().find(|(key, _)| key.get_ref() == step).map(|(_, value)| value.into_inner());
        let Some(DeValue::Table(inner)) = below else { return String::new() };
        here = inner;
    }
    let key = here.keys().find(|key| key.get_ref() == last);
    key.map_or_else(String::new, |key| line_and_column(text, key.span().start))
}

fn line_and_column(text: &str, at: usize) -> String {
    let Some(before) = text.get(..at.min(text.len())) else { return String::new() };
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
    format!(":{line}:{column}")
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// As much of a text as a message of one line has room for, without what would break
/// or colour the line.
pub(crate) fn shortened(text: &str) -> String {
    const MOST: usize = 80;
    let mut line: String = text.chars().take(MOST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(MOST).is_some() {
        line.push('…');
    }
    line
}
