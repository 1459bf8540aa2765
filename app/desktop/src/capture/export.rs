//! `brooklet capture export`.

use std::{
    collections::HashMap,
    fs::{self, File},
    io::BufWriter,
    path::{Path, PathBuf},
};

use brooklet_capture::{CaptureError, Item, Message, SPAN_TOPIC, SpanReader, chrome_trace, read_file};
use serde_json::{Map, Value};

use super::options::ExportOptions;
use crate::{failure::Failure, out_dir, out_dir::OutDir};

/// Writes what is asked for.
pub fn export(options: &ExportOptions) -> Result<(), Failure> {
    if let Some(folder) = &options.csv {
        let out = OutDir::create(folder)?;
        tables(&options.file, &out.path).inspect_err(|_| {
            // What is half there helps nobody; the folder is ours.
            let _ = fs::remove_dir_all(&out.path);
        })?;
        say!("tables    {}", out.path.display());
    }
    if let Some(path) = &options.chrome_trace {
        let events = trace(&options.file, path)?;
        say!("trace     {} ({events} events); ui.perfetto.dev opens it", path.display());
    }
    Ok(())
}

fn trace(file: &Path, path: &Path) -> Result<u64, Failure> {
    let folder = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let shown = path.display().to_string();
    let to = tempfile::Builder::new()
        .prefix(".brooklet-")
        .tempfile_in(folder)
        .map_err(|error| Failure::Input(format!("{shown}: cannot create: {error}")))?;
    let events = chrome_trace(file, BufWriter::new(to.as_file()), &shown).map_err(failure)?;
    out_dir::make_readable(to.as_file()).map_err(Failure::stopped)?;
    to.persist(path).map_err(|error| Failure::stopped(format_args!("{shown}: cannot be written: {}", error.error)))?;
    Ok(events)
}

fn failure(error: CaptureError) -> Failure {
    match error {
        CaptureError::Io { action: "write", .. } | CaptureError::Write { .. } => Failure::stopped(error),
        error => Failure::input(error),
    }
}

/// A table of each topic of JSON: a column a field, in the order of the schema; `/gpu/span` has a row a pass.
fn tables(file: &Path, folder: &Path) -> Result<(), Failure> {
    let mut tables =
        Tables { folder: folder.into(), files: HashMap::new(), spans: SpanReader::default(), failed: None };
    let read = read_file(file, &mut |item| match item {
        Item::Message(message) if message.channel.encoding == "json" => {
            let result = tables.row(message);
            result.map_err(|failure| {
                tables.failed.get_or_insert(failure);
                CaptureError::Stopped
            })
        }
        _ => Ok(()),
    });
    if let Some(failed) = tables.failed.take() {
        return Err(failed);
    }
    read.map_err(failure)?;
    tables.files.values_mut().try_for_each(|table| table.to.flush().map_err(|error| cannot(&table.path, &error)))
}

fn cannot(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::stopped(format_args!("{}: cannot be written: {error}", path.display()))
}

struct Table {
    path: PathBuf,
    columns: Vec<String>,
    to: csv::Writer<File>,
}

struct Tables {
    folder: PathBuf,
    /// By the channel's number.
    files: HashMap<u16, Table>,
    spans: SpanReader,
    failed: Option<Failure>,
}

impl Tables {
    fn row(&mut self, message: Message<'_>) -> Result<(), Failure> {
        let channel = message.channel;
        let input = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", channel.topic));
        if !self.files.contains_key(&channel.id) {
            let table = self.begin(message)?;
            self.files.insert(channel.id, table);
        }
        let Some(table) = self.files.get_mut(&channel.id) else { return Ok(()) };
        let path = table.path.clone();
        if channel.topic == SPAN_TOPIC {
            for span in self.spans.rows(message.data).map_err(|error| input(&error))? {
                let row = [
                    span.frame.to_string(),
                    span.recording,
                    span.stage,
                    span.begin_ticks.to_string(),
                    span.end_ticks.to_string(),
                    span.flag,
                ];
                table.to.write_record(row).map_err(|error| cannot(&path, &error))?;
            }
            return Ok(());
        }
        let row: Map<String, Value> = serde_json::from_slice(message.data).map_err(|error| input(&error))?;
        let log_time = Some(message.log_time.to_string());
        let cells = table.columns.iter().map(|column| match row.get(column) {
            None => String::new(),
            Some(Value::String(text)) => text.clone(),
            Some(value) => value.to_string(),
        });
        table.to.write_record(log_time.into_iter().chain(cells)).map_err(|error| cannot(&path, &error))
    }

    fn begin(&self, message: Message<'_>) -> Result<Table, Failure> {
        let channel = message.channel;
        let schema: Value = serde_json::from_slice(&channel.schema).unwrap_or_default();
        let columns: Vec<String> = match schema["properties"].as_object() {
            Some(properties) => properties.keys().cloned().collect(),
            None => Vec::new(),
        };
        // Letters and digits alone: a topic of another program may be called anything.
        let name: String = channel.topic.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        let name = name.trim_matches('-');
        let mut path = self.folder.join(format!("{name}.csv"));
        if path.exists() {
            path = self.folder.join(format!("{name}-{}.csv", self.files.len()));
        }
        let mut to = csv::Writer::from_path(&path).map_err(|error| cannot(&path, &error))?;
        if channel.topic == SPAN_TOPIC {
            to.write_record(["frame", "recording", "stage", "begin_ticks", "end_ticks", "flag"])
        } else {
            to.write_record(["log_time_ns"].into_iter().chain(columns.iter().map(String::as_str)))
        }
        .map_err(|error| cannot(&path, &error))?;
        Ok(Table { path, columns, to })
    }
}
