//! SPIR-V as a program carries it: the modules of one source file, which are much alike, as one deflated stream.

use std::borrow::Cow;

use miniz_oxide::inflate::decompress_to_vec;

/// The words of a module, little-endian, or where to find them.
#[derive(Clone, Copy, Debug)]
pub enum Spirv {
    /// As they are.
    Plain(&'static [u8]),
    /// Among those of a deflated stream (`build.rs`).
    Packed {
        /// The stream.
        pack: &'static [u8],
        /// Where they begin in what it holds.
        first: usize,
        /// How many bytes they have.
        bytes: usize,
    },
}

impl Spirv {
    /// The words. What is packed is inflated anew each time, half a megabyte at most: a driver takes longer to build it. Of
    /// a stream that cannot be read, or is too short, there are none.
    pub fn bytes(&self) -> Cow<'static, [u8]> {
        match *self {
            Self::Plain(bytes) => Cow::Borrowed(bytes),
            Self::Packed { pack, first, bytes } => {
                let whole = decompress_to_vec(pack).unwrap_or_default();
                Cow::Owned(whole.get(first..first + bytes).unwrap_or_default().to_vec())
            }
        }
    }

    /// How many bytes they are.
    pub fn len(&self) -> usize {
        match *self {
            Self::Plain(bytes) => bytes.len(),
            Self::Packed { bytes, .. } => bytes,
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::deflate::compress_to_vec;

    #[test]
    fn a_packed_module_is_what_was_packed() {
        let words: Vec<u8> = (0..4000_u32).flat_map(|n| (n * n).to_le_bytes()).collect();
        let pack: &'static [u8] = compress_to_vec(&words, 9).leak();
        let packed = Spirv::Packed { pack, first: 4000, bytes: 800 };
        assert_eq!(*packed.bytes(), words[4000..4800]);
        assert_eq!((packed.len(), packed.is_empty()), (800, false));
        // Beyond its end, cut off, or no stream at all.
        assert!(Spirv::Packed { pack, first: 15_600, bytes: 800 }.bytes().is_empty());
        assert!(Spirv::Packed { pack: &pack[..pack.len() / 2], first: 0, bytes: 800 }.bytes().is_empty());
        assert!(Spirv::Packed { pack: &[0xff; 64], first: 0, bytes: 4 }.bytes().is_empty());
        assert_eq!(*Spirv::Plain(&[1, 2]).bytes(), [1, 2]);
    }
}
