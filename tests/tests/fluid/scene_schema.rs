//! The JSON Schema of scenes says what the parser says.

use std::path::Path;

use brooklet_fluid::{Scene, scene::schema, shipped_scenes};
use jsonschema::Validator;
use serde_json::{Value, json};

fn scenes() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../app/fluid/scenes")
}

fn parsed() -> Value {
    serde_json::from_str(&schema()).unwrap()
}

fn validator() -> Validator {
    let schema = parsed();
    jsonschema::meta::validate(&schema).expect("a schema");
    jsonschema::validator_for(&schema).expect("a schema")
}

fn json_of(toml_text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(toml_text).unwrap()).unwrap()
}

fn to_toml(value: &Value) -> String {
    toml::to_string(value).unwrap()
}

#[test]
fn the_committed_schema_is_fresh() {
    let committed = std::fs::read_to_string(scenes().join("scene.schema.json")).unwrap();
    assert!(
        committed.trim_end() == schema(),
        "write it anew: cargo run -- scenes --schema > app/fluid/scenes/scene.schema.json"
    );
}

#[test]
fn every_shipped_scene_is_valid_and_names_the_schema() {
    let validator = validator();
    for (name, _) in shipped_scenes() {
        let text = std::fs::read_to_string(scenes().join(format!("{name}.toml"))).unwrap();
        assert!(text.starts_with("#:schema ./scene.schema.json\n"), "{name}: editors do not find the schema");
        let errors: Vec<String> = validator.iter_errors(&json_of(&text)).map(|error| error.to_string()).collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
        // With the defaults written out as well.
        let whole = json_of(&Scene::load(name, &[]).unwrap().to_toml());
        assert!(validator.is_valid(&whole), "{name}: {whole}");
    }
}

/// A scene with every field, as JSON.
fn full() -> Value {
    let text = "summary = \"all\"\nspacing_m = 0.5\ngravity_m_s2 = [0, -9.81, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [9, 9, 9]\n\
        walls = true\n[[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [4, 4, 4] }\n[[fluid]]\nsphere = { centre_m = [6, 6, 6], radius_m = 1 }\n\
        [camera]\neye_m = [20, 20, 20]\ntarget_m = [0, 0, 0]\n";
    let scene = Scene::from_toml(
        text,
        "full",
        &["solver.max_speed_m_s=9", "surface.iterations=3", "surface.absorption_per_m=[3, 1, 0.5]"].map(String::from),
    )
    .unwrap();
    json_of(&scene.to_toml())
}

/// Every place of the schema: its JSON pointer in a scene, and its part of the schema.
fn places(schema: &Value, scene: &Value, pointer: &str, found: &mut Vec<(String, Value)>) {
    found.push((pointer.to_owned(), schema.clone()));
    for (key, part) in schema["properties"].as_object().into_iter().flatten() {
        let inner = format!("{pointer}/{key}");
        if scene.pointer(&inner).is_some() {
            places(part, scene, &inner, found);
        }
    }
    if schema["items"].is_object() {
        for index in 0..scene.pointer(pointer).and_then(Value::as_array).map_or(0, Vec::len) {
            places(&schema["items"], scene, &format!("{pointer}/{index}"), found);
        }
    }
}

fn with(scene: &Value, pointer: &str, value: Value) -> Value {
    let mut changed = scene.clone();
    *changed.pointer_mut(pointer).unwrap() = value;
    changed
}

