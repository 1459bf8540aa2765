//! The backward sweep: which commands feed what is wanted, and which are left out.

use crate::formats::OtherFormat;
use crate::plan_left_out::{LeftOut, list_left_out};
use crate::planned::{PlannedRecording, describe, is_forgotten};
use crate::recording::{Command, Groups, Instances, RecordError, Recording, RecordingId, Touch};
use crate::resources::{ResourceInfo, Resources, Shape};
use crate::sharing::Sharing;
use brooklet_kernels::{BindingKind, Bound, Module, ResourceId};
use std::collections::{BTreeMap, BTreeSet};

/// The recordings of a program without what nothing wanted needs. Made once, run often.
#[derive(Clone, Debug)]
pub struct Plan {
    pub(crate) resources: Resources,
    pub(crate) recordings: Vec<PlannedRecording>,
    pub(crate) wanted: Vec<ResourceId>,
    /// Which of them have one memory.
    pub(crate) sharing: Sharing,
    used: BTreeSet<ResourceId>,
    left_out: Vec<LeftOut>,
    pub(crate) other_formats: Vec<OtherFormat>,
}

/// Runs of one module in one recording.
#[derive(Clone, Copy, Debug)]
pub struct PassInfo {
    /// The recording.
    pub recording: RecordingId,
    /// The stage.
    pub stage: &'static str,
    /// Module of the chosen variant; of a draw, its vertex module.
    pub module: &'static Module,
    /// How often the recording runs it.
    pub count: u32,
    /// Whether the GPU says of how many groups or instances.
    pub indirect: bool,
}

/// A resource that gets memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeptBuffer {
    /// Its index in the table.
    pub id: ResourceId,
    /// Its name.
    pub label: String,
    /// Size of its content in bytes.
    pub bytes: u64,
    /// The resource whose memory it has: itself, or a buffer at least as large that is not needed while it is.
    pub memory: ResourceId,
}

/// A plan could not be made; a mistake in the program that recorded it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// Recording failed.
    #[error("recording {recording}: {error}")]
    Record {
        /// The recording.
        recording: &'static str,
        /// What failed.
        error: RecordError,
    },
    /// Two recordings have one name.
    #[error("two recordings are called {name}")]
    SameName {
        /// The name.
        name: &'static str,
    },
    /// A resource of another table is used.
    #[error("{user} uses resource {id}, and the table has {count}; it was declared in another table")]
    UnknownResource {
        /// Stage or `wanted`.
        user: String,
        /// Index of the resource.
        id: u32,
        /// Number of resources in the table.
        count: usize,
    },
    /// A transient is read before its recording wrote it.
    #[error(
        "recording {recording}: {user} reads {resource}, which the recording has not written yet; \
         declare it with Resources::state if it is to last between recordings"
    )]
    ReadBeforeWrite {
        /// The recording.
        recording: &'static str,
        /// The command that reads.
        user: String,
        /// The resource.
        resource: String,
    },
    /// A command uses one resource in two ways that exclude each other.
    #[error("recording {recording}: {user} both reads and writes {resource} at once")]
    ReadAndWritten {
        /// The recording.
        recording: &'static str,
        /// The command.
        user: String,
        /// The resource.
        resource: String,
    },
    /// A resource does not fit the slot it is bound to.
    #[error("recording {recording}: {user} binds {resource} to {field}: {reason}")]
    Misfit {
        /// The recording.
        recording: &'static str,
        /// The command.
        user: String,
        /// The resource.
        resource: String,
        /// Name of the binding in HLSL.
        field: &'static str,
        /// What does not fit.
        reason: String,
    },
}

impl Plan {
    /// Sweeps `recordings` backward, once. A command stays if it writes something wanted: a
    /// resource of `wanted`, state, or what a command that stays reads. Clears, uploads and
    /// copies over all of a resource end the want above them. The recordings' order does not
    /// matter: only state lasts from one to the next.
    pub fn sweep(resources: Resources, recordings: Vec<Recording>, wanted: &[ResourceId]) -> Result<Plan, PlanError> {
        check_known(&resources, wanted.iter().copied(), || "the list of wanted outputs".into())?;
        let mut names = BTreeSet::new();
        for recording in &recordings {
            let name = recording.id().label();
            if !names.insert(name) {
                return Err(PlanError::SameName { name });
            }
            check_recording(&resources, recording)?;
        }

        let lasting: BTreeSet<ResourceId> =
            wanted.iter().copied().chain(resources.iter().filter(|(_, r)| r.state).map(|(id, _)| id)).collect();
        let mut planned = Vec::new();
        let mut dropped: Vec<Command> = Vec::new();
        for recording in recordings {
            let keep = sweep_one(&resources, recording.commands(), lasting.clone(), wanted);
            let id = recording.id();
            let mut commands = Vec::new();
            for (command, keep) in recording.into_commands().into_iter().zip(keep) {
                if keep {
                    commands.push(command);
                } else {
                    dropped.push(command);
                }
            }
            if commands.iter().all(|command| matches!(command, Command::Forget { .. })) {
                commands.clear();
            }
            planned.push(PlannedRecording { id, commands });
        }

        let used = planned
            .iter()
            .flat_map(|recording| &recording.commands)
            .flat_map(|command| command.touches())
            .map(|(id, _)| id)
            .chain(wanted.iter().copied())
            .collect();
        let left_out = list_left_out(&resources, &planned, &dropped, &used);
        let sharing = Sharing::of(&resources, &planned, &used, wanted);
        Ok(Plan {
            resources,
            recordings: planned,
            wanted: wanted.to_vec(),
            sharing,
            used,
            left_out,
            other_formats: Vec::new(),
        })
    }

