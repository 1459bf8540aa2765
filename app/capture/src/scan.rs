//! Walks the records of a file, over damage: what is whole behind a damaged place is found again.
//!
//! Only chunks are looked for behind one: messages are in them, and they carry a checksum. One chunk is in
//! memory at a time.

use std::io::{self, ErrorKind, Read, Seek, SeekFrom};

use crc32fast::Hasher;
use mcap::{MAGIC, records::op};

use crate::framing::{HEAD, chunk_is_sound, head, is_known, is_of_summary, is_sound};

/// A record larger than this is taken for damage: nothing of a capture comes near it.
const MOST_BYTES: u64 = 256 << 20;
/// What is looked through at a time.
const WINDOW: usize = 1 << 16;
/// Bytes of a chunk before its records, with an empty name of the compression.
const CHUNK_HEAD: usize = HEAD + 40;

/// The records of `from`, which is at its start.
pub(crate) struct Scan<R> {
    from: R,
    length: u64,
    at: u64,
    body: Vec<u8>,
    /// Of the data section so far; none once something is damaged.
    hasher: Option<Hasher>,
    /// Bytes that belong to no whole record.
    pub damaged_bytes: u64,
    /// Whether the proper end was reached, and that of the data before it.
    pub ended: bool,
    data_ended: bool,
    /// Whether a whole chunk was read.
    has_chunks: bool,
    /// Whether the summary alone is read.
    is_summary: bool,
}

impl<R: Read + Seek> Scan<R> {
    /// Behind the magic bytes, which were looked at already.
    pub fn new(from: R, length: u64) -> Self {
        let mut hasher = Hasher::new();
        hasher.update(MAGIC);
        Self {
            from,
            length,
            at: MAGIC.len() as u64,
            body: Vec::new(),
            hasher: Some(hasher),
            damaged_bytes: 0,
            ended: false,
            data_ended: false,
            has_chunks: false,
            is_summary: false,
        }
    }

    /// The next whole record: its kind and content. None at the end.
    pub fn next(&mut self) -> io::Result<Option<(u8, &[u8])>> {
        while !self.ended && self.at < self.length {
            match self.record()? {
                Some(op::DATA_END) => self.end_data(),
                Some(op::FOOTER) => self.end()?,
                Some(opcode) => return Ok(Some((opcode, &self.body))),
                None => self.skip_damage()?,
            }
        }
        Ok(None)
    }

    /// Goes to where the summary begins.
    pub fn go_to_summary(&mut self, at: u64) {
        self.at = at;
        self.is_summary = true;
        self.hasher = None;
    }

    /// Whether nothing was damaged, and the end is there.
    pub fn is_complete(&self) -> bool {
        self.ended && self.data_ended && self.damaged_bytes == 0
    }

    /// Reads the record at the place where we are into the buffer, and goes behind it; none if there is
    /// no whole one.
    fn record(&mut self) -> io::Result<Option<u8>> {
        let Some((opcode, end)) = self.head_at(self.at)? else { return Ok(None) };
        let length = end - self.at - HEAD as u64;
        if length > MOST_BYTES {
            return Ok(None);
        }
        self.body.clear();
        (&mut self.from).take(length).read_to_end(&mut self.body)?;
        let is_whole = match opcode {
            op::CHUNK => chunk_is_sound(&self.body),
            // One flipped bit makes a MessageIndex (7), which stands behind each chunk, a Message (5): files with
            // chunks have their messages in them.
            op::MESSAGE => !self.has_chunks && is_sound(opcode, &self.body),
            // Elsewhere, either is what damage made of another record's kind.
            op::DATA_END => length == 4,
            op::FOOTER => length == 20 && end + MAGIC.len() as u64 == self.length,
            _ if is_of_summary(opcode) => self.data_ended || self.is_summary,
            _ => is_known(opcode) && is_sound(opcode, &self.body),
        };
        if self.body.len() as u64 != length || !is_whole {
            return Ok(None);
        }
        self.has_chunks |= opcode == op::CHUNK;
        if let Some(hasher) = self.hasher.as_mut().filter(|_| opcode != op::DATA_END) {
            hasher.update(&[opcode]);
            hasher.update(&length.to_le_bytes());
            hasher.update(&self.body);
        }
        self.at += HEAD as u64 + length;
        Ok(Some(opcode))
    }

