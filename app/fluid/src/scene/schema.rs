//! The JSON Schema of a scene file, for editors: its shape from the types, its limits from the
//! table that the checks use.

use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

use super::Scene;
use super::field::{Kind, Limits};
use super::fields::FIELDS;

/// The JSON Schema (draft 7) of a scene file, as text.
pub fn schema() -> String {
    // In one piece: the table below names fields by their paths.
    let settings = SchemaSettings::draft07().with(|settings| settings.inline_subschemas = true);
    let mut schema = settings.into_generator().into_root_schema_for::<Scene>().to_value();
    tidy(&mut schema);
    schema["title"] = "Brooklet scene".into();
    schema["description"] = "A scene of Brooklet. SI units, y up. What has a default may be left out.".into();
    for field in FIELDS {
        if let Some(part) = part_of(&mut schema, field.path) {
            limit(part, &field.kind);
        }
    }
    if let Some(fluid) = part_of(&mut schema, "fluid.*") {
        fluid["oneOf"] = json!([{ "required": ["block"] }, { "required": ["sphere"] }]);
    }
    // A schema of strings and numbers is always representable.
    serde_json::to_string_pretty(&schema).unwrap_or_default()
}

fn part_of<'a>(schema: &'a mut Value, field: &str) -> Option<&'a mut Value> {
    field.split('.').try_fold(schema, |here, step| match step {
        "*" => here.get_mut("items"),
        key => here.get_mut("properties")?.get_mut(key),
    })
}

fn limit(part: &mut Value, kind: &Kind) {
    let Some(part) = part.as_object_mut() else { return };
    match kind {
        Kind::Number(limits) | Kind::Whole(limits) => put(part, limits),
        Kind::Vector(limits) => {
            if let Some(items) = part.get_mut("items").and_then(Value::as_object_mut) {
                put(items, limits);
            }
        }
        Kind::Choice(_) | Kind::Switch | Kind::Switches | Kind::Text | Kind::Table | Kind::Tables => {}
    }
}

fn put(part: &mut Map<String, Value>, limits: &Limits) {
    // Rust's name of the type, which no other program knows.
    part.remove("format");
    let number = |value: f64| if value.fract() == 0.0 { json!(value as i64) } else { json!(value) };
    part.insert("minimum".into(), number(limits.least));
    part.insert("maximum".into(), number(limits.most));
}

/// TOML has no null: what may be left out is left out. And an editor breaks lines itself.
fn tidy(schema: &mut Value) {
    match schema {
        Value::Object(object) => {
            if let Some(Value::Array(types)) = object.get_mut("type") {
                types.retain(|name| name != "null");
                if let [only] = types.as_slice() {
                    let only = only.clone();
                    object.insert("type".into(), only);
                }
            }
            let is_null = |part: &Value| part["type"] == "null";
            if let Some(Value::Array(parts)) = object.get_mut("anyOf")
                && parts.iter().any(is_null)
            {
                parts.retain(|part| !is_null(part));
                if let [Value::Object(only)] = parts.as_slice() {
                    let only = only.clone();
                    object.remove("anyOf");
                    for (key, value) in only {
                        object.entry(key).or_insert(value);
                    }
                }
            }
            if let Some(Value::String(text)) = object.get_mut("description") {
                *text = text.replace('\n', " ");
            }
            if object.get("default").is_some_and(Value::is_null) {
                object.remove("default");
            }
            object.values_mut().for_each(tidy);
        }
        Value::Array(items) => items.iter_mut().for_each(tidy),
        _ => {}
    }
}
