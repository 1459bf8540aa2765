//! What the window has to say, for as long as it takes to read.

use std::time::{Duration, Instant};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Something was done.
    Done,
    /// Something is not as asked for.
    Warning,
    /// Something went wrong.
    Error,
}

/// Something said.
#[derive(Clone, Debug)]
pub struct Message {
    /// How bad it is.
    pub kind: Kind,
    /// What.
    pub text: String,
    said: Instant,
}

/// What was said lately.
#[derive(Debug, Default)]
pub struct Messages {
    latest: Vec<Message>,
    unlogged: Vec<(Kind, String)>,
}

/// More than these hide what they tell of.
const MOST: usize = 4;
const LASTS: Duration = Duration::from_secs(6);
const ERROR_LASTS: Duration = Duration::from_secs(15);

impl Messages {
    /// Says it.
    pub fn notify(&mut self, kind: Kind, text: impl Into<String>) {
        let text = text.into();
        self.unlogged.push((kind, text.clone()));
        self.latest.retain(|message| message.text != text);
        if self.latest.len() == MOST {
            self.latest.remove(0);
        }
        self.latest.push(Message { kind, text, said: Instant::now() });
    }

    /// Says no longer what begins with these words.
    pub fn withdraw(&mut self, start: &str) {
        self.latest.retain(|message| !message.text.starts_with(start));
    }

    /// What there is to read, the oldest first.
    pub fn latest(&self) -> &[Message] {
        &self.latest
    }

    /// Drops what was read; whether something is left.
    pub fn fade(&mut self) -> bool {
        let lasts = |kind| if kind == Kind::Error { ERROR_LASTS } else { LASTS };
        self.latest.retain(|message| message.said.elapsed() < lasts(message.kind));
        !self.latest.is_empty()
    }

    /// What was said since the last call, for a log.
    pub fn take_unlogged(&mut self) -> Vec<(Kind, String)> {
        std::mem::take(&mut self.unlogged)
    }
}
