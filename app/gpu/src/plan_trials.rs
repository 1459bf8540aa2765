//! What holds a plan's sharing of memory against what it has to be: for tests.

use crate::order::encoding_order;
use crate::plan::Plan;
use crate::planned::{describe, is_forgotten};
use crate::recording::{Command, Touch};
use crate::sharing::Sharing;
use brooklet_kernels::ResourceId;
use std::collections::{BTreeMap, BTreeSet};

/// Not a number as a float, far beyond any count or index as an integer.
const GARBAGE: u32 = 0x7fc5_a5a5;

impl Plan {
    /// The same with memory of its own for each buffer.
    pub fn without_sharing(mut self) -> Plan {
        self.sharing = Sharing::default();
        self
    }

    /// The same without sharing, and with garbage in each buffer whose content a recording says that nobody needs: in
    /// transients where it begins and where it forgets them, in others where it forgets those. Whatever it then computes
    /// otherwise, it computes from what is not needed.
    pub fn with_garbage(self) -> Plan {
        let mut plan = self.without_sharing();
        let resources = &plan.resources;
        let upload = |id: &ResourceId| {
            let words = resources.bytes(*id).div_ceil(4) as usize;
            Command::Upload { to: *id, data: bytemuck::cast_slice(&vec![GARBAGE; words]).into() }
        };
        for recording in &mut plan.recordings {
            let touched = |commands: &[Command]| -> BTreeSet<ResourceId> {
                let ids = commands.iter().flat_map(Command::touches).map(|(id, _)| id);
                ids.filter(|id| resources.get(*id).is_some_and(|entry| !entry.is_texture() && entry.bytes() > 0))
                    .collect()
            };
            let commands = std::mem::take(&mut recording.commands);
            let transients = touched(&commands).into_iter().filter(|id| is_forgotten(resources, None, *id));
            let mut with: Vec<Command> = transients.map(|id| upload(&id)).collect();
            for (index, command) in commands.iter().enumerate() {
                with.push(command.clone());
                if let Command::Forget { of } = command {
                    // What is not touched again is an output, or state that stays as it is.
                    let later = touched(&commands[index + 1..]);
                    with.extend(later.iter().filter(|id| is_forgotten(resources, *of, **id)).map(upload));
                }
            }
            recording.commands = with;
        }
        plan
    }

    /// The first command that finds another buffer's content where its own is to be, if one does: a second reckoning of
    /// what the sharing of memory is to prevent, command by command, with what each memory holds.
    pub fn first_clobbered(&self) -> Option<String> {
        let states: Vec<ResourceId> =
            self.buffers().iter().map(|b| b.id).filter(|id| self.resources.get(*id).is_some_and(|r| r.state)).collect();
        for recording in &self.recordings {
            let name = recording.id.label();
            let mut holder: BTreeMap<ResourceId, ResourceId> = BTreeMap::new();
            // Of what is in memory is needed.
            let mut begun: BTreeSet<ResourceId> = BTreeSet::new();
            for state in &states {
                begun.insert(*state);
                if holder.insert(self.sharing.memory(*state), *state).is_some() {
                    return Some(format!("{name} begins: {}", self.resources.label(*state)));
                }
            }
            // Of a command, and of draws that may share a render pass.
            let mut bound: BTreeMap<ResourceId, ResourceId> = BTreeMap::new();
            let mut after_draw = false;
            for command in encoding_order(&recording.commands) {
                if let Command::Forget { of } = command {
                    begun.retain(|id| !is_forgotten(&self.resources, *of, *id));
                    continue;
                }
                let is_draw = matches!(command, Command::Draw(_));
                if !(is_draw && after_draw) {
                    bound.clear();
                }
                after_draw = is_draw;
                for (id, touch) in command.touches() {
                    let memory = self.sharing.memory(id);
                    let is_new = matches!(touch, Touch::Overwrite(bytes) if bytes >= self.resources.bytes(id));
                    let is_lost = begun.contains(&id) && !is_new && holder.get(&memory).is_some_and(|has| *has != id);
                    if is_lost || *bound.entry(memory).or_insert(id) != id {
                        let label = self.resources.label(id);
                        return Some(format!(
                            "{name}: {} finds another's in {label}",
                            describe(&self.resources, command)
                        ));
                    }
                    holder.insert(memory, id);
                    begun.insert(id);
                }
            }
            if let Some(state) = states.iter().find(|state| holder[&self.sharing.memory(**state)] != **state) {
                return Some(format!("{name} ends: {}", self.resources.label(*state)));
            }
        }
        None
    }
}
