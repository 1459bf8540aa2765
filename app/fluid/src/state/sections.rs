//! The sections of a saved state: what later versions add to, each with a name, a version and a length of its own.

/// A section's name: four ASCII characters.
pub(super) type Name = [u8; 4];

/// A program that does not know the section may go on without it.
const OPTIONAL: u16 = 1;
/// Name, version, flags, length.
const HEAD_BYTES: usize = 16;

/// A section that this program writes.
#[derive(Clone, Copy)]
pub(super) struct Known {
    pub name: Name,
    /// The newest that is read.
    pub version: u16,
    pub optional: bool,
}

impl Known {
    pub const fn new(name: &Name) -> Self {
        Self { name: *name, version: 1, optional: false }
    }
}

pub(super) struct Section<'a> {
    pub name: Name,
    pub version: u16,
    pub optional: bool,
    pub content: &'a [u8],
}

/// The file ends before byte `needed`.
pub(super) struct Cut {
    pub needed: usize,
}

/// Appends a section, whose content `write` appends.
pub(super) fn append(bytes: &mut Vec<u8>, known: Known, write: impl FnOnce(&mut Vec<u8>)) {
    let flags = if known.optional { OPTIONAL } else { 0 };
    bytes.extend_from_slice(&known.name);
    bytes.extend_from_slice(&known.version.to_le_bytes());
    bytes.extend_from_slice(&flags.to_le_bytes());
    let length_at = bytes.len();
    bytes.extend_from_slice(&[0; 8]);
    let start = bytes.len();
    write(bytes);
    let length = (bytes.len() - start) as u64;
    bytes[length_at..start].copy_from_slice(&length.to_le_bytes());
}

/// The sections of a file whose list of them, a count and so many sections, starts at byte `at`; and where it ends.
pub(super) fn read(file: &[u8], at: usize) -> Result<(Vec<Section<'_>>, usize), Cut> {
    let (count, mut at) = (u32::from_le_bytes(array(file, at)?), at + 4);
    let mut sections = Vec::new();
    for _ in 0..count {
        let name = array(file, at)?;
        let [version, flags] = [u16::from_le_bytes(array(file, at + 4)?), u16::from_le_bytes(array(file, at + 6)?)];
        let length = usize::try_from(u64::from_le_bytes(array(file, at + 8)?)).unwrap_or(usize::MAX);
        let content = slice(file, at + HEAD_BYTES, length)?;
        at += HEAD_BYTES + length;
        sections.push(Section { name, version, optional: flags & OPTIONAL != 0, content });
    }
    Ok((sections, at))
}

/// So many bytes of the file from byte `at` on.
pub(super) fn slice(file: &[u8], at: usize, length: usize) -> Result<&[u8], Cut> {
    let end = at.saturating_add(length);
    file.get(at..end).ok_or(Cut { needed: end })
}

fn array<const N: usize>(file: &[u8], at: usize) -> Result<[u8; N], Cut> {
    slice(file, at, N)?.try_into().map_err(|_| Cut { needed: at + N })
}
