//! Reads a capture piece by piece, in the order of the file, with one chunk in memory at a time. What is
//! damaged is left out and counted; every whole chunk is given.

use std::{
    collections::{BTreeMap, HashMap},
    fs::File,
    io::{Read, Seek, SeekFrom},
    path::Path,
    rc::Rc,
};

use mcap::{
    MAGIC,
    records::{Record, op},
};

use crate::{
    Attachment, CaptureError, FORMAT_KEY, FORMAT_VERSION, TOPICS,
    framing::{HEAD, chunk_records, compression},
    scan::Scan,
};

/// A topic as it is declared in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Its number in the file.
    pub id: u16,
    /// Its name.
    pub topic: String,
    /// How messages are written: `json` or `protobuf`.
    pub encoding: String,
    /// Name of the schema; empty without one.
    pub schema_name: String,
    /// How the schema is written: `jsonschema` or `protobuf`.
    pub schema_encoding: String,
    /// The schema.
    pub schema: Vec<u8>,
}

/// A piece of a capture.
#[derive(Debug)]
pub enum Item<'a> {
    /// A topic was declared, or another schema for it.
    Channel(&'a Channel),
    /// A message.
    Message(Message<'a>),
    /// Facts that hold for the whole run: a name, and texts by name.
    Metadata(&'a str, &'a BTreeMap<String, String>),
    /// A whole file.
    Attachment(&'a Attachment),
    /// A chunk was read to its end.
    ChunkEnd,
}

/// A message and where it belongs.
#[derive(Clone, Copy, Debug)]
pub struct Message<'a> {
    /// Its topic.
    pub channel: &'a Channel,
    /// When it is said to have been logged, Unix ns.
    pub log_time: u64,
    /// When it happened, Unix ns.
    pub publish_time: u64,
    /// Its content.
    pub data: &'a [u8],
}

/// How a file ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Ending {
    /// Whether it has its proper end and nothing in it is damaged.
    pub complete: bool,
    /// Whole chunks.
    pub chunks: u64,
    /// Messages given.
    pub messages: u64,
    /// Bytes that belong to nothing whole.
    pub damaged_bytes: u64,
    /// Messages whose topic only a damaged part of the file declares; they were not given.
    pub unnamed_messages: u64,
}

