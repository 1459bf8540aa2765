//! What is wrong, as a case says it.
//!
//! A case ends at the first thing that is wrong by unwinding, without a message of its own (`resume_unwind`), to
//! [`crate::Device::run`], which catches it: a device that computes nonsense makes twins look up elements that are not
//! there as well, and both end alike.

use std::any::Any;
use std::cell::Cell;
use std::fmt::{self, Debug, Display};
use std::ops::{Deref, DerefMut};

/// A result that is not what it should be, or a device that gave none.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong(Box<Found>);

/// What is known of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// What was compared, as its case names it: a stage, mostly.
    pub of: String,
    /// Modules (kernel and variant) that made the result.
    pub modules: Vec<&'static str>,
    /// Which one of the results of a run is furthest off; `None` where it is not one of many.
    pub element: Option<usize>,
    /// How many of how many were beyond the tolerance, where all were looked at.
    pub beyond: Option<[usize; 2]>,
    /// What it should have been.
    pub expected: String,
    /// What it was.
    pub got: String,
    /// How far off it is and how far it may be, both relative to a scale of the case's; `None` for integers.
    pub difference: Option<[f64; 2]>,
    /// What else is to be said.
    pub note: String,
}

impl Wrong {
    /// Something that is not as it should be, in words.
    pub fn new(note: impl Into<String>) -> Self {
        Found { note: note.into(), ..Found::default() }.into()
    }

    /// The same of a stage.
    pub(crate) fn of(mut self, stage: &str) -> Self {
        self.of = stage.to_owned();
        self
    }

    /// The same, saying with what input.
    pub fn named(mut self, name: impl Display) -> Self {
        self.note = if self.note.is_empty() { name.to_string() } else { format!("{name}: {}", self.note) };
        self
    }
}

impl Deref for Wrong {
    type Target = Found;

    fn deref(&self) -> &Found {
        &self.0
    }
}

impl DerefMut for Wrong {
    fn deref_mut(&mut self) -> &mut Found {
        &mut self.0
    }
}

impl From<Found> for Wrong {
    fn from(found: Found) -> Self {
        Self(found.into())
    }
}

impl From<String> for Wrong {
    fn from(note: String) -> Self {
        Self::new(note)
    }
}

impl Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        if !self.of.is_empty() {
            parts.push(self.of.clone());
        }
        if !self.modules.is_empty() {
            parts.push(format!("by {}", self.modules.join(", ")));
        }
        if !self.note.is_empty() {
            parts.push(self.note.clone());
        }
        if !self.got.is_empty() || !self.expected.is_empty() {
            let element = self.element.map_or(String::new(), |element| format!("value {element}: "));
            parts.push(format!("{element}got {}, expected {}", self.got, self.expected));
        }
        if let Some([difference, tolerance]) = self.difference {
            parts.push(format!("off by {difference:.1e}, tolerance {tolerance:.1e}"));
        }
        if let Some([beyond, all]) = self.beyond {
            parts.push(format!("{beyond} of {all} are"));
        }
        f.write_str(&parts.join("; "))
    }
}

impl std::error::Error for Wrong {}

/// Why a case did not run.
pub(crate) struct Skipped(pub String);

thread_local! {
    /// Whether a case runs on this thread.
    pub(crate) static IN_CASE: Cell<bool> = const { Cell::new(false) };
}

/// Ends the case that runs; where none does, it panics.
pub(crate) fn raise(wrong: Wrong) -> ! {
    assert!(IN_CASE.get(), "{wrong}");
    std::panic::resume_unwind(Box::new(wrong))
}

/// Ends the case that runs as one that cannot be run here.
pub(crate) fn skip(reason: impl Into<String>) -> ! {
    std::panic::resume_unwind(Box::new(Skipped(reason.into())))
}

/// A value's text, short enough for a table.
pub(crate) fn shown<T: Debug + ?Sized>(value: &T) -> String {
    const MOST: usize = 160;
    let text = format!("{value:?}");
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// Takes what there should be, or ends the case.
pub(crate) trait OrRaise<T> {
    /// The value.
    fn or_raise(self) -> T;
}

impl<T, E: Display + 'static> OrRaise<T> for Result<T, E> {
    fn or_raise(self) -> T {
        self.unwrap_or_else(|error| match (&error as &dyn Any).downcast_ref::<Wrong>() {
            Some(wrong) => raise(wrong.clone()),
            None => raise(Wrong::new(error.to_string())),
        })
    }
}

impl<T> OrRaise<T> for Option<T> {
    fn or_raise(self) -> T {
        self.unwrap_or_else(|| raise(Wrong::new("there is none")))
    }
}

/// Takes what there should be, or ends the case, saying with what input.
pub(crate) trait Named<T> {
    /// The value.
    fn named(self, name: impl Display) -> T;
}

impl<T, E: Into<Wrong>> Named<T> for Result<T, E> {
    fn named(self, name: impl Display) -> T {
        self.unwrap_or_else(|error| raise(error.into().named(name)))
    }
}

/// Ends the case unless something holds.
macro_rules! ensure {
    ($holds:expr $(,)?) => { $crate::wrong::ensure!($holds, "not so: {}", stringify!($holds)) };
    ($holds:expr, $($said:tt)+) => {{
        let holds: bool = $holds;
        if !holds {
            $crate::wrong::raise($crate::wrong::Wrong::new(format!($($said)+)));
        }
    }};
}

/// Ends the case unless two values are equal.
macro_rules! ensure_eq {
    ($got:expr, $expected:expr $(,)?) => { $crate::wrong::ensure_eq!($got, $expected, "") };
    ($got:expr, $expected:expr, $($said:tt)+) => {
        match (&$got, &$expected) {
            (got, expected) => {
                if !(*got == *expected) {
                    let (got, expected) = ($crate::wrong::shown(got), $crate::wrong::shown(expected));
                    let note = format!($($said)+);
                    $crate::wrong::raise($crate::wrong::Found { got, expected, note, ..Default::default() }.into());
                }
            }
        }
    };
}

/// Keeps a line for who reads a test's output.
macro_rules! note {
    ($device:expr, $($said:tt)+) => { $device.note(format!($($said)+)) };
}

pub(crate) use {ensure, ensure_eq, note};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_told_with_all_that_is_known_of_it() {
        let wrong = Found {
            of: "predict".into(),
            modules: vec!["Predict+WALLS"],
            element: Some(7),
            beyond: Some([3, 64]),
            expected: "1.0".into(),
            got: "-1.0".into(),
            difference: Some([2.0, 1e-6]),
            note: String::new(),
        };
        let text = Wrong::from(wrong).named("a pool").to_string();
        assert_eq!(
            text,
            "predict; by Predict+WALLS; a pool; value 7: got -1.0, expected 1.0; off by 2.0e0, tolerance 1.0e-6; 3 of 64 are"
        );
    }

    #[test]
    fn what_ends_a_case_keeps_what_it_says() {
        IN_CASE.set(true);
        let ended = std::panic::catch_unwind(|| ensure_eq!(1 + 1, 3, "a sum")).unwrap_err();
        let wrong = ended.downcast::<Wrong>().unwrap();
        assert_eq!((wrong.got.as_str(), wrong.expected.as_str(), wrong.note.as_str()), ("2", "3", "a sum"));
        let nested: Result<(), Wrong> = Err(*wrong);
        let ended = std::panic::catch_unwind(|| nested.or_raise()).unwrap_err();
        assert_eq!(ended.downcast::<Wrong>().unwrap().got, "2");
        IN_CASE.set(false);
        assert!(shown(&"x".repeat(999)).len() < 200);
    }
}
