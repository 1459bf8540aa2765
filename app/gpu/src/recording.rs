//! A recording: what the GPU is to do, as data that can be printed, counted and tested without one.

use crate::draw::{DrawState, Load, RecordedTargets, Targets};
use brooklet_kernels::{Access, BindingError, BindingKind, Bound, Buffer, Draw, Kernel, Module, ResourceId};
use bytemuck::Pod;
use std::sync::Arc;

/// Groups beyond this many go to a second row: shaders linearise a group as
/// `group.y * GROUP_ROW + group.x`. Every device allows 65,535 groups a dimension.
pub const GROUP_ROW: u32 = brooklet_kernels::GROUPS_PER_ROW;

/// How many groups a dispatch runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Groups {
    /// This many.
    Fixed([u32; 3]),
    /// As the GPU says: a `VkDispatchIndirectCommand`.
    Indirect(IndirectArgs),
}

/// How many instances a draw has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instances {
    /// This many.
    Fixed(u32),
    /// As the GPU says, and how many vertices each has: a `VkDrawIndirectCommand`.
    Indirect(IndirectArgs),
}

/// Where the arguments of an indirect command are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IndirectArgs {
    /// The buffer.
    pub buffer: ResourceId,
    /// Bytes before them; a multiple of 4.
    pub offset_bytes: u32,
    /// At most so many groups or instances, for estimates and lists: nothing holds the GPU to it.
    pub most: u32,
}

/// A kernel's run.
#[derive(Clone, Debug)]
pub struct Dispatch {
    /// The stage's name.
    pub stage: &'static str,
    /// Module of the chosen variant.
    pub module: &'static Module,
    /// What is bound, by slot.
    pub bindings: Vec<Bound>,
    /// How many groups.
    pub groups: Groups,
}

/// A draw call with its pipeline's state.
#[derive(Clone, Debug)]
pub struct DrawCall {
    /// The stage's name.
    pub stage: &'static str,
    /// Vertex module of the chosen variant.
    pub vertex: &'static Module,
    /// Fragment module; `None` draws depth only.
    pub fragment: Option<&'static Module>,
    /// What is bound, by slot.
    pub bindings: Vec<Bound>,
    /// What is drawn to.
    pub targets: RecordedTargets,
    /// Fixed state of the pipeline.
    pub state: DrawState,
    /// Vertices of an instance, where the GPU does not say.
    pub vertices: u32,
    /// Instances.
    pub instances: Instances,
}

/// One entry of a recording.
#[derive(Clone, Debug)]
pub enum Command {
    /// Copies host data to the start of a buffer.
    Upload {
        /// The buffer.
        to: ResourceId,
        /// The data.
        data: Arc<[u8]>,
    },
    /// Sets a whole buffer to zero.
    Clear {
        /// The buffer.
        to: ResourceId,
    },
    /// Copies a whole buffer to the start of another.
    Copy {
        /// The source.
        from: ResourceId,
        /// The destination.
        to: ResourceId,
        /// Size in bytes.
        bytes: u64,
    },
    /// Says that what a buffer holds is read by nobody any more, or what all transients hold (`None`): until it is
    /// written again, others may have its memory. Does nothing else.
    Forget {
        /// The buffer.
        of: Option<ResourceId>,
    },
    /// Runs a kernel.
    Dispatch(Dispatch),
    /// Draws.
    Draw(Box<DrawCall>),
}

/// How a command touches a resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// It needs what is there.
    Read,
    /// It may need what is there, and changes it.
    ReadWrite,
    /// It writes, from the start, this many bytes, and needs nothing of what was there.
    Overwrite(u64),
}

