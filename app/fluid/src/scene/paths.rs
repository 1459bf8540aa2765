//! Values of a TOML table, by their dotted paths.

use toml::{Table, Value};

/// The value at `path` (`fluid.0.block`).
pub(super) fn value_at<'a>(table: &'a Table, path: &str) -> Option<&'a Value> {
    let mut steps = path.split('.');
    let first = table.get(steps.next()?)?;
    steps.try_fold(first, |here, step| match here {
        Value::Table(inner) => inner.get(step),
        Value::Array(items) => items.get(step.parse::<usize>().ok()?),
        _ => None,
    })
}

/// A number, with a fraction or without.
pub(super) fn as_number(value: &Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|whole| whole as f64))
}

/// Takes the value at `path` out of the table; the tables above it stay.
pub(super) fn take(table: &mut Table, path: &str) -> Option<Value> {
    let Some((first, rest)) = path.split_once('.') else { return table.remove(path) };
    let (mut here, mut rest) = (table.get_mut(first)?, rest);
    loop {
        let (step, below) = rest.split_once('.').map_or((rest, None), |(step, below)| (step, Some(below)));
        let Some(below) = below else { return here.as_table_mut()?.remove(step) };
        here = match here {
            Value::Table(inner) => inner.get_mut(step)?,
            Value::Array(items) => items.get_mut(step.parse::<usize>().ok()?)?,
            _ => return None,
        };
        rest = below;
    }
}

/// Puts a value at `path`, which goes through tables alone, making those that are not there. A plain value in
/// its way stays.
pub(super) fn put(table: &mut Table, path: &str, value: Value) {
    match path.split_once('.') {
        None => {
            table.insert(path.into(), value);
        }
        Some((first, rest)) => {
            let inner = table.entry(first).or_insert_with(|| Value::Table(Table::new()));
            if let Some(inner) = inner.as_table_mut() {
                put(inner, rest, value);
            }
        }
    }
}

/// The paths of `table` that a field's path means, where `*` is any item of an array.
pub(super) fn matching(table: &Table, field: &str) -> Vec<String> {
    let mut steps = field.split('.');
    let first = steps.next().unwrap_or_default();
    let mut found: Vec<(String, &Value)> =
        table.get(first).map(|value| (first.to_owned(), value)).into_iter().collect();
    for step in steps {
        found = found
            .into_iter()
            .flat_map(|(path, value)| {
                let items: Vec<(String, &Value)> = match value {
                    Value::Array(items) if step == "*" => {
                        items.iter().enumerate().map(|(index, item)| (format!("{path}.{index}"), item)).collect()
                    }
                    Value::Table(inner) => {
                        inner.get(step).map(|value| (format!("{path}.{step}"), value)).into_iter().collect()
                    }
                    _ => Vec::new(),
                };
                items
            })
            .collect();
    }
    found.into_iter().map(|(path, _)| path).collect()
}
