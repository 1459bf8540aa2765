//! What is whole of a damaged or cut capture, as a file with a proper end.

use std::{
    collections::{BTreeMap, HashMap},
    io::{BufWriter, Write},
    path::Path,
};

use mcap::{WriteOptions, records::MessageHeader, records::Metadata, write::NoSeek};

use crate::{CaptureError, Ending, FORMAT_KEY, FORMAT_VERSION, Item, TOPICS, stream::read_file};

/// Writes everything whole of the capture `path` to `to`, chunk by chunk, with the messages as they were. The
/// metadata `recovered` says how much was lost.
///
/// # Errors
/// If `path` cannot be read or is no capture of this version, or if writing fails.
pub fn recover(path: &Path, to: impl Write, to_name: &str) -> Result<Ending, CaptureError> {
    let failed = |error: mcap::McapError| CaptureError::write(to_name, 0, error);
    let sink = NoSeek::new(BufWriter::new(to));
    let options = WriteOptions::new().compression(None).disable_seeking(true).chunk_size(None);
    let mut writer = options.library("brooklet-capture recover").create(sink).map_err(failed)?;
    let mut channels: HashMap<u16, u16> = HashMap::new();
    let mut sequence = 0_u32;
    let ending = read_file(path, &mut |item| {
        let written = match item {
            Item::Channel(channel) => {
                let schema = match channel.schema_encoding.as_str() {
                    "" => Ok(0),
                    encoding => writer.add_schema(&channel.schema_name, encoding, &channel.schema),
                };
                let is_ours = TOPICS.contains(&channel.topic.as_str());
                let version = is_ours.then(|| (FORMAT_KEY.to_string(), FORMAT_VERSION.to_string()));
                let version: BTreeMap<String, String> = version.into_iter().collect();
                schema.and_then(|schema| writer.add_channel(schema, &channel.topic, &channel.encoding, &version)).map(
                    |id| {
                        channels.insert(channel.id, id);
                    },
                )
            }
            Item::Message(message) => {
                let header = MessageHeader {
                    channel_id: channels.get(&message.channel.id).copied().unwrap_or(0),
                    sequence,
                    log_time: message.log_time,
                    publish_time: message.publish_time,
                };
                sequence = sequence.wrapping_add(1);
                writer.write_to_known_channel(&header, message.data)
            }
            Item::Metadata(name, fields) => {
                writer.write_metadata(&Metadata { name: name.into(), metadata: fields.clone() })
            }
            Item::Attachment(file) => writer.attach(&mcap::Attachment {
                log_time: 0,
                create_time: 0,
                name: file.name.clone(),
                media_type: file.media_type.clone(),
                data: file.data.as_slice().into(),
            }),
            Item::ChunkEnd => writer.flush(),
        };
        written.map_err(failed)
    })?;
    let lost = [
        ("damaged_bytes", ending.damaged_bytes),
        ("unnamed_messages", ending.unnamed_messages),
        ("chunks", ending.chunks),
        ("messages", ending.messages),
    ];
    let metadata = lost.map(|(key, count)| (key.to_string(), count.to_string())).into();
    writer.write_metadata(&Metadata { name: "recovered".into(), metadata }).map_err(failed)?;
    writer.finish().map_err(failed)?;
    let io = |source| CaptureError::Io { name: to_name.into(), action: "write", source };
    writer.into_inner().into_inner().flush().map_err(io)?;
    Ok(ending)
}
