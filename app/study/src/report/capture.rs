//! The runs as MCAP: one message a run with its settings and figures, one a timed step. Runs follow each
//! other on one clock, which begins at 0: each lasts as long as its steps took on the GPU.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufWriter};

use mcap::records::MessageHeader;
use serde_json::{Value, json};

use super::Facts;
use crate::{Store, Task};

fn schema(title: &str, properties: Value) -> Vec<u8> {
    json!({ "title": title, "type": "object", "properties": properties }).to_string().into_bytes()
}

/// Writes them.
pub fn mcap(to: &mut File, tasks: &[Task], store: &Store, facts: &Facts) -> io::Result<()> {
    write(to, tasks, store, facts).map_err(io::Error::other)
}

fn write(to: &mut File, tasks: &[Task], store: &Store, facts: &Facts) -> mcap::McapResult<()> {
    let options = mcap::WriteOptions::new().profile("").library("brooklet study").compression(None);
    let mut writer = options.create(BufWriter::new(to))?;
    let run_schema = writer.add_schema(
        "brooklet.StudyRun",
        "jsonschema",
        &schema(
            "brooklet.StudyRun",
            json!({
                "run": { "type": "integer" }, "part": { "type": "string" }, "case": { "type": "string" },
                "settings": { "type": "string" }, "tier": { "type": "string" }, "state": { "type": "string" },
                "reason": { "type": "string" }, "particles": { "type": "integer" },
                "gpu_s_per_s": { "type": ["number", "null"] }, "error": { "type": ["number", "null"] },
                "figures": { "type": "object" },
            }),
        ),
    )?;
    let step_schema = writer.add_schema(
        "brooklet.StudyStep",
        "jsonschema",
        &schema("brooklet.StudyStep", json!({ "run": { "type": "integer" }, "step_ms": { "type": "number" } })),
    )?;
    let runs = writer.add_channel(run_schema, "/study/run", "json", &BTreeMap::new())?;
    let steps = writer.add_channel(step_schema, "/study/step", "json", &BTreeMap::new())?;
    let facts = BTreeMap::from([
        ("program".to_string(), facts.program.clone()),
        ("devices".to_string(), facts.devices.join("; ")),
    ]);
    writer.write_metadata(&mcap::records::Metadata { name: "build".into(), metadata: facts })?;
    let (mut at_ns, mut sequence) = (0_u64, 0_u32);
    for (run, task) in tasks.iter().enumerate() {
        let Some(outcome) = store.get(task) else { continue };
        let figures: serde_json::Map<String, Value> =
            outcome.figures.iter().map(|figure| (figure.name.clone(), json!(figure.value))).collect();
        let message = json!({
            "run": run, "part": task.part, "case": task.case, "settings": task.settings.join(" "),
            "tier": task.tier, "state": outcome.state.word(), "reason": outcome.reason,
            "particles": outcome.particles, "gpu_s_per_s": outcome.cost.map(|cost| cost.median_s_per_s),
            "error": outcome.error(), "figures": figures,
        });
        let mut put = |channel_id: u16, at_ns: u64, message: &Value| {
            let header = MessageHeader { channel_id, sequence, log_time: at_ns, publish_time: at_ns };
            sequence = sequence.wrapping_add(1);
            writer.write_to_known_channel(&header, message.to_string().as_bytes())
        };
        put(runs, at_ns, &message)?;
        for step_ms in &outcome.step_ms {
            at_ns += (step_ms.max(0.0) * 1e6) as u64;
            put(steps, at_ns, &json!({ "run": run, "step_ms": step_ms }))?;
        }
        at_ns += 1;
    }
    writer.finish()?;
    Ok(())
}