impl Command {
    /// Name of its stage: the kernel's or the draw's; `None` for all others.
    pub fn stage(&self) -> Option<&'static str> {
        match self {
            Self::Dispatch(dispatch) => Some(dispatch.stage),
            Self::Draw(draw) => Some(draw.stage),
            _ => None,
        }
    }

    /// Every resource it touches, and how. A resource may be listed more than once.
    pub fn touches(&self) -> Vec<(ResourceId, Touch)> {
        match self {
            Self::Upload { to, data } => vec![(*to, Touch::Overwrite(data.len() as u64))],
            Self::Clear { to } => vec![(*to, Touch::Overwrite(u64::MAX))],
            Self::Copy { from, to, bytes } => {
                vec![(*from, Touch::Read), (*to, Touch::Overwrite(*bytes))]
            }
            Self::Forget { .. } => Vec::new(),
            Self::Dispatch(dispatch) => {
                let mut touches = bound_touches(&dispatch.bindings);
                if let Groups::Indirect(args) = dispatch.groups {
                    touches.push((args.buffer, Touch::Read));
                }
                touches
            }
            Self::Draw(draw) => {
                let mut touches = bound_touches(&draw.bindings);
                if let Instances::Indirect(args) = draw.instances {
                    touches.push((args.buffer, Touch::Read));
                }
                for (id, load) in &draw.targets.color {
                    touches.push((*id, target_touch(*load == Load::Keep)));
                }
                if let Some((id, load)) = draw.targets.depth {
                    // A test alone changes nothing: it must not keep a draw that nobody wants.
                    let tested = load == Load::Keep && !draw.state.depth_write;
                    touches.push((id, if tested { Touch::Read } else { target_touch(load == Load::Keep) }));
                }
                touches
            }
        }
    }
}

fn target_touch(kept: bool) -> Touch {
    if kept { Touch::ReadWrite } else { Touch::Overwrite(u64::MAX) }
}

fn bound_touches(bindings: &[Bound]) -> Vec<(ResourceId, Touch)> {
    bindings
        .iter()
        .filter_map(|bound| {
            let touch = match bound.info.kind {
                BindingKind::Storage { access, .. } | BindingKind::StorageTexture { access, .. }
                    if access == Access::ReadWrite =>
                {
                    Touch::ReadWrite
                }
                _ => Touch::Read,
            };
            bound.resource.map(|id| (id, touch))
        })
        .collect()
}

/// A mistake made while recording; a plan refuses a recording that holds one.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RecordError {
    /// A variant needs a resource that was not given.
    #[error(transparent)]
    Binding(#[from] BindingError),
    /// More was uploaded or copied than the destination holds.
    #[error("{what} of {elements} elements does not fit a buffer of {room}")]
    TooLong {
        /// `upload` or `copy`.
        what: &'static str,
        /// Elements of the source.
        elements: u32,
        /// Elements of the destination.
        room: u32,
    },
    /// Vulkan copies whole words.
    #[error("{what} of {bytes} bytes: only multiples of 4 can be copied on a GPU")]
    Unaligned {
        /// `upload` or `copy`.
        what: &'static str,
        /// Size of the data in bytes.
        bytes: u64,
    },
    /// A buffer was copied onto itself.
    #[error("a buffer is copied onto itself")]
    SelfCopy,
    /// A draw without a target.
    #[error("{stage} draws to no target")]
    NoTarget {
        /// The draw.
        stage: &'static str,
    },
    /// Arguments of an indirect command that are not in their buffer.
    #[error(
        "{stage} takes {bytes} bytes of arguments at byte {offset_bytes} of a buffer of {room} bytes; they must be \
             in it, at a multiple of 4"
    )]
    Arguments {
        /// The kernel or draw.
        stage: &'static str,
        /// Size of the arguments.
        bytes: u32,
        /// Where they were to be.
        offset_bytes: u32,
        /// Size of the buffer.
        room: u64,
    },
    /// More groups than any device runs.
    #[error("{stage} runs {groups:?} groups; at most 65535 a dimension are allowed")]
    TooManyGroups {
        /// The kernel.
        stage: &'static str,
        /// The groups asked for.
        groups: [u32; 3],
    },
}

/// A recording's handle: what an engine is told to run, and what plans and spans name it by. Two are
/// equal if both place and label are, so a handle of another table is found out where either differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RecordingId {
    index: u32,
    label: &'static str,
}

