//! A recording after the sweep, and what its commands are called.

use crate::recording::{Command, RecordingId};
use crate::resources::Resources;
use brooklet_kernels::ResourceId;

/// A recording after the sweep; one whose commands were all left out runs as nothing.
#[derive(Clone, Debug)]
pub(crate) struct PlannedRecording {
    pub id: RecordingId,
    pub commands: Vec<Command>,
}

/// Whether a [`Command::Forget`] of `of` is one of `id`.
pub(crate) fn is_forgotten(resources: &Resources, of: Option<ResourceId>, id: ResourceId) -> bool {
    match of {
        Some(of) => of == id,
        None => resources.get(id).is_some_and(|entry| !entry.state),
    }
}

/// A command's name: its stage, or what it does to what.
pub(crate) fn describe(resources: &Resources, command: &Command) -> String {
    match command {
        Command::Upload { to, .. } => format!("upload {}", resources.label(*to)),
        Command::Clear { to } => format!("clear {}", resources.label(*to)),
        Command::Copy { from, to, .. } => {
            format!("copy {} to {}", resources.label(*from), resources.label(*to))
        }
        Command::Forget { of: Some(of) } => format!("forget {}", resources.label(*of)),
        Command::Forget { of: None } => "forget transients".to_owned(),
        Command::Dispatch(dispatch) => dispatch.stage.to_owned(),
        Command::Draw(draw) => draw.stage.to_owned(),
    }
}