    /// The table it was made from.
    pub fn resources(&self) -> &Resources {
        &self.resources
    }

    /// The outputs it was made for.
    pub fn wanted(&self) -> &[ResourceId] {
        &self.wanted
    }

    /// The recordings, those that run as nothing included.
    pub fn recordings(&self) -> impl Iterator<Item = RecordingId> + '_ {
        self.recordings.iter().map(|recording| recording.id)
    }

    /// Commands that stayed of a recording; empty if the plan does not have it.
    pub fn commands(&self, recording: RecordingId) -> &[Command] {
        self.recordings.iter().find(|planned| planned.id == recording).map_or(&[], |planned| &planned.commands)
    }

    /// Every dispatch and draw that stayed, those of one module in one recording together, in
    /// order of their first run.
    pub fn passes(&self) -> Vec<PassInfo> {
        let mut passes: Vec<PassInfo> = Vec::new();
        for recording in &self.recordings {
            for command in &recording.commands {
                let (stage, module, indirect) = match command {
                    Command::Dispatch(dispatch) => {
                        (dispatch.stage, dispatch.module, matches!(dispatch.groups, Groups::Indirect(_)))
                    }
                    Command::Draw(draw) => (draw.stage, draw.vertex, matches!(draw.instances, Instances::Indirect(_))),
                    _ => continue,
                };
                let same = passes.iter_mut().find(|pass| {
                    pass.recording == recording.id && pass.stage == stage && pass.module.name == module.name
                });
                match same {
                    Some(pass) => pass.count += 1,
                    None => passes.push(PassInfo { recording: recording.id, stage, module, count: 1, indirect }),
                }
            }
        }
        passes
    }

    /// Every resource that gets memory, in order of declaration, textures included.
    pub fn buffers(&self) -> Vec<KeptBuffer> {
        self.used
            .iter()
            .map(|id| KeptBuffer {
                id: *id,
                label: self.resources.label(*id).to_owned(),
                bytes: self.resources.bytes(*id),
                memory: self.sharing.memory(*id),
            })
            .collect()
    }

    /// Whether a resource gets memory.
    pub fn uses(&self, id: ResourceId) -> bool {
        self.used.contains(&id)
    }

    /// Bytes of memory that all resources take.
    pub fn bytes(&self) -> u64 {
        self.bytes_where(|_| true)
    }

    /// Bytes of memory that some of the recordings need: of buffers that share it, the largest of theirs.
    pub fn bytes_of(&self, recordings: &[RecordingId]) -> u64 {
        let used = self.used_by(recordings);
        self.bytes_where(|buffer| used.contains(&buffer.id))
    }

    /// The same without buffers that stand in the memory of one that these recordings do not use.
    pub fn own_bytes_of(&self, recordings: &[RecordingId]) -> u64 {
        let used = self.used_by(recordings);
        self.bytes_where(|buffer| used.contains(&buffer.id) && used.contains(&buffer.memory))
    }

    fn used_by(&self, recordings: &[RecordingId]) -> BTreeSet<ResourceId> {
        let commands = recordings.iter().flat_map(|recording| self.commands(*recording));
        commands.flat_map(|command| command.touches()).map(|(id, _)| id).collect()
    }

    fn bytes_where(&self, counts: impl Fn(&KeptBuffer) -> bool) -> u64 {
        let mut largest: BTreeMap<ResourceId, u64> = BTreeMap::new();
        for buffer in self.buffers().iter().filter(|buffer| counts(buffer)) {
            let bytes = largest.entry(buffer.memory).or_default();
            *bytes = buffer.bytes.max(*bytes);
        }
        largest.values().sum()
    }

    /// At most so many timestamps are taken while a recording runs: what a device takes depends on
    /// whether it can take them inside a pass.
    pub fn timestamp_bound(&self, recording: RecordingId) -> u64 {
        let bound = |command: &Command| match command {
            Command::Dispatch(_) => 2,
            // Its own two, and where its pass begins.
            Command::Draw(_) => 3,
            Command::Upload { .. } | Command::Clear { .. } | Command::Copy { .. } | Command::Forget { .. } => 0,
        };
        self.commands(recording).iter().map(bound).sum()
    }

    /// What was left out, and why: stages, then commands, buffers, textures.
    pub fn left_out(&self) -> &[LeftOut] {
        &self.left_out
    }
}

