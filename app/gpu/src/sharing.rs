//! Which buffers have one memory: those of which each is needed only while the others are not.
//!
//! A transient is needed from where a recording first touches it to where it last does before it is overwritten or
//! forgotten; state always, but from where it is forgotten to where it is written again. What a host may read, a wanted
//! output, is always needed. Times are places in the order in which recordings are encoded. Two needs that touch in one
//! dispatch, or in draws that may share a render pass, overlap: there one buffer cannot be bound as two.

use crate::order::encoding_order;
use crate::planned::{PlannedRecording, is_forgotten};
use crate::recording::{Command, Touch};
use crate::resources::Resources;
use brooklet_kernels::ResourceId;
use std::collections::{BTreeMap, BTreeSet};

/// First and last time of a need.
type Span = (usize, usize);

/// Buffers that have no memory of their own, and whose they have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Sharing {
    owners: BTreeMap<ResourceId, ResourceId>,
}

impl Sharing {
    /// Of the buffers among `used`.
    pub fn of(
        resources: &Resources,
        recordings: &[PlannedRecording],
        used: &BTreeSet<ResourceId>,
        wanted: &[ResourceId],
    ) -> Self {
        let mut buffers: Vec<Need> = needs(resources, recordings)
            .into_iter()
            .filter(|(id, _)| used.contains(id) && !wanted.contains(id))
            .map(|(id, spans)| Need { id, bytes: resources.bytes(id), spans })
            .filter(|need| need.bytes > 0)
            .collect();
        buffers.sort_by_key(|need| (std::cmp::Reverse(need.bytes), need.id));
        Self { owners: share(buffers) }
    }

    /// The resource whose memory `id` has: often its own.
    pub fn memory(&self, id: ResourceId) -> ResourceId {
        self.owners.get(&id).copied().unwrap_or(id)
    }

    /// Whether another buffer has the memory of `id` too.
    pub fn is_shared(&self, id: ResourceId) -> bool {
        self.owners.contains_key(&id) || self.owners.values().any(|owner| *owner == id)
    }
}

/// When a buffer's content is needed.
struct Need {
    id: ResourceId,
    bytes: u64,
    spans: Vec<Span>,
}

/// Gives each buffer, largest first, the smallest memory there is that is free whenever it is needed, or one of its own.
fn share(largest_first: Vec<Need>) -> BTreeMap<ResourceId, ResourceId> {
    let mut memories: Vec<Need> = Vec::new();
    let mut owners = BTreeMap::new();
    for need in largest_first {
        // The last that fits is the smallest: they were made in order of size.
        match memories.iter_mut().rev().find(|memory| !overlap(&memory.spans, &need.spans)) {
            Some(memory) => {
                owners.insert(need.id, memory.id);
                memory.spans.extend(need.spans);
            }
            None => memories.push(need),
        }
    }
    owners
}

fn overlap(one: &[Span], other: &[Span]) -> bool {
    one.iter().any(|a| other.iter().any(|b| a.0 <= b.1 && b.0 <= a.1))
}

/// The needs of every buffer that a recording touches.
fn needs(resources: &Resources, recordings: &[PlannedRecording]) -> BTreeMap<ResourceId, Vec<Span>> {
    let mut needs: BTreeMap<ResourceId, Vec<Span>> = BTreeMap::new();
    let mut state: BTreeMap<ResourceId, Vec<Span>> = BTreeMap::new();
    let mut start = 0;
    for recording in recordings {
        let timed = timed(&recording.commands, start);
        let end = timed.last().map_or(start, |(time, _)| *time);
        let touched: BTreeSet<ResourceId> =
            recording.commands.iter().flat_map(Command::touches).map(|(id, _)| id).collect();
        for id in touched {
            match resources.get(id) {
                Some(entry) if entry.is_texture() => {}
                Some(entry) if entry.state => state.entry(id).or_default().extend(gaps(resources, start, &timed, id)),
                _ => needs.entry(id).or_default().extend(spans(resources, &timed, id)),
            }
        }
        start = end + 1;
    }
    for (id, gaps) in state {
        needs.insert(id, between(&gaps, start));
    }
    needs
}

/// Commands in the order in which they are encoded, with their times. Draws one after another have one time, since
/// they may share a render pass. `start` is the time before the first of them.
fn timed(commands: &[Command], start: usize) -> Vec<(usize, &Command)> {
    let mut time = start;
    let mut after_draw = false;
    let mut timed = Vec::with_capacity(commands.len());
    for command in encoding_order(commands) {
        if !matches!(command, Command::Forget { .. }) {
            let is_draw = matches!(command, Command::Draw(_));
            time += usize::from(!(is_draw && after_draw));
            after_draw = is_draw;
        }
        timed.push((time, command));
    }
    timed
}

/// When a transient is needed.
fn spans(resources: &Resources, timed: &[(usize, &Command)], id: ResourceId) -> Vec<Span> {
    let mut spans: Vec<Span> = Vec::new();
    let mut is_open = false;
    for (time, command) in timed {
        if let Command::Forget { of } = command {
            is_open &= !is_forgotten(resources, *of, id);
        }
        for (_, touch) in command.touches().iter().filter(|(touched, _)| *touched == id) {
            let is_new = matches!(touch, Touch::Overwrite(bytes) if *bytes >= resources.bytes(id));
            match spans.last_mut().filter(|_| is_open && !is_new) {
                Some(span) => span.1 = *time,
                None => spans.push((*time, *time)),
            }
            is_open = true;
        }
    }
    spans
}

/// When state is not needed: between the last touch before it is forgotten and the first after that.
fn gaps(resources: &Resources, start: usize, timed: &[(usize, &Command)], id: ResourceId) -> Vec<Span> {
    let mut gaps = Vec::new();
    let mut last_touch = None;
    let mut forgotten_after = None;
    for (time, command) in timed {
        if matches!(command, Command::Forget { of } if is_forgotten(resources, *of, id)) {
            // Before its first touch nothing of it is needed since the recording began.
            forgotten_after = forgotten_after.or(Some(last_touch.unwrap_or(start)));
        }
        if command.touches().iter().any(|(touched, _)| *touched == id) {
            if let Some(last) = forgotten_after.take()
                && *time > last + 1
            {
                gaps.push((last + 1, time - 1));
            }
            last_touch = Some(*time);
        }
    }
    gaps
}

/// What gaps leave of the time until `end`, beginning and end included.
fn between(gaps: &[Span], end: usize) -> Vec<Span> {
    let mut spans = Vec::new();
    let mut start = 0;
    for gap in gaps {
        spans.push((start, gap.0 - 1));
        start = gap.1 + 1;
    }
    spans.push((start, end));
    spans
}

#[cfg(test)]
#[path = "sharing_tests.rs"]
mod tests;
