//! What one plan has that another does not: numbers alone, which a running engine can take, or more.

use crate::plan::Plan;
use crate::recording::{Command, RecordingId};
use crate::resources::ResourceInfo;
use brooklet_kernels::{Module, ResourceId};
use std::sync::Arc;

/// An upload whose content is another in two plans that are the same in everything else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChangedUpload {
    /// The recording that uploads.
    pub recording: RecordingId,
    /// Where to.
    pub to: ResourceId,
    /// What the other plan uploads.
    pub data: Arc<[u8]>,
}

impl Plan {
    /// Whether nothing but the content of uploads is another in `other`: the same recordings of the same
    /// commands, modules, bindings, groups and targets, over the same resources, with the same outputs.
    pub fn differs_only_in_uploads(&self, other: &Plan) -> bool {
        self.changed_uploads(other).is_some()
    }

    /// The uploads whose content is another in `other`; `None` if the plans differ in anything else.
    pub fn changed_uploads(&self, other: &Plan) -> Option<Vec<ChangedUpload>> {
        if self.recordings.len() != other.recordings.len()
            || self.wanted != other.wanted
            || self.sharing != other.sharing
            || !self.memory().eq(other.memory())
        {
            return None;
        }
        let mut changed = Vec::new();
        for (one, another) in self.recordings.iter().zip(&other.recordings) {
            if one.id != another.id || one.commands.len() != another.commands.len() {
                return None;
            }
            for commands in one.commands.iter().zip(&another.commands) {
                match commands {
                    (Command::Upload { to, data }, Command::Upload { to: other_to, data: other_data }) => {
                        if to != other_to || data.len() != other_data.len() {
                            return None;
                        }
                        if data != other_data {
                            changed.push(ChangedUpload { recording: one.id, to: *to, data: other_data.clone() });
                        }
                    }
                    (one, another) if is_same(one, another) => {}
                    _ => return None,
                }
            }
        }
        Some(changed)
    }

    /// Takes the content of `other`'s uploads, which differs in nothing else.
    pub(crate) fn take_uploads(&mut self, other: &Plan) {
        for (one, another) in self.recordings.iter_mut().zip(&other.recordings) {
            for commands in one.commands.iter_mut().zip(&another.commands) {
                if let (Command::Upload { data, .. }, Command::Upload { data: other_data, .. }) = commands {
                    *data = other_data.clone();
                }
            }
        }
    }

    /// Takes `content` as what its uploads to a buffer hold; those of another length stay.
    pub(crate) fn set_uploads(&mut self, buffer: ResourceId, content: &[u8]) {
        for command in self.recordings.iter_mut().flat_map(|recording| &mut recording.commands) {
            if let Command::Upload { to, data } = command
                && *to == buffer
                && data.len() == content.len()
            {
                *data = content.into();
            }
        }
    }

    fn memory(&self) -> impl Iterator<Item = (ResourceId, &ResourceInfo)> {
        self.resources().iter().filter(|(id, _)| self.uses(*id))
    }
}

/// Whether two commands do the same; uploads are compared by the caller.
fn is_same(one: &Command, other: &Command) -> bool {
    match (one, other) {
        (Command::Clear { to }, Command::Clear { to: other_to }) => to == other_to,
        (Command::Forget { of }, Command::Forget { of: other_of }) => of == other_of,
        (Command::Copy { from, to, bytes }, Command::Copy { from: other_from, to: other_to, bytes: other_bytes }) => {
            (from, to, bytes) == (other_from, other_to, other_bytes)
        }
        (Command::Dispatch(one), Command::Dispatch(other)) => {
            is_same_module(one.module, other.module) && one.bindings == other.bindings && one.groups == other.groups
        }
        (Command::Draw(one), Command::Draw(other)) => {
            is_same_module(one.vertex, other.vertex)
                && match (one.fragment, other.fragment) {
                    (Some(one), Some(other)) => is_same_module(one, other),
                    (one, other) => one.is_none() && other.is_none(),
                }
                && one.bindings == other.bindings
                && one.targets == other.targets
                && one.state == other.state
                && (one.vertices, one.instances) == (other.vertices, other.instances)
        }
        _ => false,
    }
}

/// A module is its kernel and variant: one that was compiled anew while the program runs stands for the one before.
fn is_same_module(one: &Module, other: &Module) -> bool {
    one.name == other.name && one.bindings == other.bindings && one.group_size == other.group_size
}

#[cfg(test)]
#[path = "plan_difference_tests.rs"]
mod tests;