/// Which of a recording's commands stay. `live` starts as what is wanted at its end.
fn sweep_one(
    resources: &Resources,
    commands: &[Command],
    mut live: BTreeSet<ResourceId>,
    wanted: &[ResourceId],
) -> Vec<bool> {
    let mut keep = vec![false; commands.len()];
    for (index, command) in commands.iter().enumerate().rev() {
        if let Command::Forget { of } = command {
            keep[index] = true;
            live.retain(|id| wanted.contains(id) || !is_forgotten(resources, *of, *id));
            continue;
        }
        let touches = command.touches();
        keep[index] = touches.iter().any(|(id, touch)| *touch != Touch::Read && live.contains(id));
        if !keep[index] {
            continue;
        }
        // First what it ends, then what it needs: a copy ends the want for its destination, and
        // starts one for its source.
        for (id, touch) in &touches {
            if let Touch::Overwrite(bytes) = touch
                && *bytes >= resources.bytes(*id)
            {
                live.remove(id);
            }
        }
        for (id, touch) in &touches {
            if !matches!(touch, Touch::Overwrite(_)) {
                live.insert(*id);
            }
        }
    }
    keep
}

fn check_known(
    resources: &Resources,
    ids: impl Iterator<Item = ResourceId>,
    user: impl Fn() -> String,
) -> Result<(), PlanError> {
    for id in ids {
        if resources.get(id).is_none() {
            return Err(PlanError::UnknownResource { user: user(), id: id.0, count: resources.iter().count() });
        }
    }
    Ok(())
}

/// Refuses what no GPU could run, before anything is left out: a mistake in a stage that happens
/// to be unwanted today would otherwise show only when somebody wants it.
fn check_recording(resources: &Resources, recording: &Recording) -> Result<(), PlanError> {
    let name = recording.id().label();
    if let Some(error) = recording.errors().first() {
        return Err(PlanError::Record { recording: name, error: error.clone() });
    }
    let mut written: BTreeSet<ResourceId> =
        resources.iter().filter(|(_, entry)| entry.state).map(|(id, _)| id).collect();
    for command in recording.commands() {
        if let Command::Forget { of } = command {
            check_known(resources, of.iter().copied(), || describe(resources, command))?;
            written.retain(|id| !is_forgotten(resources, *of, *id));
        }
        let user = || describe(resources, command);
        let touches = command.touches();
        check_known(resources, touches.iter().map(|(id, _)| *id), user)?;
        for (id, touch) in &touches {
            if *touch == Touch::Read && !written.contains(id) {
                return Err(PlanError::ReadBeforeWrite {
                    recording: name,
                    user: user(),
                    resource: resources.label(*id).to_owned(),
                });
            }
            let clash =
                touches.iter().any(|(other, how)| other == id && (*how == Touch::Read) != (*touch == Touch::Read));
            if clash {
                return Err(PlanError::ReadAndWritten {
                    recording: name,
                    user: user(),
                    resource: resources.label(*id).to_owned(),
                });
            }
        }
        for bound in bindings(command) {
            check_fit(resources, name, command, bound)?;
        }
        written.extend(touches.iter().filter(|(_, touch)| *touch != Touch::Read).map(|(id, _)| *id));
    }
    Ok(())
}

fn bindings(command: &Command) -> &[Bound] {
    match command {
        Command::Dispatch(dispatch) => &dispatch.bindings,
        Command::Draw(draw) => &draw.bindings,
        _ => &[],
    }
}

fn check_fit(
    resources: &Resources,
    recording: &'static str,
    command: &Command,
    bound: &Bound,
) -> Result<(), PlanError> {
    let misfit = |resource: &str, reason: String| {
        Err(PlanError::Misfit {
            recording,
            user: describe(resources, command),
            resource: resource.to_owned(),
            field: bound.info.name,
            reason,
        })
    };
    let entry = bound.resource.and_then(|id| resources.get(id));
    let Some(ResourceInfo { label, shape, .. }) = entry else {
        return match bound.info.kind {
            BindingKind::Sampler => Ok(()),
            _ => misfit("nothing", "a resource is needed".into()),
        };
    };
    match (bound.info.kind, *shape) {
        (BindingKind::Uniform { bytes }, Shape::Buffer { .. }) => {
            let has = bound.resource.map_or(0, |id| resources.bytes(id));
            if has < u64::from(bytes) {
                return misfit(label, format!("it has {has} bytes, {bytes} are needed"));
            }
        }
        (BindingKind::Storage { stride_bytes: wanted, .. }, Shape::Buffer { stride_bytes, .. }) => {
            // A stride of 4 stands for raw words, which any element is made of.
            if wanted != stride_bytes && wanted != 4 {
                return misfit(label, format!("its elements have {stride_bytes} bytes, {wanted} are needed"));
            }
        }
        (BindingKind::Texture { .. }, Shape::Texture { .. }) => {}
        (BindingKind::StorageTexture { format: wanted, .. }, Shape::Texture { format, .. }) => {
            if wanted != format {
                return misfit(label, format!("its format is {format:?}, {wanted:?} is needed"));
            }
        }
        (kind, _) => return misfit(label, format!("{kind:?} is needed")),
    }
    Ok(())
}

#[cfg(test)]
#[path = "plan_tests.rs"]
mod tests;
