//! What is wrong with a scene, in one line that names the file, the field, the value and what is
//! allowed.

use thiserror::Error;

/// A scene that cannot be run.
#[derive(Debug, Error)]
pub enum SceneError {
    /// The file cannot be read.
    #[error("scene {source_name}: cannot be read: {reason}")]
    Unreadable {
        /// File.
        source_name: String,
        /// What the system says.
        reason: String,
    },
    /// No shipped scene has this name, and no file this path.
    #[error("no scene {name:?}: neither a file nor a shipped scene; did you mean {nearest}? (shipped: {shipped})")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The nearest shipped name.
        nearest: String,
        /// All shipped names.
        shipped: String,
    },
    /// Not TOML.
    #[error("scene {source_name}{place}: {reason}")]
    Malformed {
        /// File.
        source_name: String,
        /// `:line:column`, where known.
        place: String,
        /// What is wrong.
        reason: String,
    },
    /// A key that no scene has.
    #[error("scene {source_name}{place}: unknown key `{key}`; did you mean `{nearest}`? (keys here: {allowed})")]
    UnknownKey {
        /// File.
        source_name: String,
        /// `:line:column`, where known.
        place: String,
        /// The unknown key.
        key: String,
        /// The nearest known one.
        nearest: String,
        /// All known ones.
        allowed: String,
    },
    /// A field that every scene needs.
    #[error("scene {source_name}{place}: {field} is missing: {allowed}")]
    Missing {
        /// File.
        source_name: String,
        /// `:line:column` of the table it should be in, where known.
        place: String,
        /// Path of the field.
        field: String,
        /// What is allowed.
        allowed: String,
    },
    /// A value of a wrong type, or outside what is allowed.
    #[error("scene {source_name}{place}: {field} = {value}: {allowed}")]
    NotAllowed {
        /// File.
        source_name: String,
        /// `:line:column`, where known.
        place: String,
        /// Path of the field.
        field: String,
        /// The value found.
        value: String,
        /// What is allowed.
        allowed: String,
    },
    /// Keys where scenes of earlier versions had them.
    #[error("scene {source_name}{place}: {moves}")]
    Moved {
        /// File.
        source_name: String,
        /// `:line:column` of the first, where known.
        place: String,
        /// Each with its value and its new place.
        moves: String,
    },
    /// A setting that is not `path=value`, or whose path does not exist.
    #[error("--set {setting}: {reason}")]
    BadSetting {
        /// The setting as given.
        setting: String,
        /// What is wrong.
        reason: String,
    },
}