    /// The checksum over all before it tells damage that nothing else does: in metadata, say.
    fn end_data(&mut self) {
        self.data_ended = true;
        let stated = self.body.first_chunk().map_or(0, |bytes| u32::from_le_bytes(*bytes));
        let counted = self.hasher.take().map(Hasher::finalize);
        if stated != 0 && counted.is_some_and(|counted| counted != stated) {
            self.damaged_bytes += 1;
        }
    }

    fn end(&mut self) -> io::Result<()> {
        self.ended = true;
        let mut magic = Vec::new();
        (&mut self.from).take(MAGIC.len() as u64 + 1).read_to_end(&mut magic)?;
        self.damaged_bytes += u64::from(magic != MAGIC);
        Ok(())
    }

    /// Goes on behind a record that is not whole: where its length says, if a record begins there, or at the
    /// next whole chunk.
    fn skip_damage(&mut self) -> io::Result<()> {
        let from = self.at;
        self.hasher = None;
        self.at = match self.end_by_length()? {
            Some(end) => end,
            None => self.next_chunk(from + 1)?.unwrap_or(self.length),
        };
        self.damaged_bytes += self.at - from;
        Ok(())
    }

    /// Where the damaged record here ends, if its length leads to two whole heads in a row, or to the footer.
    fn end_by_length(&mut self) -> io::Result<Option<u64>> {
        let Some((_, end)) = self.head_at(self.at)? else { return Ok(None) };
        let Some((opcode, next)) = self.head_at(end)?.filter(|(opcode, _)| is_known(*opcode)) else { return Ok(None) };
        if opcode == op::FOOTER || next == self.length {
            return Ok(Some(end));
        }
        Ok(self.head_at(next)?.filter(|(opcode, _)| is_known(*opcode)).map(|_| end))
    }

    /// The kind of record that is said to be at `at`, and where it is said to end, if that is in the file.
    fn head_at(&mut self, at: u64) -> io::Result<Option<(u8, u64)>> {
        let mut start = [0; HEAD];
        if self.read_at(at, &mut start)? < HEAD {
            return Ok(None);
        }
        let (opcode, length) = head(&start);
        let end = at.checked_add(HEAD as u64).and_then(|body| body.checked_add(length));
        Ok(end.filter(|end| *end <= self.length).map(|end| (opcode, end)))
    }

    /// The first whole chunk at or behind `from`.
    fn next_chunk(&mut self, mut from: u64) -> io::Result<Option<u64>> {
        let mut window = vec![0; WINDOW];
        loop {
            let read = self.read_at(from, &mut window)?;
            if read < CHUNK_HEAD {
                return Ok(None);
            }
            for offset in 0..=read - CHUNK_HEAD {
                let left = self.length.saturating_sub(from + offset as u64);
                if looks_like_chunk(&window[offset..offset + CHUNK_HEAD], left)
                    && self.is_chunk(from + offset as u64)?
                {
                    return Ok(Some(from + offset as u64));
                }
            }
            from += (read - CHUNK_HEAD + 1) as u64;
        }
    }

    fn is_chunk(&mut self, at: u64) -> io::Result<bool> {
        let back = std::mem::replace(&mut self.at, at);
        let found = self.record()?;
        self.at = back;
        Ok(found == Some(op::CHUNK))
    }

    fn read_at(&mut self, at: u64, into: &mut [u8]) -> io::Result<usize> {
        self.from.seek(SeekFrom::Start(at))?;
        let mut filled = 0;
        while filled < into.len() {
            match self.from.read(&mut into[filled..]) {
                Ok(0) => break,
                Ok(read) => filled += read,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(filled)
    }
}

/// The cheap half of what a whole chunk is: its lengths agree. `rest` is what the file has from here on.
fn looks_like_chunk(start: &[u8], rest: u64) -> bool {
    let number = |at: usize| start[at..at + 8].try_into().map_or(0, u64::from_le_bytes);
    let length = number(1);
    start[0] == op::CHUNK
        && length.checked_sub(40).is_some_and(|records| records == number(HEAD + 32))
        && start[HEAD + 28..HEAD + 32] == [0; 4]
        && length <= rest.min(MOST_BYTES)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    #[test]
    fn a_file_that_grows_behind_damage_is_read_to_the_end_that_it_had() {
        let mut bytes = MAGIC.to_vec();
        bytes.extend((0..3 * WINDOW as u32 / 4).flat_map(u32::to_be_bytes));
        let length = (MAGIC.len() + WINDOW / 2) as u64;
        let mut scan = Scan::new(Cursor::new(bytes), length);
        while scan.next().unwrap().is_some() {}
        assert!(!scan.ended && scan.damaged_bytes > 0);
    }
}
