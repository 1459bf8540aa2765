//! Messages against their schemas: the part of JSON Schema that captures use, and Foxglove's two messages
//! in protobuf. What a schema says beyond that part is said to be unknown, not passed over.

use prost::Message as _;
use serde_json::Value;

use crate::{foxglove, stream::Channel};

/// What the messages of a channel have to be.
pub(crate) enum Expected {
    Json(Value),
    Image,
    Points,
    /// Another program's, of which nothing is known.
    Unknown,
}

impl Expected {
    /// Of a channel, or what is wrong with its schema.
    pub fn of(channel: &Channel) -> Result<Self, String> {
        match (channel.encoding.as_str(), channel.schema_encoding.as_str(), channel.schema_name.as_str()) {
            ("json", "jsonschema", _) => {
                let schema: Value = serde_json::from_slice(&channel.schema).map_err(|e| format!("its schema: {e}"))?;
                check_schema(&schema)?;
                Ok(Self::Json(schema))
            }
            ("protobuf", "protobuf", "foxglove.CompressedImage") => Ok(Self::Image),
            ("protobuf", "protobuf", "foxglove.PointCloud") => Ok(Self::Points),
            _ => Ok(Self::Unknown),
        }
    }

    /// What is wrong with a message.
    pub fn problem(&self, data: &[u8]) -> Option<String> {
        match self {
            Self::Json(schema) => match serde_json::from_slice(data) {
                Ok(value) => mismatch(schema, &value, "").err(),
                Err(error) => Some(error.to_string()),
            },
            Self::Image => foxglove::CompressedImage::decode(data).map_or_else(
                |error| Some(error.to_string()),
                |image| {
                    (image.format.is_empty() || image.data.is_empty()).then(|| "a picture of no format, or none".into())
                },
            ),
            Self::Points => foxglove::PointCloud::decode(data).map_or_else(
                |error| Some(error.to_string()),
                |cloud| {
                    let stride = cloud.point_stride as usize;
                    (stride == 0 || cloud.data.len() % stride != 0)
                        .then(|| format!("{} bytes of points of {stride} bytes", cloud.data.len()))
                },
            ),
            Self::Unknown => None,
        }
    }
}

const KEYWORDS: [&str; 12] = [
    "$schema",
    "title",
    "description",
    "unit",
    "type",
    "properties",
    "required",
    "items",
    "enum",
    "const",
    "oneOf",
    "$id",
];

/// Whether a schema says only what is understood here.
fn check_schema(schema: &Value) -> Result<(), String> {
    let Some(object) = schema.as_object() else { return Err("its schema is no object".into()) };
    if let Some(unknown) = object.keys().find(|key| !KEYWORDS.contains(&key.as_str())) {
        return Err(format!("its schema has the keyword `{unknown}`, which is not understood here"));
    }
    let parts = object.get("properties").and_then(Value::as_object).into_iter().flat_map(|all| all.values());
    let choices = object.get("oneOf").and_then(Value::as_array).into_iter().flatten();
    parts.chain(object.get("items")).chain(choices).try_for_each(check_schema)
}

/// Where and why a value is not what a schema says.
fn mismatch(schema: &Value, value: &Value, place: &str) -> Result<(), String> {
    let wrong = |what: String| Err(format!("{}: {what}", if place.is_empty() { "the message" } else { place }));
    if let Some(kind) = schema["type"].as_str() {
        let fits = match kind {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "boolean" => value.is_boolean(),
            "integer" => value.is_i64() || value.is_u64(),
            "number" => value.is_number(),
            _ => return wrong(format!("a schema of type `{kind}`, which is not understood here")),
        };
        if !fits {
            return wrong(format!("{value} is no {kind}"));
        }
    }
    if let Some(allowed) = schema["enum"].as_array()
        && !allowed.contains(value)
    {
        return wrong(format!("{value} is none of {}", schema["enum"]));
    }
    if let Some(only) = schema.get("const")
        && only != value
    {
        return wrong(format!("{value} is not {only}"));
    }
    if let Some(choices) = schema["oneOf"].as_array() {
        let fitting = choices.iter().filter(|choice| mismatch(choice, value, place).is_ok()).count();
        if fitting != 1 {
            return wrong(format!("{value} fits {fitting} of its {} kinds", choices.len()));
        }
    }
    for key in schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
        if value.get(key).is_none() {
            return wrong(format!("field `{key}` is missing"));
        }
    }
    if let (Some(properties), Some(fields)) = (schema["properties"].as_object(), value.as_object()) {
        for (key, field) in fields {
            match properties.get(key) {
                Some(about) => mismatch(about, field, &format!("field `{key}`"))?,
                None => return wrong(format!("field `{key}` is not in the schema")),
            }
        }
    }
    if let (Some(about), Some(entries)) = (schema.get("items"), value.as_array()) {
        for (index, entry) in entries.iter().enumerate() {
            mismatch(about, entry, &format!("{place}[{index}]"))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{frame_schema, log_schema, passes_schema, span_schema, state_schema, stats_schema, thermal_schema};
    use serde_json::json;

    #[test]
    fn each_keyword_is_understood() {
        let all = [
            frame_schema(),
            log_schema(),
            passes_schema(["a"]),
            span_schema(),
            state_schema(),
            thermal_schema(),
            crate::check_schema(),
        ];
        for schema in all.iter().chain([&stats_schema(&[])]) {
            assert_eq!(check_schema(schema), Ok(()), "{schema}");
        }
        assert!(check_schema(&json!({ "properties": { "a": { "minimum": 3 } } })).is_err());
    }

    #[test]
    fn wrong_messages_are_found() {
        let problem = |schema: &Value, value: Value| mismatch(schema, &value, "").err().unwrap_or_default();
        let passes = passes_schema(["a"]);
        assert_eq!(problem(&passes, json!({ "frame": 1, "wall_s": 2, "a_ms": 0.5 })), "");
        assert!(problem(&passes, json!({ "frame": 1 })).contains("`wall_s` is missing"));
        assert!(problem(&passes, json!({ "frame": 1.5, "wall_s": 2 })).contains("1.5 is no integer"));
        assert!(
            problem(&passes, json!({ "frame": 1, "wall_s": 2, "b_ms": 0.5 })).contains("`b_ms` is not in the schema")
        );
        assert!(problem(&passes, json!([])).contains("no object"));
        let mut log = json!({ "timestamp": { "sec": 1, "nsec": 2 }, "level": 3, "message": "", "name": "", "file": "", "line": 0 });
        assert_eq!(problem(&log_schema(), log.clone()), "");
        log["level"] = 9.into();
        assert!(problem(&log_schema(), log).contains("fits 0 of its 6 kinds"));
        let spans =
            json!({ "frame": 0, "sequence": 0, "first_ticks": 5, "begin_ticks": [0], "ticks": [1], "flags": ["odd"] });
        assert!(problem(&span_schema(), spans).contains("is none of"));
    }
}
