//! The JSON Schema of a scene file, for editors: its shape from the types, its limits from the
//! table that the checks use.

use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

use super::field::{Field, Kind, Limits};
use super::fields::FIELDS;
use super::{Method, Scene, auto_step};

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
    if let Some(step) = part_of(&mut schema, auto_step::DT) {
        auto_step::describe(step);
    }
    if let Some(fluid) = part_of(&mut schema, "fluid.*") {
        fluid["oneOf"] = json!([{ "required": ["block"] }, { "required": ["sphere"] }, { "required": ["cylinder"] }]);
    }
    by_method(&mut schema, FIELDS, Method::NAMES);
    // A schema of strings and numbers is always representable.
    serde_json::to_string_pretty(&schema).unwrap_or_default()
}

fn part_of<'a>(schema: &'a mut Value, field: &str) -> Option<&'a mut Value> {
    field.split('.').try_fold(schema, |here, step| match step {
        "*" => here.get_mut("items"),
        key => here.get_mut("properties")?.get_mut(key),
    })
}

/// Refuses each method the fields that it does not have. The first is the one of scenes that name none.
fn by_method(schema: &mut Value, fields: &[Field], methods: &[&str]) {
    let mut rules = Vec::new();
    for method in methods {
        let mut refused = json!({});
        for field in fields.iter().filter(|field| !field.is_of(method)) {
            refuse(&mut refused, field.path);
        }
        if refused == json!({}) {
            continue;
        }
        let mut chosen = json!({ "properties": { "solver": { "properties": { "method": { "const": method } } } } });
        if methods.first() != Some(method) {
            chosen["required"] = json!(["solver"]);
            chosen["properties"]["solver"]["required"] = json!(["method"]);
        }
        rules.push(json!({ "if": chosen, "then": refused }));
    }
    if !rules.is_empty() {
        schema["allOf"] = rules.into();
    }
}

/// Nothing may be at `path`.
fn refuse(schema: &mut Value, path: &str) {
    let mut here = schema;
    for step in path.split('.') {
        // A table that is refused as a whole.
        if here.as_bool() == Some(false) {
            return;
        }
        here = match step {
            "*" => &mut here["items"],
            key => &mut here["properties"][key],
        };
    }
    *here = false.into();
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
        Kind::Vectors(limits) => {
            let numbers = part.get_mut("items").and_then(|point| point.get_mut("items"));
            if let Some(items) = numbers.and_then(Value::as_object_mut) {
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

#[cfg(test)]
mod tests {
    use super::super::methods::tests::MORE;
    use super::*;

    #[test]
    fn a_schema_refuses_each_method_what_others_have() {
        let mut schema = json!({});
        by_method(&mut schema, MORE, &["pbf", "none", "sph"]);
        let solver = |method: &str| json!({ "properties": { "method": { "const": method } }, "required": ["method"] });
        let chosen = |method: &str| json!({ "properties": { "solver": solver(method) }, "required": ["solver"] });
        let lifetime = json!({ "items": { "properties": { "lifetime_s": false } } });
        let expected = json!([
            {
                "if": { "properties": { "solver": { "properties": { "method": { "const": "pbf" } } } } },
                "then": { "properties": { "forces": { "properties": { "drag": false } }, "fluid": lifetime } },
            },
            {
                "if": chosen("none"),
                "then": { "properties": {
                    "solver": { "properties": { "pbf": false } },
                    "forces": { "properties": { "xsph": false } },
                } },
            },
            {
                "if": chosen("sph"),
                "then": { "properties": {
                    "solver": { "properties": { "pbf": false } },
                    "forces": { "properties": { "drag": false } },
                    "fluid": lifetime,
                } },
            },
        ]);
        assert_eq!(schema["allOf"], expected);
        let mut schema = json!({});
        by_method(&mut schema, &MORE[..3], &["pbf", "none", "sph"]);
        assert_eq!(schema, json!({}), "fields that every method has");
    }

    #[test]
    fn scenes_that_name_no_method_have_the_first() {
        assert_eq!(Method::NAMES.first(), Some(&Method::default().name()));
    }
}
