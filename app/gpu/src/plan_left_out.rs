//! What the sweep left out, by name and with its reason.

use crate::planned::{PlannedRecording, describe};
use crate::recording::{Command, Touch};
use crate::resources::Resources;
use brooklet_kernels::ResourceId;
use std::collections::{BTreeMap, BTreeSet};

/// What kind of thing was left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftOutKind {
    /// A dispatch or draw, named by its stage.
    Stage,
    /// An upload, clear or copy, named by what it does (`clear counts`).
    Command,
    /// A buffer, which is not allocated.
    Buffer,
    /// A texture, which is not allocated.
    Texture,
}

/// Something that the sweep left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: LeftOutKind,
    /// Memory that is saved; 0 for stages and commands.
    pub bytes: u64,
    /// Why: `nothing wanted reads density_ratio`.
    pub reason: String,
}

pub(crate) fn list_left_out(
    resources: &Resources,
    planned: &[PlannedRecording],
    dropped: &[Command],
    used: &BTreeSet<ResourceId>,
) -> Vec<LeftOut> {
    let label = |id: &ResourceId| resources.label(*id).to_owned();
    // By name: a stage dropped forty times is one thing left out.
    let mut commands: BTreeMap<(LeftOutKind, String), BTreeSet<ResourceId>> = BTreeMap::new();
    let mut order = Vec::new();
    let mut users: BTreeMap<ResourceId, BTreeSet<String>> = BTreeMap::new();
    for command in dropped {
        let name = describe(resources, command);
        let kind = match command.stage() {
            Some(_) => LeftOutKind::Stage,
            None => LeftOutKind::Command,
        };
        let key = (kind, name.clone());
        if !commands.contains_key(&key) {
            order.push(key.clone());
        }
        let outputs = commands.entry(key).or_default();
        for (id, touch) in command.touches() {
            users.entry(id).or_default().insert(name.clone());
            if touch != Touch::Read {
                outputs.insert(id);
            }
        }
    }
    let kept: BTreeSet<&str> =
        planned.iter().flat_map(|recording| &recording.commands).filter_map(Command::stage).collect();
    order.sort_by_key(|(kind, _)| *kind);
    let mut left_out = Vec::new();
    for key in order {
        let outputs = &commands[&key];
        let names: Vec<String> = outputs.iter().map(label).collect();
        let reason = match (names.as_slice(), kept.contains(key.1.as_str())) {
            ([], _) => "it writes nothing".to_owned(),
            (names, false) => format!("nothing wanted reads {}", names.join(" or ")),
            (names, true) => format!("some of its runs: nothing wanted reads {} then", names.join(" or ")),
        };
        left_out.push(LeftOut { name: key.1, kind: key.0, bytes: 0, reason });
    }
    let mut memory: Vec<LeftOut> = resources
        .iter()
        .filter(|(id, _)| !used.contains(id))
        .map(|(id, entry)| LeftOut {
            name: entry.label.clone(),
            kind: if entry.is_texture() { LeftOutKind::Texture } else { LeftOutKind::Buffer },
            bytes: entry.bytes(),
            reason: match users.get(&id) {
                Some(users) => format!("only left out: {}", users.iter().cloned().collect::<Vec<_>>().join(", ")),
                None => "nothing recorded uses it".to_owned(),
            },
        })
        .collect();
    memory.sort_by_key(|entry| entry.kind);
    left_out.extend(memory);
    left_out
}