/// Reads the file `path`; see [`read`].
///
/// # Errors
/// As [`read`].
pub fn read_file(
    path: &Path,
    each: &mut dyn FnMut(Item<'_>) -> Result<(), CaptureError>,
) -> Result<Ending, CaptureError> {
    let name = path.display().to_string();
    let io = |action, source| CaptureError::Io { name: name.clone(), action, source };
    let file = File::open(path).map_err(|e| io("open", e))?;
    let about = file.metadata().map_err(|e| io("open", e))?;
    if !about.is_file() {
        return Err(io("read", std::io::Error::other("it is no file")));
    }
    // Without a buffer: chunks are read whole, and a buffer would be filled anew after each jump.
    read(file, about.len(), &name, each)
}

/// Reads a capture of `length` bytes from `from`; `name` is what errors call it. Gives each piece to `each`.
///
/// # Errors
/// If reading fails, if it is no capture of this version, or if `each` fails. Damage is no error.
pub fn read(
    mut from: impl Read + Seek,
    length: u64,
    name: &str,
    each: &mut dyn FnMut(Item<'_>) -> Result<(), CaptureError>,
) -> Result<Ending, CaptureError> {
    let io = |source| CaptureError::Io { name: name.into(), action: "read", source };
    let mut start = Vec::new();
    from.by_ref().take(MAGIC.len() as u64).read_to_end(&mut start).map_err(io)?;
    if start != MAGIC {
        return Err(not_mcap(name, &start));
    }
    let mut stream = Stream { name, known: HashMap::new(), schemas: HashMap::new(), ending: Ending::default(), each };
    if let Some(at) = summary_start(&mut from, length).map_err(io)? {
        let mut summary = Scan::new(&mut from, length);
        summary.go_to_summary(at);
        while let Some((opcode, body)) = summary.next().map_err(io)? {
            if matches!(opcode, op::SCHEMA | op::CHANNEL) {
                stream.declare(opcode, body, true)?;
            }
        }
    }
    let mut scan = Scan::new(&mut from, length);
    while let Some((opcode, body)) = scan.next().map_err(io)? {
        stream.record(opcode, body)?;
    }
    stream.ending.damaged_bytes = scan.damaged_bytes;
    stream.ending.complete = scan.is_complete() && stream.ending.unnamed_messages == 0;
    stream.end()
}

/// Where the file's end says that its summary begins; none of a summary that its checksum shows to be damaged: names
/// in it may be wrong.
fn summary_start(from: &mut (impl Read + Seek), length: u64) -> std::io::Result<Option<u64>> {
    const FOOTER: u64 = HEAD as u64 + 20;
    let Some(at) = length.checked_sub(FOOTER + MAGIC.len() as u64).filter(|at| *at > 0) else { return Ok(None) };
    let mut footer = [0; FOOTER as usize];
    from.seek(SeekFrom::Start(at))?;
    from.read_exact(&mut footer)?;
    let number = |place: usize| footer[place..place + 8].try_into().map_or(0, u64::from_le_bytes);
    let start = number(HEAD);
    if footer[0] != op::FOOTER || number(1) != 20 || start == 0 || start >= at {
        return Ok(None);
    }
    const CHECKSUM: usize = HEAD + 16;
    let stated = footer[CHECKSUM..].try_into().map_or(0, u32::from_le_bytes);
    let mut hasher = crc32fast::Hasher::new();
    let mut left = at - start;
    let mut piece = vec![0; 1 << 16];
    from.seek(SeekFrom::Start(start))?;
    while stated != 0 && left > 0 {
        let size = piece.len().min(usize::try_from(left).unwrap_or(usize::MAX));
        from.read_exact(&mut piece[..size])?;
        hasher.update(&piece[..size]);
        left -= size as u64;
    }
    hasher.update(&footer[..CHECKSUM]);
    Ok((stated == 0 || hasher.finalize() == stated).then_some(start))
}

struct Stream<'a> {
    name: &'a str,
    known: HashMap<u16, Known>,
    schemas: HashMap<u16, (mcap::records::SchemaHeader, Vec<u8>)>,
    ending: Ending,
    each: &'a mut dyn FnMut(Item<'_>) -> Result<(), CaptureError>,
}

struct Known {
    channel: Rc<Channel>,
    /// Told outside of chunks alone so far, as at the file's end, where nothing has a checksum.
    only_outside: bool,
}

