//! What can go wrong with a capture, in words for the person who ran the program.

/// An error of writing or reading a capture.
#[derive(Debug, thiserror::Error)]
pub enum CaptureError {
    /// The file could not be created, opened or read.
    #[error("{name}: cannot {action}: {source}")]
    Io {
        /// The file.
        name: String,
        /// What was tried: `create`, `open`, `read`.
        action: &'static str,
        /// What the system said.
        source: std::io::Error,
    },
    /// Something else than a capture has the name that was given.
    #[error("{name}: cannot create: a file of that name is there, and is no capture; it is kept")]
    NotReplaced {
        /// The file.
        name: String,
    },
    /// Writing stopped. Returned once; what was written before stays readable.
    #[error(
        "{name}: the capture stopped after {frames} frames: {reason}; \
         what was written up to there stays readable"
    )]
    Write {
        /// The file.
        name: String,
        /// Frames given to the capture before this one.
        frames: u64,
        /// What the system, or the writer, said.
        reason: String,
    },
    /// The file is not MCAP at all.
    #[error("{name}: not an MCAP file: it starts with {found}, an MCAP file with 89 4d 43 41 50 30 0d 0a")]
    NotMcap {
        /// The file.
        name: String,
        /// Its first bytes in hex, or that it is empty.
        found: String,
    },
    /// A capture that another program compressed.
    #[error("{name}: its chunks are compressed with {compression}; `mcap decompress` makes one that can be read")]
    Compressed {
        /// The file.
        name: String,
        /// The compression.
        compression: String,
    },
    /// An MCAP file, but of another program.
    #[error(
        "{name}: an MCAP file without any topic of a capture (its topics: {topics}; \
         wanted: /gpu/frame, /gpu/passes or another of a capture's)"
    )]
    NotACapture {
        /// The file.
        name: String,
        /// The topics it has.
        topics: String,
    },
    /// A capture of another version of the format.
    #[error("{name}: {topic} has format version {found}, and this program reads version {}", crate::FORMAT_VERSION)]
    Version {
        /// The file.
        name: String,
        /// The topic.
        topic: String,
        /// Its version, or that it has none.
        found: String,
    },
    /// A message that does not fit its topic.
    #[error("{name}: message {index} of {topic}: {problem}")]
    Message {
        /// The file.
        name: String,
        /// The topic.
        topic: String,
        /// Which message of the topic, from 0.
        index: usize,
        /// What is wrong with it.
        problem: String,
    },
    /// Whoever took the pieces of a file wants no more, and knows why.
    #[error("reading was stopped")]
    Stopped,
    /// The caller gave another number of statistics than it declared.
    #[error("{name}: {given} statistics were given, {declared} are declared")]
    StatCount {
        /// The file.
        name: String,
        /// Values given.
        given: usize,
        /// Fields declared in the options.
        declared: usize,
    },
    /// Two statistics of one name, or one that the format uses itself.
    #[error("statistic `{field}`: {problem}")]
    StatField {
        /// The field.
        field: String,
        /// What is wrong with it.
        problem: &'static str,
    },
}

impl CaptureError {
    pub(crate) fn write(name: &str, frames: u64, error: mcap::McapError) -> Self {
        let reason = match error {
            // Its own text does not say which error.
            mcap::McapError::Io(error) => error.to_string(),
            other => other.to_string(),
        };
        Self::Write { name: name.into(), frames, reason }
    }
}
