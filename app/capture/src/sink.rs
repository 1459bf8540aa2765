//! The byte sink under a capture: after its first failure it takes nothing more.
//!
//! Without this, a write that fails halfway through a record and succeeds later (somebody freed
//! space) would leave a hole in the middle of the file, and a reader could not go on behind it.

use std::io::{Error, ErrorKind, Result, Write};

/// Passes bytes on until the first failure, then refuses every further write.
pub(crate) struct StickySink<W> {
    inner: W,
    failed: bool,
}

impl<W> StickySink<W> {
    pub(crate) fn new(inner: W) -> Self {
        Self { inner, failed: false }
    }
}

impl<W: Write> StickySink<W> {
    fn guard<T>(&mut self, run: impl FnOnce(&mut W) -> Result<T>) -> Result<T> {
        if self.failed {
            return Err(Error::other("an earlier write failed"));
        }
        let result = run(&mut self.inner);
        if let Err(error) = &result {
            // An interrupted call wrote nothing and is repeated by `write_all`.
            self.failed = error.kind() != ErrorKind::Interrupted;
        }
        result
    }
}

impl<W: Write> Write for StickySink<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        self.guard(|inner| inner.write(bytes))
    }

    fn flush(&mut self) -> Result<()> {
        self.guard(Write::flush)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct FailsOnce(u32);

    impl Write for FailsOnce {
        fn write(&mut self, bytes: &[u8]) -> Result<usize> {
            self.0 += 1;
            if self.0 == 2 {
                return Err(Error::from(ErrorKind::StorageFull));
            }
            Ok(bytes.len())
        }
        fn flush(&mut self) -> Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_failure_is_final() {
        let mut sink = StickySink::new(FailsOnce(0));
        assert!(sink.write_all(b"whole").is_ok());
        assert!(sink.write_all(b"torn").is_err());
        assert!(sink.write_all(b"after the hole").is_err());
        assert!(sink.flush().is_err());
        assert_eq!(sink.inner.0, 2, "nothing reached the disk after it failed");
    }
}