impl RecordingId {
    pub(crate) fn new(index: u32, label: &'static str) -> Self {
        Self { index, label }
    }

    /// For spans of passes that no engine ran, a host program's own: no plan has it.
    pub const fn outside(label: &'static str) -> Self {
        Self { index: u32::MAX, label }
    }

    /// Name in plans, captures and errors.
    pub fn label(self) -> &'static str {
        self.label
    }
}

/// A list of commands, declared by [`crate::Resources::recording`].
#[derive(Clone, Debug)]
pub struct Recording {
    id: RecordingId,
    commands: Vec<Command>,
    errors: Vec<RecordError>,
}

impl Recording {
    pub(crate) fn new(id: RecordingId) -> Self {
        Self { id, commands: Vec::new(), errors: Vec::new() }
    }

    /// Its handle, which lasts when the recording is given to a plan.
    pub fn id(&self) -> RecordingId {
        self.id
    }

    /// What was recorded.
    pub fn commands(&self) -> &[Command] {
        &self.commands
    }

    pub(crate) fn into_commands(self) -> Vec<Command> {
        self.commands
    }

    /// Mistakes made while recording.
    pub fn errors(&self) -> &[RecordError] {
        &self.errors
    }

    /// Takes the commands of another recording at the end of this one.
    pub fn append(&mut self, other: &Recording) {
        self.commands.extend_from_slice(&other.commands);
        self.errors.extend_from_slice(&other.errors);
    }

    /// Copies `data` to the start of `to`, each time the recording runs.
    pub fn upload<T: Pod>(&mut self, to: &mut Buffer<T>, data: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(data);
        if data.len() > to.len as usize {
            self.errors.push(RecordError::TooLong {
                what: "upload",
                elements: data.len().min(u32::MAX as usize) as u32,
                room: to.len,
            });
        } else if !bytes.len().is_multiple_of(4) {
            self.errors.push(RecordError::Unaligned { what: "upload", bytes: bytes.len() as u64 });
        } else if !data.is_empty() {
            self.commands.push(Command::Upload { to: to.id, data: bytes.into() });
        }
    }

    /// Sets all of `to` to zero.
    pub fn clear<T>(&mut self, to: &mut Buffer<T>) {
        self.commands.push(Command::Clear { to: to.id });
    }

    /// Nobody reads what `of` holds any more: the next command that touches it writes all that is read after that. Of
    /// state, which is written again before the recording ends; else it keeps its memory.
    pub fn forget<T>(&mut self, of: &Buffer<T>) {
        self.commands.push(Command::Forget { of: Some(of.id) });
    }

    /// Nobody reads what transients hold any more: as at the recording's end.
    pub fn forget_transients(&mut self) {
        self.commands.push(Command::Forget { of: None });
    }

    /// Copies all of `from` to the start of `to`.
    pub fn copy<T>(&mut self, from: &Buffer<T>, to: &mut Buffer<T>) {
        let bytes = u64::from(from.len) * size_of::<T>() as u64;
        if from.id == to.id {
            self.errors.push(RecordError::SelfCopy);
        } else if from.len > to.len {
            self.errors.push(RecordError::TooLong { what: "copy", elements: from.len, room: to.len });
        } else if !bytes.is_multiple_of(4) {
            self.errors.push(RecordError::Unaligned { what: "copy", bytes });
        } else if bytes > 0 {
            self.commands.push(Command::Copy { from: from.id, to: to.id, bytes });
        }
    }

    /// Runs `kernel` with one thread an item. No items: nothing is recorded. Kernels must ignore
    /// the threads beyond the last item.
    pub fn dispatch<K: Kernel>(&mut self, kernel: &K, items: u32) {
        let threads: u32 = K::GROUP_SIZE.iter().product();
        self.dispatch_groups(kernel, group_grid(items.div_ceil(threads.max(1))));
    }

