//! Damage that knows how an MCAP file is framed.

use rand::{Rng, RngExt};
use rand_chacha::ChaCha8Rng;

use brooklet_tests::captures::{CHUNK, framing, records};

/// Opcode of the record behind the last chunk, which has the checksum of all before it.
const DATA_END: u8 = 0x0f;

/// The capture with every checksum 0, which says that there is none.
pub fn without_checksums(bytes: &[u8]) -> Vec<u8> {
    let mut out = bytes.to_vec();
    let mut start = mcap::MAGIC.len();
    for record in records(bytes) {
        let body = start + 9;
        match record.opcode {
            // Behind start, end and size, 8 bytes each.
            CHUNK => out[body + 24..body + 28].fill(0),
            DATA_END => out[body..body + 4].fill(0),
            _ => {}
        }
        start = record.end;
    }
    out
}

/// `bytes` with a length, offset or time (little-endian, at any place) replaced by an awkward one.
pub fn replace_number(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    let mut out = bytes.to_vec();
    let numbers = [0, 1, 0xff, 0xffff, 0x7fff_ffff, 0xffff_ffff, 1 << 40, u64::MAX >> 1, u64::MAX, rng.next_u64()];
    let number = numbers[rng.random_range(0..numbers.len())].to_le_bytes();
    let width = [1, 2, 4, 8][rng.random_range(0..4)];
    // Half of them where a record's head is, which few places are.
    let mut heads = Vec::new();
    let mut end = mcap::MAGIC.len();
    while let Some((_, next)) = framing(bytes, end) {
        heads.push(end + 1);
        end = next;
    }
    let at = if rng.random_bool(0.5) && !heads.is_empty() {
        heads[rng.random_range(0..heads.len())]
    } else {
        rng.random_range(0..out.len().max(1))
    };
    let end = (at + width).min(out.len());
    if at < end {
        out[at..end].copy_from_slice(&number[..end - at]);
    }
    out
}

/// `bytes` with a piece of its JSON replaced by one of the same length.
pub fn replace_text(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    let mut out = bytes.to_vec();
    let colons: Vec<usize> =
        (1..out.len().saturating_sub(16)).filter(|at| out[*at] == b':' && out[*at - 1] == b'"').collect();
    let Some(at) = colons.get(rng.random_range(0..colons.len().max(1))) else { return out };
    let pieces: [&[u8]; 9] =
        [b"-1", b"null", b"1e999", b"\"\"", b"[[[[", b"{}", b"true", b"99999999999999999999", b"\"\\ud800\""];
    let piece = pieces[rng.random_range(0..pieces.len())];
    let end = (at + 1 + piece.len()).min(out.len());
    out[at + 1..end].copy_from_slice(&piece[..end - at - 1]);
    out
}
