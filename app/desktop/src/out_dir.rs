//! The folder a run writes to, and files that are there whole or not at all.

use std::{
    fs,
    io::{self, ErrorKind, Write},
    path::{Path, PathBuf},
};

use crate::failure::Failure;

/// Creates `wanted`, or, where that exists, the first free of `wanted-1`, `wanted-2` and so on:
/// what an earlier run wrote is kept.
pub fn create(wanted: &Path) -> Result<PathBuf, Failure> {
    let cannot = |path: &Path, error: io::Error| {
        Failure::Input(format!("--out {}: cannot create the folder: {error}", path.display()))
    };
    if wanted.file_name().is_none() {
        return Err(Failure::Input(format!(
            "--out {}: name a folder of the run's own, which is created",
            wanted.display()
        )));
    }
    // Without the slash at the end, behind which a number would be another folder's name.
    let wanted = &wanted.components().collect::<PathBuf>();
    if let Some(parent) = wanted.parent() {
        fs::create_dir_all(parent).map_err(|error| cannot(parent, error))?;
    }
    for number in 0_u32.. {
        let path = match number {
            0 => wanted.to_path_buf(),
            _ => numbered(wanted, number),
        };
        match fs::create_dir(&path) {
            Ok(()) => return Ok(path),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(cannot(&path, error)),
        }
    }
    Err(cannot(wanted, ErrorKind::AlreadyExists.into()))
}

fn numbered(wanted: &Path, number: u32) -> PathBuf {
    let mut name = wanted.as_os_str().to_os_string();
    name.push(format!("-{number}"));
    name.into()
}

/// Writes a file under a temporary name and renames it: nobody ever sees half of it.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), Failure> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let write = || -> io::Result<()> {
        let mut file = tempfile::Builder::new().prefix(".brooklet-").tempfile_in(folder)?;
        file.write_all(content)?;
        #[cfg(unix)]
        {
            // A temporary file is its owner's alone; a result is for whoever the folder is for.
            use std::os::unix::fs::PermissionsExt;
            file.as_file().set_permissions(fs::Permissions::from_mode(0o644))?;
        }
        file.persist(path)?;
        Ok(())
    };
    write().map_err(|error| Failure::stopped(format_args!("{}: cannot be written: {error}", path.display())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        let wanted = folder.path().join("deep/out");
        let first = create(&wanted).unwrap();
        assert_eq!(first, wanted);
        write_file(&first.join("a.txt"), b"first").unwrap();
        assert_eq!(create(&wanted).unwrap(), folder.path().join("deep/out-1"));
        assert_eq!(create(&folder.path().join("deep/out/")).unwrap(), folder.path().join("deep/out-2"));
        assert_eq!(fs::read(first.join("a.txt")).unwrap(), b"first");
    }

    #[test]
    fn a_folder_that_cannot_be_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        write_file(&file, b"").unwrap();
        let failure = create(&file.join("out")).unwrap_err();
        assert!(matches!(failure, Failure::Input(_)), "{failure:?}");
        assert!(failure.to_string().contains(&file.display().to_string()), "{failure}");
        assert!(matches!(create(Path::new("..")), Err(Failure::Input(_))));
    }

    #[test]
    fn a_file_is_whole_or_absent() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        write_file(&path, b"{}").unwrap();
        write_file(&path, b"{\"again\": 1}").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"{\"again\": 1}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no file is left behind");
        assert!(write_file(&folder.path().join("no/summary.json"), b"").is_err());
    }
}