#[test]
fn schema_and_parser_refuse_the_same() {
    let (schema, validator, scene) = (parsed(), validator(), full());
    let load = |scene: &Value| Scene::from_toml(&to_toml(scene), "scene.toml", &[]).map_err(|error| error.to_string());
    assert!(validator.is_valid(&scene) && load(&scene).is_ok());
    let mut found = Vec::new();
    places(&schema, &scene, "", &mut found);
    let numbers = found.iter().filter(|(_, part)| part["minimum"].is_number()).count();
    assert!(found.len() > 50 && numbers > 30, "{} places, {numbers} numbers", found.len());
    let mut refused = 0;
    for (pointer, part) in found.iter().filter(|(pointer, _)| !pointer.is_empty()) {
        // Of another type each, or beyond the limits.
        let mut wrong = vec![json!([[1]]), json!({ "x": 1 }), json!([true, true, true])];
        match part["type"].as_str() {
            Some("string") => wrong.push(json!(5)),
            Some("boolean") => wrong.extend([json!("true"), json!(1)]),
            // Three switches are what it takes.
            Some("array") if part["items"]["type"] == "boolean" => {
                wrong.pop();
                wrong.extend([json!([true, true]), json!([true, true, 1]), json!(true)]);
            }
            _ => wrong.extend([json!("text"), json!(true)]),
        }
        for (limit, further) in [("minimum", -1.0), ("maximum", 1.0)] {
            if let Some(limit) = part[limit].as_f64() {
                let whole = part["type"] == "integer";
                let beyond = limit + further * if whole { 1.0 } else { 1e-3 * limit.abs().max(1e-3) };
                wrong.push(if whole { json!(beyond as i64) } else { json!(beyond) });
            }
        }
        for value in wrong {
            let changed = with(&scene, pointer, value.clone());
            assert!(!validator.is_valid(&changed), "{pointer} = {value} is valid");
            let message = load(&changed).expect_err(&format!("{pointer} = {value} is read"));
            assert!(message.contains("scene.toml"), "{message}");
            refused += 1;
        }
    }
    assert!(refused > 300, "{refused}");
    // Limits themselves are allowed by the schema, and refused by the parser for other reasons only.
    for (pointer, part) in found.iter().filter(|(_, part)| part["minimum"].is_number()) {
        for limit in ["minimum", "maximum"] {
            let changed = with(&scene, pointer, part[limit].clone());
            assert!(validator.is_valid(&changed), "{pointer}");
            if let Err(error) = load(&changed) {
                assert!(
                    !error.contains("must be a number") && !error.contains("must be a whole"),
                    "{pointer}: {error}"
                );
                assert!(!error.contains("must be three numbers"), "{pointer}: {error}");
            }
        }
    }
    // Keys: none is unknown to one of the two, and the same ones are needed.
    for (pointer, part) in found.iter().filter(|(_, part)| part["type"] == "object") {
        let mut changed = scene.clone();
        changed.pointer_mut(pointer).unwrap()["no_such_key"] = json!(1);
        assert!(!validator.is_valid(&changed) && load(&changed).is_err(), "{pointer}: an unknown key");
        for key in part["properties"].as_object().unwrap().keys() {
            let mut changed = scene.clone();
            if changed.pointer_mut(pointer).unwrap().as_object_mut().unwrap().remove(key).is_some() {
                let valid = validator.is_valid(&changed);
                assert_eq!(valid, load(&changed).is_ok(), "{pointer} without {key}");
            }
        }
    }
    // A fluid is one of the two.
    let both =
        with(&scene, "/fluid/0", json!({ "block": scene["fluid"][0]["block"], "sphere": scene["fluid"][1]["sphere"] }));
    assert!(!validator.is_valid(&both) && load(&both).is_err());
    // The comparison can fail: a schema without limits lets through what the parser refuses.
    let loose = jsonschema::validator_for(&json!({ "type": "object" })).unwrap();
    let absurd = with(&scene, "/spacing_m", json!(-1));
    assert!(loose.is_valid(&absurd) && load(&absurd).is_err());
}

#[test]
fn every_field_says_what_it_is() {
    let mut found = Vec::new();
    places(&parsed(), &full(), "", &mut found);
    for (pointer, part) in &found {
        let is_item = pointer.rsplit('/').next().is_some_and(|key| key.parse::<u8>().is_ok());
        assert!(is_item || part["description"].as_str().is_some_and(|text| text.len() > 5), "{pointer}: {part}");
        let unit = ["_m", "_s", "_deg", "_px", "seconds"].iter().any(|ending| pointer.ends_with(ending));
        if unit && part["minimum"].is_number() {
            let text = part["description"].as_str().unwrap();
            assert!([" m", " s", "degrees", "pixels"].iter().any(|unit| text.contains(unit)), "{pointer}: {text}");
        }
    }
}
