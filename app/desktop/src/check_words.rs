//! The names of cases and verdicts, as a table and a capture have them.

use brooklet_check::{KnownAnswer, ModuleVerdict};

pub fn title(known: &KnownAnswer) -> String {
    format!("{}: {}", known.room, known.name.replace('_', " "))
}

pub fn verdict_name(verdict: ModuleVerdict) -> &'static str {
    match verdict {
        ModuleVerdict::Right => "right",
        ModuleVerdict::Wrong => "WRONG",
        ModuleVerdict::NotChecked => "not checked",
    }
}