impl Stream<'_> {
    /// A record outside of chunks, or a chunk.
    fn record(&mut self, opcode: u8, body: &[u8]) -> Result<(), CaptureError> {
        match opcode {
            op::CHUNK => {
                if let Some(compression) = compression(body) {
                    return Err(CaptureError::Compressed { name: self.name.into(), compression: compression.into() });
                }
                for (opcode, body) in chunk_records(body) {
                    match opcode {
                        op::MESSAGE => self.message(body)?,
                        _ => self.declare(opcode, body, false)?,
                    }
                }
                self.ending.chunks += 1;
                (self.each)(Item::ChunkEnd)
            }
            op::MESSAGE => self.message(body),
            // Outside of chunks nothing has a checksum: what a chunk declares goes before.
            op::SCHEMA | op::CHANNEL => self.declare(opcode, body, true),
            op::METADATA | op::ATTACHMENT => match mcap::parse_record(opcode, body) {
                Ok(Record::Metadata(record)) => (self.each)(Item::Metadata(&record.name, &record.metadata)),
                Ok(Record::Attachment { header, data, .. }) => {
                    let attachment =
                        Attachment { name: header.name, media_type: header.media_type, data: data.into_owned() };
                    (self.each)(Item::Attachment(&attachment))
                }
                // Its lengths agree; a text in it is damaged.
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    fn declare(&mut self, opcode: u8, body: &[u8], outside: bool) -> Result<(), CaptureError> {
        match mcap::parse_record(opcode, body) {
            Ok(Record::Schema { header, data }) => {
                if !outside || !self.schemas.contains_key(&header.id) {
                    self.schemas.insert(header.id, (header, data.into_owned()));
                }
                Ok(())
            }
            Ok(Record::Channel(record)) => {
                let version = record.metadata.get(FORMAT_KEY).map_or("none", String::as_str);
                if TOPICS.contains(&record.topic.as_str()) && version != FORMAT_VERSION {
                    if outside {
                        return Ok(());
                    }
                    return Err(CaptureError::Version {
                        name: self.name.into(),
                        topic: record.topic,
                        found: printable(version),
                    });
                }
                let schema = self.schemas.get(&record.schema_id);
                let channel = Rc::new(Channel {
                    id: record.id,
                    topic: record.topic,
                    encoding: record.message_encoding,
                    schema_name: schema.map_or_else(String::new, |(header, _)| header.name.clone()),
                    schema_encoding: schema.map_or_else(String::new, |(header, _)| header.encoding.clone()),
                    schema: schema.map_or_else(Vec::new, |(_, data)| data.clone()),
                });
                let before = self.known.get(&record.id).filter(|known| !known.only_outside);
                if let Some(before) = before {
                    let same = *before.channel == *channel;
                    return if same || outside { Ok(()) } else { Err(self.declared_twice(&channel)) };
                }
                if !outside {
                    (self.each)(Item::Channel(&channel))?;
                }
                self.known.insert(record.id, Known { channel, only_outside: outside });
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn message(&mut self, body: &[u8]) -> Result<(), CaptureError> {
        let Ok(Record::Message { header, data }) = mcap::parse_record(op::MESSAGE, body) else { return Ok(()) };
        let Some(known) = self.known.get_mut(&header.channel_id) else {
            self.ending.unnamed_messages += 1;
            return Ok(());
        };
        let channel = Rc::clone(&known.channel);
        if std::mem::take(&mut known.only_outside) {
            (self.each)(Item::Channel(&channel))?;
        }
        self.ending.messages += 1;
        (self.each)(Item::Message(Message {
            channel: &channel,
            log_time: header.log_time,
            publish_time: header.publish_time,
            data: &data,
        }))
    }

    fn declared_twice(&self, channel: &Channel) -> CaptureError {
        CaptureError::Message {
            name: self.name.into(),
            topic: printable(&channel.topic),
            index: 0,
            problem: format!("channel {} is declared twice, and differently", channel.id),
        }
    }

    fn end(self) -> Result<Ending, CaptureError> {
        let topics: std::collections::BTreeSet<&str> =
            self.known.values().map(|known| known.channel.topic.as_str()).collect();
        // A file cut before its first chunk has no topics yet, and is still a capture.
        if self.ending.complete && !topics.iter().any(|topic| TOPICS.contains(topic)) {
            let topics = topics.into_iter().collect::<Vec<_>>().join(", ");
            let topics = if topics.is_empty() { "none".into() } else { printable(&topics) };
            return Err(CaptureError::NotACapture { name: self.name.into(), topics });
        }
        Ok(self.ending)
    }
}

/// An error of a message, in words that fit a line.
pub(crate) fn message_problem(name: &str, topic: &str, index: usize, problem: &str) -> CaptureError {
    CaptureError::Message { name: name.into(), topic: printable(topic), index, problem: printable(problem) }
}

/// A name from the file, without what would break or colour the line of an error, and not too long for it.
pub(crate) fn printable(text: &str) -> String {
    const MOST: usize = 500;
    let shown = text.chars().take(MOST).map(|c| if c.is_control() { '\u{fffd}' } else { c });
    shown.chain((text.chars().count() > MOST).then_some('…')).collect()
}

fn not_mcap(name: &str, start: &[u8]) -> CaptureError {
    let found = if start.is_empty() {
        "nothing (it is empty)".into()
    } else {
        let hex: Vec<String> = start.iter().map(|byte| format!("{byte:02x}")).collect();
        hex.join(" ")
    };
    CaptureError::NotMcap { name: name.into(), found }
}
