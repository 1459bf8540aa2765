//! Checks that lengths inside a file are those of what is there, before anything is made that
//! large: the MCAP library allocates what a text's length says, and trusts that a chunk's records
//! end where the chunk does.

use mcap::records::op;

/// Bytes of a record before its content: its kind and its length.
pub(crate) const HEAD: usize = 9;

/// A record's kind and length.
pub(crate) fn head(bytes: &[u8; HEAD]) -> (u8, u64) {
    let [opcode, length @ ..] = bytes;
    (*opcode, u64::from_le_bytes(*length))
}

/// Whether captures have records of this kind.
pub(crate) fn is_known(opcode: u8) -> bool {
    matches!(opcode, op::HEADER..=op::DATA_END)
}

/// Whether records of this kind stand behind the data alone, where chunks and messages do not.
pub(crate) fn is_of_summary(opcode: u8) -> bool {
    matches!(opcode, op::CHUNK_INDEX | op::ATTACHMENT_INDEX | op::STATISTICS | op::METADATA_INDEX | op::SUMMARY_OFFSET)
}

/// The records of a chunk that is sound and not compressed.
pub(crate) fn chunk_records(chunk: &[u8]) -> impl Iterator<Item = (u8, &[u8])> {
    let mut rest = Rest(chunk_content(chunk).unwrap_or_default());
    std::iter::from_fn(move || rest.record())
}

fn chunk_content(chunk: &[u8]) -> Option<&[u8]> {
    let mut rest = Rest(chunk);
    rest.skip(28)?;
    rest.text()?;
    let length = u64::from_le_bytes(rest.take(8)?.try_into().ok()?);
    (rest.0.len() as u64 == length).then_some(rest.0)
}

/// Whether a chunk is whole: its lengths agree, and its checksum, where it has one, is that of its records.
/// Of a compressed one only the lengths are looked at.
pub(crate) fn chunk_is_sound(chunk: &[u8]) -> bool {
    let Some(content) = chunk_content(chunk) else { return false };
    if compression(chunk).is_some() {
        return true;
    }
    let number =
        |at: usize, width: usize| chunk[at..at + width].iter().rev().fold(0_u64, |n, b| n << 8 | u64::from(*b));
    let (size, checksum) = (number(16, 8), number(24, 4) as u32);
    size == content.len() as u64
        && chunk[28..32] == [0; 4]
        && (checksum == 0 || crc32fast::hash(content) == checksum)
        && is_sound_chunk(content)
}

/// Whether the texts and tables of a record end inside it, and fill it: a damaged length would swallow what
/// follows. Kinds that are of the summary alone are not looked into.
pub(crate) fn is_sound(opcode: u8, body: &[u8]) -> bool {
    let mut rest = Rest(body);
    let mut parts = || -> Option<()> {
        match opcode {
            op::HEADER => rest.text().and_then(|()| rest.text()),
            op::SCHEMA => rest.skip(2).and_then(|()| rest.text()).and_then(|()| rest.text()).and_then(|()| rest.text()),
            op::CHANNEL => {
                rest.skip(4).and_then(|()| rest.text()).and_then(|()| rest.text()).and_then(|()| rest.table())
            }
            op::MESSAGE_INDEX => rest.skip(2).and_then(|()| rest.text()),
            op::METADATA => rest.text().and_then(|()| rest.table()),
            op::ATTACHMENT => {
                rest.skip(16).and_then(|()| rest.text()).and_then(|()| rest.text())?;
                let length = u64::from_le_bytes(rest.take(8)?.try_into().ok()?);
                rest.skip(usize::try_from(length).ok()?).and_then(|()| rest.skip(4))
            }
            _ => rest.skip(body.len()),
        }
    };
    parts().is_some() && rest.0.is_empty()
}

/// The compression that a sound chunk names, if it is one that other programs use.
pub(crate) fn compression(chunk: &[u8]) -> Option<&str> {
    let mut rest = Rest(chunk);
    rest.skip(28)?;
    let name = std::str::from_utf8(rest.sized()?).ok()?;
    matches!(name, "zstd" | "lz4").then_some(name)
}

/// Whether a chunk's uncompressed content is whole, sound records of the kinds that may be in one.
fn is_sound_chunk(content: &[u8]) -> bool {
    let mut rest = Rest(content);
    while !rest.0.is_empty() {
        let Some((opcode, body)) = rest.record() else { return false };
        if !matches!(opcode, op::SCHEMA | op::CHANNEL | op::MESSAGE) || !is_sound(opcode, body) {
            return false;
        }
    }
    true
}

/// What is not looked at yet.
struct Rest<'a>(&'a [u8]);

impl<'a> Rest<'a> {
    fn take(&mut self, length: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        Some(taken)
    }

    fn skip(&mut self, length: usize) -> Option<()> {
        self.take(length).map(|_| ())
    }

    /// Bytes behind their number.
    fn sized(&mut self) -> Option<&'a [u8]> {
        let length = u32::from_le_bytes(self.take(4)?.try_into().ok()?);
        self.take(length as usize)
    }

    fn text(&mut self) -> Option<()> {
        self.sized().map(|_| ())
    }

    fn table(&mut self) -> Option<()> {
        let mut entries = Rest(self.sized()?);
        while !entries.0.is_empty() {
            entries.text()?;
            entries.text()?;
        }
        Some(())
    }

    fn record(&mut self) -> Option<(u8, &'a [u8])> {
        let [opcode] = *self.take(1)? else { return None };
        let length = u64::from_le_bytes(self.take(8)?.try_into().ok()?);
        Some((opcode, self.take(usize::try_from(length).ok()?)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(text: &str) -> Vec<u8> {
        [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat()
    }

    #[test]
    fn lengths_must_end_inside() {
        let metadata = [text("device"), text(&String::from_utf8([text("a"), text("b")].concat()).unwrap())].concat();
        assert!(is_sound(op::METADATA, &metadata));
        for cut in 0..metadata.len() {
            assert!(!is_sound(op::METADATA, &metadata[..cut]), "cut at {cut}");
        }
        let mut long = metadata;
        long[3] = 0x7f;
        assert!(!is_sound(op::METADATA, &long), "2 GB of text in {} bytes", long.len());
    }

    #[test]
    fn a_chunk_is_its_records() {
        let record = |length: u64| [&[op::MESSAGE][..], &length.to_le_bytes(), &[0; 4]].concat();
        assert!(is_sound_chunk(&[]) && is_sound_chunk(&[record(4), record(4)].concat()));
        let mut other = record(4);
        other[0] = op::METADATA_INDEX;
        assert!(!is_sound_chunk(&other), "a kind of record that no chunk has");
        assert!(!is_sound_chunk(&record(5)) && !is_sound_chunk(&record(3)) && !is_sound_chunk(&record(u64::MAX)));
    }
}
