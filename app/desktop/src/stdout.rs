//! Standard output, whose end may be gone (`| head`) or full (`> file`): neither is a reason to
//! panic, as `println!` does.

use std::{
    fmt,
    io::{self, ErrorKind, Write},
    sync::Mutex,
};

use crate::failure::Failure;

/// The first error; nothing is written after it.
static TROUBLE: Mutex<Option<io::Error>> = Mutex::new(None);

/// Writes a line; use it through `say!`.
pub fn line(text: fmt::Arguments<'_>) {
    let mut trouble = TROUBLE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    if trouble.is_none() {
        *trouble = writeln!(io::stdout().lock(), "{text}").err();
    }
}

/// Flushes; says what could not be written. A reader that went away wanted no more.
pub fn finish() -> Result<(), Failure> {
    let trouble = TROUBLE.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).take();
    match trouble.or_else(|| io::stdout().lock().flush().err()) {
        Some(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::stopped(format_args!("standard output: cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// `println!` that does not panic; [`finish`] tells what went wrong.
macro_rules! say {
    () => { $crate::stdout::line(format_args!("")) };
    ($($text:tt)*) => { $crate::stdout::line(format_args!($($text)*)) };
}