    /// Runs `kernel` with this many groups; any of them 0: nothing is recorded.
    pub fn dispatch_groups<K: Kernel>(&mut self, kernel: &K, groups: [u32; 3]) {
        if groups.contains(&0) {
            return;
        }
        if groups.iter().any(|count| *count > 65_535) {
            self.errors.push(RecordError::TooManyGroups { stage: K::STAGE, groups });
            return;
        }
        self.push_dispatch(kernel, Groups::Fixed(groups));
    }

    /// Runs `kernel` with as many groups as the GPU wrote to `args` behind `offset_bytes`: for at most `most_items`,
    /// with one thread each. No items at most: nothing is recorded.
    pub fn dispatch_indirect<K: Kernel, T: Pod>(
        &mut self,
        kernel: &K,
        args: &Buffer<T>,
        offset_bytes: u32,
        most_items: u32,
    ) {
        let threads: u32 = K::GROUP_SIZE.iter().product();
        let most = most_items.div_ceil(threads.max(1));
        if self.holds_arguments(K::STAGE, args, offset_bytes, size_of::<[u32; 3]>()) && most > 0 {
            self.push_dispatch(kernel, Groups::Indirect(IndirectArgs { buffer: args.id, offset_bytes, most }));
        }
    }

    /// Draws as many instances as the GPU wrote to `args` behind `offset_bytes`, at most `most`.
    pub fn draw_indirect<D: Draw, T: Pod>(
        &mut self,
        draw: &D,
        targets: &Targets<'_>,
        state: DrawState,
        args: &Buffer<T>,
        offset_bytes: u32,
        most: u32,
    ) {
        if self.holds_arguments(D::STAGE, args, offset_bytes, size_of::<[u32; 4]>()) {
            let args = IndirectArgs { buffer: args.id, offset_bytes, most };
            self.push_draw(draw, targets, state, 0, Instances::Indirect(args));
        }
    }

    /// Whether `args` has so many bytes behind `offset_bytes`.
    fn holds_arguments<T: Pod>(
        &mut self,
        stage: &'static str,
        args: &Buffer<T>,
        offset_bytes: u32,
        bytes: usize,
    ) -> bool {
        let room = u64::from(args.len) * size_of::<T>() as u64;
        let holds = u64::from(offset_bytes) + bytes as u64 <= room && offset_bytes.is_multiple_of(4);
        if !holds {
            self.errors.push(RecordError::Arguments { stage, bytes: bytes as u32, offset_bytes, room });
        }
        holds
    }

    fn push_dispatch<K: Kernel>(&mut self, kernel: &K, groups: Groups) {
        match kernel.bindings() {
            Ok(bindings) => self.commands.push(Command::Dispatch(Dispatch {
                stage: K::STAGE,
                module: kernel.module(),
                bindings,
                groups,
            })),
            Err(error) => self.errors.push(error.into()),
        }
    }

    /// Draws; no vertices or no instances still clears the targets that are to be cleared.
    pub fn draw<D: Draw>(&mut self, draw: &D, targets: &Targets<'_>, state: DrawState, vertices: u32, instances: u32) {
        self.push_draw(draw, targets, state, vertices, Instances::Fixed(instances));
    }

    fn push_draw<D: Draw>(
        &mut self,
        draw: &D,
        targets: &Targets<'_>,
        state: DrawState,
        vertices: u32,
        instances: Instances,
    ) {
        if targets.color.is_empty() && targets.depth.is_none() {
            self.errors.push(RecordError::NoTarget { stage: D::STAGE });
            return;
        }
        match draw.bindings() {
            Ok(bindings) => self.commands.push(Command::Draw(Box::new(DrawCall {
                stage: D::STAGE,
                vertex: draw.vertex(),
                fragment: draw.fragment(),
                bindings,
                targets: targets.into(),
                state,
                vertices,
                instances,
            }))),
            Err(error) => self.errors.push(error.into()),
        }
    }
}

/// Lays `groups` out in rows of [`GROUP_ROW`].
pub fn group_grid(groups: u32) -> [u32; 3] {
    if groups <= GROUP_ROW { [groups, 1, 1] } else { [GROUP_ROW, groups.div_ceil(GROUP_ROW), 1] }
}
