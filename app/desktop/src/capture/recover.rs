//! `brooklet capture recover`.

use std::path::PathBuf;

use brooklet_capture::CaptureError;

use super::options::RecoverOptions;
use crate::failure::Failure;

/// Writes everything whole of a capture to a new file.
pub fn recover(options: &RecoverOptions) -> Result<(), Failure> {
    let out = options.out.clone().unwrap_or_else(|| beside(&options.file));
    let shown = out.display().to_string();
    let exists = || Failure::Input(format!("{shown} exists and is kept; name another file with --out"));
    if out.symlink_metadata().is_ok() {
        return Err(exists());
    }
    let folder = match out.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        _ => PathBuf::from("."),
    };
    // Under another name until it is whole.
    let mut file = tempfile::Builder::new()
        .prefix(".brooklet-")
        .tempfile_in(&folder)
        .map_err(|error| Failure::Input(format!("{shown}: cannot create: {error}")))?;
    let ending = brooklet_capture::recover(&options.file, file.as_file_mut(), &shown).map_err(|error| match error {
        CaptureError::Write { reason, .. } => Failure::Stopped(format!("{shown}: cannot be written: {reason}")),
        error @ CaptureError::Io { action: "write", .. } => Failure::stopped(error),
        error => Failure::input(error),
    })?;
    if ending.messages == 0 {
        return Err(Failure::Stopped(format!("{}: nothing whole is left of it", options.file.display())));
    }
    crate::out_dir::make_readable(file.as_file()).map_err(Failure::stopped)?;
    file.persist_noclobber(&out).map_err(|error| match error.error.kind() {
        std::io::ErrorKind::AlreadyExists => exists(),
        _ => Failure::stopped(format_args!("{shown}: cannot be written: {}", error.error)),
    })?;
    say!("{} messages of {} whole chunks are in {shown}", ending.messages, ending.chunks);
    if ending.complete {
        say!("nothing was lost: the file was whole");
    } else {
        say!("lost: {} bytes that belong to nothing whole", ending.damaged_bytes);
    }
    if ending.unnamed_messages > 0 {
        say!("lost: {} messages whose topic only a damaged part declared", ending.unnamed_messages);
    }
    Ok(())
}

/// `run.mcap` becomes `run-recovered.mcap`.
fn beside(file: &std::path::Path) -> PathBuf {
    let mut name = file.file_stem().unwrap_or_default().to_os_string();
    name.push("-recovered");
    if let Some(extension) = file.extension() {
        name.push(".");
        name.push(extension);
    }
    file.with_file_name(name)
}
